//! Regions of similar levels.

use super::disjoint_sets::DisjointSets;
use super::grid::Grid;

/// A step in level between regions of one cell that joins them, in sums over the pixels of a cell;
/// between larger regions it is this by their number of cells, beyond what is found within them.
const STEP: u32 = 100;
/// The least number of cells of a region, and the least number of matches, for small pictures.
const LEAST_CELLS: f64 = 25.0;
const LEAST_MATCHES: f64 = 30.0;
/// The number of different sums of a cell.
const SUMS: usize = 4 * 255 + 1;

/// A picture in regions. The memory for finding them is kept.
#[derive(Debug, Default)]
pub(super) struct Regions {
    /// The number of the region of each cell.
    labels: Vec<u32>,
    /// The number of matches of each region.
    matches: Vec<usize>,
    edges: Edges,
    sets: DisjointSets,
    /// The number of matches, or something else, of each set of cells.
    of_sets: Vec<u32>,
}

impl Regions {
    /// Finds the regions of a picture (P. F. Felzenszwalb and D. P. Huttenlocher, "Efficient
    /// graph-based image segmentation", International Journal of Computer Vision 59, 2004). Small
    /// ones join the neighbour of the most similar level. Then those with few matches join the
    /// neighbour across the border with the least mean step, the least of all borders first. What
    /// is small or few rises with `scale`.
    pub(super) fn find(
        &mut self,
        grid: &Grid,
        is_matched: impl Fn([usize; 2]) -> bool,
        scale: f64,
    ) {
        let Self {
            edges,
            sets,
            of_sets,
            ..
        } = self;
        edges.sort(grid);
        sets.separate(grid.cells());
        let numbers = |of_sets: &mut Vec<u32>, number| {
            of_sets.clear();
            of_sets.resize(grid.cells(), number);
        };
        numbers(of_sets, STEP);
        join_similar(edges, grid, sets, of_sets);
        edges.keep_between(grid, sets);
        join_small(edges, grid, sets, (LEAST_CELLS * scale) as u32);

        numbers(of_sets, 0);
        grid.each(|cell| {
            if is_matched(cell.place) {
                of_sets[sets.find(cell.number)] += 1;
            }
        });
        join_unmatched(edges, grid, sets, of_sets, (LEAST_MATCHES * scale) as u32);
        self.number_regions();
    }

    /// Numbers the sets that are left.
    fn number_regions(&mut self) {
        // A set that has its number has this bit.
        const NUMBERED: u32 = 1 << 31;
        let Self {
            labels,
            matches,
            sets,
            of_sets,
            ..
        } = self;
        matches.clear();
        labels.clear();
        labels.extend((0..of_sets.len()).map(|cell| {
            let of_set = &mut of_sets[sets.find(cell)];
            if *of_set & NUMBERED == 0 {
                let number = matches.len() as u32;
                matches.push(*of_set as usize);
                *of_set = number | NUMBERED;
            }
            *of_set & !NUMBERED
        }));
    }

    /// The number of regions.
    pub(super) fn count(&self) -> usize {
        self.matches.len()
    }

    /// How many cells of a region are matched.
    pub(super) fn matches(&self, region: usize) -> usize {
        self.matches[region]
    }

    /// The region of a cell.
    #[inline(always)]
    pub(super) fn of_cell(&self, cell: usize) -> usize {
        self.labels[cell] as usize
    }

    /// The region of a pixel.
    #[inline(always)]
    pub(super) fn of_pixel(&self, grid: &Grid, column: usize, row: usize) -> usize {
        self.of_cell(grid.cell(column, row))
    }
}

/// Pairs of cells beside and below each other, in the order of rising difference, and of cells
/// where these are equal.
#[derive(Debug, Default)]
struct Edges(Vec<u32>);

impl Edges {
    /// Takes all pairs of a grid.
    fn sort(&mut self, grid: &Grid) {
        let mut starts = [0; SUMS + 1];
        each_edge(grid, |_, step| starts[usize::from(step) + 1] += 1);
        for step in 0..SUMS {
            starts[step + 1] += starts[step];
        }
        self.0.resize(starts[SUMS], 0);
        each_edge(grid, |code, step| {
            let place = &mut starts[usize::from(step)];
            self.0[*place] = code;
            *place += 1;
        });
    }

    /// Keeps the pairs of cells that are in different sets.
    fn keep_between(&mut self, grid: &Grid, sets: &mut DisjointSets) {
        self.0.retain(|code| {
            let [first, second] = sets.find_both(cells(*code, grid));
            first != second
        });
    }

    /// The pairs with the difference of their sums.
    #[inline(always)]
    fn each(&self, grid: &Grid, mut visit: impl FnMut([usize; 2], u32)) {
        for code in &self.0 {
            let [first, second] = cells(*code, grid);
            let step = grid.sum(first).abs_diff(grid.sum(second));
            visit([first, second], step.into());
        }
    }
}

/// The cells of a pair.
#[inline(always)]
fn cells(code: u32, grid: &Grid) -> [usize; 2] {
    let first = (code >> 1) as usize;
    [
        first,
        first + if code & 1 == 1 { grid.columns() } else { 1 },
    ]
}

/// All pairs of neighbouring cells, each as twice the first one, plus 1 where the second is below
/// it, with the difference of their sums.
#[inline(always)]
fn each_edge(grid: &Grid, mut visit: impl FnMut(u32, u16)) {
    let mut below = grid.rows().skip(1);
    let mut code = 0;
    for row in grid.rows() {
        let below = below.next().unwrap_or_default();
        for (column, sum) in row.iter().enumerate() {
            if let Some(beside) = row.get(column + 1) {
                visit(code, sum.abs_diff(*beside));
            }
            if let Some(below) = below.get(column) {
                visit(code + 1, sum.abs_diff(*below));
            }
            code += 2;
        }
    }
}

/// Joins regions whose border has a step that is little more than those within both. `limits` has
/// the greatest step at which a set may join another.
fn join_similar(edges: &Edges, grid: &Grid, sets: &mut DisjointSets, limits: &mut [u32]) {
    edges.each(grid, |cells, step| {
        let roots = sets.find_both(cells);
        if roots[0] != roots[1] && roots.iter().all(|root| step <= limits[*root]) {
            let [root, _] = sets.join(roots);
            limits[root] = step + STEP / sets.size(root);
        }
    });
}

/// Joins regions of fewer cells than `least` with their neighbours.
fn join_small(edges: &Edges, grid: &Grid, sets: &mut DisjointSets, least: u32) {
    edges.each(grid, |cells, _| {
        let roots = sets.find_both(cells);
        if roots[0] != roots[1] && roots.iter().any(|root| sets.size(*root) < least) {
            sets.join(roots);
        }
    });
}

/// Joins regions of fewer matches than `least` with their neighbours.
fn join_unmatched(
    edges: &Edges,
    grid: &Grid,
    sets: &mut DisjointSets,
    matches: &mut [u32],
    least: u32,
) {
    let mut steps: Vec<([u32; 2], u32)> = Vec::new();
    edges.each(grid, |cells, step| {
        let mut roots = sets.find_both(cells);
        if roots[0] != roots[1] && roots.iter().any(|root| matches[*root] < least) {
            roots.sort_unstable();
            steps.push((roots.map(|root| root as u32), step));
        }
    });
    steps.sort_unstable_by_key(|(roots, _)| *roots);
    let borders = steps.chunk_by(|a, b| a.0 == b.0);
    let mut borders: Vec<(f64, [u32; 2])> = borders
        .map(|steps| {
            let sum: u32 = steps.iter().map(|(_, step)| step).sum();
            (f64::from(sum) / steps.len() as f64, steps[0].0)
        })
        .collect();
    borders.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, roots) in borders {
        let roots = sets.find_both(roots.map(|root| root as usize));
        if roots[0] != roots[1] && roots.iter().any(|root| matches[*root] < least) {
            let [root, other] = sets.join(roots);
            matches[root] += matches[other];
        }
    }
}

#[cfg(test)]
mod tests {
    use ga_image::plane::Plane;

    use super::super::super::view::View;
    use super::*;

    fn grid(width: usize, height: usize, level: impl Fn(usize, usize) -> u8) -> Grid {
        let mut view = View::new(width, height, false);
        let identity = |level: u8| level;
        view.fill(Plane::from_fn(width, height, level).view(), identity, 0);
        let mut grid = Grid::default();
        grid.fill(&view);
        grid
    }

    /// What was found in another picture before makes no difference.
    fn found(grid: &Grid, is_matched: impl Fn([usize; 2]) -> bool) -> Regions {
        let mut other = Grid::default();
        let mut view = View::new(31, 17, false);
        let level = |column, row| (90 * column * row) as u8;
        view.fill(Plane::from_fn(31, 17, level).view(), |level| level, 0);
        other.fill(&view);
        let mut regions = Regions::default();
        regions.find(&other, |[column, _]| column < 9, 1.0);
        regions.find(grid, is_matched, 1.0);
        regions
    }

    /// Levels that vary a little are one region, and a step of more divides.
    #[test]
    fn steps_in_level_divide() {
        let grid = grid(81, 41, |column, row| {
            let texture = (7 * column + 13 * row + column * row) % 6;
            (texture + if column < 40 { 40 } else { 120 }) as u8
        });
        let regions = found(&grid, |_| true);
        assert_eq!(regions.count(), 2);
        let region = |column, row| regions.of_pixel(&grid, column, row);
        assert_eq!(region(0, 0), region(39, 40));
        assert_eq!(region(40, 3), region(80, 40));
        assert_ne!(region(0, 0), region(80, 0));
        assert_eq!(regions.matches(0) + regions.matches(1), 41 * 21);
    }

    /// What is small is larger in large pictures.
    #[test]
    fn small_regions_join_by_the_scale() {
        let is_patch = |column: usize, row: usize| column < 16 && row < 16;
        let grid = grid(
            120,
            80,
            |column, row| if is_patch(column, row) { 200 } else { 60 },
        );
        let mut regions = Regions::default();
        for (scale, count) in [(1.0, 2), (4.0, 1)] {
            regions.find(&grid, |_| true, scale);
            assert_eq!(regions.count(), count, "{scale}");
        }
    }

    /// A region without matches joins the more similar one of its neighbours, and one of few
    /// pixels joins any.
    #[test]
    fn regions_without_matches_join_the_most_similar_neighbour() {
        let levels = [40u8, 100, 130];
        let level = |column: usize, row: usize| {
            let is_dot = column == 10 && row == 10;
            if is_dot { 255 } else { levels[column / 40] }
        };
        let grid = grid(120, 40, level);
        let regions = found(&grid, |[column, _]| column / 40 != 1);
        assert_eq!(regions.count(), 2);
        let region = |column, row| regions.of_pixel(&grid, column, row);
        assert_eq!(region(60, 20), region(100, 20));
        assert_eq!(region(10, 10), region(0, 0));
    }
}

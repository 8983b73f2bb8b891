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

/// A picture in regions.
pub(super) struct Regions {
    labels: Vec<u32>,
    matches: Vec<usize>,
}

impl Regions {
    /// The regions of a picture (P. F. Felzenszwalb and D. P. Huttenlocher, "Efficient graph-based
    /// image segmentation", International Journal of Computer Vision 59, 2004). Small ones join
    /// the neighbour of the most similar level. Then those with few matches join the neighbour
    /// across the border with the least mean step, the least of all borders first. What is small
    /// or few rises with `scale`.
    pub(super) fn new(grid: &Grid, is_matched: impl Fn(usize) -> bool, scale: f64) -> Self {
        let edges = Edges::sorted(grid);
        let mut sets = DisjointSets::new(grid.cells());
        join_similar(&edges, grid, &mut sets);
        join_small(&edges, grid, &mut sets, (LEAST_CELLS * scale) as u32);

        let mut matches = vec![0; grid.cells()];
        for cell in 0..grid.cells() {
            matches[sets.find(cell)] += usize::from(is_matched(cell));
        }
        let least = (LEAST_MATCHES * scale) as usize;
        join_unmatched(&edges, grid, &mut sets, &mut matches, least);
        Self::numbered(&mut sets, &matches)
    }

    fn numbered(sets: &mut DisjointSets, matches: &[usize]) -> Self {
        const NONE: u32 = u32::MAX;
        let mut numbers = vec![NONE; matches.len()];
        let mut of_regions = Vec::new();
        let labels = (0..matches.len()).map(|cell| {
            let root = sets.find(cell);
            if numbers[root] == NONE {
                numbers[root] = of_regions.len() as u32;
                of_regions.push(matches[root]);
            }
            numbers[root]
        });
        Self {
            labels: labels.collect(),
            matches: of_regions,
        }
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

/// The pairs of cells beside and below each other.
struct Edges(Vec<u32>);

impl Edges {
    /// In the order of rising difference, and of cells where these are equal.
    fn sorted(grid: &Grid) -> Self {
        let mut starts = [0; SUMS + 1];
        each_edge(grid, |_, step| starts[usize::from(step) + 1] += 1);
        for step in 0..SUMS {
            starts[step + 1] += starts[step];
        }
        let mut sorted = vec![0; starts[SUMS]];
        each_edge(grid, |code, step| {
            let place = &mut starts[usize::from(step)];
            sorted[*place] = code;
            *place += 1;
        });
        Self(sorted)
    }

    /// The pairs with the difference of their sums.
    #[inline(always)]
    fn each(&self, grid: &Grid, mut visit: impl FnMut([usize; 2], u32)) {
        for code in &self.0 {
            let first = (code >> 1) as usize;
            let second = first + if code & 1 == 1 { grid.columns() } else { 1 };
            let step = grid.sum(first).abs_diff(grid.sum(second));
            visit([first, second], step.into());
        }
    }
}

/// All pairs of neighbouring cells, each as twice the first one, plus 1 where the second is below
/// it, with the difference of their sums.
#[inline(always)]
fn each_edge(grid: &Grid, mut visit: impl FnMut(u32, u16)) {
    let columns = grid.columns();
    for cell in 0..grid.cells() {
        let sum = grid.sum(cell);
        if (cell + 1) % columns != 0 {
            visit(2 * cell as u32, sum.abs_diff(grid.sum(cell + 1)));
        }
        if cell + columns < grid.cells() {
            visit(2 * cell as u32 + 1, sum.abs_diff(grid.sum(cell + columns)));
        }
    }
}

/// Joins regions whose border has a step that is little more than those within both.
fn join_similar(edges: &Edges, grid: &Grid, sets: &mut DisjointSets) {
    let mut limits = vec![STEP; grid.cells()];
    edges.each(grid, |cells, step| {
        let roots = cells.map(|cell| sets.find(cell));
        if roots[0] != roots[1] && roots.iter().all(|root| step <= limits[*root]) {
            let [root, _] = sets.join(roots);
            limits[root] = step + STEP / sets.size(root);
        }
    });
}

/// Joins regions of fewer cells than `least` with their neighbours.
fn join_small(edges: &Edges, grid: &Grid, sets: &mut DisjointSets, least: u32) {
    edges.each(grid, |cells, _| {
        let roots = cells.map(|cell| sets.find(cell));
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
    matches: &mut [usize],
    least: usize,
) {
    let mut steps: Vec<([usize; 2], u32)> = Vec::new();
    edges.each(grid, |cells, step| {
        let mut roots = cells.map(|cell| sets.find(cell));
        if roots[0] != roots[1] && roots.iter().any(|root| matches[*root] < least) {
            roots.sort_unstable();
            steps.push((roots, step));
        }
    });
    steps.sort_unstable_by_key(|(roots, _)| *roots);
    let borders = steps.chunk_by(|a, b| a.0 == b.0);
    let mut borders: Vec<(f64, [usize; 2])> = borders
        .map(|steps| {
            let sum: u32 = steps.iter().map(|(_, step)| step).sum();
            (f64::from(sum) / steps.len() as f64, steps[0].0)
        })
        .collect();
    borders.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, roots) in borders {
        let roots = roots.map(|root| sets.find(root));
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
        Grid::new(&view)
    }

    /// Levels that vary a little are one region, and a step of more divides.
    #[test]
    fn steps_in_level_divide() {
        let grid = grid(81, 41, |column, row| {
            let texture = (7 * column + 13 * row + column * row) % 6;
            (texture + if column < 40 { 40 } else { 120 }) as u8
        });
        let regions = Regions::new(&grid, |_| true, 1.0);
        assert_eq!(regions.count(), 2);
        let region = |column, row| regions.of_pixel(&grid, column, row);
        assert_eq!(region(0, 0), region(39, 40));
        assert_eq!(region(40, 3), region(80, 40));
        assert_ne!(region(0, 0), region(80, 0));
        assert_eq!(regions.matches(0) + regions.matches(1), 41 * 21);
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
        let is_matched = |cell: usize| grid.place(cell)[0] / 40 != 1;
        let regions = Regions::new(&grid, is_matched, 1.0);
        assert_eq!(regions.count(), 2);
        let region = |column, row| regions.of_pixel(&grid, column, row);
        assert_eq!(region(60, 20), region(100, 20));
        assert_eq!(region(10, 10), region(0, 0));
    }
}

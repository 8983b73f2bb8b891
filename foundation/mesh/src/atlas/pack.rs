//! Placing charts in a square so that no two claim the same cell.

use super::chart::{Flat, cross, minus};
use super::mask::{Mask, SLACK};

/// How much work is spent on placing charts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    /// Cells along a side of the grid in which charts are placed, at most.
    cells: usize,
    /// Scales that are tried at most.
    tries: usize,
    /// The search for the scale ends when the largest that fits and the smallest that does not are
    /// in this ratio.
    close: f64,
    /// The orders in which charts are placed; one of them must fit.
    orders: &'static [Order],
}

/// Which charts are placed first.
#[derive(Clone, Copy, Debug)]
enum Order {
    /// Those with the longest side.
    Longest,
    /// Those with the largest area.
    Largest,
    /// Those with the longest shorter side.
    Widest,
}

impl Effort {
    /// Enough for most surfaces.
    pub(super) const QUICK: Self = Self {
        cells: 512,
        tries: 12,
        close: 1.008,
        orders: &[Order::Longest],
    };

    /// For charts that leave much room between them.
    pub(super) const THOROUGH: Self = Self {
        cells: 1024,
        tries: 16,
        close: 1.002,
        orders: &[Order::Longest, Order::Largest, Order::Widest],
    };
}

/// The part of the square that charts and their margins usually fill.
const FILLED: f64 = 0.72;

/// A chart to be placed: its image, in the unit of the surface.
pub(super) struct Item {
    pub(super) places: Vec<Flat>,
    /// The segments of the boundary, with the image to their left.
    pub(super) boundary: Vec<[Flat; 2]>,
}

/// Turns an image so that its bounding rectangle is smallest, the longer side horizontal.
pub(super) fn straighten(places: &mut [Flat]) {
    let hull = hull(places);
    let mut best = (f64::INFINITY, [1.0, 0.0]);
    for (at, &a) in hull.iter().enumerate() {
        let b = hull[(at + 1) % hull.len()];
        let [x, y] = minus(b, a);
        let length = x.hypot(y);
        if length > 0.0 {
            let direction = [x / length, y / length];
            let [w, h] = extent(&hull, direction);
            if w * h < best.0 {
                let lying = if w >= h {
                    direction
                } else {
                    [-direction[1], direction[0]]
                };
                best = (w * h, lying);
            }
        }
    }
    let [c, s] = best.1;
    for place in places {
        *place = [c * place[0] + s * place[1], c * place[1] - s * place[0]];
    }
}

/// The width and the height of points in a frame whose first axis has this direction.
fn extent(points: &[Flat], [c, s]: Flat) -> Flat {
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for [x, y] in points {
        let place = [c * x + s * y, c * y - s * x];
        for axis in 0..2 {
            low[axis] = low[axis].min(place[axis]);
            high[axis] = high[axis].max(place[axis]);
        }
    }
    minus(high, low)
}

/// The convex hull, by Andrew's monotone chain.
fn hull(places: &[Flat]) -> Vec<Flat> {
    let mut sorted = places.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut hull: Vec<Flat> = Vec::new();
    for upper in [false, true] {
        let kept = hull.len();
        let mut add = |point: &Flat| {
            while hull.len() >= kept + 2 {
                let (a, b) = (hull[hull.len() - 2], hull[hull.len() - 1]);
                if cross(minus(b, a), minus(*point, b)) > 0.0 {
                    break;
                }
                hull.pop();
            }
            hull.push(*point);
        };
        if upper {
            sorted.iter().rev().for_each(&mut add);
        } else {
            sorted.iter().for_each(&mut add);
        }
        hull.pop();
    }
    if hull.is_empty() { sorted } else { hull }
}

/// The images of the items in a square of `size` texels, at the largest common scale that was
/// found; `None` if they do not fit at any scale.
///
/// The texels that an item touches, and those within `margin` of them, are its own.
pub(super) fn pack(
    items: &[Item],
    size: u32,
    margin: u32,
    effort: Effort,
) -> Option<Vec<Vec<Flat>>> {
    let cell = (size as usize).div_ceil(effort.cells);
    let grid = size as usize / cell;
    let margin = margin as usize;
    let least = (2 * margin + 1)
        .saturating_pow(2)
        .saturating_mul(items.len());
    if least > (size as usize).pow(2) {
        return None;
    }
    let mut scale = first_scale(items, size as usize, margin);
    let mut best: Option<(f64, Vec<Placed>)> = None;
    let mut too_large = f64::INFINITY;
    for attempt in 0.. {
        let shapes: Vec<[Shape; 4]> = items
            .iter()
            .map(|item| shapes(item, scale, margin, cell))
            .collect();
        let mut orders = effort.orders.iter();
        if let Some(placed) = orders.find_map(|&order| place(&shapes, grid, order)) {
            best = Some((scale, placed));
        } else {
            too_large = scale;
        }
        scale = match &best {
            Some((fits, _)) if attempt >= effort.tries || too_large < effort.close * fits => break,
            Some((fits, _)) if too_large == f64::INFINITY => fits * 1.04,
            Some((fits, _)) => (fits * too_large).sqrt(),
            // Margins may take all the place, however small the charts are.
            None if attempt >= 4 * effort.tries => return None,
            None => scale * if attempt < 8 { 0.96 } else { 0.8 },
        };
    }
    let (scale, placed) = best?;
    let write = |(item, placed): (&Item, Placed)| {
        let offset = [placed.column, placed.row].map(|cells| (cell * cells) as f64);
        let rotated = rotated(&item.places, item, placed.rotation, scale, margin);
        let moved = |place: Flat| [0, 1].map(|axis| place[axis] + offset[axis]);
        rotated.into_iter().map(moved).collect()
    };
    Some(items.iter().zip(placed).map(write).collect())
}

/// The scale at which the items and their margins have a part of the square's area that usually
/// fits.
fn first_scale(items: &[Item], size: usize, margin: usize) -> f64 {
    let (mut area, mut length) = (0.0, 0.0);
    for item in items {
        let [a, l] = extents(item);
        area += a;
        length += l;
    }
    // area s² + border s = texels, with a border of the margin and half a texel.
    let border = length * (margin as f64 + 0.5);
    let texels = FILLED * (size * size) as f64;
    2.0 * texels / (border + (border * border + 4.0 * area * texels).sqrt())
}

/// The area of an image, and the length of its boundary.
fn extents(item: &Item) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for &[a, b] in &item.boundary {
        let [x, y] = minus(b, a);
        sum[0] += 0.5 * cross(a, b);
        sum[1] += x.hypot(y);
    }
    sum
}

/// Where an item lies.
#[derive(Clone, Copy, Debug)]
struct Placed {
    /// Quarter rotations.
    rotation: usize,
    column: usize,
    row: usize,
}

/// The cells of an item in one rotation.
struct Shape {
    mask: Mask,
    /// The rows, those that are likely to collide first.
    order: Vec<u32>,
    /// Some rows with the lengths of their longest runs.
    runs: Vec<(usize, usize)>,
}

/// Places of an item rotated by quarters, scaled, and moved so that the least coordinates of the
/// item are `margin` and a little.
fn rotated(places: &[Flat], item: &Item, rotation: usize, scale: f64, margin: usize) -> Vec<Flat> {
    let turn = |[x, y]: Flat| match rotation {
        0 => [x, y],
        1 => [-y, x],
        2 => [-x, -y],
        _ => [y, -x],
    };
    let mut low = [f64::INFINITY; 2];
    for &[place, _] in &item.boundary {
        let place = turn(place);
        low = [low[0].min(place[0]), low[1].min(place[1])];
    }
    let start = margin as f64 + 2.0 * SLACK;
    let places = places.iter().map(|&place| {
        let place = turn(place);
        [0, 1].map(|axis| (place[axis] - low[axis]) * scale + start)
    });
    places.collect()
}

fn shapes(item: &Item, scale: f64, margin: usize, cell: usize) -> [Shape; 4] {
    std::array::from_fn(|rotation| {
        let ends = item.boundary.as_flattened();
        let ends = rotated(ends, item, rotation, scale, margin);
        let (segments, _) = ends.as_chunks();
        Shape::new(Mask::of_image(segments, margin).coarse(cell))
    })
}

impl Shape {
    fn new(mask: Mask) -> Self {
        // Rows in the order of the bits of their numbers reversed: far apart first.
        let bits = usize::BITS - (mask.height.max(2) - 1).leading_zeros();
        let order = (0..1_u32 << bits)
            .map(|row| row.reverse_bits() >> (u32::BITS - bits))
            .filter(|&row| (row as usize) < mask.height)
            .collect();
        let mut runs: Vec<(usize, usize)> = (0..8)
            .map(|eighth| (mask.height - 1) * eighth / 7)
            .map(|row| (row, mask.longest_run(row, false)))
            .collect();
        runs.sort_by_key(|&(_, length)| std::cmp::Reverse(length));
        Self { mask, order, runs }
    }
}

/// Places all shapes in an order, each as low as it fits and then as far to the left; `None`
/// when one does not fit.
fn place(shapes: &[[Shape; 4]], grid: usize, order: Order) -> Option<Vec<Placed>> {
    let cells: usize = shapes.iter().map(|shapes| shapes[0].mask.count()).sum();
    if cells > grid * grid {
        return None;
    }
    let mut sorted: Vec<usize> = (0..shapes.len()).collect();
    sorted.sort_by_key(|&item| {
        let mask = &shapes[item][0].mask;
        let size = match order {
            Order::Longest => mask.width.max(mask.height),
            Order::Largest => mask.count(),
            Order::Widest => mask.width.min(mask.height),
        };
        (std::cmp::Reverse(size), item)
    });
    let mut square = Square::new(grid);
    let nowhere = Placed {
        rotation: 0,
        column: 0,
        row: 0,
    };
    let mut placed = vec![nowhere; shapes.len()];
    for &item in &sorted {
        let mut best: Option<(usize, Placed)> = None;
        for (rotation, shape) in shapes[item].iter().enumerate() {
            let limit = best.as_ref().map_or(grid, |(top, _)| top - 1);
            if let Some([column, row]) = square.lowest(shape, limit) {
                let place = Placed {
                    rotation,
                    column,
                    row,
                };
                best = Some((row + shape.mask.height, place));
            }
        }
        let (_, place) = best?;
        square.add(&shapes[item][place.rotation], place.column, place.row);
        placed[item] = place;
    }
    Some(placed)
}

/// The cells that are taken.
struct Square {
    taken: Mask,
    /// The longest run of free cells of each row.
    free: Vec<usize>,
}

impl Square {
    fn new(grid: usize) -> Self {
        Self {
            taken: Mask::empty(grid, grid),
            free: vec![grid; grid],
        }
    }

    /// The lowest place, and the leftmost of these, at which a shape ends at or below `limit`.
    fn lowest(&self, shape: &Shape, limit: usize) -> Option<[usize; 2]> {
        let mask = &shape.mask;
        if mask.width > self.taken.width {
            return None;
        }
        let mut hint = 0;
        for row in 0..=limit.checked_sub(mask.height)? {
            if shape
                .runs
                .iter()
                .any(|&(at, run)| self.free[row + at] < run)
            {
                continue;
            }
            let mut column = 0;
            while column + mask.width <= self.taken.width {
                match self.collision(shape, column, row, &mut hint) {
                    Some(next) => column = next,
                    None => return Some([column, row]),
                }
            }
        }
        None
    }

    /// Whether a shape would overlap what is taken; if so, the next column at which the run that
    /// collides would not.
    fn collision(&self, shape: &Shape, column: usize, row: usize, hint: &mut u32) -> Option<usize> {
        if let Some(next) = self.row_collision(&shape.mask, column, row, *hint) {
            return Some(next);
        }
        for &at in &shape.order {
            if let Some(next) = self.row_collision(&shape.mask, column, row, at) {
                *hint = at;
                return Some(next);
            }
        }
        None
    }

    fn row_collision(&self, mask: &Mask, column: usize, row: usize, at: u32) -> Option<usize> {
        let at = (at as usize).min(mask.height - 1);
        let taken = self.taken.row(row + at);
        let (skip, shift) = (column / 64, column % 64);
        let words = mask.row(at);
        for place in (skip..(skip + words.len() + 1).min(taken.len())).rev() {
            let index = place - skip;
            let here = words.get(index).map_or(0, |word| word << shift);
            let before = index.checked_sub(1).map_or(0, |index| words[index]);
            let carried = before.checked_shr(64 - shift as u32).unwrap_or(0);
            let common = (here | carried) & taken[place];
            if common != 0 {
                let last = 64 * place + 63 - common.leading_zeros() as usize;
                return Some(last + 1 - mask.run_start(at, last - column));
            }
        }
        None
    }

    fn add(&mut self, shape: &Shape, column: usize, row: usize) {
        self.taken.add(&shape.mask, [column, row], |_, _| ());
        for row in row..row + shape.mask.height {
            self.free[row] = self.taken.longest_run(row, true);
        }
    }
}

//! Products of the changes of both eyes, block by block and translation by translation.

use ga_image::plane::Plane;
use ga_runtime::batch::{Batch, Work};

/// Columns and rows of a reduced picture: the blocks and the reach of the translations.
pub(super) const SIZE: [usize; 2] = [
    BLOCK[0] * BLOCKS_ACROSS + 2 * REACH[0],
    BLOCK[1] * BLOCKS_DOWN + 2 * REACH[1],
];

/// The farthest translations that are tried, in columns and rows of the reduced picture: 14 % of
/// the width and 3.7 % of the height.
const REACH: [usize; 2] = [14, 2];
const ACROSS: usize = 2 * REACH[0] + 1;
const DOWN: usize = 2 * REACH[1] + 1;
/// The number of translations.
pub(super) const TRANSLATIONS: usize = ACROSS * DOWN;

/// Columns and rows of a block.
const BLOCK: [usize; 2] = [24, 25];
const BLOCKS_ACROSS: usize = 3;
const BLOCKS_DOWN: usize = 2;
/// The number of blocks.
pub(super) const BLOCKS: usize = BLOCKS_ACROSS * BLOCKS_DOWN;

/// A change of this many codes, as root mean square, counts half as much as a great one.
const FLOOR_CODES: f32 = 0.25;

/// The change from one frame to the next in one eye, at most of unit size.
#[derive(Clone, Debug)]
pub(super) struct Change {
    values: Plane<f32>,
    /// Sums of squares above and to the left of each corner.
    squares: Vec<f64>,
    /// The mean square, less than 1.
    pub(super) energy: f32,
}

impl Change {
    /// The difference, divided by its root mean square, to which a floor is added: a cut then
    /// weighs no more than any other frame, and noise of a still picture little.
    pub(super) fn between(before: &Plane<f32>, now: &Plane<f32>) -> Self {
        let mut values = now.clone();
        let mut sum = 0.0_f64;
        for (value, before) in values.values_mut().iter_mut().zip(before.values()) {
            *value -= before;
            sum += f64::from(*value * *value);
        }
        let mean = (sum / (SIZE[0] * SIZE[1]) as f64) as f32;
        let scale = 1.0 / (mean + FLOOR_CODES * FLOOR_CODES).sqrt();
        values.values_mut().iter_mut().for_each(|v| *v *= scale);
        let width = SIZE[0] + 1;
        let mut squares = vec![0.0; width * (SIZE[1] + 1)];
        for (row, line) in values.rows().enumerate() {
            let mut sum = 0.0;
            for (column, value) in line.iter().enumerate() {
                sum += f64::from(value * value);
                let place = (row + 1) * width + column + 1;
                squares[place] = squares[place - width] + sum;
            }
        }
        Self {
            values,
            squares,
            energy: mean * scale * scale,
        }
    }

    /// The sum of squares over the block that begins here.
    fn energy_at(&self, left: usize, top: usize) -> f32 {
        let at = |column: usize, row: usize| self.squares[row * (SIZE[0] + 1) + column];
        let (right, bottom) = (left + BLOCK[0], top + BLOCK[1]);
        let sum = at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
        sum.max(0.0) as f32
    }
}

/// Sums over the frames of a window for one delay: products of the changes of the right eye with
/// those of the left, for each block and each translation of the left picture.
#[derive(Clone, Debug)]
pub(super) struct Products {
    product: Vec<f32>,
    left: Vec<f32>,
    right: [f32; BLOCKS],
}

impl Default for Products {
    fn default() -> Self {
        Self {
            product: vec![0.0; BLOCKS * TRANSLATIONS],
            left: vec![0.0; BLOCKS * TRANSLATIONS],
            right: [0.0; BLOCKS],
        }
    }
}

impl Products {
    pub(super) fn of(left: &Change, right: &Change) -> Self {
        let mut products = Self::default();
        Batch::new().run(Pair {
            left,
            right,
            products: &mut products,
        });
        products
    }

    /// Adds what changes have that are multiplied by these factors, of the left and of the right
    /// eye.
    pub(super) fn add(&mut self, other: &Self, [left, right]: [f32; 2]) {
        let add = |sums: &mut [f32], others: &[f32], factor: f32| {
            for (sum, other) in sums.iter_mut().zip(others) {
                *sum += factor * other;
            }
        };
        add(&mut self.product, &other.product, left * right);
        add(&mut self.left, &other.left, left * left);
        add(&mut self.right, &other.right, right * right);
    }

    /// These sums without a part of them.
    pub(super) fn without(&self, part: &Self) -> Self {
        let rest = |sums: &[f32], parts: &[f32]| {
            let each = sums.iter().zip(parts);
            each.map(|(sum, part)| sum - part).collect()
        };
        Self {
            product: rest(&self.product, &part.product),
            left: rest(&self.left, &part.left),
            right: std::array::from_fn(|block| self.right[block] - part.right[block]),
        }
    }

    /// What the left eye explains of each block.
    pub(super) fn explained(&self) -> [Explained; BLOCKS] {
        let mut explained = [Explained::default(); BLOCKS];
        Batch::new().run(Best {
            products: self,
            explained: &mut explained,
        });
        explained
    }
}

/// What the changes of the left eye explain of those of the right eye in a block.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Explained {
    /// The sum of squares of the right eye.
    pub(super) right: f32,
    /// The part of it that the left eye explains under the translation that explains most, between
    /// whole translations by parabolas.
    pub(super) part: f32,
    /// This translation of the left picture, in columns and rows of the reduced picture.
    pub(super) translation: [f32; 2],
}

struct Best<'a> {
    products: &'a Products,
    explained: &'a mut [Explained; BLOCKS],
}

impl Work for Best<'_> {
    #[inline(always)]
    fn run(self) {
        for (block, explained) in self.explained.iter_mut().enumerate() {
            let place = block * TRANSLATIONS..(block + 1) * TRANSLATIONS;
            let products = self.products.product[place.clone()].iter();
            let right = self.products.right[block];
            let mut all = [0.0_f32; TRANSLATIONS];
            for ((correlation, product), left) in
                all.iter_mut().zip(products).zip(&self.products.left[place])
            {
                let size = left * right;
                let quotient = product / size.max(1e-12).sqrt();
                *correlation = if size > 1e-12 { quotient } else { 0.0 };
            }
            let (mut best, mut greatest) = (0, all[0]);
            for (index, value) in all.iter().enumerate() {
                if *value > greatest {
                    (best, greatest) = (index, *value);
                }
            }
            let (row, column) = (best / ACROSS, best % ACROSS);
            let mut top = greatest;
            let mut translation = [
                column as f32 - REACH[0] as f32,
                row as f32 - REACH[1] as f32,
            ];
            for (axis, step) in [1, ACROSS].into_iter().enumerate() {
                let (at, count) = [(column, ACROSS), (row, DOWN)][axis];
                if (1..count - 1).contains(&at) {
                    let near = [all[best - step], all[best], all[best + step]];
                    let (rise, offset) = parabola(near);
                    top += rise;
                    translation[axis] += offset;
                }
            }
            *explained = Explained {
                right,
                part: right * top.clamp(0.0, 1.0).powi(2),
                translation,
            };
        }
    }
}

/// How far the parabola through three values at equal distances, of which the middle one is the
/// greatest, rises above it, and where.
#[inline(always)]
fn parabola([before, middle, after]: [f32; 3]) -> (f32, f32) {
    let bend = 2.0 * middle - before - after;
    match bend > 1e-9 {
        true => (
            (after - before).powi(2) / (8.0 * bend),
            0.5 * (after - before) / bend,
        ),
        false => (0.0, 0.0),
    }
}

struct Pair<'a> {
    left: &'a Change,
    right: &'a Change,
    products: &'a mut Products,
}

impl Work for Pair<'_> {
    #[inline(always)]
    fn run(self) {
        for block in 0..BLOCKS {
            let start = [
                REACH[0] + BLOCK[0] * (block % BLOCKS_ACROSS),
                REACH[1] + BLOCK[1] * (block / BLOCKS_ACROSS),
            ];
            self.products.right[block] = self.right.energy_at(start[0], start[1]);
            for down in 0..DOWN {
                let top = start[1] + down - REACH[1];
                let first = start[0] - REACH[0];
                let index = block * TRANSLATIONS + down * ACROSS;
                let energies = &mut self.products.left[index..index + ACROSS];
                for (across, energy) in energies.iter_mut().enumerate() {
                    *energy = self.left.energy_at(first + across, top);
                }
                let (left, right) = (&self.left.values, &self.right.values);
                let sums = product(left, [first, top], right, start);
                self.products.product[index..index + ACROSS].copy_from_slice(&sums);
            }
        }
    }
}

/// The sums of products of a block of one plane with blocks of another, each of which begins a
/// column after the one before.
#[inline(always)]
fn product(
    a: &Plane<f32>,
    [a_left, a_top]: [usize; 2],
    b: &Plane<f32>,
    b_start: [usize; 2],
) -> [f32; ACROSS] {
    let mut sums = [0.0; ACROSS];
    for row in 0..BLOCK[1] {
        let a = &a.row(a_top + row)[a_left..a_left + BLOCK[0] + ACROSS - 1];
        let b = &b.row(b_start[1] + row)[b_start[0]..b_start[0] + BLOCK[0]];
        for (near, weight) in a.windows(ACROSS).zip(b) {
            for (sum, value) in sums.iter_mut().zip(near) {
                *sum += weight * value;
            }
        }
    }
    sums
}

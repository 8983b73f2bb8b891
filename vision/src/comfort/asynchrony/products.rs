//! Products of the changes of both eyes, block by block and translation by translation.

use ga_image::plane::Plane;
use ga_runtime::batch::{Batch, Work};

use crate::keyframe::signature::{Sample, box_means};
use crate::video::Samples;

/// Columns and rows of a reduced picture: the blocks and the reach of the translations.
const SIZE: [usize; 2] = [
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
/// Boxes of a frame in all blocks.
pub(super) const CELLS: usize = BLOCKS * BLOCK[0] * BLOCK[1];
/// The number of blocks.
pub(super) const BLOCKS: usize = BLOCKS_ACROSS * BLOCKS_DOWN;

/// A change of this many codes, as root mean square, counts half as much as a great one.
const FLOOR_CODES: f32 = 0.25;

/// The reduced picture: means of luma over boxes, smoothed.
pub(super) fn reduced(samples: &Samples) -> Plane<f32> {
    match samples {
        Samples::Eight(planes) => smoothed(&means(&planes.luma, 1.0)),
        Samples::Ten(planes) => smoothed(&means(&planes.luma, 0.25)),
    }
}

fn means<S: Sample>(luma: &Plane<S>, to_eight: f32) -> Plane<f32> {
    let mut means = box_means(luma.view(), SIZE);
    means.values_mut().iter_mut().for_each(|v| *v *= to_eight);
    means
}

/// Weights 1, 2, 1 along rows and along columns. Interpolation between whole translations needs a
/// picture without the finest detail.
fn smoothed(plane: &Plane<f32>) -> Plane<f32> {
    let along = |plane: &Plane<f32>| {
        Plane::from_fn(plane.width(), plane.height(), |column, row| {
            let values = plane.row(row);
            let before = values[column.saturating_sub(1)];
            let after = values[(column + 1).min(values.len() - 1)];
            0.25 * (before + after) + 0.5 * values[column]
        })
    };
    along(&along(plane).transposed()).transposed()
}

/// The change from one frame to the next in one eye, at most of unit size.
#[derive(Clone, Debug)]
pub(super) struct Change {
    values: Plane<f32>,
    /// Sums of squares above and to the left of each corner.
    squares: Vec<f64>,
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
        Self { values, squares }
    }

    /// The sum of squares over the block that begins here.
    fn energy(&self, left: usize, top: usize) -> f32 {
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

    /// Adds `factor` times the other sums.
    pub(super) fn add(&mut self, other: &Self, factor: f32) {
        for (sums, others) in [
            (&mut self.product[..], &other.product[..]),
            (&mut self.left, &other.left),
            (&mut self.right, &other.right),
        ] {
            for (sum, other) in sums.iter_mut().zip(others) {
                *sum += factor * other;
            }
        }
    }

    /// The sum of squares of the changes of the right eye.
    pub(super) fn energy(&self) -> f32 {
        self.right.iter().sum()
    }

    /// For each block the sum of squares of the right eye, and the part of it that the left one
    /// explains under the translation that explains most, between whole translations by parabolas.
    pub(super) fn explained(&self) -> [[f32; 2]; BLOCKS] {
        std::array::from_fn(|block| {
            let place = block * TRANSLATIONS;
            let (product, left) = (
                &self.product[place..place + TRANSLATIONS],
                &self.left[place..place + TRANSLATIONS],
            );
            let right = self.right[block];
            let correlation = |index: usize| {
                let size = left[index] * right;
                match size > 1e-12 {
                    true => product[index] / size.sqrt(),
                    false => 0.0,
                }
            };
            let all: [f32; TRANSLATIONS] = std::array::from_fn(correlation);
            let best = (0..TRANSLATIONS)
                .reduce(|a, b| if all[b] > all[a] { b } else { a })
                .unwrap_or(0);
            let (row, column) = (best / ACROSS, best % ACROSS);
            let mut top = all[best];
            if (1..ACROSS - 1).contains(&column) {
                top += rise([all[best - 1], all[best], all[best + 1]]);
            }
            if (1..DOWN - 1).contains(&row) {
                top += rise([all[best - ACROSS], all[best], all[best + ACROSS]]);
            }
            [right, right * top.clamp(0.0, 1.0).powi(2)]
        })
    }
}

/// How far the parabola through three values at equal distances rises above the middle one, which
/// is the greatest.
fn rise([before, middle, after]: [f32; 3]) -> f32 {
    let bend = 2.0 * middle - before - after;
    match bend > 1e-9 {
        true => (after - before).powi(2) / (8.0 * bend),
        false => 0.0,
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
            self.products.right[block] = self.right.energy(start[0], start[1]);
            for down in 0..DOWN {
                for across in 0..ACROSS {
                    let place = [start[0] + across - REACH[0], start[1] + down - REACH[1]];
                    let index = block * TRANSLATIONS + down * ACROSS + across;
                    self.products.left[index] = self.left.energy(place[0], place[1]);
                    self.products.product[index] =
                        product(&self.left.values, place, &self.right.values, start);
                }
            }
        }
    }
}

/// The sum of products of a block of one plane with a block of another.
#[inline(always)]
fn product(
    a: &Plane<f32>,
    [a_left, a_top]: [usize; 2],
    b: &Plane<f32>,
    b_start: [usize; 2],
) -> f32 {
    const LANES: usize = 8;
    let mut sums = [0.0_f32; LANES];
    for row in 0..BLOCK[1] {
        let a = &a.row(a_top + row)[a_left..a_left + BLOCK[0]];
        let b = &b.row(b_start[1] + row)[b_start[0]..b_start[0] + BLOCK[0]];
        for (a, b) in a
            .as_chunks::<LANES>()
            .0
            .iter()
            .zip(b.as_chunks::<LANES>().0)
        {
            for lane in 0..LANES {
                sums[lane] += a[lane] * b[lane];
            }
        }
    }
    sums.iter().sum()
}

//! How much two frames differ, block by block.

use ga_image::plane::Plane;
use ga_numerics::order_statistics::{Sorted, median};
use ga_runtime::batch::{Batch, Work};

use super::layout::{COLUMN_EDGES, Layout, ROW_EDGES, Rectangle, without_bars};

/// The greatest factor of brightness from one frame to the next that counts as flicker.
const GREATEST_GAIN: f32 = 1.6;

/// What is added to the standard deviation of a frame, in numbers of 8 bits, so that noise of dark
/// or even frames is not taken for contrast.
const FLOOR: f32 = 2.0;

/// The farthest motion of the camera that is looked for, in boxes of a signature: columns, rows.
const REACH: [i32; 2] = [7, 5];

/// How much two signatures differ.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Difference {
    /// For each block of the layout the mean of |b − g a| over its boxes, divided by the standard
    /// deviation of the frames.
    pub blocks: Vec<f32>,
    /// The factor of brightness g from `a` to `b`.
    pub gain: f32,
    /// The motion of the whole picture from `a` to `b`, in boxes.
    pub motion: [i32; 2],
}

impl Difference {
    /// The median over the blocks: two blocks of five may change or stand still without effect.
    #[must_use]
    pub fn typical(&self) -> f32 {
        median(&mut self.blocks.clone()).unwrap_or(0.0)
    }

    /// The difference of the background: of region 3 of the paper's layout, and the second least
    /// of four corners.
    #[must_use]
    pub fn background(&self, layout: Layout) -> f32 {
        match layout {
            Layout::Paper => self.blocks.get(2).copied().unwrap_or(0.0),
            Layout::Five => {
                let mut corners = self.blocks.get(1..).unwrap_or_default().to_vec();
                let sorted = Sorted::new(&mut corners);
                sorted.map_or(0.0, |corners| corners.quantile(1.0 / 3.0))
            }
        }
    }

    /// The second greatest difference of the four blocks of the background.
    #[must_use]
    pub fn surroundings(&self) -> f32 {
        let mut blocks = self.blocks.get(1..).unwrap_or_default().to_vec();
        Sorted::new(&mut blocks).map_or(0.0, |blocks| blocks.quantile(2.0 / 3.0))
    }

    /// The difference of the region of objects.
    #[must_use]
    pub fn object(&self) -> f32 {
        self.blocks.first().copied().unwrap_or(0.0)
    }
}

/// The difference at the same places.
#[must_use]
pub fn at_rest(a: &Plane<f32>, b: &Plane<f32>, layout: Layout) -> Difference {
    difference(a, b, layout, false)
}

/// The difference after the whole picture was moved by the translation that makes it least.
#[must_use]
pub fn after_motion(a: &Plane<f32>, b: &Plane<f32>, layout: Layout) -> Difference {
    difference(a, b, layout, true)
}

fn difference(a: &Plane<f32>, b: &Plane<f32>, layout: Layout, moving: bool) -> Difference {
    let mut result = Difference {
        blocks: vec![0.0; layout.blocks().len()],
        gain: 1.0,
        motion: [0, 0],
    };
    if let Some(part) = without_bars(a, b) {
        Batch::new().run(Comparison {
            a,
            b,
            part,
            layout,
            moving,
            result: &mut result,
        });
    }
    result
}

struct Comparison<'a> {
    a: &'a Plane<f32>,
    b: &'a Plane<f32>,
    part: Rectangle<usize>,
    layout: Layout,
    moving: bool,
    result: &'a mut Difference,
}

impl Work for Comparison<'_> {
    #[inline(always)]
    fn run(self) {
        let [mean_a, sigma_a] = moments(self.a, self.part);
        let [mean_b, sigma_b] = moments(self.b, self.part);
        let ratio = (mean_b + 0.5) / (mean_a + 0.5);
        let gain = ratio.clamp(1.0 / GREATEST_GAIN, GREATEST_GAIN);
        let gains = [1.0, gain];
        // Brightness that hardly changes needs no second attempt.
        let count = if (gain - 1.0).abs() < 0.01 { 1 } else { 2 };
        let mut best = f32::INFINITY;
        for gain in gains.into_iter().take(count) {
            let motion = if self.moving {
                self.motion(gain)
            } else {
                [0, 0]
            };
            let scale = 1.0 / (0.5 * (gain * sigma_a + sigma_b) + FLOOR);
            let blocks = self.blocks(gain, motion, scale);
            let total: f32 = blocks.iter().sum();
            if total < best {
                best = total;
                *self.result = Difference {
                    blocks,
                    gain,
                    motion,
                };
            }
        }
    }
}

impl Comparison<'_> {
    /// The translation with the least difference: every second box first, then its neighbours.
    #[inline(always)]
    fn motion(&self, gain: f32) -> [i32; 2] {
        let mut best = ([0, 0], self.residual(gain, [0, 0], 2));
        let try_at = |motion: [i32; 2], step: usize, best: &mut ([i32; 2], f32)| {
            let residual = self.residual(gain, motion, step);
            if residual < best.1 {
                *best = (motion, residual);
            }
        };
        for y in (-REACH[1]..=REACH[1]).filter(|y| y % 2 == 0) {
            for x in (-REACH[0]..=REACH[0]).filter(|x| x % 2 == 0) {
                try_at([x, y], 2, &mut best);
            }
        }
        let ([x, y], _) = best;
        let mut fine = ([x, y], self.residual(gain, [x, y], 1));
        for dy in -1..=1 {
            for dx in -1..=1 {
                try_at([x + dx, y + dy], 1, &mut fine);
            }
        }
        // A motion has to explain more than standing still.
        if fine.1 < 0.95 * self.residual(gain, [0, 0], 1) {
            fine.0
        } else {
            [0, 0]
        }
    }

    /// The mean of |b − g a| over the rows `step` apart, where `a` is moved.
    #[inline(always)]
    fn residual(&self, gain: f32, motion: [i32; 2], step: usize) -> f32 {
        let Some((rows, columns)) = self.overlap(motion) else {
            return f32::INFINITY;
        };
        let (mut sum, mut count) = (0.0, 0);
        for row in (rows[0]..rows[1]).step_by(step) {
            let b = &self.b.row(row)[columns[0]..columns[1]];
            let a = moved(self.a, row, columns, motion);
            sum += absolute(a, b, gain);
            count += b.len();
        }
        sum / count.max(1) as f32
    }

    /// The rows and columns of `b` for which the moved `a` has boxes; half of them at least.
    #[inline(always)]
    fn overlap(&self, [x, y]: [i32; 2]) -> Option<([usize; 2], [usize; 2])> {
        let part = self.part;
        let along = |start: usize, end: usize, shift: i32| {
            let (start, end) = (start as i32, end as i32);
            let range = [start.max(start + shift), end.min(end + shift)];
            (2 * (range[1] - range[0]) >= end - start).then(|| range.map(|v| v as usize))
        };
        Some((
            along(part.top, part.bottom, y)?,
            along(part.left, part.right, x)?,
        ))
    }

    #[inline(always)]
    fn blocks(&self, gain: f32, motion: [i32; 2], scale: f32) -> Vec<f32> {
        let count = self.layout.blocks().len();
        let (mut sums, mut counts) = (vec![0.0; count], vec![0.0; count]);
        let Some((rows, columns)) = self.overlap(motion) else {
            return sums;
        };
        let part = self.part;
        let bands = |edges: &[f32], start: usize, end: usize, range: [usize; 2]| {
            let place = |edge: &f32| {
                let at = start as f32 + edge * (end - start) as f32;
                (at.round() as usize).clamp(range[0], range[1])
            };
            edges.iter().map(place).collect::<Vec<usize>>()
        };
        let across = bands(&COLUMN_EDGES, part.left, part.right, columns);
        let down = bands(&ROW_EDGES, part.top, part.bottom, rows);
        for (vertical, band) in down.windows(2).enumerate() {
            let y = 0.5 * (ROW_EDGES[vertical] + ROW_EDGES[vertical + 1]);
            for (horizontal, range) in across.windows(2).enumerate() {
                let x = 0.5 * (COLUMN_EDGES[horizontal] + COLUMN_EDGES[horizontal + 1]);
                let block = self.layout.block_at(x, y);
                for row in band[0]..band[1] {
                    let b = &self.b.row(row)[range[0]..range[1]];
                    let a = moved(self.a, row, [range[0], range[1]], motion);
                    sums[block] += absolute(a, b, gain);
                    counts[block] += b.len() as f32;
                }
            }
        }
        for (sum, count) in sums.iter_mut().zip(&counts) {
            *sum *= scale / f32::max(*count, 1.0);
        }
        sums
    }
}

/// The boxes of `a` that lie over these columns of a row after the motion.
#[inline(always)]
fn moved(a: &Plane<f32>, row: usize, columns: [usize; 2], [x, y]: [i32; 2]) -> &[f32] {
    let [start, end] = columns.map(|column| (column as i32 - x) as usize);
    &a.row((row as i32 - y) as usize)[start..end]
}

#[inline(always)]
fn absolute(a: &[f32], b: &[f32], gain: f32) -> f32 {
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    let mut sums = [0.0_f32; 8];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..8 {
            sums[lane] += (b[lane] - gain * a[lane]).abs();
        }
    }
    let rest = a_rest.iter().zip(b_rest).map(|(a, b)| (b - gain * a).abs());
    sums.iter().sum::<f32>() + rest.sum::<f32>()
}

/// Mean and standard deviation over a part of a signature.
#[must_use]
pub fn moments(signature: &Plane<f32>, part: Rectangle<usize>) -> [f32; 2] {
    let rows = part.top..part.bottom;
    let (mut sum, mut squares) = (0.0_f64, 0.0_f64);
    for row in rows.clone() {
        for value in &signature.row(row)[part.left..part.right] {
            sum += f64::from(*value);
            squares += f64::from(value * value);
        }
    }
    let count = (rows.len() * (part.right - part.left)).max(1) as f64;
    let mean = sum / count;
    [
        mean as f32,
        (squares / count - mean * mean).max(0.0).sqrt() as f32,
    ]
}

/// Sums over a part of two signatures, of 1, a, b, a², a b and b².
pub(super) fn products(a: &Plane<f32>, b: &Plane<f32>, part: Rectangle<usize>) -> [f64; 6] {
    let mut sums = [0.0; 6];
    for row in part.top..part.bottom {
        let columns = part.left..part.right;
        for (a, b) in a.row(row)[columns.clone()].iter().zip(&b.row(row)[columns]) {
            let (a, b) = (f64::from(*a), f64::from(*b));
            let terms = [1.0, a, b, a * a, a * b, b * b];
            let pairs = sums.iter_mut().zip(terms);
            pairs.for_each(|(sum, term)| *sum += term);
        }
    }
    sums
}

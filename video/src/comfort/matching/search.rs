//! The search of a pixel's surroundings in the other view.

use std::ops::Range;

use super::reduced::{RADIUS, Reduced, SIDE};

/// The number of candidates of a row that are correlated at a time.
const BLOCK: usize = 32;

/// The columns and rows of pixels that are candidates.
#[derive(Clone, Debug)]
pub(super) struct Reach {
    pub(super) columns: Range<usize>,
    pub(super) rows: Range<usize>,
}

impl Reach {
    /// The pixels of a view with all of their surroundings at these differences of columns and rows
    /// from a pixel.
    #[inline(always)]
    pub(super) fn around(pixel: [usize; 2], reach: [usize; 2], size: [usize; 2]) -> Self {
        let [columns, rows] = [0, 1].map(|axis| {
            let first = pixel[axis].saturating_sub(reach[axis]).max(RADIUS);
            first..(pixel[axis] + reach[axis] + 1).min(size[axis] - RADIUS)
        });
        Self { columns, rows }
    }
}

/// The best candidate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) pixel: [usize; 2],
    /// Where the correlation is greatest between pixels.
    pub(super) place: [f32; 2],
    pub(super) correlation: f32,
    /// The greatest correlation of candidates that are not neighbours of the best one.
    second: f32,
}

impl Found {
    /// Whether the best candidate is clearly better than others.
    #[inline(always)]
    pub(super) fn is_distinct(&self) -> bool {
        /// The greatest ratio of what is lacking to a correlation of 1.
        const RATIO: f32 = 0.75;
        /// Less than this cannot be told from noise.
        const NOISE: f32 = 0.01;
        (1.0 - self.correlation).max(NOISE) < RATIO * (1.0 - self.second)
    }
}

/// The correlations of candidates, with the memory for them.
#[derive(Clone, Debug, Default)]
pub(super) struct Scores {
    values: Vec<f32>,
    /// The greatest of each row.
    greatest: Vec<f32>,
}

impl Scores {
    /// The best candidate in `target` for the surroundings of a pixel of `source`. `None` where
    /// there are no candidates.
    #[inline(always)]
    pub(super) fn run(
        &mut self,
        source: &Reduced,
        pixel: [usize; 2],
        target: &Reduced,
        reach: Reach,
    ) -> Option<Found> {
        let template = template(source, pixel);
        let (width, height) = (reach.columns.len(), reach.rows.len());
        if width == 0 || height == 0 {
            return None;
        }
        self.values.resize(width * height, 0.0);
        self.greatest.resize(height, 0.0);
        for (row, values) in self.values.chunks_exact_mut(width).enumerate() {
            correlate(
                &template,
                target,
                &reach.columns,
                reach.rows.start + row,
                values,
            );
            self.greatest[row] = greatest(values);
        }
        let (row, best) = first_greatest(&self.greatest)?;
        let (column, _) = first_greatest(&self.values[row * width..][..width])?;
        let mut place = [reach.columns.start + column, reach.rows.start + row].map(|x| x as f32);
        if (1..width - 1).contains(&column) {
            let near = |step: usize| self.values[row * width + column + step - 1];
            place[0] += top([near(0), best, near(2)]);
        }
        if (1..height - 1).contains(&row) {
            let near = |step: usize| self.values[(row + step - 1) * width + column];
            place[1] += top([near(0), best, near(2)]);
        }
        Some(Found {
            pixel: [reach.columns.start + column, reach.rows.start + row],
            place,
            correlation: best,
            second: self.second(width, [column, row]),
        })
    }

    /// The greatest correlation outside the neighbourhood of the best candidate.
    #[inline(always)]
    fn second(&self, width: usize, best: [usize; 2]) -> f32 {
        const AROUND: [usize; 2] = [4, 3];
        let mut second = -1.0_f32;
        for (row, row_greatest) in self.greatest.iter().enumerate() {
            if row.abs_diff(best[1]) > AROUND[1] {
                second = second.max(*row_greatest);
            } else {
                let values = &self.values[row * width..][..width];
                let before = best[0].saturating_sub(AROUND[0]);
                let after = (best[0] + AROUND[0] + 1).min(width);
                second = second
                    .max(greatest(&values[..before]))
                    .max(greatest(&values[after..]));
            }
        }
        second
    }
}

/// The surroundings of a pixel, less their mean, with the norm 1.
#[inline(always)]
fn template(source: &Reduced, [column, row]: [usize; 2]) -> [[f32; SIDE]; SIDE] {
    let mut template = [[0.0; SIDE]; SIDE];
    let mut sum = 0.0;
    for (near, line) in template.iter_mut().enumerate() {
        line.copy_from_slice(&source.levels.row(row + near - RADIUS)[column - RADIUS..][..SIDE]);
        sum += line.iter().sum::<f32>();
    }
    let mean = sum / (SIDE * SIDE) as f32;
    let scale = source.reciprocal_norms.row(row)[column];
    for value in template.as_flattened_mut() {
        *value = (*value - mean) * scale;
    }
    template
}

/// The correlations of a template with the surroundings of pixels of one row.
#[inline(always)]
fn correlate(
    template: &[[f32; SIDE]; SIDE],
    target: &Reduced,
    columns: &Range<usize>,
    row: usize,
    scores: &mut [f32],
) {
    let count = columns.len();
    let rows: [&[f32]; SIDE] = std::array::from_fn(|near| {
        &target.levels.row(row + near - RADIUS)[columns.start - RADIUS..columns.end + RADIUS]
    });
    let norms = &target.reciprocal_norms.row(row)[columns.clone()];
    if count < BLOCK {
        for (index, score) in scores.iter_mut().enumerate() {
            let mut sum = 0.0;
            for (weights, row) in template.iter().zip(rows) {
                for (weight, level) in weights.iter().zip(&row[index..]) {
                    sum += weight * level;
                }
            }
            *score = sum * norms[index];
        }
        return;
    }
    let mut start = 0;
    loop {
        let mut sums = [0.0; BLOCK];
        for (weights, row) in template.iter().zip(rows) {
            let row = &row[start..start + BLOCK + SIDE - 1];
            for (near, weight) in weights.iter().enumerate() {
                for (sum, level) in sums.iter_mut().zip(&row[near..near + BLOCK]) {
                    *sum += weight * level;
                }
            }
        }
        let norms = &norms[start..start + BLOCK];
        let scores = &mut scores[start..start + BLOCK];
        for ((score, sum), norm) in scores.iter_mut().zip(sums).zip(norms) {
            *score = sum * norm;
        }
        if start + BLOCK == count {
            return;
        }
        // The last block overlaps the one before.
        start = (start + BLOCK).min(count - BLOCK);
    }
}

/// The greatest of some numbers, or −1.
#[inline(always)]
fn greatest(values: &[f32]) -> f32 {
    const LANES: usize = 16;
    let (blocks, rest) = values.as_chunks::<LANES>();
    let mut lanes = [-1.0_f32; LANES];
    for block in blocks {
        for (lane, value) in lanes.iter_mut().zip(block) {
            *lane = if *value > *lane { *value } else { *lane };
        }
    }
    lanes.iter().chain(rest).copied().fold(-1.0, f32::max)
}

/// The index and the value of the first greatest number.
#[inline(always)]
fn first_greatest(values: &[f32]) -> Option<(usize, f32)> {
    let most = greatest(values);
    let index = values.iter().position(|value| *value == most)?;
    Some((index, most))
}

/// Where the parabola through three neighbours is greatest, from the middle one.
#[inline(always)]
fn top([before, middle, after]: [f32; 3]) -> f32 {
    let bend = before - 2.0 * middle + after;
    if bend < 0.0 {
        (0.5 * (before - after) / bend).clamp(-0.5, 0.5)
    } else {
        0.0
    }
}

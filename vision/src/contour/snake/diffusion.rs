//! Diffusion with sinks: `(w − μΔ) x = b` on the pixels of a picture.

use crate::contour::ContourError;
use ga_numerics::conjugate_gradient::{self, NotConverged, Options};

/// The equations `wᵢ xᵢ + μ Σⱼ (xᵢ − xⱼ) = bᵢ`, where the pixels j are the two to four neighbours
/// of the pixel i: nothing flows across the border.
///
/// They are solved by conjugate gradients. The preconditioner is a V-cycle of multigrid, whose
/// pixels are twice as large from level to level, with one symmetric sweep of Gauss and Seidel
/// before and after (W. Briggs, V. Henson and S. McCormick, "A Multigrid Tutorial", 2000).
pub(super) struct Diffusion {
    levels: Vec<Level>,
}

struct Level {
    size: [usize; 2],
    /// μ over the square of the pixels' size.
    mu: f64,
    weights: Vec<f64>,
}

impl Diffusion {
    /// For weights that are not negative, of at least 2 × 2 pixels.
    pub(super) fn new(size: [usize; 2], mu: f64, weights: Vec<f64>) -> Self {
        /// The smallest picture has no more pixels in a row or in a column.
        const LEAST: usize = 4;
        let mut levels = vec![Level { size, mu, weights }];
        while let Some(last) = levels.last() {
            if last.size.into_iter().min() <= Some(LEAST) {
                break;
            }
            let next = last.coarser();
            levels.push(next);
        }
        Self { levels }
    }

    pub(super) fn weights(&self) -> &[f64] {
        &self.levels[0].weights
    }

    /// The solution, or the one of mean zero where all weights are zero.
    pub(super) fn solve(&self, right: &[f64]) -> Result<Vec<f64>, ContourError> {
        const OPTIONS: Options = Options {
            steps: 200,
            relative_tolerance: 1e-10,
            absolute_tolerance: 0.0,
        };
        let finest = &self.levels[0];
        let mut solution = vec![0.0; right.len()];
        conjugate_gradient::solve(
            right,
            &mut solution,
            |x, image| finest.image(x, image),
            |residual, improved| improved.copy_from_slice(&self.cycle(0, residual)),
            &OPTIONS,
        )
        .map_err(
            |NotConverged { steps, residual }| ContourError::FlowNotConverged { steps, residual },
        )?;
        if finest.weights.iter().all(|weight| *weight == 0.0) {
            let mean = solution.iter().sum::<f64>() / solution.len() as f64;
            solution.iter_mut().for_each(|value| *value -= mean);
        }
        Ok(solution)
    }

    /// One V-cycle from zero.
    fn cycle(&self, level: usize, right: &[f64]) -> Vec<f64> {
        const SWEEPS_OF_THE_SMALLEST: usize = 20;
        let here = &self.levels[level];
        let mut values = vec![0.0; right.len()];
        let Some(coarser) = self.levels.get(level + 1) else {
            for _ in 0..SWEEPS_OF_THE_SMALLEST {
                here.sweep(&mut values, right, false);
                here.sweep(&mut values, right, true);
            }
            return values;
        };
        here.sweep(&mut values, right, false);
        let mut image = vec![0.0; right.len()];
        here.image(&values, &mut image);
        let rest: Vec<f64> = right.iter().zip(&image).map(|(b, x)| b - x).collect();
        let correction = self.cycle(level + 1, &here.restricted(&rest, coarser.size));
        here.add_enlarged(&correction, coarser.size, &mut values);
        here.sweep(&mut values, right, true);
        values
    }
}

impl Level {
    /// Pixels of twice the size, each with the mean weight of those it covers.
    fn coarser(&self) -> Self {
        let size = self.size.map(|length| length.div_ceil(2));
        let mut sums = vec![[0.0; 2]; size[0] * size[1]];
        for (index, weight) in self.weights.iter().enumerate() {
            let (column, row) = (index % self.size[0], index / self.size[0]);
            let [sum, count] = &mut sums[row / 2 * size[0] + column / 2];
            *sum += weight;
            *count += 1.0;
        }
        Self {
            size,
            mu: self.mu / 4.0,
            weights: sums.into_iter().map(|[sum, count]| sum / count).collect(),
        }
    }

    /// The sum of the neighbours of a pixel, and their number.
    #[inline]
    fn neighbours(&self, values: &[f64], column: usize, row: usize) -> (f64, f64) {
        let [width, height] = self.size;
        let index = row * width + column;
        let (mut sum, mut count) = (0.0, 0.0);
        for (exists, neighbour) in [
            (column > 0, index.wrapping_sub(1)),
            (column + 1 < width, index + 1),
            (row > 0, index.wrapping_sub(width)),
            (row + 1 < height, index + width),
        ] {
            if exists {
                sum += values[neighbour];
                count += 1.0;
            }
        }
        (sum, count)
    }

    /// The left-hand sides of the equations.
    fn image(&self, values: &[f64], image: &mut [f64]) {
        let [width, height] = self.size;
        for row in 0..height {
            for column in 0..width {
                let index = row * width + column;
                let (sum, count) = self.neighbours(values, column, row);
                let flow = self.mu * (count * values[index] - sum);
                image[index] = self.weights[index] * values[index] + flow;
            }
        }
    }

    /// Solves the equation of each pixel for its value, one after the other.
    fn sweep(&self, values: &mut [f64], right: &[f64], backwards: bool) {
        let [width, height] = self.size;
        let mut solve = |column: usize, row: usize| {
            let index = row * width + column;
            let (sum, count) = self.neighbours(values, column, row);
            let diagonal = self.weights[index] + self.mu * count;
            values[index] = (right[index] + self.mu * sum) / diagonal;
        };
        for row in 0..height {
            for column in 0..width {
                if backwards {
                    solve(width - 1 - column, height - 1 - row);
                } else {
                    solve(column, row);
                }
            }
        }
    }

    /// The transpose of the enlargement, a quarter of it: means round the larger pixels.
    fn restricted(&self, values: &[f64], size: [usize; 2]) -> Vec<f64> {
        let mut means = vec![0.0; size[0] * size[1]];
        self.join(size, |index, larger, weight| {
            means[larger] += 0.25 * weight * values[index];
        });
        means
    }

    /// Adds values of larger pixels, bilinear between their centres.
    fn add_enlarged(&self, larger: &[f64], size: [usize; 2], values: &mut [f64]) {
        self.join(size, |index, from, weight| {
            values[index] += weight * larger[from];
        });
    }

    /// Each pixel with the four nearest larger ones and their weights.
    fn join(&self, size: [usize; 2], mut pair: impl FnMut(usize, usize, f64)) {
        /// The nearer and the farther of two larger pixels.
        const WEIGHTS: [f64; 2] = [0.75, 0.25];
        let around = |place: usize, length: usize| {
            let near = place / 2;
            let far = if place.is_multiple_of(2) {
                near.saturating_sub(1)
            } else {
                (near + 1).min(length - 1)
            };
            [near, far]
        };
        for row in 0..self.size[1] {
            let rows = around(row, size[1]);
            for column in 0..self.size[0] {
                let index = row * self.size[0] + column;
                let columns = around(column, size[0]);
                for (row, down) in rows.into_iter().zip(WEIGHTS) {
                    for (column, across) in columns.into_iter().zip(WEIGHTS) {
                        pair(index, row * size[0] + column, down * across);
                    }
                }
            }
        }
    }
}

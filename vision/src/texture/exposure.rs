//! Gains that level the exposures of views.

use nalgebra_035::{DMatrix, DVector};

/// What two views show of the same texels: for each pair of views how many texels both see well,
/// and for each channel the sums of their linear light in the first and in the second view.
pub(super) struct Overlaps {
    views: usize,
    pairs: Vec<[[f64; 2]; 3]>,
    counts: Vec<f64>,
}

/// Channels whose mean is darker than this say nothing about the gain.
const DARKEST: f64 = 1e-4;

impl Overlaps {
    pub(super) fn new(views: usize) -> Self {
        Self {
            views,
            pairs: vec![[[0.0; 2]; 3]; views * views],
            counts: vec![0.0; views * views],
        }
    }

    /// Adds a texel with its colours in the views that see it.
    pub(super) fn add(&mut self, colours: &[(usize, [f32; 3])]) {
        for (place, (a, first)) in colours.iter().enumerate() {
            for (b, second) in &colours[place + 1..] {
                let pair = a * self.views + b;
                self.counts[pair] += 1.0;
                for (sums, (x, y)) in self.pairs[pair].iter_mut().zip(first.iter().zip(second)) {
                    sums[0] += f64::from(*x);
                    sums[1] += f64::from(*y);
                }
            }
        }
    }

    /// How many other views show texels that a view shows.
    pub(super) fn partners(&self, view: usize) -> usize {
        let shared = |other: usize| self.counts[view.min(other) * self.views + view.max(other)];
        (0..self.views).filter(|other| shared(*other) > 0.0).count()
    }

    /// The gain of each view and channel: the factors g of linear light that minimise
    ///
    /// ```text
    /// Σ n_ab (ln g_a Ī_ab − ln g_b Ī_ba)²
    /// ```
    ///
    /// over the pairs of views, with the number n_ab of texels that both see and the mean light
    /// Ī_ab of view a there. What pairs leave open, a common factor of the views that are
    /// connected by overlaps, is chosen so that the geometric mean of their gains is 1 (the
    /// solution of least norm).
    pub(super) fn gains(&self) -> Vec<[f64; 3]> {
        let mut gains = vec![[1.0; 3]; self.views];
        for channel in 0..3 {
            let mut normal = DMatrix::<f64>::zeros(self.views, self.views);
            let mut right = DVector::<f64>::zeros(self.views);
            for a in 0..self.views {
                for b in a + 1..self.views {
                    let pair = a * self.views + b;
                    let count = self.counts[pair];
                    let means = self.pairs[pair][channel].map(|sum| sum / count);
                    // A comparison with NaN, where there are no texels, is false.
                    if !means.iter().all(|mean| *mean > DARKEST) {
                        continue;
                    }
                    let ratio = (means[1] / means[0]).ln();
                    normal[(a, a)] += count;
                    normal[(b, b)] += count;
                    normal[(a, b)] -= count;
                    normal[(b, a)] -= count;
                    right[a] += count * ratio;
                    right[b] -= count * ratio;
                }
            }
            let largest = normal.diagonal().max();
            let Ok(logarithms) = normal.svd(true, true).solve(&right, 1e-9 * largest) else {
                continue;
            };
            for (gain, logarithm) in gains.iter_mut().zip(logarithms.iter()) {
                gain[channel] = logarithm.exp();
            }
        }
        gains
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three views in a row, of which the first and the last have no texel in common, with the
    /// light of the scene times 0.5, 1 and 3: the gains are in inverse proportion, and the product
    /// of all is 1. A fourth view sees nothing of what others see.
    #[test]
    fn factors_are_undone() {
        let factors = [0.5, 1.0, 3.0];
        let mut overlaps = Overlaps::new(4);
        for texel in 1..20 {
            let light = |view: usize| {
                let shown = (0.01 * texel as f64 * factors[view]) as f32;
                (view, [shown, 2.0 * shown, 0.0])
            };
            let first = texel % 2;
            overlaps.add(&[light(first), light(first + 1)]);
        }
        let gains = overlaps.gains();
        let mean = (0.5_f64 * 3.0).cbrt();
        for (gain, factor) in gains.iter().zip(factors) {
            assert!((gain[0] - mean / factor).abs() < 1e-6, "{gain:?}");
            assert!((gain[1] - mean / factor).abs() < 1e-6, "{gain:?}");
            assert_eq!(gain[2], 1.0);
        }
        assert_eq!(gains[3], [1.0; 3]);
        assert_eq!(
            [0, 1, 2, 3].map(|view| overlaps.partners(view)),
            [1, 2, 1, 0]
        );
    }
}

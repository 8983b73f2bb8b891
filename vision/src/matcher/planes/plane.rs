//! The plane that most of the disparities of a region lie on.

use ga_numerics::ransac::{Consensus, Search};

/// Fewer matches do not tell a plane.
const LEAST: usize = 12;
/// Planes whose disparity changes faster than this, in pixels by pixel, are seen almost from the
/// side: a region does not show them.
const STEEPEST: f64 = 0.3;
/// How often the matches that agree are collected anew.
const ROUNDS: usize = 2;

/// A plane in space, as d = a x + b y + c of the pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct DisparityPlane {
    slopes: [f64; 2],
    offset: f64,
    /// The part of the matches that agree with it.
    pub(super) agreement: f64,
}

impl DisparityPlane {
    /// The plane that most of the matches, given by column, row and disparity, are within
    /// `threshold` of.
    pub(super) fn fit(matches: &[[f64; 3]], threshold: f64) -> Option<Self> {
        if matches.len() < LEAST {
            return None;
        }
        let search = Search {
            threshold,
            confidence: 0.99,
            least_samples: 8,
            samples: 30,
            seed: 1,
        };
        let problem = Matches(matches);
        let mut plane = search.run(&problem, 1).pop()?.model;
        for _ in 0..ROUNDS {
            let agreeing = search.inliers(&problem, &plane);
            let agreeing: Vec<[f64; 3]> = agreeing.iter().map(|&k| matches[k]).collect();
            plane = Self::least_squares(&agreeing).unwrap_or(plane);
        }
        plane.agreement = search.inliers(&problem, &plane).len() as f64 / matches.len() as f64;
        Some(plane)
    }

    /// The disparity at a pixel.
    #[inline(always)]
    pub(super) fn at(&self, column: usize, row: usize) -> f64 {
        self.slopes[0] * column as f64 + self.slopes[1] * row as f64 + self.offset
    }

    /// The plane of least squares of the disparities, unless it is too steep or not determined.
    fn least_squares(matches: &[[f64; 3]]) -> Option<Self> {
        let count = matches.len() as f64;
        let mean: [f64; 3] =
            std::array::from_fn(|k| matches.iter().map(|m| m[k]).sum::<f64>() / count);
        let moment = |i: usize, j: usize| -> f64 {
            let products = matches.iter().map(|m| (m[i] - mean[i]) * (m[j] - mean[j]));
            products.sum()
        };
        let [xx, xy, yy] = [moment(0, 0), moment(0, 1), moment(1, 1)];
        let [xd, yd] = [moment(0, 2), moment(1, 2)];
        let determinant = xx * yy - xy * xy;
        let slopes = [
            (xd * yy - yd * xy) / determinant,
            (yd * xx - xd * xy) / determinant,
        ];
        Self::through(mean, slopes)
    }

    /// The plane through a match, unless it is too steep or its slopes are not numbers.
    fn through([column, row, disparity]: [f64; 3], slopes: [f64; 2]) -> Option<Self> {
        let is_flat = slopes.iter().all(|slope| slope.abs() <= STEEPEST);
        is_flat.then(|| Self {
            slopes,
            offset: disparity - slopes[0] * column - slopes[1] * row,
            agreement: 0.0,
        })
    }
}

struct Matches<'a>(&'a [[f64; 3]]);

impl Consensus for Matches<'_> {
    type Model = DisparityPlane;

    const SAMPLE: usize = 3;

    fn count(&self) -> usize {
        self.0.len()
    }

    fn fit(&self, sample: &[usize], models: &mut Vec<DisparityPlane>) {
        let [a, b, c] = [0, 1, 2].map(|k| self.0[sample[k]]);
        let [p, q] = [b, c].map(|m| [m[0] - a[0], m[1] - a[1], m[2] - a[2]]);
        let determinant = p[0] * q[1] - q[0] * p[1];
        let slopes = [
            (p[2] * q[1] - q[2] * p[1]) / determinant,
            (p[0] * q[2] - q[0] * p[2]) / determinant,
        ];
        models.extend(DisparityPlane::through(a, slopes));
    }

    fn squared_error(&self, plane: &DisparityPlane, observation: usize) -> f64 {
        let [column, row, disparity] = self.0[observation];
        let [a, b] = plane.slopes;
        (a * column + b * row + plane.offset - disparity).powi(2)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// The plane is found though a quarter of the matches lie elsewhere.
        #[test]
        fn the_plane_of_most_matches_is_found(
            slopes in [-0.28f64..0.28, -0.28f64..0.28],
            offset in 0.0f64..60.0,
            elsewhere in 3.0f64..40.0,
        ) {
            let on_plane = |x: f64, y: f64| slopes[0] * x + slopes[1] * y + offset;
            let matches: Vec<[f64; 3]> = (0..100u32).map(|k| {
                let [x, y] = [f64::from(k % 10) * 3.0, f64::from(k / 10) * 2.0];
                let off = if k % 4 == 1 { elsewhere + f64::from(k % 7) } else { 0.0 };
                [x, y, on_plane(x, y) + off]
            }).collect();
            let found = DisparityPlane::fit(&matches, 1.0).expect("a plane");
            prop_assert!((found.agreement - 0.75).abs() < 1e-9, "{found:?}");
            prop_assert!((found.at(7, 90) - on_plane(7.0, 90.0)).abs() < 1e-6, "{found:?}");
        }
    }

    #[test]
    fn steep_planes_and_lines_are_none() {
        let matches = |slope: f64, rows: u32| -> Vec<[f64; 3]> {
            let places = (0..20).flat_map(|x| (0..rows).map(move |y| [f64::from(x), f64::from(y)]));
            places.map(|[x, y]| [x, y, slope * x]).collect()
        };
        assert!(DisparityPlane::fit(&matches(0.25, 5), 0.1).is_some());
        assert_eq!(DisparityPlane::fit(&matches(0.35, 5), 0.1), None);
        assert_eq!(DisparityPlane::fit(&matches(0.25, 1), 0.1), None);
        assert_eq!(DisparityPlane::fit(&matches(0.25, 5)[..11], 0.1), None);
    }
}

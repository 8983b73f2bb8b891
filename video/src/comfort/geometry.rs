//! How the right view is displaced, rotated and scaled against the left one.

use nalgebra_035::{SMatrix, SVector};

use super::matching::Match;
use ga_numerics::order_statistics::{Sorted, median};
use ga_numerics::ransac::Search;
use ga_vision::diagnosis::row_model::{RowModel, Rows};
use ga_vision::feature::PixelPair;
use serde::{Deserialize, Serialize};

/// The least number of points that agree, and their least share of all.
const LEAST_POINTS: usize = 12;
const LEAST_SHARE: f64 = 0.4;

/// Points agree whose rows are so near to what a smooth function says, as a share of the columns.
/// At first they may be farther from one of the first degree.
const THRESHOLDS: [f64; 2] = [0.0015, 0.006];

/// How the rows of two views differ.
///
/// If the right camera is displaced vertically, rotated about its axis and has another focal
/// length, then v_left = a u_right + b v_right + c for points at any depth, which is fitted to
/// matches: see [`diagnosis`](ga_vision::diagnosis). Parallax plays no part.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Geometry {
    /// By how many rows the middle of the left view is lower in the right view.
    pub shift_px: f64,
    /// The angle by which the right view is rotated, counter-clockwise as one looks at it, in
    /// degrees; in the picture as it is shown, also where pixels are not square.
    pub rotation_degrees: f64,
    /// By how much the right view is larger, in per cent.
    pub zoom_percent: f64,
    /// What 95 % of the vertical differences of points stay below, in rows.
    ///
    /// The differences are those of a smooth function of the place, of which chance errors of
    /// single matches have no part in it: where they are larger, as in blurred views, it does not
    /// rise. The function is of the second degree where that explains the matches clearly better
    /// than shift, rotation and zoom do, as under the keystone distortion of converging cameras.
    pub deviation_px: f64,
    /// The same in per cent of the picture's width.
    pub deviation_percent: f64,
    /// How many points agree.
    pub agreeing: usize,
    /// How many times a pixel is as high as wide.
    pub pixel_height: f64,
}

/// The geometry of matches of views of this size, and how many columns the row of each match is
/// from what it says: infinitely many where the match does not agree with it. `pixel_height` is how
/// many times a pixel is as high as wide.
pub(super) fn fit(
    matches: &[Match],
    size: [usize; 2],
    pixel_height: f64,
    distances: &mut Vec<f64>,
) -> Option<Geometry> {
    // Lengths are counted in columns, so that angles are those of the picture that is shown.
    let size = [size[0], (pixel_height * size[1] as f64).round() as usize];
    let square = |[u, v]: [f64; 2]| [u, pixel_height * (v + 0.5) - 0.5];
    let shown = matches.iter().map(|found| Match {
        left: square(found.left),
        right: square(found.right),
        deviation: [found.deviation[0], pixel_height * found.deviation[1]],
        ..*found
    });
    let matches = &*shown.collect::<Vec<_>>();
    distances.clear();
    distances.resize(matches.len(), f64::INFINITY);
    let pairs: Vec<PixelPair> = matches
        .iter()
        .map(|found| PixelPair {
            left: found.left,
            right: found.right,
        })
        .collect();
    let mut fit = Fit {
        matches,
        rows: Rows::new(&pairs, size).ok()?,
        enough: (LEAST_SHARE * matches.len() as f64).max(LEAST_POINTS as f64) as usize,
    };
    let [near, far] = THRESHOLDS.map(|share| (share * size[0] as f64).max(1.0).max(pixel_height));
    let search = Search {
        threshold: far,
        confidence: 0.999,
        least_samples: 30,
        samples: 300,
        seed: 1,
    };
    let mut model = search.run(&fit.rows, 1).first()?.model;
    model = fit.refined(model, far)?;
    let second = fit.second_degree(&model, far, size);
    if second.is_none() {
        model = fit.refined(model, near)?;
    }
    let mut differences = Vec::new();
    for (index, distance) in distances.iter_mut().enumerate() {
        let more = second
            .as_ref()
            .map_or(0.0, |second| second.at(&matches[index]));
        let residual = fit.rows.residual(&model, index) + more;
        if residual.abs() < near {
            *distance = residual.abs();
            // The residual is the row of the model in the left view less the measured one.
            let [left, right] = [matches[index].left[1], matches[index].right[1]];
            differences.push((right - left - residual).abs());
        }
    }
    if differences.len() < fit.enough {
        return None;
    }
    let sorted = Sorted::new(&mut differences)?;
    let deviation = sorted.quantile(0.95);
    let geometry = Geometry {
        shift_px: model.vertical_offset() / pixel_height,
        // The model counts from the u axis towards the v axis, which points down.
        rotation_degrees: -model.rotation().to_degrees(),
        zoom_percent: 100.0 * (model.zoom() - 1.0),
        deviation_px: deviation / pixel_height,
        deviation_percent: 100.0 * deviation / size[0] as f64,
        agreeing: sorted.values().len(),
        pixel_height,
    };
    let numbers = [
        geometry.shift_px,
        geometry.rotation_degrees,
        geometry.zoom_percent,
        geometry.deviation_px,
    ];
    numbers.iter().all(|x| x.is_finite()).then_some(geometry)
}

/// Matches and their rows.
struct Fit<'a> {
    matches: &'a [Match],
    rows: Rows,
    /// How many matches must agree.
    enough: usize,
}

impl Fit<'_> {
    /// The model that fits the matches best that are within a threshold of it.
    fn refined(&mut self, mut model: RowModel, threshold: f64) -> Option<RowModel> {
        const STEPS: usize = 5;
        for _ in 0..STEPS {
            let chosen = self.rows.agreeing(&model, threshold);
            if chosen.len() < self.enough {
                return None;
            }
            let spread = self.spread(&model, &chosen);
            for &index in &chosen {
                let residual = self.rows.residual(&model, index);
                let weight = weight(residual, spread, &self.matches[index]);
                self.rows.set_weight(index, weight);
            }
            model = self.rows.fitted(&chosen).filter(RowModel::is_plausible)?;
        }
        Some(model)
    }

    /// The standard deviation of residuals, from the median of their absolute values.
    fn spread(&self, model: &RowModel, chosen: &[usize]) -> f64 {
        let residual = |&index: &usize| self.rows.residual(model, index).abs();
        median_deviation(chosen.iter().map(residual).collect())
    }

    /// What a function of the second degree explains of the rows that the model does not, where it
    /// clearly explains something.
    fn second_degree(
        &self,
        model: &RowModel,
        threshold: f64,
        size: [usize; 2],
    ) -> Option<SecondDegree> {
        const STEPS: usize = 5;
        const LEAST_MATCHES: usize = 40;
        let chosen = self.rows.agreeing(model, threshold);
        if chosen.len() < LEAST_MATCHES {
            return None;
        }
        let mut second = SecondDegree::zero(size);
        // Residuals have the opposite sign of what is to be explained.
        let left = |second: &SecondDegree, index: usize| {
            -self.rows.residual(model, index) - second.at(&self.matches[index])
        };
        for _ in 0..STEPS {
            let residuals = chosen.iter().map(|&index| left(&second, index).abs());
            let spread = median_deviation(residuals.collect());
            let mut moments = SMatrix::<f64, 6, 6>::zeros();
            let mut target = SVector::<f64, 6>::zeros();
            for &index in &chosen {
                let found = &self.matches[index];
                let weight = weight(left(&second, index), spread, found);
                let terms = second.terms(found);
                moments.ger(weight, &terms, &terms, 1.0);
                target.axpy(-weight * self.rows.residual(model, index), &terms, 1.0);
            }
            second.factors = moments.cholesky()?.solve(&target);
        }
        // Twice what the information criterion of Schwarz asks for three more numbers, for errors
        // of the distribution of Laplace, whose scale is the mean of their absolute values.
        let sum = |second: &SecondDegree| -> f64 {
            let cut = |&index: &usize| left(second, index).abs().min(threshold);
            chosen.iter().map(cut).sum()
        };
        let count = chosen.len() as f64;
        let gain = count * (sum(&SecondDegree::zero(size)) / sum(&second)).ln();
        (gain > 3.0 * count.ln()).then_some(second)
    }
}

/// A function of the second degree of the place in the right view.
struct SecondDegree {
    /// Of 1, u, v, uv, u² and v².
    factors: SVector<f64, 6>,
    middle: [f64; 2],
    /// Half of the columns, the unit of u and v.
    scale: f64,
}

impl SecondDegree {
    fn zero(size: [usize; 2]) -> Self {
        Self {
            factors: SVector::zeros(),
            middle: size.map(|side| 0.5 * (side as f64 - 1.0)),
            scale: 0.5 * size[0].max(1) as f64,
        }
    }

    fn terms(&self, found: &Match) -> SVector<f64, 6> {
        let [u, v] = [0, 1].map(|axis| (found.right[axis] - self.middle[axis]) / self.scale);
        SVector::from([1.0, u, v, u * v, u * u, v * v])
    }

    fn at(&self, found: &Match) -> f64 {
        self.factors.dot(&self.terms(found))
    }
}

/// The standard deviation of errors, from the median of their absolute values.
pub(super) fn median_deviation(mut absolute: Vec<f64>) -> f64 {
    const LEAST: f64 = 0.02;
    (1.4826 * median(&mut absolute).unwrap_or(0.0)).max(LEAST)
}

/// The weight of a match: less for uncertain ones, and for those far from the model (S. Geman and
/// D. E. McClure, "Statistical methods for tomographic image reconstruction", 1987).
fn weight(residual: f64, spread: f64, found: &Match) -> f64 {
    let variance = found.deviation[1].powi(2) + spread * spread;
    let distance = residual * residual / (4.0 * variance);
    1.0 / (variance * (1.0 + distance).powi(2))
}

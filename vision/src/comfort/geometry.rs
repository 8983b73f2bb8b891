//! How the right view is displaced, rotated and scaled against the left one.

use nalgebra_035::{SMatrix, SVector};

use super::matching::Match;
use crate::diagnosis::row_model::{RowModel, Rows};
use crate::feature::PixelPair;
use crate::quality::percentile;
use crate::ransac::Search;

/// The least number of points that agree, and their least share of all.
const LEAST_POINTS: usize = 12;
const LEAST_SHARE: f64 = 0.4;

/// How the rows of two views differ.
///
/// If the right camera is displaced vertically, rotated about its axis and has another focal length,
/// then v_left = a u_right + b v_right + c for points at any depth, which is fitted to matches: see
/// [`diagnosis`](crate::diagnosis). Parallax plays no part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geometry {
    /// By how many pixels the middle of the left view is lower in the right view.
    pub shift_px: f64,
    /// The angle by which the right view is rotated, counter-clockwise as one looks at it, in
    /// degrees.
    pub rotation_degrees: f64,
    /// By how much the right view is larger, in per cent.
    pub zoom_percent: f64,
    /// What 95 % of the vertical differences of points stay below, in pixels.
    ///
    /// The differences are those of a smooth function of the place, of which chance errors of
    /// single matches are no part: where they are larger, as in blurred views, it does not rise.
    /// The function is of the second degree where that explains the matches clearly better than
    /// shift, rotation and zoom do, as under the keystone distortion of converging cameras.
    pub deviation_px: f64,
    /// How many points agree.
    pub agreeing: usize,
}

/// The geometry of matches of views of this size, and which of the matches agree with it.
pub(super) fn fit(matches: &[Match], size: [usize; 2], agrees: &mut Vec<bool>) -> Option<Geometry> {
    agrees.clear();
    agrees.resize(matches.len(), false);
    let pairs: Vec<PixelPair> = matches
        .iter()
        .map(|found| PixelPair {
            left: found.left,
            right: found.right,
        })
        .collect();
    let mut rows = Rows::new(&pairs, size).ok()?;
    let threshold = threshold(size);
    let search = Search {
        threshold,
        confidence: 0.999,
        least_samples: 30,
        samples: 300,
        seed: 1,
    };
    let mut model = search.run(&rows, 1).first()?.model;
    let enough = (LEAST_SHARE * matches.len() as f64).max(LEAST_POINTS as f64);
    for _ in 0..5 {
        let chosen = rows.agreeing(&model, threshold);
        if (chosen.len() as f64) < enough {
            return None;
        }
        let spread = spread(&rows, &model, &chosen);
        for &index in &chosen {
            let weight = weight(rows.residual(&model, index), spread, &matches[index]);
            rows.set_weight(index, weight);
        }
        model = rows.fitted(&chosen).filter(RowModel::is_plausible)?;
    }
    let chosen = rows.agreeing(&model, threshold);
    for &index in &chosen {
        agrees[index] = true;
    }
    let geometry = Geometry {
        shift_px: model.vertical_offset(),
        // The model counts from the u axis towards the v axis, which points down.
        rotation_degrees: -model.rotation().to_degrees(),
        zoom_percent: 100.0 * (model.zoom() - 1.0),
        deviation_px: deviation(matches, &chosen, &rows, &model, size)?,
        agreeing: chosen.len(),
    };
    let numbers = [
        geometry.shift_px,
        geometry.rotation_degrees,
        geometry.zoom_percent,
        geometry.deviation_px,
    ];
    numbers.iter().all(|x| x.is_finite()).then_some(geometry)
}

/// Rows that differ by more pixels from the model do not agree.
fn threshold(size: [usize; 2]) -> f64 {
    (0.0015 * size[0] as f64).max(1.0)
}

/// The standard deviation of residuals, from the median of their absolute values.
fn spread(rows: &Rows, model: &RowModel, chosen: &[usize]) -> f64 {
    const LEAST: f64 = 0.02;
    let residuals = chosen
        .iter()
        .map(|&index| rows.residual(model, index).abs());
    let mut residuals: Vec<f64> = residuals.collect();
    residuals.sort_by(f64::total_cmp);
    (1.4826 * percentile(&residuals, 0.5)).max(LEAST)
}

/// The weight of a match: less for uncertain ones, and for those far from the model (S. Geman and
/// D. E. McClure, "Statistical methods for tomographic image reconstruction", 1987).
fn weight(residual: f64, spread: f64, found: &Match) -> f64 {
    let variance = found.deviation[1].powi(2) + spread * spread;
    let distance = residual * residual / (4.0 * variance);
    1.0 / (variance * (1.0 + distance).powi(2))
}

/// The 95th percentile of the absolute vertical differences that a smooth function has at matches.
fn deviation(
    matches: &[Match],
    chosen: &[usize],
    rows: &Rows,
    model: &RowModel,
    size: [usize; 2],
) -> Option<f64> {
    let spread = spread(rows, model, chosen);
    let scale = 0.5 * size[0].max(1) as f64;
    let middle = size.map(|side| 0.5 * (side as f64 - 1.0));
    let terms = |index: usize| {
        let [u, v] = [0, 1].map(|axis| (matches[index].right[axis] - middle[axis]) / scale);
        SVector::<f64, 6>::from([1.0, u, v, u * v, u * u, v * v])
    };
    // The second degree is fitted to what the first one leaves.
    let (mut moments, mut target) = (SMatrix::<f64, 6, 6>::zeros(), SVector::<f64, 6>::zeros());
    for &index in chosen {
        let residual = -rows.residual(model, index);
        let (terms, weight) = (terms(index), weight(residual, spread, &matches[index]));
        moments.ger(weight, &terms, &terms, 1.0);
        target.axpy(weight * residual, &terms, 1.0);
    }
    let second = moments.cholesky().map(|moments| moments.solve(&target));
    let (mut before, mut after) = (0.0, 0.0);
    for &index in chosen {
        let residual = -rows.residual(model, index);
        let left = second.map_or(residual, |second| residual - second.dot(&terms(index)));
        before += weight(residual, spread, &matches[index]) * residual * residual;
        after += weight(residual, spread, &matches[index]) * left * left;
    }
    // Twice what the information criterion of Schwarz asks for three more numbers.
    let count = chosen.len() as f64;
    let is_clear = chosen.len() >= 40 && count * (before / after).ln() > 6.0 * count.ln();
    let second = second.filter(|_| is_clear);
    let mut differences: Vec<f64> = chosen
        .iter()
        .map(|&index| {
            let more = second.map_or(0.0, |second| second.dot(&terms(index)));
            (difference(&matches[index], rows, model, index) - more).abs()
        })
        .collect();
    differences.sort_by(f64::total_cmp);
    Some(percentile(&differences, 0.95))
}

/// The vertical difference that the model has at a match.
fn difference(found: &Match, rows: &Rows, model: &RowModel, index: usize) -> f64 {
    // The residual is the row of the model in the left view less the measured one.
    found.right[1] - (found.left[1] + rows.residual(model, index))
}

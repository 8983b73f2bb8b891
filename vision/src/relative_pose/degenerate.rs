//! Pairs of pixels from which no model can be found.

use super::view::View;
use crate::feature::PixelPair;
use crate::geometry_error::ViewGeometryError;

/// Refuses pixels that are not finite.
pub(super) fn check_finite(pairs: &[PixelPair]) -> Result<(), ViewGeometryError> {
    for (index, pair) in pairs.iter().enumerate() {
        for (view, pixel) in [(View::Left, pair.left), (View::Right, pair.right)] {
            if !pixel.iter().all(|x| x.is_finite()) {
                return Err(ViewGeometryError::NotFinite { pair: index, view });
            }
        }
    }
    Ok(())
}

/// Refuses pixels whose root mean square distance from one line is not above their noise in pixels,
/// or above rounding, and pixels that are near one place for their noise.
pub(super) fn check_lines(pairs: &[PixelPair], noise: f64) -> Result<(), ViewGeometryError> {
    /// Within so many deviations of their noise, pixels seem to determine what they do not.
    const PLACE: f64 = 20.0;
    for view in [View::Left, View::Right] {
        let pixel = |pair: &PixelPair| match view {
            View::Left => pair.left,
            View::Right => pair.right,
        };
        let [along, across] = extents(pairs.iter().map(pixel));
        if across <= noise.max(1e-9 * along) {
            return Err(ViewGeometryError::Collinear {
                view,
                distance: across,
            });
        }
        if along <= PLACE * noise {
            return Err(ViewGeometryError::OnePlace {
                view,
                distance: along.hypot(across),
            });
        }
    }
    Ok(())
}

/// The root mean square distances of pixels from their centroid, along the line that fits best and
/// across it.
fn extents(pixels: impl Iterator<Item = [f64; 2]> + Clone) -> [f64; 2] {
    let count = pixels.clone().count() as f64;
    let sum = pixels
        .clone()
        .fold([0.0; 2], |[a, b], [u, v]| [a + u, b + v]);
    let centre = sum.map(|x| x / count);
    let [mut uu, mut uv, mut vv] = [0.0; 3];
    for [u, v] in pixels {
        let (u, v) = (u - centre[0], v - centre[1]);
        (uu, uv, vv) = (uu + u * u, uv + u * v, vv + v * v);
    }
    let (mean, half) = (0.5 * (uu + vv), (0.5 * (uu - vv)).hypot(uv));
    // The product of the eigenvalues is the determinant, which keeps the digits of the smaller one.
    let largest = mean + half;
    let smallest = match largest > 0.0 {
        true => ((uu * vv - uv * uv) / largest).max(0.0),
        false => 0.0,
    };
    [(largest / count).sqrt(), (smallest / count).sqrt()]
}

/// Whether more pairs agree with one essential matrix than chance explains: the
/// expected number of such agreements among pairs of random pixels is below 1 (L. Moisan and B.
/// Stival, "A probabilistic criterion to detect rigid point matches between two images and estimate
/// the fundamental matrix", International Journal of Computer Vision 57, 2004).
pub(super) fn is_consensus(pairs: &[PixelPair], agreeing: usize, threshold: f64) -> bool {
    const SAMPLE: usize = 5;
    const SOLUTIONS: f64 = 10.0;
    if agreeing == pairs.len() {
        return true;
    }
    if agreeing <= SAMPLE {
        return false;
    }
    let [width, height] = [0, 1].map(|axis| {
        let range = pairs
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], pair| {
                [low.min(pair.right[axis]), high.max(pair.right[axis])]
            });
        range[1] - range[0]
    });
    // A random pixel is within the threshold of an epipolar line: the error is shared by the two
    // views, so that the strip is √2 thresholds wide on either side.
    let strip = 2.0 * std::f64::consts::SQRT_2 * threshold * width.hypot(height);
    let chance = (strip / (width * height)).min(1.0);
    let log_choices = |from: usize, count: usize| -> f64 {
        (0..count)
            .map(|k| ((from - k) as f64 / (count - k) as f64).ln())
            .sum()
    };
    let count = pairs.len();
    let expected = (SOLUTIONS * (count - SAMPLE) as f64).ln()
        + log_choices(count, agreeing)
        + log_choices(agreeing, SAMPLE)
        + (agreeing - SAMPLE) as f64 * chance.ln();
    expected < 0.0
}

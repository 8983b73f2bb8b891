//! The alignment of the surroundings of two features to a fraction of a pixel.

use ga_image::interpolation::bilinear;
use nalgebra_035::{SMatrix, SVector};

use super::Feature;
use super::scale::Scale;

/// The pixels at which two views show one point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PixelPair {
    /// The pixel in the left view.
    pub left: [f64; 2],
    /// The pixel in the right view.
    pub right: [f64; 2],
}

/// Pixels on either side of the middle one.
const RADIUS: i32 = 7;
/// Two coordinates, four coefficients of a linear map, gain and offset.
const UNKNOWNS: usize = 8;

/// The map from surroundings in the left view to those in the right one.
#[derive(Clone, Copy)]
struct Warp {
    centre: [f64; 2],
    /// By rows.
    linear: [[f64; 2]; 2],
    gain: f64,
    offset: f64,
}

/// The pixels of two features after their surroundings have been aligned, or `None` where that
/// fails: where the steps do not converge, go far, or leave surroundings that differ.
///
/// The left place is the middle of a pixel, so that only the right view is interpolated.
pub(super) fn align(
    left_scales: &[Scale],
    left: &Feature,
    right_scales: &[Scale],
    right: &Feature,
) -> Option<PixelPair> {
    const STEPS: usize = 30;
    const FINE: f64 = 0.003;
    /// The greatest distance in pixels that steps may lead away from the feature.
    const FARTHEST: f64 = 3.0;
    const LEAST_CORRELATION: f64 = 0.95;
    let (left_scale, right_scale) = (&left_scales[left.scale], &right_scales[right.scale]);
    let middle = left.place.map(f64::round);
    let patch = Patch::new(left_scale, middle)?;
    // The features say how the surroundings are rotated. Each is in its own scale.
    let (sine, cosine) = (right.angle - left.angle).sin_cos();
    let away = [0, 1].map(|axis| middle[axis] - left.place[axis]);
    let start = [
        right.place[0] + cosine * away[0] - sine * away[1],
        right.place[1] + sine * away[0] + cosine * away[1],
    ];
    let mut warp = Warp {
        centre: start,
        linear: [[cosine, -sine], [sine, cosine]],
        gain: 1.0,
        offset: 0.0,
    };
    for _ in 0..STEPS {
        let (step, correlation) = patch.step(right_scale, &warp)?;
        warp.centre = [warp.centre[0] + step[0], warp.centre[1] + step[1]];
        for (index, change) in step[2..6].iter().enumerate() {
            warp.linear[index / 2][index % 2] += change;
        }
        warp.gain += step[6];
        warp.offset += step[7];
        let moved = (warp.centre[0] - start[0]).hypot(warp.centre[1] - start[1]);
        let [[a, b], [c, d]] = warp.linear;
        let determinant = a * d - b * c;
        if moved > FARTHEST || !(0.3..3.0).contains(&determinant) {
            return None;
        }
        if step[0].hypot(step[1]) < FINE {
            let pair = PixelPair {
                left: left_scale.to_view(middle),
                right: right_scale.to_view(warp.centre),
            };
            return (correlation > LEAST_CORRELATION).then_some(pair);
        }
    }
    None
}

/// The surroundings of a place in the left view.
struct Patch {
    values: Vec<f64>,
}

impl Patch {
    fn new(scale: &Scale, middle: [f64; 2]) -> Option<Self> {
        let [column, row] = middle.map(|x| x as usize);
        let radius = RADIUS as usize;
        let side = 2 * radius + 1;
        let view = scale.smooth.view();
        let part = view.part(
            column.checked_sub(radius)?,
            row.checked_sub(radius)?,
            side,
            side,
        )?;
        let values = part.rows().flatten().map(|value| f64::from(*value));
        Some(Self {
            values: values.collect(),
        })
    }

    /// A step of Gauss and Newton's method for `gain · left + offset = right`, and the correlation
    /// of the surroundings before it. `None` where these leave the right view or are flat.
    fn step(&self, scale: &Scale, warp: &Warp) -> Option<([f64; UNKNOWNS], f64)> {
        let plane = &scale.smooth;
        let [width, height] = [plane.width(), plane.height()].map(|side| side as f64);
        let mut matrix = SMatrix::<f64, UNKNOWNS, UNKNOWNS>::zeros();
        let mut gradient = SVector::<f64, UNKNOWNS>::zeros();
        let (mut sums, mut squares, mut product) = ([0.0; 2], [0.0; 2], 0.0);
        let offsets = (-RADIUS..=RADIUS).flat_map(|y| (-RADIUS..=RADIUS).map(move |x| [x, y]));
        for ([x, y], left) in offsets.map(|o| o.map(f64::from)).zip(&self.values) {
            let [[a, b], [c, d]] = warp.linear;
            let [u, v] = [
                warp.centre[0] + a * x + b * y,
                warp.centre[1] + c * x + d * y,
            ];
            let is_inside = u >= 1.0 && v >= 1.0 && u < width - 3.0 && v < height - 3.0;
            if !is_inside {
                return None;
            }
            let value = |du: f64, dv: f64| bilinear(plane, [u + du, v + dv]);
            let right = value(0.0, 0.0)?;
            let du = 0.5 * (value(1.0, 0.0)? - value(-1.0, 0.0)?);
            let dv = 0.5 * (value(0.0, 1.0)? - value(0.0, -1.0)?);
            // Less towards the edge, so that the middle counts.
            let weight = (-(x * x + y * y) / f64::from(RADIUS * RADIUS)).exp();
            let residual = right - (warp.gain * left + warp.offset);
            let row = SVector::<f64, UNKNOWNS>::from([
                du,
                dv,
                du * x,
                du * y,
                dv * x,
                dv * y,
                -left,
                -1.0,
            ]);
            matrix.ger(weight, &row, &row, 1.0);
            gradient.axpy(weight * residual, &row, 1.0);
            for (k, value) in [*left, right].into_iter().enumerate() {
                sums[k] += value;
                squares[k] += value * value;
            }
            product += left * right;
        }
        let count = self.values.len() as f64;
        let spread = |k: usize| squares[k] - sums[k] * sums[k] / count;
        let correlation = (product - sums[0] * sums[1] / count) / (spread(0) * spread(1)).sqrt();
        let step = matrix.cholesky()?.solve(&-gradient);
        let step: [f64; UNKNOWNS] = step.into();
        (step.iter().all(|x| x.is_finite()) && correlation.is_finite())
            .then_some((step, correlation))
    }
}

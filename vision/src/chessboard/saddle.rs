//! Where the brightness of a picture has saddle points: what the inner corners of a chessboard are.
//!
//! The determinant of the second derivatives is that of P. R. Beaudet, "Rotationally invariant
//! image operators", 1978; it is negative at a saddle point. The examination on a circle is our
//! own.

use ga_image::filter::{Border, Gaussian};
use ga_image::interpolation::bilinear;
use ga_image::plane::{Plane, PlaneError};
use ga_runtime::vga2::Vector;

/// The standard deviation in pixels of the blur before derivatives are taken.
const SIGMA: f64 = 1.5;
/// The least strength of a saddle point, as a part of the greatest in the picture.
const LEAST_STRENGTH: f32 = 0.02;
/// As many saddle points are considered, and more only for a board with more than half as many
/// corners.
const MOST: usize = 3000;
/// The radius in pixels of the circle around a saddle point on which the brightness is examined.
const RING_RADIUS: f64 = 3.5;
/// Places on that circle.
const RING: usize = 24;

/// A saddle point of the brightness, with the two edges that cross there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Saddle {
    /// Where it is, in pixels.
    pub(super) place: Vector<f64>,
    /// Unit vectors along the edges. The quadrants between them and between their negatives are
    /// bright, and the second is at an angle of 0 to 180° from the first, from u to v.
    pub(super) edges: [Vector<f64>; 2],
    /// The root of the negative determinant of the second derivatives.
    pub(super) strength: f64,
}

/// The saddle points of a picture in which a board has a number of corners, the strongest first.
pub(super) fn saddles(picture: &Plane<f32>, corners: usize) -> Result<Vec<Saddle>, PlaneError> {
    let smooth = Gaussian::new(SIGMA)?.blur(picture, Border::Mirror);
    let strengths = strengths(&smooth);
    let greatest = strengths.values().iter().fold(0.0_f32, |a, b| a.max(*b));
    let least = LEAST_STRENGTH * greatest;
    let mut found = Vec::new();
    let margin = RING_RADIUS.ceil() as usize + 1;
    for row in margin..smooth.height().saturating_sub(margin) {
        let (above, here, below) = (
            strengths.row(row - 1),
            strengths.row(row),
            strengths.row(row + 1),
        );
        for column in margin..smooth.width().saturating_sub(margin) {
            let strength = here[column];
            if strength <= least || strength <= here[column - 1] || strength < here[column + 1] {
                continue;
            }
            let around = column - 1..=column + 1;
            let is_greatest = above[around.clone()].iter().all(|s| *s < strength)
                && below[around].iter().all(|s| *s <= strength);
            if is_greatest && let Some(saddle) = saddle(&smooth, column, row) {
                found.push(saddle);
            }
        }
    }
    // The order of rows and columns decides between equal strengths.
    found.sort_by(|a: &Saddle, b| b.strength.total_cmp(&a.strength));
    found.truncate(MOST.max(2 * corners));
    Ok(found)
}

/// The root of `f_xy² − f_xx f_yy` where that is positive, and 0 elsewhere and at the border.
fn strengths(smooth: &Plane<f32>) -> Plane<f32> {
    let mut strengths = Plane::filled(smooth.width(), smooth.height(), 0.0);
    for row in 1..smooth.height().saturating_sub(1) {
        let (above, here, below) = (smooth.row(row - 1), smooth.row(row), smooth.row(row + 1));
        let result = strengths.row_mut(row);
        for column in 1..smooth.width().saturating_sub(1) {
            let (left, right) = (column - 1, column + 1);
            let xx = here[left] - 2.0 * here[column] + here[right];
            let yy = above[column] - 2.0 * here[column] + below[column];
            let xy = 0.25 * (above[left] - above[right] - below[left] + below[right]);
            result[column] = (xy * xy - xx * yy).max(0.0).sqrt();
        }
    }
    strengths
}

/// The saddle point next to a pixel: of the quadratic function with the derivatives there. `None`
/// where it lies elsewhere, or where the brightness around it does not change four times between
/// bright and dark.
fn saddle(smooth: &Plane<f32>, column: usize, row: usize) -> Option<Saddle> {
    let value = |dx: isize, dy: isize| {
        let at = smooth.row(row.wrapping_add_signed(dy));
        f64::from(at[column.wrapping_add_signed(dx)])
    };
    let gradient = [
        0.5 * (value(1, 0) - value(-1, 0)),
        0.5 * (value(0, 1) - value(0, -1)),
    ];
    let xx = value(-1, 0) - 2.0 * value(0, 0) + value(1, 0);
    let yy = value(0, -1) - 2.0 * value(0, 0) + value(0, 1);
    let xy = 0.25 * (value(-1, -1) - value(1, -1) - value(-1, 1) + value(1, 1));
    let determinant = xx * yy - xy * xy;
    if determinant >= 0.0 {
        return None;
    }
    let offset = Vector::new(
        (xy * gradient[1] - yy * gradient[0]) / determinant,
        (xy * gradient[0] - xx * gradient[1]) / determinant,
    );
    if offset.length().is_nan() || offset.length() >= 1.5 {
        return None;
    }
    let place = Vector::new(column as f64, row as f64) + offset;
    // The greater second derivative is that across the dark to the bright quadrants: along its
    // direction at the angle φ it is greatest, and it vanishes at φ ± t.
    let half_difference = (0.5 * (xx - yy)).hypot(xy);
    let mean = 0.5 * (xx + yy);
    let (greatest, least) = (mean + half_difference, mean - half_difference);
    let bright = 0.5 * (2.0 * xy).atan2(xx - yy);
    let opening = (greatest / -least).sqrt().atan();
    let unit = |angle: f64| Vector::new(angle.cos(), angle.sin());
    let saddle = Saddle {
        place,
        edges: [unit(bright - opening), unit(bright + opening)],
        strength: (-determinant).sqrt(),
    };
    changes_four_times(smooth, place).then_some(saddle)
}

/// Whether the brightness on a circle around a saddle point crosses that of its centre four times.
fn changes_four_times(smooth: &Plane<f32>, place: Vector<f64>) -> bool {
    let Some(centre) = bilinear(smooth, place.coordinates()) else {
        return false;
    };
    let mut is_bright = [false; RING];
    for (k, bright) in is_bright.iter_mut().enumerate() {
        let angle = std::f64::consts::TAU * k as f64 / RING as f64;
        let around = place + Vector::new(angle.cos(), angle.sin()) * RING_RADIUS;
        let Some(value) = bilinear(smooth, around.coordinates()) else {
            return false;
        };
        *bright = value > centre;
    }
    let changes = (0..RING).filter(|&k| is_bright[k] != is_bright[(k + 1) % RING]);
    changes.count() == 4
}

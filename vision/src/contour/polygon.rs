//! Closed polygons, given by their corners.

use ga_runtime::cga2::Point;
use ga_runtime::vga2::Vector;

/// The area that a closed polygon encloses, positive where its corners run clockwise as seen in the
/// picture, whose v axis points down: ½ Σ xᵢ∧xᵢ₊₁ = ½ Σ (uᵢ vᵢ₊₁ − uᵢ₊₁ vᵢ). Not a number where a
/// corner is not.
///
/// ```
/// use ga_vision::contour::{perimeter, signed_area};
///
/// let rectangle = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
/// assert_eq!(signed_area(&rectangle), 12.0);
/// assert_eq!(perimeter(&rectangle), 14.0);
/// ```
#[must_use]
pub fn signed_area(corners: &[[f64; 2]]) -> f64 {
    // Products of differences from one corner are exact for more numbers than those of places.
    let origin = corners.first().copied().unwrap_or_default();
    let sum: f64 = edges(corners).map(|edge| doubled_area(edge, origin)).sum();
    sum / 2.0
}

/// The length of a closed polygon. Not a number where a corner is not.
#[must_use]
pub fn perimeter(corners: &[[f64; 2]]) -> f64 {
    edges(corners).map(|(a, b)| distance(a, b)).sum()
}

/// The centre of gravity of the area of a closed polygon, or `None` where it has no area: where the
/// sum of the areas along its edges is within their rounding errors and those of the corners.
///
/// ```
/// use ga_vision::contour::centroid;
///
/// let triangle = [[0.0, 0.0], [6.0, 0.0], [0.0, 3.0]];
/// assert_eq!(centroid(&triangle), Some([2.0, 1.0]));
/// assert_eq!(centroid(&[[0.1, 0.3], [0.2, 0.6], [0.7, 2.1]]), None);
/// ```
#[must_use]
pub fn centroid(corners: &[[f64; 2]]) -> Option<[f64; 2]> {
    let origin = *corners.first()?;
    let (mut doubled, mut products) = (0.0, 0.0);
    let mut sums = [0.0; 2];
    for (a, b) in edges(corners) {
        let weight = doubled_area((a, b), origin);
        doubled += weight;
        let [p, q] = [a, b].map(|corner| [0, 1].map(|k| corner[k] - origin[k]));
        products += (p[0] * q[1]).abs() + (p[1] * q[0]).abs();
        for axis in 0..2 {
            sums[axis] += weight * (p[axis] + q[axis]);
        }
    }
    let coordinates = corners.as_flattened().iter();
    let size = coordinates.fold(0.0f64, |size, x| size.max(x.abs()));
    let rounding = 4.0 * f64::EPSILON * (products + size * perimeter(corners));
    if doubled.is_nan() || doubled.abs() <= rounding {
        return None;
    }
    let centre = [0, 1].map(|axis| origin[axis] + sums[axis] / (3.0 * doubled));
    centre.iter().all(|x| x.is_finite()).then_some(centre)
}

/// `count` points at equal distances along a closed polygon, from its first corner on. Empty where
/// the polygon has no length, or none that is finite.
///
/// ```
/// use ga_vision::contour::resampled;
///
/// let rectangle = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]];
/// let points = [[0.0, 0.0], [3.0, 0.0], [4.0, 2.0], [1.0, 2.0]];
/// assert_eq!(resampled(&rectangle, 4), points);
/// ```
#[must_use]
pub fn resampled(corners: &[[f64; 2]], count: usize) -> Vec<[f64; 2]> {
    let length = perimeter(corners);
    if !(length > 0.0 && length.is_finite()) {
        return Vec::new();
    }
    let mut points = Vec::with_capacity(count);
    let mut before = 0.0;
    for (a, b) in edges(corners) {
        let edge = distance(a, b);
        while points.len() < count {
            let along = length * points.len() as f64 / count as f64 - before;
            if along >= edge {
                break;
            }
            points.push(
                Point::from(a)
                    .lerp(Point::from(b), along / edge)
                    .coordinates(),
            );
        }
        before += edge;
    }
    // Rounding may leave the last place behind the end of the last edge.
    points.resize(count, corners[0]);
    points
}

/// The distance of a closed polygon from a point, and the nearest point of the polygon.
pub(super) fn distance_to(corners: &[[f64; 2]], point: [f64; 2]) -> (f64, [f64; 2]) {
    let mut best = (f64::INFINITY, point);
    for (a, b) in edges(corners) {
        let [along, across] = [b, point].map(|end| way(a, end));
        let square = along.norm_squared();
        let share = (along | across) / square;
        // An edge without a length has its place as the nearest one.
        let part = if square > 0.0 {
            share.clamp(0.0, 1.0)
        } else {
            0.0
        };
        let nearest = (Vector::from(a) + along * part).coordinates();
        let found = distance(nearest, point);
        if found < best.0 {
            best = (found, nearest);
        }
    }
    best
}

fn edges(corners: &[[f64; 2]]) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().copied().zip(next.copied())
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    Point::from(a).distance(Point::from(b))
}

/// Twice the area of the triangle of an origin and an edge.
fn doubled_area((a, b): ([f64; 2], [f64; 2]), origin: [f64; 2]) -> f64 {
    (way(origin, a) ^ way(origin, b)).e12
}

fn way(from: [f64; 2], to: [f64; 2]) -> Vector<f64> {
    Vector::from(to) - Vector::from(from)
}

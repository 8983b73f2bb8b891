//! Closed polygons, given by their corners.

use ga_runtime::cga2::Point;

/// The area that a closed polygon encloses, positive where its corners run clockwise as seen in the
/// picture, whose v axis points down: ½ Σ (uᵢ vᵢ₊₁ − uᵢ₊₁ vᵢ).
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
    let sum: f64 = edges(corners).map(|(a, b)| cross(a, b, origin)).sum();
    sum / 2.0
}

/// The length of a closed polygon.
#[must_use]
pub fn perimeter(corners: &[[f64; 2]]) -> f64 {
    edges(corners).map(|(a, b)| distance(a, b)).sum()
}

/// The centre of gravity of the area of a closed polygon, or `None` where it has no area.
#[must_use]
pub fn centroid(corners: &[[f64; 2]]) -> Option<[f64; 2]> {
    let origin = *corners.first()?;
    let area = signed_area(corners);
    let mut sums = [0.0; 2];
    for (a, b) in edges(corners) {
        let weight = cross(a, b, origin);
        for axis in 0..2 {
            sums[axis] += weight * (a[axis] + b[axis] - 2.0 * origin[axis]);
        }
    }
    let centre = [0, 1].map(|axis| origin[axis] + sums[axis] / (6.0 * area));
    centre.iter().all(|x| x.is_finite()).then_some(centre)
}

/// `count` points at equal distances along a closed polygon, from its first corner on. Empty where
/// the polygon has no length.
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
        let [along, across] = [b, point].map(|p| [p[0] - a[0], p[1] - a[1]]);
        let square = along[0] * along[0] + along[1] * along[1];
        let share = (along[0] * across[0] + along[1] * across[1]) / square;
        // An edge without a length has its place as the nearest one.
        let part = if square > 0.0 {
            share.clamp(0.0, 1.0)
        } else {
            0.0
        };
        let nearest = [a[0] + part * along[0], a[1] + part * along[1]];
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

fn cross(a: [f64; 2], b: [f64; 2], origin: [f64; 2]) -> f64 {
    let [a, b] = [a, b].map(|p| [p[0] - origin[0], p[1] - origin[1]]);
    a[0] * b[1] - a[1] * b[0]
}

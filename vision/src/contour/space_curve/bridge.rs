//! Stretches of a curve on the planes of their neighbours.

use crate::contour::ContourError;
use ga_runtime::geometry::ray::Ray;
use ga_runtime::vga3::Vector;
use nalgebra_035::{Matrix3, Vector3};

/// The distances along rays, with those that are missing from planes through both ends of the
/// stretch.
///
/// A plane `n·x = 1`, with the rays' origin as that of x, meets the ray of direction d at the
/// distance `1/(n·d)`: the reciprocals of distances are linear in the directions. The plane is
/// fitted to as many points on either side as are missing; the difference that is left at the ends
/// is spread over the stretch. Where that is not in front of the camera, because few points with
/// their errors give the plane, the stretch is straight.
pub(super) fn bridge(
    rays: &[Ray<f64>],
    distances: &[Option<f64>],
) -> Result<Vec<f64>, ContourError> {
    let count = rays.len();
    let known = |index: usize| distances[index % count].map(f64::recip);
    let direction = |index: usize| Vector::from(rays[index % count].direction());
    let mut bridged: Vec<f64> = distances.iter().map(|d| d.unwrap_or(f64::NAN)).collect();
    let Some(first) = distances.iter().position(Option::is_some) else {
        return Ok(bridged);
    };
    let mut index = first;
    while index < first + count {
        if known(index).is_some() {
            index += 1;
            continue;
        }
        let length = (index..).take_while(|k| known(*k).is_none()).count();
        // The stretch is after the known point `before` and before the known point `after`.
        let ends = [index + count - 1, index + length];
        let reciprocals = ends.map(|end| known(end).unwrap_or(0.0));
        let plane = plane(length, ends, count, known, direction);
        let rests = [0, 1].map(|k| reciprocals[k] - plane.dot(direction(ends[k])));
        let curved = |missing: usize, part: f64| {
            plane.dot(direction(missing)) + rests[0] + part * (rests[1] - rests[0])
        };
        // Reciprocals of depths along an axis are linear along a straight line in a picture.
        let axis = direction(ends[0]) + direction(ends[1]);
        let depths = [0, 1].map(|k| reciprocals[k] / axis.dot(direction(ends[k])));
        let straight = |missing: usize, part: f64| {
            axis.dot(direction(missing)) * (depths[0] + part * (depths[1] - depths[0]))
        };
        let part = |missing: usize| (missing + 1 - index) as f64 / (length + 1) as f64;
        let is_in_front = |reciprocal: f64| reciprocal > 0.0 && reciprocal.recip().is_finite();
        let is_curved = (index..ends[1]).all(|k| is_in_front(curved(k, part(k))));
        for missing in index..ends[1] {
            let reciprocal = if is_curved {
                curved(missing, part(missing))
            } else {
                straight(missing, part(missing))
            };
            let index = missing % count;
            if !is_in_front(reciprocal) {
                return Err(ContourError::NotBridged { index });
            }
            bridged[index] = reciprocal.recip();
        }
        index = ends[1];
    }
    Ok(bridged)
}

/// The plane n through known points on both sides of a stretch of `length` points.
fn plane(
    length: usize,
    [before, after]: [usize; 2],
    count: usize,
    known: impl Fn(usize) -> Option<f64>,
    direction: impl Fn(usize) -> Vector<f64>,
) -> Vector<f64> {
    /// The least number of points on either side.
    const LEAST: usize = 4;
    /// Directions in which the points spread less, relative to the greatest, say nothing.
    const LEAST_SPREAD: f64 = 1e-12;
    let wanted = length.max(LEAST);
    let backwards = (0..count).map(|k| before + count - k);
    let forwards = (0..count).map(|k| after + k);
    let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
    let mut add = |index: usize| {
        if let Some(reciprocal) = known(index) {
            let row = Vector3::from(direction(index).coordinates());
            normal += row * row.transpose();
            right += row * reciprocal;
        }
    };
    backwards
        .filter(|index| known(*index).is_some())
        .take(wanted)
        .for_each(&mut add);
    forwards
        .filter(|index| known(*index).is_some())
        .take(wanted)
        .for_each(&mut add);
    let eigen = normal.symmetric_eigen();
    let least = LEAST_SPREAD * eigen.eigenvalues.max();
    let mut found = Vector3::zeros();
    for (value, axis) in eigen
        .eigenvalues
        .iter()
        .zip(eigen.eigenvectors.column_iter())
    {
        if *value > least {
            found += axis * (axis.dot(&right) / value);
        }
    }
    Vector::from([found.x, found.y, found.z])
}

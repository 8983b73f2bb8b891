//! Lines and circles as sequences of points.

use crate::vector3::{Vector3, along, difference, dot, length, normalized, on_circle};

/// How far lines and planes reach from the middle of the picture.
pub(super) const REACH: f64 = 1.15;

/// The middle of a line's part within reach, and half its length.
pub(super) fn clipped(point: Vector3, direction: Vector3) -> (Vector3, f64) {
    let middle = along(point, direction, -dot(point, direction));
    let half = (REACH * REACH - dot(middle, middle)).max(0.1).sqrt();
    (middle, half)
}

pub(super) fn segment(from: Vector3, to: Vector3, pieces: u32) -> Vec<Vector3> {
    let step = difference(to, from);
    let place = |k| match k {
        _ if k == pieces => to,
        _ => along(from, step, f64::from(k) / f64::from(pieces)),
    };
    (0..=pieces).map(place).collect()
}

/// A circle, its first point also the last.
pub(super) fn ring(centre: Vector3, basis: [Vector3; 2], radius: f64, pieces: u32) -> Vec<Vector3> {
    let angle = |k: u32| std::f64::consts::TAU * f64::from(k % pieces) / f64::from(pieces);
    (0..=pieces)
        .map(|k| on_circle(centre, basis, radius, angle(k)))
        .collect()
}

/// A path with points put in where they lie far apart, so that a part of it can be hidden.
pub(super) fn refined(points: &[Vector3]) -> Vec<Vector3> {
    let mut fine = vec![points[0]];
    for pair in points.windows(2) {
        let gap = length(difference(pair[1], pair[0]));
        let pieces = (gap / 0.05).ceil().clamp(1.0, 48.0) as u32;
        fine.extend(&segment(pair[0], pair[1], pieces)[1..]);
    }
    fine
}

/// The direction of the last piece of a curve.
pub(crate) fn heading(points: &[Vector3]) -> Option<Vector3> {
    let (last, before) = points.split_last()?;
    let steps = before.iter().rev().map(|point| difference(*last, *point));
    steps.into_iter().find_map(normalized)
}

//! Lines as sequences of points.

use ga_runtime::vga3::Vector;

/// How far lines and planes reach from the middle of the picture.
pub(super) const REACH: f64 = 1.15;

/// The middle of the part of a line that is within reach, and half the length of that part.
pub(super) fn clipped(point: Vector<f64>, direction: Vector<f64>) -> (Vector<f64>, f64) {
    let middle = point - direction * point.dot(direction);
    let half = (REACH * REACH - middle.dot(middle)).max(0.1).sqrt();
    (middle, half)
}

/// The segment between two points, in pieces of equal length.
pub(super) fn segment(from: Vector<f64>, to: Vector<f64>, pieces: u32) -> Vec<Vector<f64>> {
    let step = to - from;
    let place = |k| match k {
        _ if k == pieces => to,
        _ => from + step * (f64::from(k) / f64::from(pieces)),
    };
    (0..=pieces).map(place).collect()
}

/// A path with points added where they lie far apart, so that a part of it can be hidden.
pub(super) fn refined(points: &[Vector<f64>]) -> Vec<Vector<f64>> {
    let mut fine = vec![points[0]];
    for pair in points.windows(2) {
        let gap = (pair[1] - pair[0]).length();
        let pieces = (gap / 0.05).ceil().clamp(1.0, 48.0) as u32;
        fine.extend(&segment(pair[0], pair[1], pieces)[1..]);
    }
    fine
}

/// The direction of the last piece of a curve.
pub(crate) fn heading(points: &[Vector<f64>]) -> Option<Vector<f64>> {
    let (last, before) = points.split_last()?;
    let mut steps = before.iter().rev().map(|point| *last - *point);
    steps.find_map(Vector::normalized)
}

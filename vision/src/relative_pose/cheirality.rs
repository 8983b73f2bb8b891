//! Which of the motions with one essential matrix has the points in front of both cameras.

use ga_runtime::cga3::{Direction, Motor};
use ga_runtime::vga3::Vector;

use super::sampson::BearingPair;

/// The motion for which most points are in front of both cameras, and how many are.
pub(super) fn most_in_front(motors: [Motor<f64>; 4], pairs: &[BearingPair]) -> (Motor<f64>, usize) {
    let count = |motor: &Motor<f64>| {
        let is_in_front = |pair: &&BearingPair| depths(pair, *motor).into_iter().all(|s| s > 0.0);
        pairs.iter().filter(is_in_front).count()
    };
    let mut best = (motors[0], count(&motors[0]));
    for motor in &motors[1..] {
        let in_front = count(motor);
        if in_front > best.1 {
            best = (*motor, in_front);
        }
    }
    best
}

/// The depths along both directions, up to a positive factor, of the points where the two rays come
/// closest: the s and s' for which `s R d + t − s' d'` is perpendicular to both rays.
fn depths(pair: &BearingPair, left_to_right: Motor<f64>) -> [f64; 2] {
    let d = Direction::from_vector(pair.left.direction.coordinates());
    let first = Vector::from(left_to_right.transform(d));
    let second = pair.right.direction;
    let translation = Vector::from(left_to_right.translator().displacement());
    let normal = first.cross(second);
    [
        second.cross(translation).dot(normal),
        first.cross(translation).dot(normal),
    ]
}

//! Rotations of vectors.

use ga_runtime::cga3::{Point, Rotor};
use ga_runtime::vga3::Vector;

/// The rotor that takes a direction a to the direction a', and the half plane of a and b to that of
/// a' and b'. `None` where one of the pairs is parallel.
pub(super) fn rotation_between_frames(
    from: [Vector<f64>; 2],
    to: [Vector<f64>; 2],
) -> Option<Rotor<f64>> {
    let first = Rotor::between(from[0].into(), to[0].into())?;
    let axis = to[0].normalized()?;
    let across = |vector: Vector<f64>| (vector - axis * vector.dot(axis)).normalized();
    let (side, goal) = (across(rotated(first, from[1]))?, across(to[1])?);
    // About the axis, also where the two are opposite: cos ½θ and sin ½θ from cos θ and sin θ.
    let (sine, cosine) = (side.cross(goal).dot(axis), side.dot(goal));
    let angle = sine.atan2(cosine);
    Some(Rotor::from_axis_angle(axis.into(), angle)? * first)
}

/// A vector rotated.
pub(super) fn rotated(rotor: Rotor<f64>, vector: Vector<f64>) -> Vector<f64> {
    rotor.transform(Point::from(vector)).into()
}

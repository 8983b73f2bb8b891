//! What holds at the ends of a spline.

use crate::cga3::MotorGenerator;

/// What holds at an end of a [smooth spline](super::MotorSpline::smooth).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SplineEnd<S> {
    /// The acceleration there is zero.
    Natural,
    /// The velocity there, in the frame of the moved body, as of
    /// [`MotorSpline::velocity`](super::MotorSpline::velocity).
    Velocity(MotorGenerator<S>),
}

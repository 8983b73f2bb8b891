//! Several motions together: blends and means, curves through them, and the motion that fits
//! measured points.
//!
//! - A cheap weighted average, as in skinning: [`Motor::blend`], [`Rotor::blend`].
//! - The weighted average that does not depend on the choice of frames: [`Motor::mean`],
//!   [`Rotor::mean`].
//! - A smooth motion through keys: [`MotorSpline`], [`RotorSpline`], with a continuous velocity or,
//!   by [`MotorSpline::smooth`], a continuous acceleration too.
//! - A single curve, given by control motions: [`Motor::bezier`], [`Motor::squad`] and their
//!   namesakes for rotors.
//! - The motion that moves points to points: [`Motor::from_point_pairs`],
//!   [`Similarity::from_point_pairs`].
//! - The rotation that takes directions to directions: [`Rotor::from_direction_pairs`].
//!
//! A motor and its negative are the same motion. All of these depend only on the motions, not on
//! the signs of the motors given. Sums run in the order of the input, so the same input gives the
//! same result to the last bit.
//!
//! [`Motor::blend`]: crate::cga3::Motor::blend
//! [`Rotor::blend`]: crate::cga3::Rotor::blend
//! [`Motor::mean`]: crate::cga3::Motor::mean
//! [`Rotor::mean`]: crate::cga3::Rotor::mean
//! [`Motor::bezier`]: crate::cga3::Motor::bezier
//! [`Motor::squad`]: crate::cga3::Motor::squad
//! [`Motor::from_point_pairs`]: crate::cga3::Motor::from_point_pairs
//! [`Similarity::from_point_pairs`]: crate::cga3::Similarity::from_point_pairs
//! [`Rotor::from_direction_pairs`]: crate::cga3::Rotor::from_direction_pairs

mod alignment;
mod blend;
mod curve;
mod enclosing;
mod fit;
mod mean;
pub(super) mod moments;
mod registration;
mod residual;
mod rotor_spline;
mod smooth_search;
mod smooth_spline;
mod span;
mod spline;
mod spline_end;

pub(crate) use alignment::relative_sign;
pub use fit::Fit;
pub use mean::Mean;
pub use residual::Residual;
pub use rotor_spline::RotorSpline;
pub use spline::{MotorSpline, SplineError};
pub use spline_end::SplineEnd;

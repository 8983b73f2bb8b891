//! Curves over time through keys: of numbers, of vectors, and of several channels together.
//!
//! | what | how |
//! | --- | --- |
//! | two continuous derivatives | [`Curve::spline`] with any [`Ends`], [`SplineSystem`] for many |
//! | local | [`Curve::catmull_rom`], [`Curve::hermite`], [`Curve::bezier`], [`BezierCurve`] |
//! | none | [`Curve::linear`], [`Curve::step`] |
//! | evaluation | [`Curve::value`] at random, [`Cursor`] in order, [`Curve::sample_into`] |
//! | calculus | [`Curve::derivative`], [`Curve::integral`], [`ArcLength`] |
//! | few vertices | [`Curve::resampled`], with a proven bound of the deviation |
//! | in pictures | [`Curve::drawn`] |
//! | from tables | [`table::KeyTable`], [`SampledTable`] |
//!
//! Curves of motors are [`MotorSpline`](ga_runtime::geometry::motion::MotorSpline) and its
//! relatives, since motors do not add.

mod arc_length;
mod bezier;
mod channel_ends;
mod cursor;
mod drawn;
mod ends;
mod error;
mod hermite;
mod integral;
mod linear;
mod piecewise;
mod resample;
mod sampled;
mod spline;
pub mod table;
mod value;

pub use arc_length::ArcLength;
pub use bezier::{BezierCurve, BezierKey};
pub use channel_ends::{ChannelEnds, ChannelEndsError};
pub use cursor::Cursor;
pub use ends::{EndKind, Ends};
pub use error::CurveError;
pub use piecewise::{Curve, Outside};
pub use resample::{Distance, Resampled, resample_channels, sample_channels};
pub use sampled::{SampledTable, Sampling};
pub use spline::SplineSystem;
pub use value::Value;

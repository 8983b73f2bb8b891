//! The error of a fit of a primitive to points.

use core::fmt::{Debug, Display, Formatter, Result as FmtResult};

use crate::geometry::cga3::weight::WeightError;

/// Points that do not determine a primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PrimitiveFitError<S> {
    /// There are too few points with a weight above zero.
    TooFewPoints {
        /// The number of such points.
        found: usize,
        /// The number needed.
        needed: usize,
    },
    /// The weights do not define an average.
    Weight(WeightError<S>),
    /// A coordinate of a point is not finite.
    NotFinite {
        /// The index of the point, from 0.
        index: usize,
    },
    /// All points coincide.
    Coincident,
    /// All points lie on a line, but the primitive needs points of a plane or of space.
    Collinear,
    /// All points lie in a plane, but the primitive needs points of space.
    Coplanar,
    /// Several primitives fit equally well.
    NotUnique,
    /// No round primitive fits best: the larger its radius, the better, up to that of a flat one.
    Flat,
    /// The search for the least distances did not come to an end.
    NotConverged,
    /// No primitive was found with which enough points agree.
    NoConsensus {
        /// The greatest number of points that agreed with one.
        found: usize,
        /// The number needed.
        needed: usize,
    },
    /// A setting of a robust fit is outside of its range.
    InvalidSetting {
        /// The name of the setting.
        name: &'static str,
        /// Its value.
        value: S,
    },
    /// The result is beyond the range of the scalar.
    OutOfRange,
}

impl<S: Debug> Display for PrimitiveFitError<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> FmtResult {
        match self {
            Self::TooFewPoints { found, needed } => {
                write!(
                    f,
                    "{needed} points with a weight above zero are needed, not {found}"
                )
            }
            Self::Weight(error) => Display::fmt(error, f),
            Self::NotFinite { index } => write!(f, "point {index} is not finite"),
            Self::Coincident => f.write_str("all points coincide"),
            Self::Collinear => f.write_str("all points lie on a line"),
            Self::Coplanar => f.write_str("all points lie in a plane"),
            Self::NotUnique => f.write_str("several primitives fit the points equally well"),
            Self::Flat => {
                f.write_str("no radius fits the points best: larger ones fit ever better")
            }
            Self::NotConverged => f.write_str("the search for the least distances did not end"),
            Self::NoConsensus { found, needed } => {
                write!(f, "no more than {found} points agree, but {needed} must")
            }
            Self::InvalidSetting { name, value } => {
                write!(f, "the setting {name} is outside of its range: {value:?}")
            }
            Self::OutOfRange => f.write_str("the result is beyond the range of the scalar"),
        }
    }
}

impl<S: Debug> core::error::Error for PrimitiveFitError<S> {}

impl<S> From<WeightError<S>> for PrimitiveFitError<S> {
    fn from(error: WeightError<S>) -> Self {
        Self::Weight(error)
    }
}

//! The error of a fit to pairs of points or directions.

use core::fmt::{Debug, Display, Formatter, Result as FmtResult};

use crate::geometry::cga3::weight::WeightError;

/// Pairs that do not determine a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum FitError<S> {
    /// There are too few pairs with a weight above zero.
    TooFewPairs {
        /// The number of such pairs.
        found: usize,
        /// The number needed: three of points, two of directions.
        needed: usize,
    },
    /// The weights do not define an average.
    Weight(WeightError<S>),
    /// A point or direction of a pair is not finite.
    NotFinite {
        /// The index of the pair, from 0.
        index: usize,
    },
    /// A direction of a pair is zero.
    NoDirection {
        /// The index of the pair, from 0.
        index: usize,
    },
    /// All first points, or all second points, coincide.
    Coincident,
    /// All first points, or all second points, lie on a line, or all first or all second directions
    /// are parallel: a rotation about that line changes nothing.
    Collinear,
    /// Several rotations fit equally well. This happens where the second points are the mirror
    /// image of a regular body, or where they are unrelated to the first.
    NotUnique,
    /// The result is beyond the range of the scalar.
    OutOfRange,
}

impl<S: Debug> Display for FitError<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> FmtResult {
        match self {
            Self::TooFewPairs { found, needed } => {
                write!(
                    f,
                    "{needed} pairs with a weight above zero are needed, not {found}"
                )
            }
            Self::Weight(error) => Display::fmt(error, f),
            Self::NotFinite { index } => write!(f, "pair {index} is not finite"),
            Self::NoDirection { index } => write!(f, "pair {index} has a direction of length zero"),
            Self::Coincident => f.write_str("all first points or all second points coincide"),
            Self::Collinear => f.write_str("all first points or all second points lie on a line"),
            Self::NotUnique => f.write_str("several rotations fit equally well"),
            Self::OutOfRange => f.write_str("the result is beyond the range of the scalar"),
        }
    }
}

impl<S: Debug> core::error::Error for FitError<S> {}

impl<S> From<WeightError<S>> for FitError<S> {
    fn from(error: WeightError<S>) -> Self {
        Self::Weight(error)
    }
}

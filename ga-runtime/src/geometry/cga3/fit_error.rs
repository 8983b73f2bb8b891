//! Why points or motions do not determine what is fitted to them.

use core::fmt::{Debug, Display, Formatter, Result as FmtResult};

use super::motion::Residual;

/// Points that do not determine a primitive, pairs that do not determine a motion, or motions that
/// have no blend or mean. Points, pairs, motions and weights are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum FitError<S> {
    /// A weight is negative or not finite.
    InvalidWeight {
        /// The index of the weight.
        index: usize,
        /// Its value.
        weight: S,
    },
    /// All weights are zero.
    ZeroWeights,
    /// There are too few points with a weight above zero.
    TooFewPoints {
        /// The number of such points.
        found: usize,
        /// The number needed.
        needed: usize,
    },
    /// A coordinate of a point is not finite.
    PointNotFinite {
        /// The index of the point.
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
    /// There are too few pairs with a weight above zero.
    TooFewPairs {
        /// The number of such pairs.
        found: usize,
        /// The number needed: three of points, two of directions.
        needed: usize,
    },
    /// A point or direction of a pair is not finite.
    PairNotFinite {
        /// The index of the pair.
        index: usize,
    },
    /// A direction of a pair is zero.
    NoDirection {
        /// The index of the pair.
        index: usize,
    },
    /// All first points, or all second points, coincide.
    PairsCoincident,
    /// All first points, or all second points, lie on a line, or all first or all second directions
    /// are parallel: a rotation about that line changes nothing.
    PairsCollinear,
    /// Several rotations fit equally well. This happens where the second points are the mirror
    /// image of a regular body, or where they are unrelated to the first.
    RotationNotUnique,
    /// There are no motions to blend.
    NoMotions,
    /// A coefficient of a motion is not finite.
    MotionNotFinite {
        /// The index of the motion.
        index: usize,
    },
    /// No rotation is within a quarter turn of all of them, or there are only two different
    /// rotations, half a turn apart: there may be several means.
    MeanNotUnique {
        /// The index of the motion with the largest angle from the blend.
        index: usize,
        /// The angle from the blend, in radians.
        angle: S,
    },
    /// The iteration for the mean did not converge.
    MeanNotConverged {
        /// The number of steps taken.
        steps: usize,
        /// The remaining error of the condition on the mean.
        residual: Residual<S>,
    },
    /// The result is beyond the range of the scalar.
    OutOfRange,
}

impl<S: Debug> Display for FitError<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> FmtResult {
        match self {
            Self::InvalidWeight { index, weight } => write!(
                f,
                "weight {index} is {weight:?}, but must be zero or a positive number"
            ),
            Self::ZeroWeights => f.write_str("all weights are zero"),
            Self::TooFewPoints { found, needed } => write!(
                f,
                "{needed} points with a weight above zero are needed, not {found}"
            ),
            Self::PointNotFinite { index } => write!(f, "point {index} is not finite"),
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
            Self::TooFewPairs { found, needed } => write!(
                f,
                "{needed} pairs with a weight above zero are needed, not {found}"
            ),
            Self::PairNotFinite { index } => write!(f, "pair {index} is not finite"),
            Self::NoDirection { index } => write!(f, "pair {index} has a direction of length zero"),
            Self::PairsCoincident => f.write_str("all first points or all second points coincide"),
            Self::PairsCollinear => {
                f.write_str("all first points or all second points lie on a line")
            }
            Self::RotationNotUnique => f.write_str("several rotations fit equally well"),
            Self::NoMotions => f.write_str("there are no motions"),
            Self::MotionNotFinite { index } => write!(f, "motion {index} is not finite"),
            Self::MeanNotUnique { index, angle } => write!(
                f,
                "no rotation is within a quarter turn of all; motion {index} is rotated by {angle:?} rad from the blend"
            ),
            Self::MeanNotConverged { steps, residual } => write!(
                f,
                "no convergence after {steps} steps: {:?} rad and a displacement of {:?} remain",
                residual.angle, residual.displacement
            ),
            Self::OutOfRange => f.write_str("the result is beyond the range of the scalar"),
        }
    }
}

impl<S: Debug> core::error::Error for FitError<S> {}

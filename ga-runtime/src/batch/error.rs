//! Errors of operations on slices.

use core::fmt;

/// Two slices that must have the same length have different lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthMismatch {
    /// The length of the first operand.
    pub expected: usize,
    /// The other length.
    pub found: usize,
}

impl fmt::Display for LengthMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { expected, found } = self;
        write!(
            f,
            "a slice has {found} elements where {expected} are needed"
        )
    }
}

impl core::error::Error for LengthMismatch {}

pub(super) fn same_length(expected: usize, found: usize) -> Result<(), LengthMismatch> {
    if expected == found {
        Ok(())
    } else {
        Err(LengthMismatch { expected, found })
    }
}

/// Why motors cannot be blended, or points cannot follow motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BatchError {
    /// Two lists that must have the same length have different lengths.
    Length(LengthMismatch),
    /// The index in an influence of a blend is outside of the palette.
    NotInPalette {
        /// The index of the result.
        element: usize,
        /// The index of the motor.
        place: usize,
        /// The number of motors in the palette.
        palette: usize,
    },
    /// The weighted sum of this result is not a multiple of a motor: the weights are all zero or
    /// not finite, or the motors cancel.
    NoDirection {
        /// The index of the result.
        element: usize,
    },
    /// The joint in an influence of a skin is outside of the palette.
    JointNotInPalette {
        /// The index of the point.
        element: usize,
        /// The index of the joint.
        place: usize,
        /// The number of joints.
        palette: usize,
    },
    /// A weight of a skin is negative or not finite.
    NotAWeight {
        /// The index of the point.
        element: usize,
    },
    /// A point of a skin has no influence with a weight above zero.
    NoInfluence {
        /// The index of the point.
        element: usize,
    },
    /// There are more joints or pairs of joints than the indices of a skin can count.
    TooLarge,
    /// The motion of a joint is not finite, or not a unit motor.
    BadMotion {
        /// The joint.
        joint: usize,
    },
    /// Normals or tangents are asked for, but the skin has none.
    NoDirections,
}

impl fmt::Display for BatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(mismatch) => mismatch.fmt(f),
            Self::NotInPalette {
                element,
                place,
                palette,
            } => write!(
                f,
                "element {element} is influenced by motor {place} of a palette of {palette}"
            ),
            Self::NoDirection { element } => {
                write!(f, "the motors of element {element} have no mean")
            }
            Self::JointNotInPalette {
                element,
                place,
                palette,
            } => write!(
                f,
                "point {element} is influenced by joint {place} of a palette of {palette}"
            ),
            Self::NotAWeight { element } => {
                write!(f, "a weight of point {element} is negative or not finite")
            }
            Self::NoInfluence { element } => write!(
                f,
                "point {element} has no influence with a weight above zero"
            ),
            Self::TooLarge => f.write_str("there are too many joints or pairs of joints"),
            Self::BadMotion { joint } => write!(
                f,
                "the motion of joint {joint} is not finite or not a unit motor"
            ),
            Self::NoDirections => {
                f.write_str("normals or tangents are asked for, but the skin has none")
            }
        }
    }
}

impl core::error::Error for BatchError {}

impl From<LengthMismatch> for BatchError {
    fn from(mismatch: LengthMismatch) -> Self {
        Self::Length(mismatch)
    }
}

use core::fmt;

use crate::batch::LengthMismatch;

/// Why points cannot follow motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SkinError {
    /// Two lists that must have the same length have different lengths.
    Length(LengthMismatch),
    /// The joint in an influence is outside of the palette.
    NotInPalette {
        /// The index of the point.
        element: usize,
        /// The index of the joint.
        place: usize,
        /// The number of joints.
        palette: usize,
    },
    /// A weight is negative or not finite.
    NotAWeight {
        /// The index of the point.
        element: usize,
    },
    /// A point has no influence with a weight above zero.
    NoInfluence {
        /// The index of the point.
        element: usize,
    },
    /// There are more joints or pairs of joints than the indices can count.
    TooLarge,
    /// The motion of a joint is not finite, or not a unit motor.
    BadMotion {
        /// The joint.
        joint: usize,
    },
    /// Normals or tangents are asked for, but the skin has none.
    NoDirections,
}

impl fmt::Display for SkinError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(mismatch) => mismatch.fmt(f),
            Self::NotInPalette {
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
            Self::NoInfluence { element } => {
                write!(
                    f,
                    "point {element} has no influence with a weight above zero"
                )
            }
            Self::TooLarge => f.write_str("there are too many joints or pairs of joints"),
            Self::BadMotion { joint } => {
                write!(
                    f,
                    "the motion of joint {joint} is not finite or not a unit motor"
                )
            }
            Self::NoDirections => {
                f.write_str("normals or tangents are asked for, but the skin has none")
            }
        }
    }
}

impl core::error::Error for SkinError {}

impl From<LengthMismatch> for SkinError {
    fn from(mismatch: LengthMismatch) -> Self {
        Self::Length(mismatch)
    }
}

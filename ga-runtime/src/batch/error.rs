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

/// Why motors cannot be blended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlendError {
    /// The numbers of results and of lists of influences differ.
    Length(LengthMismatch),
    /// The index in an influence is outside of the palette.
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
}

impl fmt::Display for BlendError {
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
        }
    }
}

impl core::error::Error for BlendError {}

impl From<LengthMismatch> for BlendError {
    fn from(mismatch: LengthMismatch) -> Self {
        Self::Length(mismatch)
    }
}

//! What can be wrong with an MTL file.

use crate::words::WordError;

/// What can be wrong with an MTL file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MtlProblem {
    /// The line is not UTF-8, or holds a null byte.
    #[error("the file is not UTF-8 text")]
    NotText,
    /// A word is in the place of a number.
    #[error("{word:?} is not a number")]
    NotANumber {
        /// The word.
        word: String,
    },
    /// A number is infinite, not a number, or too large.
    #[error("{word:?} is not a finite number")]
    NotFinite {
        /// The word.
        word: String,
    },
    /// A line has too few or too many numbers.
    #[error("a {statement} line has {expected}, but this one has {found}")]
    WrongCount {
        /// The line's first word.
        statement: String,
        /// How many numbers it may have, in words.
        expected: &'static str,
        /// How many it has.
        found: usize,
    },
    /// A colour is a spectral curve or has CIE XYZ coordinates.
    #[error("{statement} {kind} is not supported; write red, green and blue")]
    ColourKind {
        /// The line's first word.
        statement: String,
        /// `"spectral"` or `"xyz"`.
        kind: String,
    },
    /// A property comes before the first `newmtl` line.
    #[error("{statement} comes before the first newmtl line")]
    NoMaterial {
        /// The line's first word.
        statement: String,
    },
    /// A `newmtl` line has no name.
    #[error("a newmtl line has a name, but this one has none")]
    NoName,
    /// A line for a picture does not name one. This is a warning.
    #[error("a {statement} line ends with the path of a picture, but this one has none")]
    NoPicture {
        /// The line's first word.
        statement: String,
    },
    /// A picture has an option that does not exist. This is a warning.
    #[error("{statement} has no option {option}")]
    UnknownOption {
        /// The line's first word.
        statement: String,
        /// The option.
        option: String,
    },
    /// An option of a picture lacks its value.
    #[error("the option {option} of {statement} has no value")]
    OptionValue {
        /// The line's first word.
        statement: String,
        /// The option.
        option: String,
    },
}

impl From<WordError> for MtlProblem {
    fn from(error: WordError) -> Self {
        match error {
            WordError::Encoding => MtlProblem::NotText,
            WordError::Word(word) => MtlProblem::NotANumber { word },
            WordError::Infinite(word) => MtlProblem::NotFinite { word },
        }
    }
}

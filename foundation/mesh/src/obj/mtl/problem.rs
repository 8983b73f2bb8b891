//! What can be wrong with an MTL file.

use std::borrow::Cow;

use ga_files::Tolerated;
use ga_files::text::Encoding;

use crate::words::WordError;

/// What can be wrong with an MTL file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MtlProblem {
    /// The line is not UTF-8, or holds a null byte.
    #[error("the file is not UTF-8 text")]
    NotText,
    /// The file is in another encoding.
    #[error("the file is not UTF-8 text")]
    NotUtf8 {
        /// As which it is read, unless it is read strictly.
        encoding: Encoding,
    },
    /// A line ends in a carriage return alone.
    #[error("the line ends in a carriage return alone")]
    CarriageReturns,
    /// The first word of the line stands for nothing. This is a warning.
    #[error("{statement} is no statement of MTL")]
    UnknownStatement {
        /// The word.
        statement: String,
    },
    /// `d` and `Tr` state different opacities of a material. This is a warning.
    #[error("the opacity 1 − Tr is another than that by d")]
    TwoOpacities,
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

impl Tolerated for MtlProblem {
    fn kind(&self) -> &'static str {
        match self {
            Self::NotText | Self::NotUtf8 { .. } => "encoding",
            Self::CarriageReturns => "line_ends",
            Self::UnknownStatement { .. } => "unknown_statement",
            Self::TwoOpacities => "two_opacities",
            Self::NotANumber { .. } | Self::NotFinite { .. } => "not_a_number",
            Self::WrongCount { .. } => "number_count",
            Self::ColourKind { .. } => "colour_kind",
            Self::NoMaterial { .. } => "no_material",
            Self::NoName => "no_name",
            Self::NoPicture { .. } => "no_picture",
            Self::UnknownOption { .. } => "unknown_option",
            Self::OptionValue { .. } => "no_option_value",
        }
    }

    fn remedy(&self) -> Cow<'_, str> {
        match self {
            Self::NotUtf8 { encoding } => return format!("it is read as {encoding}").into(),
            Self::CarriageReturns => "the next line begins behind it",
            Self::TwoOpacities => "that by d counts",
            Self::NoName => "the material is left out",
            Self::WrongCount {
                expected, found, ..
            } if *found > 3 || (*expected == "one number" && *found > 1) => {
                "the numbers beyond are ignored"
            }
            _ => "this is ignored",
        }
        .into()
    }

    fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (
                Self::WrongCount { statement, .. },
                Self::WrongCount {
                    statement: other, ..
                },
            )
            | (Self::UnknownStatement { statement }, Self::UnknownStatement { statement: other }) => {
                statement == other
            }
            _ => std::mem::discriminant(self) == std::mem::discriminant(other),
        }
    }
}

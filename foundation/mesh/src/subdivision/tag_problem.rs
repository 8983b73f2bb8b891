//! What can be wrong with the text of tags.

/// What can be wrong with a line of tags.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TagProblem {
    /// The line is not UTF-8.
    #[error("the line is not UTF-8 text")]
    NotText,
    /// The first word is not known.
    #[error("a line begins with \"crease\" or \"corner\", not with {word:?}")]
    UnknownTag {
        /// The word.
        word: String,
    },
    /// The line has too few or too many words.
    #[error("expected \"{expected}\", but {found} words follow the first")]
    WrongCount {
        /// The form of the line.
        expected: &'static str,
        /// How many words follow the first.
        found: usize,
    },
    /// A word is in the place of a vertex.
    #[error("{word:?} is not the number of a vertex")]
    NotAVertex {
        /// The word.
        word: String,
    },
    /// A word is in the place of a sharpness.
    #[error("{word:?} is not a sharpness: a number that is at least 0, or inf")]
    NotASharpness {
        /// The word.
        word: String,
    },
}

//! Feet.

use serde::Serialize;

/// A foot, or both.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Foot {
    /// The left one.
    Left,
    /// The right one.
    Right,
    /// Both at once, as after a jump.
    Both,
}

impl Foot {
    /// As a part of a sentence.
    pub(super) fn with_article(self) -> &'static str {
        match self {
            Self::Left => "the left foot",
            Self::Right => "the right foot",
            Self::Both => "both feet",
        }
    }
}

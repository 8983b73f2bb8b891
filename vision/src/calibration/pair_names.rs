//! The names of pairs of pictures.

use std::fmt;

use serde::Serialize;

/// The names of two pictures.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct PairNames {
    /// That of the left picture.
    pub left: String,
    /// That of the right picture.
    pub right: String,
}

impl fmt::Display for PairNames {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} and {}", self.left, self.right)
    }
}

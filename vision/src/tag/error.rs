//! Why tags and boards of tags cannot be described.

use super::dictionary::Dictionary;

/// Why a tag or a board of tags cannot be as described.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TagError {
    /// A board has too few squares or tags, or more than it may have.
    #[error("a board of {columns} × {rows} {what} is not one: each is from {least} to 100")]
    Size {
        /// Squares or tags in a row.
        columns: usize,
        /// Rows of them.
        rows: usize,
        /// What is counted.
        what: &'static str,
        /// The least number.
        least: usize,
    },
    /// A dictionary has fewer tags than a board needs.
    #[error("{dictionary} has {} tags, and the board needs {needed}", dictionary.count())]
    TooFewTags {
        /// The dictionary.
        dictionary: Dictionary,
        /// How many are needed.
        needed: usize,
    },
    /// A length is not positive and finite.
    #[error("{what} of {metres} m is not positive and finite")]
    Length {
        /// What the length is of.
        what: &'static str,
        /// The length in metres.
        metres: f64,
    },
    /// The black border of a tag is 1 or 2 modules wide.
    #[error("no tag has a border of {border} modules: 1 and 2 are possible")]
    Border {
        /// Its width in modules.
        border: u8,
    },
    /// The tags of a ChArUco board are not smaller than its squares.
    #[error("tags of {marker} m do not fit into squares of {square} m")]
    Marker {
        /// The side of a tag in metres.
        marker: f64,
        /// The side of a square in metres.
        square: f64,
    },
}

/// Fails where a board has too few or too many columns or rows.
pub(super) fn check_size(
    [columns, rows]: [usize; 2],
    what: &'static str,
    least: usize,
) -> Result<(), TagError> {
    let is_possible = |count: usize| (least..=100).contains(&count);
    match is_possible(columns) && is_possible(rows) {
        true => Ok(()),
        false => Err(TagError::Size {
            columns,
            rows,
            what,
            least,
        }),
    }
}

/// Fails where a length is not positive and finite.
pub(super) fn check_length(what: &'static str, metres: f64) -> Result<(), TagError> {
    match metres > 0.0 && metres.is_finite() {
        true => Ok(()),
        false => Err(TagError::Length { what, metres }),
    }
}

//! Found cuts against labelled ones.

use ga_files::table::{Table, TableError};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

/// How many found cuts are right, and how many labelled ones are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Score {
    /// Found cuts that belong to a label.
    pub correct: usize,
    /// Found cuts without a label.
    pub extra: usize,
    /// Labels without a found cut.
    pub missed: usize,
}

impl Score {
    /// The fraction of found cuts that are right; `None` where none were found.
    #[must_use]
    pub fn precision(&self) -> Option<f64> {
        ratio(self.correct, self.correct + self.extra)
    }

    /// The fraction of labelled cuts that are found; `None` where there are no labels.
    #[must_use]
    pub fn recall(&self) -> Option<f64> {
        ratio(self.correct, self.correct + self.missed)
    }

    /// The harmonic mean of both, 2c / (2c + extra + missed); `None` without cuts and labels.
    #[must_use]
    pub fn f1(&self) -> Option<f64> {
        ratio(
            2 * self.correct,
            2 * self.correct + self.extra + self.missed,
        )
    }
}

impl Serialize for Score {
    /// The counts, and the quotients under their names; `null` where there is none.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("Score", 6)?;
        object.serialize_field("correct", &self.correct)?;
        object.serialize_field("extra", &self.extra)?;
        object.serialize_field("missed", &self.missed)?;
        object.serialize_field("precision", &self.precision())?;
        object.serialize_field("recall", &self.recall())?;
        object.serialize_field("f1", &self.f1())?;
        object.end()
    }
}

/// Why labels cannot be read. Lines count from 1.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LabelError {
    /// They are no table.
    #[error(transparent)]
    Table(#[from] TableError),
    /// A cell is not the number of a frame.
    #[error("line {line}: {text:?} is not a frame number")]
    Frame {
        /// The line.
        line: usize,
        /// What the cell says.
        text: String,
    },
    /// Several columns, none of which is named as one of frames.
    #[error("none of several columns is named cut, frame or start, but {0}")]
    Column(String),
}

/// The names of columns of labels.
const NAMES: [&str; 4] = ["cut", "cuts", "frame", "start"];

/// The numbers of frames in a table: of its only column, whatever its name, or of the first one
/// that is named `cut`, `cuts`, `frame` or `start`; of a table without names in the first column.
/// Frame 0, with which a list of shots begins, follows no cut.
///
/// ```
/// use ga_video::keyframe::evaluation::{LabelError, labels};
///
/// assert_eq!(labels(b"cut\n10\n25\n")?, [10, 25]);
/// assert_eq!(labels(b"shot;start\n1;0\n2;30\n")?, [30]);
/// let message = labels(b"10\n2.5\n").unwrap_err().to_string();
/// assert_eq!(message, "line 2: \"2.5\" is not a frame number");
/// # Ok::<(), LabelError>(())
/// ```
///
/// # Errors
///
/// Any [`LabelError`].
pub fn labels(bytes: &[u8]) -> Result<Vec<usize>, LabelError> {
    let table = Table::parse(bytes)?;
    let named = NAMES.iter().find_map(|name| table.column(name));
    let column = match (named, table.names()) {
        (Some(column), _) => column,
        (None, [] | [_]) => 0,
        (None, names) => return Err(LabelError::Column(names.join(", "))),
    };
    let labels = (0..table.len()).map(|row| {
        let number = table.number(row, column).ok().flatten();
        let frame = number.filter(|number| number.fract() == 0.0 && *number >= 0.0);
        // Beyond 2⁵³ a number does not tell frames apart; no video has as many.
        frame
            .map(|frame| frame as usize)
            .ok_or_else(|| LabelError::Frame {
                line: table.line(row),
                text: table.text(row, column).to_owned(),
            })
    });
    let labels: Result<Vec<usize>, LabelError> = labels.collect();
    Ok(labels?.into_iter().filter(|label| *label > 0).collect())
}

/// Pairs found cuts with labels at most `tolerance` frames away, each with at most one, and as many
/// as possible. Both are sorted first; the earliest label that is near enough is taken, which is
/// the greatest number of pairs for intervals of one length.
///
/// ```
/// use ga_video::keyframe::evaluation::score;
///
/// let found = score(&[10, 12, 30], &[11, 29, 50], 1);
/// assert_eq!([found.correct, found.extra, found.missed], [2, 1, 1]);
/// assert!((found.f1().unwrap() - 2.0 / 3.0).abs() < 1e-12);
/// ```
#[must_use]
pub fn score(found: &[usize], labels: &[usize], tolerance: usize) -> Score {
    let sorted = |frames: &[usize]| {
        let mut frames = frames.to_vec();
        frames.sort_unstable();
        frames
    };
    let (found, labels) = (sorted(found), sorted(labels));
    let (mut i, mut j, mut correct) = (0, 0, 0);
    while i < found.len() && j < labels.len() {
        if found[i].abs_diff(labels[j]) <= tolerance {
            (i, j, correct) = (i + 1, j + 1, correct + 1);
        } else if found[i] < labels[j] {
            i += 1;
        } else {
            j += 1;
        }
    }
    Score {
        correct,
        extra: found.len() - correct,
        missed: labels.len() - correct,
    }
}

fn ratio(part: usize, whole: usize) -> Option<f64> {
    (whole > 0).then(|| part as f64 / whole as f64)
}

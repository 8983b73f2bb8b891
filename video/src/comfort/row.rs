//! What is measured of a stereoscopic video, and how a measurement is stated.

use std::fmt;

use super::dimension::{Dimension, Unit};
use super::scale::Score;

/// Why there is no score.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Missing {
    /// The views have been compared, and the answer is not certain enough.
    Unknown,
    /// Too few points are seen in both views.
    NotMeasurable,
    /// Hardly anything moves, so that no delay shows.
    NoMotion,
    /// The motion in one view does not explain that in the other.
    UnrelatedMotion,
    /// The motion fits several delays.
    AmbiguousMotion,
}

impl Missing {
    /// All of them, in the order of the declaration.
    pub const ALL: [Self; 5] = [
        Self::Unknown,
        Self::NotMeasurable,
        Self::NoMotion,
        Self::UnrelatedMotion,
        Self::AmbiguousMotion,
    ];

    /// The name in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Unknown => "unknown",
            Self::NotMeasurable
            | Self::NoMotion
            | Self::UnrelatedMotion
            | Self::AmbiguousMotion => "not measurable",
        }
    }

    /// The reason in words, as the part of a sentence.
    #[must_use]
    pub fn reason(self) -> &'static str {
        match self {
            Self::Unknown => "the pictures do not show which eye is which",
            Self::NotMeasurable => "too few points are found in both views",
            Self::NoMotion => "hardly anything moves",
            Self::UnrelatedMotion => "the motion in one view does not explain that in the other",
            Self::AmbiguousMotion => "the motion fits several delays nearly equally well",
        }
    }
}

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// One measurement of one frame.
///
/// ```
/// use ga_video::comfort::{Dimension, Level, Missing, Row, Scale, Viewing};
///
/// let scale = Scale::of(Dimension::Vertical, &Viewing::default()).unwrap();
/// let row = Row::measured(Dimension::Vertical, 8.5, &scale);
/// assert_eq!(row.score.map(|score| score.level()), Ok(Level::Orange));
/// assert_eq!(row.unit().name(), "arcminutes");
///
/// let row = Row::missing(Dimension::Vertical, Missing::NotMeasurable);
/// assert_eq!((row.score, row.raw), (Err(Missing::NotMeasurable), None));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// What is measured.
    pub dimension: Dimension,
    /// How uncomfortable it is, or why that cannot be said.
    pub score: Result<Score, Missing>,
    /// The measurement in the [`unit`](Self::unit) of the row. It may be there without a score.
    pub raw: Option<f64>,
}

impl Row {
    /// A row whose score follows from its raw number. A number that is not finite is not a
    /// measurement.
    #[must_use]
    pub fn measured(dimension: Dimension, raw: f64, scale: &super::Scale) -> Self {
        if !raw.is_finite() {
            return Self::missing(dimension, Missing::NotMeasurable);
        }
        Self {
            dimension,
            score: Ok(scale.score(raw)),
            raw: Some(raw),
        }
    }

    /// A row without a score and a raw number.
    #[must_use]
    pub fn missing(dimension: Dimension, why: Missing) -> Self {
        Self {
            dimension,
            score: Err(why),
            raw: None,
        }
    }

    /// The unit of the raw number.
    #[must_use]
    pub fn unit(&self) -> Unit {
        self.dimension.unit()
    }
}

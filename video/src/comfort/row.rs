//! What is measured of a stereoscopic video, and how a measurement is stated.

use std::fmt;

use super::dimension::{Dimension, Unit};
use super::scale::Score;

/// Why there is no score.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Missing {
    /// The views have been compared, and the answer is not certain enough.
    Unknown,
    /// The frame does not show what is needed: too few points are seen in both views, or nothing
    /// moves.
    NotMeasurable,
}

impl Missing {
    /// The name in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Unknown => "unknown",
            Self::NotMeasurable => "not measurable",
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

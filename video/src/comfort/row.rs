//! What is measured of a stereoscopic video, and how a measurement is stated.

use super::dimension::Dimension;
use std::fmt;

use super::scale::Score;

/// The unit of a raw number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unit {
    /// Per cent: of luminance in [`Dimension::Brightness`], of the picture's width otherwise.
    Percent,
    /// Units of CIE 1976 L\*a\*b\*.
    ColourDifference,
    /// Sixtieths of a degree of visual angle.
    Arcminutes,
    /// Frames of the video.
    Frames,
    /// Degrees of visual angle.
    Degrees,
    /// The binary logarithm of a ratio.
    Log2,
    /// A number that is positive where the views are in their order, negative where they are
    /// exchanged, and near zero where that cannot be told.
    Evidence,
}

impl Unit {
    /// The name in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Percent => "percent",
            Self::ColourDifference => "delta_ab",
            Self::Arcminutes => "arcminutes",
            Self::Frames => "frames",
            Self::Degrees => "degrees",
            Self::Log2 => "log2",
            Self::Evidence => "evidence",
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

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

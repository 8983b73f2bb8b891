//! What is said of one frame.

use super::asynchrony::Asynchrony;
use super::stereoscopy::Stereoscopy;
use super::{Dimension, FrameMeasures, Missing, Row, Scale, Score, Viewing};

/// All rows of the table for one frame, and what was measured for them.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// The number of the frame, from 0.
    pub frame: usize,
    /// When it is shown, in seconds after the first frame.
    pub time_seconds: f64,
    /// Whether a shot begins with it.
    pub begins_shot: bool,
    /// The number of the run of frames that it belongs to: within each the eyes cannot have been
    /// exchanged, since the picture and its depth continue.
    pub run: usize,
    /// What its two views show.
    pub measures: FrameMeasures,
    /// By how many frames the right eye is late.
    pub asynchrony: Asynchrony,
    /// How the shot uses its views.
    pub stereoscopy: Stereoscopy,
    /// The rows in the order of [`Dimension::ALL`].
    pub rows: [Row; 11],
}

impl Record {
    /// The row of a quantity.
    #[must_use]
    pub fn row(&self, dimension: Dimension) -> &Row {
        // They are in the order of the declaration.
        &self.rows[dimension as usize]
    }

    /// Fills in the rows that need other frames.
    pub(super) fn new(known: Known, viewing: &Viewing) -> Self {
        let rows = Dimension::ALL.map(|dimension| known.row(dimension, viewing));
        Self {
            frame: known.frame,
            time_seconds: known.time_seconds,
            begins_shot: known.begins_shot,
            run: known.run,
            measures: known.measures,
            asynchrony: known.asynchrony,
            stereoscopy: known.stereoscopy,
            rows,
        }
    }
}

/// What a record is made of.
pub(super) struct Known {
    pub(super) frame: usize,
    pub(super) time_seconds: f64,
    pub(super) begins_shot: bool,
    pub(super) run: usize,
    pub(super) measures: FrameMeasures,
    pub(super) deviation_arcminutes: Option<f64>,
    pub(super) asynchrony: Asynchrony,
    pub(super) stereoscopy: Stereoscopy,
    pub(super) evidence: f64,
}

impl Known {
    fn row(&self, dimension: Dimension, viewing: &Viewing) -> Row {
        let measured = |raw: Option<f64>| match (raw, Scale::of(dimension, viewing)) {
            (Some(raw), Some(scale)) => Row::measured(dimension, raw, &scale),
            _ => Row::missing(dimension, Missing::NotMeasurable),
        };
        match dimension {
            Dimension::Asynchrony => {
                let missing = match self.asynchrony {
                    // Not −0.
                    Asynchrony::Measured(delay) => return measured(Some(delay.frames + 0.0)),
                    Asynchrony::NoMotion => Missing::NoMotion,
                    Asynchrony::Unrelated => Missing::UnrelatedMotion,
                    Asynchrony::Ambiguous => Missing::AmbiguousMotion,
                };
                Row::missing(dimension, missing)
            }
            Dimension::ParallaxDeviation => measured(self.deviation_arcminutes),
            Dimension::Stereoscopy => Row {
                dimension,
                score: self.stereoscopy.score().ok_or(Missing::Unknown),
                raw: Some(self.evidence),
            },
            _ => self
                .measures
                .row(dimension, viewing)
                .unwrap_or(Row::missing(dimension, Missing::NotMeasurable)),
        }
    }
}

impl Stereoscopy {
    /// Its score: 0 in order, 14 without depth, 15 where depth is wrong; `None` if it is unknown.
    #[must_use]
    pub fn score(self) -> Option<Score> {
        match self {
            Self::InOrder => Some(Score::new(0)),
            Self::Identical => Some(Score::new(14)),
            Self::Exchanged | Self::Unrelated => Some(Score::MOST),
            Self::Unknown => None,
        }
    }
}

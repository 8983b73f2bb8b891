//! What is said of a whole video.

use super::stereoscopy::Stereoscopy;
use super::{Dimension, Level, Record};

/// The rows of the table over all frames, as the last column of Cui, table 6. It holds sums only,
/// so that a video may be of any length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// The number of frames.
    pub frames: usize,
    /// The number of shots.
    pub shots: usize,
    rows: [RowSummary; 11],
}

/// One row over all frames.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RowSummary {
    /// The number of frames with a score.
    pub scored: usize,
    /// Of these, frames in green, orange and red.
    pub levels: [usize; 3],
    /// The greatest score, and the first frame that has it.
    pub worst: Option<(u8, usize)>,
    sum: f64,
    raw_sum: f64,
}

impl RowSummary {
    /// The mean score; `None` where no frame has one.
    #[must_use]
    pub fn mean_score(&self) -> Option<f64> {
        (self.scored > 0).then(|| self.sum / self.scored as f64)
    }

    /// The mean of the raw numbers of frames with a score.
    #[must_use]
    pub fn mean_raw(&self) -> Option<f64> {
        (self.scored > 0).then(|| self.raw_sum / self.scored as f64)
    }
}

impl Summary {
    /// Adds a frame.
    pub fn add(&mut self, record: &Record) {
        self.frames += 1;
        self.shots += usize::from(record.begins_shot);
        for (summary, row) in self.rows.iter_mut().zip(&record.rows) {
            let Ok(score) = row.score else { continue };
            summary.scored += 1;
            summary.sum += f64::from(score.number());
            summary.raw_sum += row.raw.unwrap_or(0.0);
            summary.levels[match score.level() {
                Level::Green => 0,
                Level::Orange => 1,
                Level::Red => 2,
            }] += 1;
            if summary.worst.is_none_or(|worst| score.number() > worst.0) {
                summary.worst = Some((score.number(), record.frame));
            }
        }
    }

    /// The row of a quantity.
    #[must_use]
    pub fn row(&self, dimension: Dimension) -> &RowSummary {
        // They are in the order of the declaration.
        &self.rows[dimension as usize]
    }
}

/// What a verdict means to those who make a video.
#[must_use]
pub fn meaning(stereoscopy: Stereoscopy) -> &'static str {
    match stereoscopy {
        Stereoscopy::InOrder => "the left eye sees the left view",
        Stereoscopy::Exchanged => "the left eye sees the right view: exchange the views",
        Stereoscopy::Identical => "both eyes see the same picture: there is no depth",
        Stereoscopy::Unrelated => "the eyes see different scenes",
        Stereoscopy::Unknown => "the pictures do not show which eye is which",
    }
}

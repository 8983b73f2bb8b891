//! What is said of a whole video.

use super::stereoscopy::Stereoscopy;
use super::{Dimension, FrameRuns, Level, Missing, Record, Row, Score};

/// The rows of the table over all frames, as the last column of Cui, table 6. It holds sums only,
/// so that a video may be of any length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// The number of frames.
    pub frames: usize,
    /// The number of shots.
    pub shots: usize,
    /// Frames in which the order of the eyes could not be decided.
    pub undecided: FrameRuns,
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
    /// The least and the greatest raw number of frames with a score.
    pub raw_range: Option<[f64; 2]>,
    /// Frames without a score, by the reasons in the order of [`Missing::ALL`].
    pub missing: [usize; 5],
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

    /// Frames for which the answer is not certain enough: [`Missing::Unknown`].
    #[must_use]
    pub fn unknown(&self) -> usize {
        self.missing[Missing::Unknown as usize]
    }

    /// Frames that do not show what is needed.
    #[must_use]
    pub fn not_measurable(&self) -> usize {
        self.missing.iter().sum::<usize>() - self.unknown()
    }

    fn add(&mut self, row: &Row, frame: usize) {
        let score = match row.score {
            Ok(score) => score,
            Err(missing) => {
                self.missing[missing as usize] += 1;
                return;
            }
        };
        let raw = row.raw.unwrap_or(0.0);
        let mut levels = [0; 3];
        levels[match score.level() {
            Level::Green => 0,
            Level::Orange => 1,
            Level::Red => 2,
        }] = 1;
        self.merge(&Self {
            scored: 1,
            levels,
            worst: Some((score.number(), frame)),
            raw_range: Some([raw, raw]),
            missing: [0; 5],
            sum: f64::from(score.number()),
            raw_sum: raw,
        });
    }

    /// The level of [`mean_score`](Self::mean_score).
    #[must_use]
    pub fn mean_level(&self) -> Option<Level> {
        // A cast from float saturates.
        let level = |mean: f64| Score::new(mean.round() as u8).level();
        self.mean_score().map(level)
    }

    /// Adds later frames.
    fn merge(&mut self, later: &Self) {
        self.scored += later.scored;
        for (count, more) in self.levels.iter_mut().zip(later.levels) {
            *count += more;
        }
        self.worst = match (self.worst, later.worst) {
            (Some(worst), Some(other)) if other.0 > worst.0 => Some(other),
            (worst, other) => worst.or(other),
        };
        self.raw_range = match (self.raw_range, later.raw_range) {
            (Some([low, high]), Some(other)) => Some([low.min(other[0]), high.max(other[1])]),
            (range, other) => range.or(other),
        };
        for (count, more) in self.missing.iter_mut().zip(later.missing) {
            *count += more;
        }
        self.sum += later.sum;
        self.raw_sum += later.raw_sum;
    }
}

impl Summary {
    /// Adds a frame.
    pub fn add(&mut self, record: &Record) {
        self.frames += 1;
        self.shots += usize::from(record.begins_shot);
        if record.stereoscopy == Stereoscopy::Unknown {
            self.undecided.add(record.frame);
        }
        for (summary, row) in self.rows.iter_mut().zip(&record.rows) {
            summary.add(row, record.frame);
        }
    }

    /// Adds a summary of later frames.
    pub fn merge(&mut self, later: &Self) {
        self.frames += later.frames;
        self.shots += later.shots;
        self.undecided.merge(&later.undecided);
        for (row, more) in self.rows.iter_mut().zip(&later.rows) {
            row.merge(more);
        }
    }

    /// The row of a quantity.
    #[must_use]
    pub fn row(&self, dimension: Dimension) -> &RowSummary {
        // They are in the order of the declaration.
        &self.rows[dimension as usize]
    }

    /// The worst level of any frame in the quantities that strain the eyes, which are all but
    /// [`Dimension::WeakDepth`]; `None` where none of these has a score.
    #[must_use]
    pub fn strain(&self) -> Option<Level> {
        let strains = |dimension: &Dimension| *dimension != Dimension::WeakDepth;
        let rows = Dimension::ALL.into_iter().filter(strains);
        let levels = rows.flat_map(|dimension| {
            let all = [Level::Green, Level::Orange, Level::Red];
            all.into_iter().zip(self.row(dimension).levels)
        });
        let found = levels.filter(|(_, frames)| *frames > 0);
        found.map(|(level, _)| level).max()
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
        Stereoscopy::Unknown => Missing::Unknown.reason(),
    }
}

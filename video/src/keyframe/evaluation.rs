//! Found cuts against labelled ones.

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

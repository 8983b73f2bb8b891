//! What is varied in an evaluation.

use std::fmt;

use serde::Serialize;

/// How many cameras there are, and how well they see.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Case {
    /// The standard deviation of the noise in each coordinate, in pixels.
    pub noise_px: f64,
    /// The number of cameras.
    pub views: usize,
    /// The probability that a view does not show a joint, from 0 to below 1.
    pub missing: f64,
}

impl Case {
    /// All combinations, of which the noise varies fastest and the missing joints most slowly.
    ///
    /// ```
    /// use ga_body::evaluation::Case;
    ///
    /// let cases = Case::combinations(&[0.0, 2.0], &[1, 4], &[0.0]);
    /// assert_eq!(cases.len(), 4);
    /// assert_eq!(cases[1], Case { noise_px: 2.0, views: 1, missing: 0.0 });
    /// ```
    #[must_use]
    pub fn combinations(noise_px: &[f64], views: &[usize], missing: &[f64]) -> Vec<Self> {
        let all = missing.iter().flat_map(|&missing| {
            views.iter().flat_map(move |&views| {
                noise_px.iter().map(move |&noise_px| Self {
                    noise_px,
                    views,
                    missing,
                })
            })
        });
        all.collect()
    }

    /// The number of cameras in words.
    pub(super) fn counted_views(views: usize) -> String {
        match views {
            1 => "1 view".to_owned(),
            views => format!("{views} views"),
        }
    }

    /// The part of the joints that is missing in words, after a comma; nothing where none is.
    pub(super) fn missing_in_words(missing: f64) -> String {
        match missing {
            0.0 => String::new(),
            missing => format!(", {} % of the joints missing", 100.0 * missing),
        }
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let views = Self::counted_views(self.views);
        let missing = Self::missing_in_words(self.missing);
        write!(f, "{views}, {} px of noise{missing}", self.noise_px)
    }
}

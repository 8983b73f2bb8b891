//! Scores from measurements.

use super::dimension::Dimension;
use std::fmt;

use super::viewing::Viewing;

/// How uncomfortable something is, from 0 to 15 as in Cui, table 6.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Score(u8);

impl Score {
    /// The greatest score.
    pub const MOST: Self = Self(15);

    /// The score of this number; more than 15 is 15.
    #[must_use]
    pub const fn new(number: u8) -> Self {
        if number < 15 {
            Self(number)
        } else {
            Self::MOST
        }
    }

    /// The number from 0 to 15.
    #[must_use]
    pub fn number(self) -> u8 {
        self.0
    }

    /// Green up to 7, orange up to 13, red above.
    #[must_use]
    pub fn level(self) -> Level {
        match self.0 {
            0..=7 => Level::Green,
            8..=13 => Level::Orange,
            _ => Level::Red,
        }
    }
}

impl fmt::Display for Score {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// The three colours of Cui, table 6.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// Comfortable.
    Green,
    /// Uncomfortable after a while.
    Orange,
    /// Uncomfortable at once.
    Red,
}

impl Level {
    /// The name in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Green => "green",
            Self::Orange => "orange",
            Self::Red => "red",
        }
    }
}

/// The limits between comfort and discomfort of one quantity.
///
/// Up to the comfortable amount c the score rises linearly from 0 to 7, from there to the limit l
/// in six steps from 8 to 13; up to 1.5 l it is 14, and beyond it 15. The sign of a raw number does
/// not count. Where too little is uncomfortable, as in [`Dimension::WeakDepth`], c is above l and
/// the same holds for reciprocals.
///
/// | row | raw number | c | l | source |
/// | --- | --- | --- | --- | --- |
/// | brightness | difference of luminance | 20 % | 50 % | our choice |
/// | colour | length of (Δa\*, Δb\*) | 3 | 10 | our choice |
/// | vertical | 95th percentile of the difference of height | 5′ | 20′ | our choice |
/// | asynchrony | delay of one eye | 0.25 frames | 1 frame | our choice |
/// | parallax deviation | change of the median parallax | 20′ | 60′ | our choice |
/// | weak depth | range of parallax | 0.5 % | 0.15 % of the width | our choice |
/// | rich depth | range of parallax | 3 % | 6 % of the width | c: BSkyB; l: our choice |
/// | over-convergence | crossed parallax | 1° | 1.84° | c: Lambooij; l: Nagata |
/// | over-divergence | uncrossed parallax | 1° | 2.04°, or parallel | c: Lambooij; l: Nagata |
/// | focal gap | difference of sharpness, log2 | 0.2 | 1 | our choice |
/// | focal gap | difference of size | 1 % | 2.5 % | our choice |
///
/// - BSkyB, "Technical guidelines for plano stereoscopic (3D) programme content": a depth budget of
///   3 % of the width for the main subject, from −1 % to +2 %, on screens of 46 to 70 inches.
/// - M. Lambooij, W. IJsselsteijn and I. Heynderickx, "Visual discomfort in stereoscopic displays:
///   a review", Proceedings of SPIE 6490, 2007: conflicts of accommodation and convergence are of
///   minor importance up to one degree of disparity.
/// - S. Nagata, 2002: the 84th percentile of what viewers fuse, crossed and uncrossed. Where the
///   parallax at which lines of sight become parallel is a smaller angle, that is the limit l of
///   over-divergence, and c is at most three quarters of it, which is our choice.
///
/// F. L. Kooi and A. Toet, "Visual comfort of binocular and 3D displays", Displays 25, 2004, found
/// that nearly all differences between the views reduce comfort if they are large enough. Where a
/// limit is our choice, it is not taken from a publication.
///
/// Stereoscopy is not a matter of degree, so that it has no scale.
///
/// ```
/// use ga_video::comfort::{Dimension, Level, Scale, Viewing};
///
/// let vertical = Scale::of(Dimension::Vertical, &Viewing::default()).unwrap();
/// let scores = [0.0, 2.5, 5.0, 5.1, 20.0, 25.0, 31.0].map(|raw| vertical.score(raw).number());
/// assert_eq!(scores, [0, 4, 7, 8, 13, 14, 15]);
///
/// let weak = Scale::of(Dimension::WeakDepth, &Viewing::default()).unwrap();
/// let scores = [2.0, 0.5, 0.49, 0.15, 0.12, 0.0].map(|raw| weak.score(raw).number());
/// assert_eq!(scores, [2, 7, 8, 13, 14, 15]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    comfortable: f64,
    limit: f64,
}

/// The scale of the difference of size in [`Dimension::FocalGap`], in per cent.
pub const SIZE: Scale = Scale {
    comfortable: 1.0,
    limit: 2.5,
};

impl Scale {
    /// The scale of a quantity for eyes before a screen; `None` for stereoscopy.
    #[must_use]
    pub fn of(dimension: Dimension, viewing: &Viewing) -> Option<Self> {
        let [comfortable, limit] = match dimension {
            Dimension::Brightness => [20.0, 50.0],
            Dimension::Colour => [3.0, 10.0],
            Dimension::Vertical => [5.0, 20.0],
            Dimension::Asynchrony => [0.25, 1.0],
            Dimension::ParallaxDeviation => [20.0, 60.0],
            Dimension::Stereoscopy => return None,
            Dimension::WeakDepth => [0.5, 0.15],
            Dimension::RichDepth => [3.0, 6.0],
            Dimension::OverConvergence => [1.0, 1.84],
            Dimension::OverDivergence => {
                let limit = viewing
                    .degrees_of_parallax(viewing.parallel_percent())
                    .min(2.04);
                [(0.75 * limit).min(1.0), limit]
            }
            Dimension::FocalGap => [0.2, 1.0],
        };
        Some(Self { comfortable, limit })
    }

    /// The greatest amount that is comfortable; the least one where too little is uncomfortable.
    #[must_use]
    pub fn comfortable(&self) -> f64 {
        self.comfortable
    }

    /// The amount at which discomfort becomes severe.
    #[must_use]
    pub fn limit(&self) -> f64 {
        self.limit
    }

    /// The score of a raw number; 15 for one that is not a number.
    #[must_use]
    pub fn score(&self, raw: f64) -> Score {
        let amount = raw.abs();
        let [amount, comfortable, limit] = match self.comfortable > self.limit {
            true => [amount, self.comfortable, self.limit].map(f64::recip),
            false => [amount, self.comfortable, self.limit],
        };
        let number = if amount <= comfortable {
            (7.0 * amount / comfortable).round()
        } else if amount <= limit {
            // Six equal steps; the last one includes the limit.
            (8.0 + (6.0 * (amount - comfortable) / (limit - comfortable)).floor()).min(13.0)
        } else if amount <= 1.5 * limit {
            14.0
        } else {
            15.0
        };
        Score::new(number as u8)
    }
}

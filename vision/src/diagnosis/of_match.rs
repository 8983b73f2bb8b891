//! Why two views were matched badly as a whole.

use ga_image::plane::Plane;
use ga_image::sample::{Pixel, Sample};
use ga_numerics::order_statistics::Sorted;

use super::{Diagnosis, DiagnosisFault, DiagnosisOptions};
use crate::disparity::range::{along_rows, points_of_both};
use crate::geometry_error::ViewGeometryError;
use crate::matcher::Match;

/// Where the mean confidence of pixels with texture is below this, the views are looked at. The ten
/// rectified pairs that it was chosen by have 0.34 to 0.72 in all modes, and those of them that are
/// exchanged, rotated or displaced by two rows or more 0.01 to 0.36.
const SUSPICIOUS: f64 = 0.4;
/// Below this nearly nothing was found, whether a reason is known or not. Views of different scenes
/// have 0.01 to 0.09.
const HOPELESS: f64 = 0.12;
/// The least part of the pixels with texture.
const LEAST_TEXTURE: f64 = 0.01;
/// The part of the points that may be outside the range of disparities: mismatches.
const OUTSIDE: f64 = 0.1;
/// The part of the confirmed disparities that may be at an end of the range.
const AT_END: f64 = 0.05;
/// Fewer points say nothing.
const LEAST_POINTS: usize = 10;

/// Why views are matched badly.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MatchFault {
    /// The views are no rectified pair.
    #[error(transparent)]
    Pair(DiagnosisFault),
    /// Disparities are not in the range that was looked at.
    #[error(
        "{outside:.0} % of the points that both views show have disparities outside the range from \
         {} px up to, and without, {} px: 99 % are from {:.0} to {:.0} px",
        range[0], range[1], found[0], found[1]
    )]
    Range {
        /// How many points have such disparities, in percent.
        outside: f64,
        /// The range that was looked at.
        range: [i32; 2],
        /// What 99 % of the disparities are between.
        found: [f64; 2],
    },
    /// The views have no texture.
    #[error(
        "{textured:.2} % of the pixels differ from their neighbours in the row: nothing tells \
         disparities apart"
    )]
    NoTexture {
        /// Pixels whose costs have a minimum, in percent.
        textured: f64,
    },
    /// The confidence is low, and the reason is not known.
    #[error(
        "the mean confidence is {confidence:.3}: the views seem to show different scenes ({})",
        match reason {
            Some(reason) => reason.to_string(),
            None => "few pixels have a match, though the views are rectified".into(),
        }
    )]
    Unclear {
        /// The mean confidence of pixels with texture.
        confidence: f64,
        /// Why the views cannot be diagnosed.
        reason: Option<ViewGeometryError>,
    },
}

impl MatchFault {
    /// One word for programs.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Pair(fault) => fault.kind(),
            Self::Range { .. } => "outside_range",
            Self::NoTexture { .. } => "no_texture",
            Self::Unclear { .. } => "unclear_match",
        }
    }
}

/// Why two views were matched badly, where most of what was found is not certain; nothing where it
/// is. Points that both views show are looked for only in the first case. `range` is that of the
/// disparities that were looked for.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::diagnosis::of_match::faults_of_match;
/// use ga_vision::matcher::{Matcher, MatcherOptions, Mode};
///
/// // Random blocks at a disparity of 9 px, and the same views exchanged.
/// let grey = |u: usize, v: usize| {
///     let block = (u / 9 + 1) * 7919 + (v / 9 + 1) * 104_729;
///     (block * block / 977 % 200) as u8
/// };
/// let [left, right] = [0, 9].map(|shift| Plane::from_fn(240, 200, |u, v| grey(u + shift, v)));
/// let range = [0, 32];
/// let options = MatcherOptions { range, mode: Mode::Fast, threads: 1 };
/// let mut matcher = Matcher::new(options, 240, 200)?;
/// let found = matcher.run(&left, &right)?;
/// assert!(faults_of_match([&left, &right], &found, range).is_empty());
/// let found = matcher.run(&right, &left)?;
/// let faults = faults_of_match([&right, &left], &found, range);
/// assert_eq!(faults[0].kind(), "views_exchanged");
/// # Ok::<(), ga_vision::disparity::StereoError>(())
/// ```
#[must_use]
pub fn faults_of_match<T: Sample + Pixel>(
    [left, right]: [&Plane<T>; 2],
    found: &Match,
    range: [i32; 2],
) -> Vec<MatchFault> {
    let pixels = found.confidence.values();
    if (found.textured as f64) < LEAST_TEXTURE * pixels.len() as f64 {
        let textured = found.summary().textured;
        return vec![MatchFault::NoTexture { textured }];
    }
    let sum: f64 = pixels.iter().map(|c| f64::from(*c)).sum();
    let confidence = sum / found.textured as f64;
    if confidence >= SUSPICIOUS && at_ends(found, range) < AT_END {
        return Vec::new();
    }
    let pairs = points_of_both(left, right);
    let size = [left.width(), left.height()];
    let (mut faults, reason) = match Diagnosis::new(&pairs, size, DiagnosisOptions::default()) {
        Ok(diagnosis) if diagnosis.agreeing >= LEAST_POINTS || diagnosis.is_sideways => {
            (diagnosis.faults(), None)
        }
        Ok(diagnosis) => {
            let (found, needed) = (diagnosis.agreeing, LEAST_POINTS);
            (
                Vec::new(),
                Some(ViewGeometryError::TooFewMatches { found, needed }),
            )
        }
        Err(error) => (Vec::new(), Some(error)),
    };
    let is_rectified = faults
        .iter()
        .all(|fault| *fault == DiagnosisFault::Exchanged);
    let beside = outside(&along_rows(&pairs), range).filter(|_| is_rectified && reason.is_none());
    // Cameras that are turned towards each other see negative disparities as well.
    let is_within = is_rectified && beside.is_none();
    faults.retain(|fault| *fault != DiagnosisFault::Exchanged || !is_within);
    let mut faults: Vec<_> = faults
        .into_iter()
        .map(MatchFault::Pair)
        .chain(beside)
        .collect();
    if faults.is_empty() && confidence < HOPELESS {
        faults.push(MatchFault::Unclear { confidence, reason });
    }
    faults
}

/// The part of the confirmed disparities that are at an end of the range, as those beyond it are;
/// at 0 they may be far away.
fn at_ends(found: &Match, [least, beyond]: [i32; 2]) -> f64 {
    let values = found.disparity.plane().values().iter();
    let confirmed = values
        .zip(found.confidence.values())
        .filter(|(_, c)| **c > 0.0);
    let is_at_end = |d: f32| d >= (beyond - 1) as f32 || least != 0 && d <= least as f32;
    let at_end = confirmed.clone().filter(|(d, _)| is_at_end(**d)).count();
    at_end as f64 / confirmed.count().max(1) as f64
}

/// That disparities of points are not in a range.
fn outside(disparities: &[f64], range: [i32; 2]) -> Option<MatchFault> {
    let [least, beyond] = range.map(f64::from);
    let is_outside = |d: &&f64| **d < least - 1.0 || **d > beyond;
    let share = disparities.iter().filter(is_outside).count() as f64 / disparities.len() as f64;
    let mut sorted = disparities.to_vec();
    let sorted = Sorted::new(&mut sorted)?;
    (disparities.len() >= LEAST_POINTS && share > OUTSIDE).then(|| MatchFault::Range {
        outside: 100.0 * share,
        range,
        found: [0.005, 0.995].map(|share| sorted.quantile(share)),
    })
}

//! The range of the disparities of two rectified views, from points that both show.

use ga_image::plane::Plane;
use ga_image::pyramid::halved;
use ga_image::resample::{Method, resize};
use ga_image::sample::{Pixel, Sample};
use ga_numerics::order_statistics::Sorted;

use super::error::StereoError;
use crate::feature::{PixelPair, ViewOptions, match_views};
use crate::matcher::{GREATEST_RANGE, Matcher, MatcherOptions, Mode};

/// Points of rectified views whose rows differ by more than this number of pixels are mismatches.
const ROW_TOLERANCE: f64 = 2.0;
/// Fewer points do not tell a range.
const LEAST_POINTS: usize = 20;
/// Views with a longer side up to [`SMALL`] pixels that show fewer points are looked at in twice
/// their size.
const ENOUGH_POINTS: usize = 100;
const SMALL: usize = 800;
/// The part of the points beyond either end of the range before its margin: mismatches.
const BEYOND: f64 = 0.005;
/// The margin at either end: this part of the range, and this number of pixels.
const MARGIN: (f64, f64) = (0.1, 4.0);
/// Surfaces without corners are looked for beyond those of the points by the length of their range,
/// and at least by this number of pixels.
const REACH: f64 = 32.0;
/// Pixels of the small views are counted whose confidence is at least this.
const CONFIDENCE: f32 = 0.2;
/// Views are halved to no more columns than this before they are matched.
const COLUMNS: usize = 320;
/// Views are not halved to fewer rows than this: a matcher compares windows of several rows.
const ROWS: usize = 16;
/// The number of disparities is a multiple of this, as blocks of candidates are.
const MULTIPLE: u32 = 16;

/// The range of the disparities of two views.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DisparityRange {
    /// The least disparity in pixels, and the first one beyond the greatest.
    pub ends: [i32; 2],
    /// How many points it was found from.
    pub points: usize,
}

impl DisparityRange {
    /// The range of two rectified views in grey: that of 99 % of the points that both show in one
    /// row, and of 99 % of the pixels that are matched clearly at a small size in a range up to
    /// three times as long, with a margin of a tenth and 4 px at either end. Their number is a
    /// multiple of 16, or as many as a [`Matcher`] looks for. The rule is our own.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    /// use ga_vision::disparity::range::DisparityRange;
    ///
    /// // Random blocks, and the same further right by 9 px.
    /// let grey = |u: usize, v: usize| {
    ///     let block = (u / 9 + 1) * 7919 + (v / 9 + 1) * 104_729;
    ///     (block * block / 977 % 200) as u8
    /// };
    /// let left = Plane::from_fn(240, 200, |u, v| grey(u + 9, v));
    /// let right = Plane::from_fn(240, 200, grey);
    /// let [least, beyond] = DisparityRange::of(&left, &right, 1)?.ends;
    /// assert!((-18..-9).contains(&least) && (-8..4).contains(&beyond));
    /// # Ok::<(), ga_vision::disparity::StereoError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`StereoError::FewPoints`] for fewer than 20 of them, and those of [`Matcher`].
    pub fn of<T: Sample + Pixel>(
        left: &Plane<T>,
        right: &Plane<T>,
        threads: usize,
    ) -> Result<Self, StereoError> {
        let mut disparities = along_rows(&points_of_both(left, right));
        let points = disparities.len();
        let sorted = Sorted::new(&mut disparities).filter(|_| points >= LEAST_POINTS);
        let Some(sorted) = sorted else {
            return Err(StereoError::FewPoints {
                found: points,
                needed: LEAST_POINTS,
            });
        };
        let [mut low, mut high] = [BEYOND, 1.0 - BEYOND].map(|share| sorted.quantile(share));
        let reach = (high - low).max(REACH);
        let wide = [low - reach, high + reach];
        let (mut clear, _) = clear_disparities(left, right, CONFIDENCE, threads, |_| wide)?;
        if let Some(sorted) = Sorted::new(&mut clear) {
            low = low.min(sorted.quantile(BEYOND));
            high = high.max(sorted.quantile(1.0 - BEYOND));
        }
        let margin = MARGIN.0 * (high - low) + MARGIN.1;
        let width = left.width() as i32;
        let most = left.width().min(GREATEST_RANGE) as i32;
        let least = ((low - margin).floor() as i32).max(1 - width);
        let beyond = (high + margin).ceil() as i32 + 1;
        let count = (beyond.saturating_sub(least).max(1).unsigned_abs()).next_multiple_of(MULTIPLE);
        let beyond = (least + count.cast_signed().min(most)).min(width);
        Ok(Self {
            ends: [least, beyond],
            points,
        })
    }
}

/// The disparities in pixels of what is matched with at least this confidence at a small size,
/// within a range for views of this width; and how many pixels one of that size is wide.
pub(crate) fn clear_disparities<T: Sample + Pixel>(
    left: &Plane<T>,
    right: &Plane<T>,
    confidence: f32,
    threads: usize,
    range: impl Fn(f64) -> [f64; 2],
) -> Result<(Vec<f64>, usize), StereoError> {
    let (mut small, mut factor) = ([left.clone(), right.clone()], 1);
    while small[0].width() > COLUMNS && small[0].height() >= 2 * ROWS {
        small = [halved(&small[0]), halved(&small[1])];
        factor *= 2;
    }
    let (width, step) = (small[0].width(), factor as f64);
    let [least, beyond] = range(width as f64 * step).map(|end| (end / step) as i64);
    let last = width.max(1) as i64;
    let least = least.clamp(1 - last, last - 1);
    let beyond = beyond.clamp(least + 1, last.min(least + last.min(GREATEST_RANGE as i64)));
    let options = MatcherOptions {
        range: [least as i32, beyond as i32],
        mode: Mode::Fast,
        threads,
    };
    let mut matcher = Matcher::new(options, width, small[0].height())?;
    let found = matcher.run(&small[0], &small[1])?.at_least(confidence);
    let known = found
        .disparity
        .plane()
        .values()
        .iter()
        .filter(|d| d.is_finite());
    Ok((known.map(|d| f64::from(*d) * step).collect(), factor))
}

/// Points that two views show. Small views have few corners; they are looked at in twice their
/// size.
pub(crate) fn points_of_both<T: Sample + Pixel>(
    left: &Plane<T>,
    right: &Plane<T>,
) -> Vec<PixelPair> {
    let options = ViewOptions::default();
    let pairs = match_views(left, right, &options);
    if pairs.len() >= ENOUGH_POINTS || left.width().max(left.height()) > SMALL {
        return pairs;
    }
    let doubled = |view: &Plane<T>| {
        resize(view, 2 * view.width(), 2 * view.height(), Method::Bilinear).unwrap_or_default()
    };
    let mut more = match_views(&doubled(left), &doubled(right), &options);
    // The centre of the first pixel is in the middle of four.
    let halved = |pixel: [f64; 2]| pixel.map(|place| 0.5 * place - 0.25);
    for pair in &mut more {
        *pair = PixelPair {
            left: halved(pair.left),
            right: halved(pair.right),
        };
    }
    if more.len() > pairs.len() {
        more
    } else {
        pairs
    }
}

/// The disparities of points that are in one row, up to the accuracy of points.
pub(crate) fn along_rows(pairs: &[PixelPair]) -> Vec<f64> {
    let is_in_row = |pair: &&PixelPair| (pair.right[1] - pair.left[1]).abs() <= ROW_TOLERANCE;
    let pairs = pairs.iter().filter(is_in_row);
    pairs.map(|pair| pair.left[0] - pair.right[0]).collect()
}

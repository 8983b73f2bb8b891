//! The range of the disparities of two rectified views, from points that both show.

use ga_image::plane::Plane;
use ga_numerics::order_statistics::Sorted;

use super::error::StereoError;
use crate::feature::{PixelPair, ViewOptions, match_views};

/// Points of rectified views whose rows differ by more than this number of pixels are mismatches.
const ROW_TOLERANCE: f64 = 2.0;
/// Fewer points do not tell a range.
const LEAST_POINTS: usize = 20;
/// The part of the points beyond either end of the range before its margin: mismatches.
const BEYOND: f64 = 0.005;
/// The margin at either end: this part of the range, and this number of pixels. Corners are seldom
/// on the nearest and the farthest thing.
const MARGIN: (f64, f64) = (0.15, 4.0);
/// The number of disparities is a multiple of this, as blocks of candidates are.
const MULTIPLE: u32 = 16;
/// The greatest number of disparities that a matcher looks for.
pub const GREATEST_RANGE: usize = 2047;

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
    /// row, with a margin of 15 % and 4 px at either end, up to a multiple of 16 disparities. Every
    /// disparity of it points into the views. The rule is our own.
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
    /// let [least, beyond] = DisparityRange::of(&left, &right)?.ends;
    /// assert!((-18..-9).contains(&least) && (-8..4).contains(&beyond));
    /// # Ok::<(), ga_vision::disparity::StereoError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`StereoError::FewPoints`] for fewer than 20 of them.
    pub fn of(left: &Plane<u8>, right: &Plane<u8>) -> Result<Self, StereoError> {
        let pairs = match_views(left, right, &ViewOptions::default());
        let mut disparities = along_rows(&pairs);
        let points = disparities.len();
        let sorted = Sorted::new(&mut disparities).filter(|_| points >= LEAST_POINTS);
        let Some(sorted) = sorted else {
            return Err(StereoError::FewPoints {
                found: points,
                needed: LEAST_POINTS,
            });
        };
        let [low, high] = [BEYOND, 1.0 - BEYOND].map(|share| sorted.quantile(share));
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

/// The disparities of points that are in one row, up to the accuracy of points.
pub(crate) fn along_rows(pairs: &[PixelPair]) -> Vec<f64> {
    let is_in_row = |pair: &&PixelPair| (pair.right[1] - pair.left[1]).abs() <= ROW_TOLERANCE;
    let pairs = pairs.iter().filter(is_in_row);
    pairs.map(|pair| pair.left[0] - pair.right[0]).collect()
}

//! What a pair of rectified views needs before its disparities are a surface.

use ga_image::plane::{Plane, PlaneError, PlaneView, same_size};
use ga_image::sample::{Pixel, Sample};
use ga_numerics::order_statistics::Sorted;

use crate::disparity::range::clear_disparities;
use crate::disparity::{DisparityMap, StereoError};
use crate::matcher::GREATEST_RANGE;

/// The part of the pixels whose disparity the range holds.
const PART: f64 = 0.995;
/// Pixels are counted whose confidence is at least this.
const CONFIDENCE: f32 = 0.1;

/// A range of disparities from 0 that holds those of two rectified views, for
/// [`MatcherOptions::range`](crate::matcher::MatcherOptions::range): a multiple of 16 px, or the
/// greatest range that a matcher accepts for views of this width.
///
/// The views are matched at a small size over two thirds of their width. The range ends a tenth
/// beyond the disparity that 99.5 % of the confident pixels stay below. The rule is our own.
///
/// # Errors
/// [`StereoError`] for views that cannot be matched.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::surface::disparity_range;
///
/// // Random blocks, and the same at a disparity of 21 px.
/// let grey = |u: usize, v: usize| {
///     let block = (u / 4 + 1) * 7919 + (v / 4 + 1) * 104_729;
///     (block * block / 977 % 200) as u8
/// };
/// let left = Plane::from_fn(400, 160, grey);
/// let right = Plane::from_fn(400, 160, |u, v| grey(u + 21, v));
/// let range = disparity_range(&left, &right, 1)?;
/// assert!(range > 21 && range <= 64, "{range}");
/// # Ok::<(), ga_vision::disparity::StereoError>(())
/// ```
pub fn disparity_range<T: Sample + Pixel>(
    left: &Plane<T>,
    right: &Plane<T>,
    threads: usize,
) -> Result<usize, StereoError> {
    let reach = |width: f64| [0.0, width * 2.0 / 3.0];
    let (mut disparities, factor) = clear_disparities(left, right, CONFIDENCE, threads, reach)?;
    let most = Sorted::new(&mut disparities).map_or(0.0, |sorted| sorted.quantile(PART));
    // One candidate of the small views is several of the large ones.
    let range = (1.1 * most) as usize + 2 * factor;
    let greatest = left.width().min(GREATEST_RANGE);
    Ok(range.next_multiple_of(16).min(greatest))
}

/// The disparities of pixels that both cameras see: others are made unknown. `inside` says of each
/// pixel of the left and of the right rectified view whether its camera sees it
/// ([`Warp::inside`](ga_image::warp::Warp::inside)).
///
/// # Errors
/// [`PlaneError::Differs`] for planes of different sizes.
pub fn seen_by_both(
    map: &DisparityMap,
    inside: [PlaneView<'_, bool>; 2],
) -> Result<DisparityMap, PlaneError> {
    let [left, right] = inside;
    same_size(map.view(), left)?;
    same_size(map.view(), right)?;
    let pixels = Plane::from_fn(map.width(), map.height(), |column, row| {
        let disparity = map.get(column, row).unwrap_or(f32::NAN);
        // The pixel at the place where the right camera sees the point, rounded; negative columns
        // are outside.
        let place = column as f32 - disparity + 0.5;
        let is_seen = left.row(row)[column]
            && place >= 0.0
            && right.get(place as usize, row).unwrap_or(false);
        if is_seen { disparity } else { f32::NAN }
    });
    Ok(DisparityMap::new(pixels))
}

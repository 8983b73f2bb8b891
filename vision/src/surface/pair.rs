//! What a pair of rectified views needs before its disparities are a surface.

use ga_image::plane::{Plane, PlaneError, PlaneView, same_size};
use ga_image::pyramid::halved;
use ga_numerics::order_statistics::Sorted;

use crate::disparity::range::GREATEST_RANGE;
use crate::disparity::{DisparityMap, StereoError};
use crate::matcher::{Matcher, MatcherOptions, Mode};

/// Views are halved to no more columns than this before their range is measured.
const COLUMNS: usize = 320;
/// Views are not halved to fewer rows than this: a matcher compares windows of several rows.
const ROWS: usize = 16;
/// The part of the pixels whose disparity the range holds.
const PART: f64 = 0.995;
/// Pixels are counted whose confidence is at least this.
const CONFIDENCE: f32 = 0.1;

/// A range of disparities from 0 that holds those of two rectified views, for
/// [`MatcherOptions::range`]: a multiple of 16 px, or the greatest range that a [`Matcher`] accepts
/// for views of this width.
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
pub fn disparity_range(
    left: &Plane<u8>,
    right: &Plane<u8>,
    threads: usize,
) -> Result<usize, StereoError> {
    let width = left.width();
    let (mut small, mut factor) = ([left.clone(), right.clone()], 1);
    while small[0].width() > COLUMNS && small[0].height() >= 2 * ROWS {
        small = [halved(&small[0]), halved(&small[1])];
        factor *= 2;
    }
    let reach = (small[0].width() * 2 / 3).clamp(1, GREATEST_RANGE);
    let options = MatcherOptions {
        range: [0, reach as i32],
        mode: Mode::Fast,
        threads,
    };
    let mut matcher = Matcher::new(options, small[0].width(), small[0].height())?;
    let found = matcher.run(&small[0], &small[1])?;
    let pixels = found.disparity.plane().values().iter();
    let confident = pixels.zip(found.confidence.values());
    let mut disparities: Vec<f32> = confident
        .filter(|(disparity, confidence)| disparity.is_finite() && **confidence >= CONFIDENCE)
        .map(|(disparity, _)| *disparity)
        .collect();
    let most = Sorted::new(&mut disparities).map_or(0.0, |sorted| sorted.quantile(PART));
    let most = f64::from(most) * factor as f64;
    // One candidate of the small views is several of the large ones.
    let range = (1.1 * most) as usize + 2 * factor;
    Ok(range.next_multiple_of(16).min(width).min(GREATEST_RANGE))
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

//! Pictures at other sizes.
//!
//! A picture covers the same rectangle before and after. The centre of pixel *i* of *n* is at
//! (*i* + ½) / *n* of the width, so that nothing moves by parts of a pixel.

use crate::plane::{Plane, PlaneError, PlaneView};
use crate::sample::{Pixel, Sample};

/// How the pixels of the new size are made from the old ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The old pixel in which the centre of the new one lies.
    Nearest,
    /// Linear interpolation along both axes between the centres of the four nearest old pixels;
    /// beyond the outermost centres the picture is constant. For enlarging: when a picture shrinks
    /// to less than half, some of its pixels do not take part.
    Bilinear,
    /// The mean of the old picture over the square of the new pixel, old pixels counted by the area
    /// that lies in it. For shrinking: no pixel is left out, and the mean of the picture is kept.
    Area,
}

/// The picture at another size.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::resample::{Method, resize};
///
/// let plane = Plane::from_values(4, 1, vec![0u8, 100, 40, 60])?;
/// assert_eq!(resize(&plane, 2, 1, Method::Area)?.values(), [50, 50]);
/// assert_eq!(resize(&plane, 2, 1, Method::Nearest)?.values(), [100, 60]);
/// assert_eq!(resize(&plane, 8, 1, Method::Bilinear)?.values()[..4], [0, 25, 75, 85]);
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
///
/// # Errors
///
/// [`PlaneError::TooSmall`] when the picture has no pixels and the new size has some.
pub fn resize<'a, P: Pixel>(
    picture: impl Into<PlaneView<'a, P>>,
    width: usize,
    height: usize,
    method: Method,
) -> Result<Plane<P>, PlaneError> {
    let picture = picture.into();
    if picture.is_empty() && width > 0 && height > 0 {
        return Err(PlaneError::TooSmall {
            width: picture.width(),
            height: picture.height(),
            least: 1,
        });
    }
    Ok(match method {
        Method::Nearest => nearest(picture, width, height),
        Method::Bilinear => weighted(picture, width, height, bilinear),
        Method::Area => weighted(picture, width, height, area),
    })
}

/// The means of squares of `factor` × `factor` pixels, rounded; of fewer pixels at the right and at
/// the lower border where the sides are not multiples of the factor. As [`Method::Area`] for
/// factors that divide the sides, and several times as fast. A factor of 0 counts as 1.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::resample::box_means;
///
/// let plane = Plane::from_fn(5, 3, |column, row| (10 * row + column) as u8);
/// let means = box_means(&plane, 2);
/// assert_eq!(means.row(0), [6, 8, 9]);
/// assert_eq!(means.row(1), [21, 23, 24]);
/// ```
#[must_use]
pub fn box_means<'a>(picture: impl Into<PlaneView<'a, u8>>, factor: usize) -> Plane<u8> {
    means(picture.into(), factor)
}

fn means(picture: PlaneView<'_, u8>, factor: usize) -> Plane<u8> {
    let factor = factor.max(1);
    let (width, height) = (
        picture.width().div_ceil(factor),
        picture.height().div_ceil(factor),
    );
    let mut result = Plane::filled(width, height, 0);
    if result.is_empty() {
        return result;
    }
    let mut sums = vec![0_u32; picture.width()];
    for row in 0..height {
        sums.fill(0);
        let rows = row * factor..((row + 1) * factor).min(picture.height());
        let count = rows.len() as u32;
        for source in rows {
            for (sum, value) in sums.iter_mut().zip(picture.row(source)) {
                *sum += u32::from(*value);
            }
        }
        for (target, sums) in result.row_mut(row).iter_mut().zip(sums.chunks(factor)) {
            let pixels = count * sums.len() as u32;
            *target = ((sums.iter().sum::<u32>() + pixels / 2) / pixels) as u8;
        }
    }
    result
}

fn nearest<P: Pixel>(picture: PlaneView<'_, P>, width: usize, height: usize) -> Plane<P> {
    // (i + ½) · old / new, rounded down, in integers.
    let index = |i: usize, new: usize, old: usize| {
        ((2 * i as u128 + 1) * old as u128 / (2 * new as u128)) as usize
    };
    let columns: Vec<usize> = (0..width)
        .map(|column| index(column, width, picture.width()))
        .collect();
    let mut result = Plane::filled(width, height, P::default());
    for row in 0..height {
        let source = picture.row(index(row, height, picture.height()));
        for (target, column) in result.row_mut(row).iter_mut().zip(&columns) {
            *target = source[*column];
        }
    }
    result
}

/// The old pixels that make up a new one along one axis.
struct Share {
    first: usize,
    weights: Vec<f32>,
}

/// Along columns first, a row of the result at a time, then along rows.
fn weighted<P: Pixel>(
    picture: PlaneView<'_, P>,
    width: usize,
    height: usize,
    share: fn(usize, usize, usize) -> Share,
) -> Plane<P> {
    let mut result = Plane::filled(width, height, P::default());
    if result.is_empty() {
        return result;
    }
    let shares = |new, old| -> Vec<Share> { (0..new).map(|i| share(i, new, old)).collect() };
    let columns = shares(width, picture.width());
    let mut floats = vec![0.0f32; picture.width() * P::CHANNELS];
    let mut sums = floats.clone();
    let mut new = vec![0.0f32; width * P::CHANNELS];
    for (row, share) in shares(height, picture.height()).iter().enumerate() {
        sums.fill(0.0);
        for (offset, weight) in share.weights.iter().enumerate() {
            let source = P::samples(picture.row(share.first + offset));
            P::Sample::to_floats(source, &mut floats);
            add(&mut sums, *weight, &floats);
        }
        along_row(&sums, P::CHANNELS, &columns, &mut new);
        P::Sample::from_floats(&new, P::samples_mut(result.row_mut(row)));
    }
    result
}

fn add(sums: &mut [f32], weight: f32, floats: &[f32]) {
    for (sum, float) in sums.iter_mut().zip(floats) {
        *sum += weight * float;
    }
}

fn along_row(old: &[f32], channels: usize, columns: &[Share], new: &mut [f32]) {
    for (new, share) in new.chunks_exact_mut(channels).zip(columns) {
        for (channel, new) in new.iter_mut().enumerate() {
            let samples = old[share.first * channels + channel..].iter();
            let samples = samples.step_by(channels).zip(&share.weights);
            *new = samples.map(|(sample, weight)| weight * sample).sum();
        }
    }
}

fn bilinear(i: usize, new: usize, old: usize) -> Share {
    let place = (i as f64 + 0.5) * old as f64 / new as f64 - 0.5;
    let place = place.clamp(0.0, (old - 1) as f64);
    let first = (place as usize).min(old.saturating_sub(2));
    let second = (place - first as f64) as f32;
    let mut weights = vec![1.0 - second, second];
    weights.truncate(old);
    Share { first, weights }
}

fn area(i: usize, new: usize, old: usize) -> Share {
    // The new pixel covers i · old to (i + 1) · old, and old pixel j covers j · new to
    // (j + 1) · new, in units of 1 / (new · old): all lengths are integers.
    let [i, new, old] = [i, new, old].map(|n| n as u128);
    let (start, end) = (i * old, (i + 1) * old);
    let pixels = start / new..end.div_ceil(new);
    let weights = pixels.clone().map(|j| {
        let overlap = ((j + 1) * new).min(end) - (j * new).max(start);
        overlap as f32 / old as f32
    });
    Share {
        first: pixels.start as usize,
        weights: weights.collect(),
    }
}

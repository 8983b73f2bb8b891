//! What a pixel is made of: samples, one for each channel.

mod types;

use std::fmt::Debug;

use crate::luma::{Luma, weighted};
use crate::picture::PictureView;
use crate::plane::{Plane, PlaneView};

/// The number that one channel of a pixel holds: `u8`, `u16` or `f32`.
///
/// Black is 0. White is the greatest number of an integer type, and 1 for `f32`, which may also
/// hold numbers outside 0 to 1.
///
/// ```
/// use ga_image::sample::Sample;
///
/// assert_eq!(u8::from_f32(127.5), 128);
/// assert_eq!(u8::from_f32(-3.0), 0);
/// assert_eq!(u16::from_unit(0.5f32), 32768);
/// assert_eq!(255u8.to_unit(), 1.0);
/// ```
pub trait Sample: Copy + Debug + Default + PartialEq + PartialOrd + Send + Sync + 'static {
    /// The number of white.
    const WHITE: f32;

    /// The number as `f32`, without scaling.
    fn to_f32(self) -> f32;

    /// The nearest number of this type, without scaling. For integers, halves are rounded up, what
    /// is out of range becomes the nearest number in range, and NaN becomes 0.
    fn from_f32(value: f32) -> Self;

    /// The number divided by that of white.
    #[must_use]
    fn to_unit(self) -> f32 {
        self.to_f32() / Self::WHITE
    }

    /// The nearest number to `value` times that of white.
    #[must_use]
    fn from_unit(value: f32) -> Self {
        Self::from_f32(value * Self::WHITE)
    }

    /// The number where white is 255: that of a picture of 8 bits, with the fraction that other
    /// types keep. Thresholds of levels are meant for it.
    ///
    /// ```
    /// use ga_image::sample::Sample;
    ///
    /// assert_eq!((7u8.to_level(), (7 * 257u16).to_level()), (7.0, 7.0));
    /// assert_eq!(0.5f32.to_level(), 127.5);
    /// ```
    #[must_use]
    #[inline]
    fn to_level(self) -> f32 {
        // 255 and 65535 are multiples of 255.
        self.to_f32() / (Self::WHITE / 255.0)
    }

    /// The nearest number with 16 bits.
    #[doc(hidden)]
    #[must_use]
    fn to_u16(self) -> u16 {
        u16::from_unit(self.to_unit())
    }

    /// The numbers, without scaling. For whole rows: with those that follow it is compiled once for
    /// each type of sample, and not where it is called.
    #[doc(hidden)]
    fn to_floats(samples: &[Self], floats: &mut [f32]);

    /// See [`from_f32`](Self::from_f32).
    #[doc(hidden)]
    fn from_floats(floats: &[f32], samples: &mut [Self]);

    /// See [`Picture::to_grey`](crate::picture::Picture::to_grey).
    #[doc(hidden)]
    fn grey(picture: &PictureView<'_>, luma: Luma) -> Plane<Self>;

    /// See [`Picture::to_rgb`](crate::picture::Picture::to_rgb).
    #[doc(hidden)]
    fn rgb(picture: &PictureView<'_>) -> Plane<[Self; 3]>;

    /// See [`Picture::to_rgba`](crate::picture::Picture::to_rgba).
    #[doc(hidden)]
    fn rgba(picture: &PictureView<'_>) -> Plane<[Self; 4]>;

    /// The grey of a colour; see [`Luma::of`].
    #[doc(hidden)]
    #[must_use]
    fn luma(rgb: [Self; 3], luma: Luma) -> Self {
        Self::from_f32(weighted(rgb.map(Self::to_f32), luma))
    }

    /// The sum of the squared differences; see [`mse`](crate::quality::mse).
    #[doc(hidden)]
    #[must_use]
    #[inline(always)]
    fn squared_error(a: &[Self], b: &[Self]) -> f64 {
        squared_error(a, b)
    }
}

/// What a plane holds at each place: a sample, or an array of samples, one for each channel.
///
/// `[u8; 3]` is red, green and blue with 8 bits each; `[u8; 4]` has an alpha channel after them,
/// not premultiplied.
pub trait Pixel: Copy + Debug + Default + PartialEq + Send + Sync + 'static {
    /// The type of each channel.
    type Sample: Sample;

    /// The number of channels.
    const CHANNELS: usize;

    /// The samples of these pixels, one pixel after another.
    fn samples(pixels: &[Self]) -> &[Self::Sample];

    /// The samples of these pixels, to be changed.
    fn samples_mut(pixels: &mut [Self]) -> &mut [Self::Sample];

    /// See [`halved`](crate::pyramid::halved).
    #[doc(hidden)]
    fn halved(picture: PlaneView<'_, Self>) -> Plane<Self>;
}

/// A number of which `white` is the greatest, as one of 16 bits, rounded.
pub(crate) fn spread_to_16_bits(value: u16, white: u16) -> u16 {
    // At most 65535² + 32767, which is less than 2³².
    ((u32::from(value) * 65535 + u32::from(white) / 2) / u32::from(white)) as u16
}

/// The sum of the squared differences, added in eight parts.
#[inline(always)]
fn squared_error<S: Sample>(a: &[S], b: &[S]) -> f64 {
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    let square = |a: S, b: S| {
        let difference = f64::from(a.to_f32()) - f64::from(b.to_f32());
        difference * difference
    };
    let mut sums = [0.0; 8];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..8 {
            sums[lane] += square(a[lane], b[lane]);
        }
    }
    let rest = a_rest.iter().zip(b_rest).map(|(a, b)| square(*a, *b));
    sums.iter().sum::<f64>() + rest.sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_integer_survives_the_way_through_the_unit_interval() {
        assert!((0..=u8::MAX).all(|v| u8::from_unit(v.to_unit()) == v));
        assert!((0..=u16::MAX).all(|v| u16::from_unit(v.to_unit()) == v));
    }

    #[test]
    fn what_is_out_of_range_becomes_the_nearest_number() {
        assert_eq!(
            [-1.0, 256.0, f32::INFINITY, f32::NAN].map(u8::from_f32),
            [0, 255, 255, 0]
        );
    }
}

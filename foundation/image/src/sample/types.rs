//! The types of samples and pixels. Loops over many of them are compiled once for each type of
//! sample, and not where they are called.

use super::{Pixel, Sample};
use crate::luma::{Luma, weighted_bytes};
use crate::picture::{PictureView, convert};
use crate::plane::{Plane, PlaneView};
use crate::pyramid::by_filter;

/// Loops over rows and pictures.
macro_rules! rows_and_pictures {
    () => {
        fn to_floats(samples: &[Self], floats: &mut [f32]) {
            for (float, sample) in floats.iter_mut().zip(samples) {
                *float = sample.to_f32();
            }
        }

        fn from_floats(floats: &[f32], samples: &mut [Self]) {
            for (sample, float) in samples.iter_mut().zip(floats) {
                *sample = Self::from_f32(*float);
            }
        }

        fn grey(picture: &PictureView<'_>, luma: Luma) -> Plane<Self> {
            convert::grey(picture, luma)
        }

        fn rgb(picture: &PictureView<'_>) -> Plane<[Self; 3]> {
            convert::channels(picture, |[red, green, blue, _]| [red, green, blue])
        }

        fn rgba(picture: &PictureView<'_>) -> Plane<[Self; 4]> {
            convert::channels(picture, |rgba| rgba)
        }
    };
}

macro_rules! integer_samples {
    ($($integer:ty { $($own:item)* })*) => {$(
        impl Sample for $integer {
            const WHITE: f32 = <$integer>::MAX as f32;

            #[inline]
            fn to_f32(self) -> f32 {
                f32::from(self)
            }

            #[inline]
            fn from_f32(value: f32) -> Self {
                // The conversion truncates and saturates.
                (value + 0.5) as Self
            }

            rows_and_pictures!();

            $($own)*
        }
    )*};
}

integer_samples! {
    u8 {
        #[inline]
        fn to_u16(self) -> u16 {
            // 65535 is 255 · 257.
            u16::from(self) * 257
        }

        #[inline]
        fn luma(rgb: [Self; 3], luma: Luma) -> Self {
            weighted_bytes(rgb, luma)
        }

        #[inline(always)]
        fn squared_error(a: &[Self], b: &[Self]) -> f64 {
            squared_error_of_bytes(a, b)
        }
    }
    u16 {
        #[inline]
        fn to_u16(self) -> u16 {
            self
        }
    }
}

impl Sample for f32 {
    const WHITE: f32 = 1.0;

    rows_and_pictures!();

    #[inline]
    fn to_level(self) -> f32 {
        self * 255.0
    }

    #[inline]
    fn to_f32(self) -> f32 {
        self
    }

    #[inline]
    fn from_f32(value: f32) -> Self {
        value
    }
}

macro_rules! pixels_of_one_sample {
    ($($sample:ty)*) => {$(
        impl Pixel for $sample {
            type Sample = Self;

            const CHANNELS: usize = 1;

            #[inline]
            fn samples(pixels: &[Self]) -> &[Self] {
                pixels
            }

            #[inline]
            fn samples_mut(pixels: &mut [Self]) -> &mut [Self] {
                pixels
            }

            fn halved(picture: PlaneView<'_, Self>) -> Plane<Self> {
                by_filter(picture)
            }
        }
    )*};
}

pixels_of_one_sample!(u8 u16 f32);

impl<S: Sample, const N: usize> Pixel for [S; N]
where
    [S; N]: Default,
{
    type Sample = S;

    const CHANNELS: usize = N;

    #[inline]
    fn samples(pixels: &[Self]) -> &[S] {
        pixels.as_flattened()
    }

    #[inline]
    fn samples_mut(pixels: &mut [Self]) -> &mut [S] {
        pixels.as_flattened_mut()
    }

    fn halved(picture: PlaneView<'_, Self>) -> Plane<Self> {
        by_filter(picture)
    }
}

/// The sum of the squared differences of integers, exact.
#[inline(always)]
fn squared_error_of_bytes(a: &[u8], b: &[u8]) -> f64 {
    // 2¹⁵ · 255² is less than 2³¹.
    let pieces = a.chunks(1 << 15).zip(b.chunks(1 << 15));
    let sums = pieces.map(|(a, b)| {
        let squares = a.iter().zip(b).map(|(a, b)| {
            let difference = i32::from(i16::from(*a) - i16::from(*b));
            difference * difference
        });
        f64::from(squares.sum::<i32>())
    });
    sums.sum()
}

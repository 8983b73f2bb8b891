//! Measures that compare pixel by pixel.

use ga_runtime::batch::{Batch, Work};

use crate::plane::{PlaneView, SizeError, same_size};
use crate::sample::{Pixel, Sample};

/// The mean squared error: the mean over all pixels and channels of (a − b)². For integers the sum
/// is exact.
///
/// # Errors
///
/// [`SizeError::Differs`] when the sizes differ, [`SizeError::TooSmall`] when there are no pixels.
pub fn mse<'a, P: Pixel>(
    a: impl Into<PlaneView<'a, P>>,
    b: impl Into<PlaneView<'a, P>>,
) -> Result<f64, SizeError> {
    let (a, b) = (a.into(), b.into());
    same_size(a, b)?;
    if a.is_empty() {
        return Err(SizeError::TooSmall {
            width: a.width(),
            height: a.height(),
            least: 1,
        });
    }
    let mut sum = 0.0;
    Batch::new().run(SquaredError {
        a,
        b,
        sum: &mut sum,
    });
    Ok(sum / (a.width() * a.height() * P::CHANNELS) as f64)
}

/// The peak signal-to-noise ratio in decibels, 10 log₁₀(range² / [`mse`]), where `range` is the
/// difference between the greatest and the least possible number: 255 for 8 bits. It is infinite
/// where the pictures are equal.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::quality::psnr;
///
/// let a = Plane::filled(8, 8, 100u8);
/// let b = Plane::filled(8, 8, 101u8);
/// assert!((psnr(&a, &b, 255.0)? - 48.1308).abs() < 1e-4);
/// assert_eq!(psnr(&a, &a, 255.0)?, f64::INFINITY);
/// # Ok::<(), ga_image::plane::SizeError>(())
/// ```
///
/// # Errors
///
/// As [`mse`].
pub fn psnr<'a, P: Pixel>(
    a: impl Into<PlaneView<'a, P>>,
    b: impl Into<PlaneView<'a, P>>,
    range: f64,
) -> Result<f64, SizeError> {
    Ok(peak_ratio(mse(a, b)?, range))
}

/// 10 log₁₀(range² / mse).
pub(super) fn peak_ratio(mse: f64, range: f64) -> f64 {
    10.0 * (range * range / mse).log10()
}

struct SquaredError<'a, 's, P> {
    a: PlaneView<'a, P>,
    b: PlaneView<'a, P>,
    sum: &'s mut f64,
}

impl<P: Pixel> Work for SquaredError<'_, '_, P> {
    #[inline(always)]
    fn run(self) {
        for (a, b) in self.a.rows().zip(self.b.rows()) {
            *self.sum += P::Sample::squared_error(P::samples(a), P::samples(b));
        }
    }
}

/// The sum of the squared differences of integers, exact.
#[inline(always)]
pub(crate) fn squared_error_of_bytes(a: &[u8], b: &[u8]) -> f64 {
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

/// The sum of the squared differences, added in eight parts.
#[inline(always)]
pub(crate) fn squared_error<S: Sample>(a: &[S], b: &[S]) -> f64 {
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

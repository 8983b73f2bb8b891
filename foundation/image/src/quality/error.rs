//! Measures that compare pixel by pixel.

use ga_runtime::batch::{Batch, Work};

use crate::plane::{PlaneError, PlaneView, same_size};
use crate::sample::{Pixel, Sample};

/// The mean squared error: the mean over all pixels and channels of (a − b)². For integers the sum
/// is exact.
///
/// # Errors
///
/// [`PlaneError::Differs`] when the sizes differ, [`PlaneError::TooSmall`] when there are no
/// pixels.
pub fn mse<'a, P: Pixel>(
    a: impl Into<PlaneView<'a, P>>,
    b: impl Into<PlaneView<'a, P>>,
) -> Result<f64, PlaneError> {
    let (a, b) = (a.into(), b.into());
    same_size(a, b)?;
    if a.is_empty() {
        return Err(PlaneError::TooSmall {
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
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
///
/// # Errors
///
/// As [`mse`].
pub fn psnr<'a, P: Pixel>(
    a: impl Into<PlaneView<'a, P>>,
    b: impl Into<PlaneView<'a, P>>,
    range: f64,
) -> Result<f64, PlaneError> {
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

//! Structural similarity at several scales.

use ga_runtime::batch::{Batch, Work};

use super::ssim::WINDOW;
use super::{Similarity, Ssim};
use crate::plane::{Plane, PlaneError, PlaneView, same_size};
use crate::sample::{Pixel, Sample};

/// The number of scales of [`MultiScale`].
pub const SCALES: usize = 5;

/// The exponents of the scales, the finest first, as printed by Wang, Simoncelli and Bovik.
const EXPONENTS: [f64; SCALES] = [0.0448, 0.2856, 0.3001, 0.2363, 0.1333];

/// The least width and height of pictures with a [`MultiScale`]: a window of SSIM, 11 pixels
/// wide, fits into a sixteenth of it.
pub const MULTISCALE_LEAST_SIDE: usize = WINDOW << (SCALES - 1);

/// The similarity of two pictures at five scales, from [`Ssim::multiscale`].
///
/// MS-SSIM = l₅^γ₅ ∏ⱼ csⱼ^γⱼ, j = 1 … 5, where csⱼ is the mean of the factor of contrast and
/// structure at scale j and l₅ that of luminance at the coarsest scale; as in the authors' program,
/// l₅ cs₅ is the mean of SSIM there. γ = 0.0448, 0.2856, 0.3001, 0.2363, 0.1333. From one scale to
/// the next, each 2 × 2 pixels are averaged; in pictures of odd size, the last column and row count
/// twice. A mean below zero, which only pictures have that are negatives of each other, counts as
/// zero (Z. Wang, E. P. Simoncelli and A. C. Bovik, "Multi-scale structural similarity for image
/// quality assessment", 2003).
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::quality::Ssim;
///
/// let picture = Plane::from_fn(200, 180, |column, row| (column * row % 256) as u8);
/// let noisy = picture.map(|v| v ^ 8);
/// let ssim = Ssim::new(255.0);
/// assert_eq!(ssim.multiscale(&picture, &picture)?.ms_ssim(), 1.0);
/// let scales = ssim.multiscale(&picture, &noisy)?;
/// assert_eq!(scales.similarities()[0], ssim.compare(&picture, &noisy)?);
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MultiScale {
    similarities: [Similarity; SCALES],
}

impl MultiScale {
    /// The similarities at the scales, the finest first.
    #[must_use]
    pub fn similarities(&self) -> [Similarity; SCALES] {
        self.similarities
    }

    /// The index MS-SSIM: 1 for equal pictures.
    #[must_use]
    pub fn ms_ssim(&self) -> f64 {
        let factor = |(scale, exponent): (usize, f64)| {
            let similarity = self.similarities[scale];
            let mean = if scale + 1 == SCALES {
                similarity.ssim
            } else {
                similarity.contrast_structure
            };
            mean.max(0.0).powf(exponent)
        };
        EXPONENTS.into_iter().enumerate().map(factor).product()
    }
}

impl Ssim {
    /// The similarity of two pictures at five scales.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the sizes differ, [`PlaneError::TooSmall`] when a side has less
    /// than [`MULTISCALE_LEAST_SIDE`] = 176 pixels, [`PlaneError::Range`] for a range that is not
    /// positive and finite.
    pub fn multiscale<'a, P: Pixel>(
        &self,
        a: impl Into<PlaneView<'a, P>>,
        b: impl Into<PlaneView<'a, P>>,
    ) -> Result<MultiScale, PlaneError> {
        let (a, b) = (a.into(), b.into());
        check(a, b)?;
        let finest = self.compare(a, b)?;
        self.multiscale_after(finest, a, b)
    }

    /// As [`multiscale`](Self::multiscale), where the similarity at the finest scale is known, such
    /// as from [`compare_weighted`](Self::compare_weighted).
    ///
    /// # Errors
    ///
    /// As [`multiscale`](Self::multiscale).
    pub fn multiscale_after<'a, P: Pixel>(
        &self,
        finest: Similarity,
        a: impl Into<PlaneView<'a, P>>,
        b: impl Into<PlaneView<'a, P>>,
    ) -> Result<MultiScale, PlaneError> {
        let (a, b) = (a.into(), b.into());
        check(a, b)?;
        let mut similarities = [finest; SCALES];
        for channel in 0..P::CHANNELS {
            let [mut a, mut b] = [a, b].map(|plane| averaged(plane, channel));
            for (scale, similarity) in similarities.iter_mut().enumerate().skip(1) {
                if scale > 1 {
                    [a, b] = [&a, &b].map(|plane| averaged(plane.view(), 0));
                }
                let found = self.compare(&a, &b)?;
                if channel == 0 {
                    *similarity = found;
                } else {
                    // The mean over the channels so far.
                    let share = 1.0 / (channel + 1) as f64;
                    similarity.ssim += share * (found.ssim - similarity.ssim);
                    similarity.contrast_structure +=
                        share * (found.contrast_structure - similarity.contrast_structure);
                }
            }
        }
        Ok(MultiScale { similarities })
    }
}

fn check<P: Pixel>(a: PlaneView<'_, P>, b: PlaneView<'_, P>) -> Result<(), PlaneError> {
    same_size(a, b)?;
    if a.width().min(a.height()) < MULTISCALE_LEAST_SIDE {
        return Err(PlaneError::TooSmall {
            width: a.width(),
            height: a.height(),
            least: MULTISCALE_LEAST_SIDE,
        });
    }
    Ok(())
}

/// A channel at half the size, rounded up: the means of each 2 × 2 pixels, not rounded.
fn averaged<P: Pixel>(picture: PlaneView<'_, P>, channel: usize) -> Plane {
    let [width, height] = [picture.width(), picture.height()].map(|side| side.div_ceil(2));
    let mut half = Plane::filled(width, height, 0.0);
    Batch::new().run(Averaging {
        picture,
        channel,
        half: &mut half,
    });
    half
}

struct Averaging<'a, P> {
    picture: PlaneView<'a, P>,
    channel: usize,
    half: &'a mut Plane,
}

impl<P: Pixel> Work for Averaging<'_, P> {
    #[inline(always)]
    fn run(self) {
        let last = self.picture.height() - 1;
        for row in 0..self.half.height() {
            let upper = P::samples(self.picture.row(2 * row));
            let lower = P::samples(self.picture.row((2 * row + 1).min(last)));
            let channel = self.channel;
            let sum = |upper: &[P::Sample], lower: &[P::Sample]| {
                upper[channel].to_f32() + lower[channel].to_f32()
            };
            let means = self.half.row_mut(row);
            let uppers = upper.chunks_exact(2 * P::CHANNELS);
            let lowers = lower.chunks_exact(2 * P::CHANNELS);
            let rest = [uppers.remainder(), lowers.remainder()];
            for (mean, (upper, lower)) in means.iter_mut().zip(uppers.zip(lowers)) {
                let right = sum(&upper[P::CHANNELS..], &lower[P::CHANNELS..]);
                *mean = 0.25 * (sum(upper, lower) + right);
            }
            if let ([_, ..], Some(mean)) = (rest[0], means.last_mut()) {
                *mean = 0.5 * sum(rest[0], rest[1]);
            }
        }
    }
}

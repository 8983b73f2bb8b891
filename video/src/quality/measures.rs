//! The measures of two frames.

use ga_image::plane::{PlaneError, PlaneView};
use ga_image::quality::{MULTISCALE_LEAST_SIDE, SCALES, Ssim, Weights, mse, weighted_psnr};
use ga_image::sample::Pixel;
use serde::{Deserialize, Serialize};

use super::vif::{VIF_LEAST_SIDE, Vif};
use crate::attention::Attention;

/// How much a frame differs from its reference.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measures {
    /// The mean squared error.
    pub mse: f64,
    /// The peak signal-to-noise ratio in decibels; infinite where the frames are equal.
    #[serde(with = "super::number")]
    pub psnr: f64,
    /// The structural similarity index, or `None` where a side has less than [`SSIM_LEAST_SIDE`]
    /// pixels.
    pub ssim: Option<f64>,
    /// The index at several scales, or `None` where a side has less than
    /// [`MULTISCALE_LEAST_SIDE`] pixels.
    pub ms_ssim: Option<f64>,
    /// The visual information fidelity over all scales, or `None` where a side has less than
    /// [`VIF_LEAST_SIDE`] pixels.
    pub vif: Option<f64>,
    /// PSNR in decibels, weighted by attention.
    #[serde(with = "super::number")]
    pub attention_psnr: f64,
    /// SSIM, weighted by attention; `None` where there is no SSIM.
    pub attention_ssim: Option<f64>,
}

/// The least width and height of frames with an SSIM, whose window is 11 pixels wide.
pub const SSIM_LEAST_SIDE: usize = MULTISCALE_LEAST_SIDE >> (SCALES - 1);

/// Measures frames of one size against their references, one after another.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_video::quality::Meter;
///
/// let reference = Plane::from_fn(64, 48, |column, row| (column * row % 200) as u8);
/// let mut meter = Meter::new([64, 48], 255.0)?;
/// let same = meter.compare(&reference, &reference, &reference)?;
/// assert_eq!((same.psnr, same.ssim, same.ms_ssim), (f64::INFINITY, Some(1.0), None));
/// let noisy = reference.map(|level| level ^ 4);
/// assert!(meter.compare(&reference, &noisy, &reference)?.attention_ssim < Some(1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Meter {
    attended: Attended,
    range: f64,
    ssim: Ssim,
}

/// Where the weights come from.
#[derive(Clone, Debug)]
enum Attended {
    Model(Box<Attention>),
    Map(Weights),
}

impl Meter {
    /// Weights by the model of [`Attention`]. `range` is the difference between the greatest and
    /// the least possible number: 255 for 8 bits, 1023 for 10.
    ///
    /// # Errors
    ///
    /// [`PlaneError::TooSmall`] when there are no pixels.
    pub fn new(size: [usize; 2], range: f64) -> Result<Self, PlaneError> {
        let attention = Attention::new(size)?;
        Ok(Self::with(Attended::Model(Box::new(attention)), range))
    }

    /// Weights by a given map, the same for all frames.
    #[must_use]
    pub fn with_map(map: Weights, range: f64) -> Self {
        Self::with(Attended::Map(map), range)
    }

    fn with(attended: Attended, range: f64) -> Self {
        Self {
            attended,
            range,
            ssim: Ssim::new(range as f32),
        }
    }

    /// The difference between the greatest and the least possible number.
    #[must_use]
    pub fn range(&self) -> f64 {
        self.range
    }

    /// The measures of the next frame. `luma` is the luma of the reference in 8 bits, which the
    /// model of attention looks at.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when sizes differ, [`PlaneError::TooSmall`] when there are no
    /// pixels, [`PlaneError::Range`] when the range is not positive and finite;
    /// [`PlaneError::ZeroWeights`] when a given map has no weight inside the border of 5 pixels
    /// that SSIM leaves out.
    pub fn compare<'a, P: Pixel>(
        &mut self,
        reference: impl Into<PlaneView<'a, P>>,
        distorted: impl Into<PlaneView<'a, P>>,
        luma: impl Into<PlaneView<'a, u8>>,
    ) -> Result<Measures, PlaneError> {
        let (reference, distorted) = (reference.into(), distorted.into());
        let mse = mse(reference, distorted)?;
        let weights = match &mut self.attended {
            Attended::Model(attention) => attention.next(luma)?,
            Attended::Map(map) => map,
        };
        let attention_psnr = weighted_psnr(reference, distorted, weights, self.range)?;
        let least_side = reference.width().min(reference.height());
        let ssim = (least_side >= SSIM_LEAST_SIDE)
            .then(|| self.ssim.compare_weighted(reference, distorted, weights))
            .transpose()?;
        let multiscale = ssim.filter(|_| least_side >= MULTISCALE_LEAST_SIDE);
        let multiscale = multiscale.map(|ssim| {
            self.ssim
                .multiscale_after(ssim.similarity, reference, distorted)
        });
        let multiscale = multiscale.transpose()?;
        let vif = (least_side >= VIF_LEAST_SIDE)
            .then(|| Vif::new(reference, distorted, self.range))
            .transpose()?;
        Ok(Measures {
            mse,
            psnr: psnr_of(mse, self.range),
            ssim: ssim.map(|ssim| ssim.similarity.ssim),
            ms_ssim: multiscale.map(|scales| scales.ms_ssim()),
            vif: vif.map(|vif| vif.all_scales),
            attention_psnr,
            attention_ssim: ssim.map(|ssim| ssim.weighted_ssim),
        })
    }
}

/// The peak signal-to-noise ratio of a mean squared error, in decibels.
pub(super) fn psnr_of(mse: f64, range: f64) -> f64 {
    10.0 * (range * range / mse).log10()
}

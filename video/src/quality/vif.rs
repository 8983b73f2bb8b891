//! Visual information fidelity.

use ga_image::plane::{PlaneError, PlaneView};
use ga_image::quality::mse;
use ga_image::sample::{Pixel, Sample};
use ga_runtime::batch::{Batch, Work};
use ga_runtime::scalar::Lanes;
use rayon::prelude::*;

/// How much of the information that a reference gives an eye is left in a distorted picture: the
/// visual information fidelity in the pixel domain (H. R. Sheikh and A. C. Bovik, "Image
/// information and visual quality", IEEE Transactions on Image Processing 15, 2006).
///
/// In a window around each pixel, weighted by a Gaussian, σ₁² and σ₂² are the variances of the
/// reference and of the distorted picture, and σ₁₂ their covariance, of numbers from 0 to 255. The
/// distorted picture is g times the reference with noise of the variance v in addition, and the eye
/// adds noise of the variance n = 2 to both:
///
/// g = σ₁₂ / σ₁², v = σ₂² − g σ₁₂,
/// VIF = Σ log₂(1 + g² σ₁² / (v + n)) / Σ log₂(1 + σ₁² / n),
///
/// both sums in bits over all pixels, where σ₁₂ is at least 0 and g at most 100. A reference of one
/// level has no information, and VIF is 1, since none is lost.
///
/// The scales have windows of 17, 9, 5 and 3 pixels, with a standard deviation of a fifth of that;
/// each but the first is every second pixel of the one before, which is blurred by its window.
/// Beyond the border pictures are mirrored, at the left and above at the centre of the outermost
/// pixel, at the right and below at its edge.
///
/// This is the filter `vif` of ffmpeg 5.1, which prints [`scales`](Self::scales); the difference is
/// below 2 · 10⁻⁵. VMAF and later versions of ffmpeg have other terms where σ₁² < n.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_video::quality::Vif;
///
/// let reference = Plane::from_fn(64, 48, |column, row| (column * row % 200) as u8);
/// assert_eq!(Vif::new(&reference, &reference, 255.0)?.all_scales, 1.0);
/// let noisy = reference.map(|level| level ^ 16);
/// let found = Vif::new(&reference, &noisy, 255.0)?;
/// // Noise of single pixels is gone at a quarter of the size.
/// assert!(found.scales[0] < found.scales[2] && found.scales[2] < 1.0);
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vif {
    /// The quotient of the sums at each scale, from the whole picture to an eighth of its size.
    pub scales: [f64; SCALES],
    /// The quotient of the sums over all scales: 0 where nothing is left, 1 for equal pictures, and
    /// above 1 where the contrast is greater.
    pub all_scales: f64,
}

/// How many scales there are.
const SCALES: usize = 4;

/// Pixels on either side of the middle of a window, at each scale.
const RADII: [usize; SCALES] = [8, 4, 2, 1];

/// The least width and height of frames with a VIF: at an eighth of their size two pixels are left
/// on either side.
pub const VIF_LEAST_SIDE: usize = 16;

/// The variance of the noise of the eye, of numbers from 0 to 255.
const EYE_NOISE: f64 = 2.0;

/// Variances below this are zero but for rounding.
const LEAST_VARIANCE: f64 = 1e-10;

const MOST_GAIN: f64 = 100.0;

/// Neighbouring columns. Variances are small differences of means of squares.
type Columns = Lanes<f64, LANES>;

const LANES: usize = 8;

/// Rows that a thread takes at a time.
const BAND: usize = 16;

impl Vif {
    /// Of pictures whose numbers lie between 0 and `range`. Channels are summed.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the sizes differ, [`PlaneError::TooSmall`] when a side has less
    /// than [`VIF_LEAST_SIDE`] pixels, [`PlaneError::Range`] for a range that is not positive and
    /// finite.
    pub fn new<'a, P: Pixel>(
        reference: impl Into<PlaneView<'a, P>>,
        distorted: impl Into<PlaneView<'a, P>>,
        range: f64,
    ) -> Result<Self, PlaneError> {
        let pictures = [reference.into(), distorted.into()];
        let error = mean_squared_error(pictures, range)?;
        if error.is_nan() {
            return Ok(Self {
                scales: [f64::NAN; SCALES],
                all_scales: f64::NAN,
            });
        }
        let mut sums = [Information::default(); SCALES];
        for channel in 0..P::CHANNELS {
            // Numbers around 0 lose less to rounding.
            let level = |sample: P::Sample| (255.0 / range) as f32 * sample.to_f32() - 127.5;
            let mut levels = pictures.map(|picture| Levels::of(picture, channel, level));
            for (scale, (radius, sum)) in RADII.into_iter().zip(&mut sums).enumerate() {
                let weights = weights(radius);
                if scale > 0 {
                    levels = halved(&levels, &weights);
                }
                sum.add(information(&levels, &weights));
            }
        }
        let mut all = Information::default();
        sums.iter().for_each(|scale| all.add(*scale));
        Ok(Self {
            scales: sums.map(Information::quotient),
            all_scales: all.quotient(),
        })
    }
}

/// The error of pictures that can be compared.
fn mean_squared_error<P: Pixel>(
    [reference, distorted]: [PlaneView<'_, P>; 2],
    range: f64,
) -> Result<f64, PlaneError> {
    if !(range > 0.0 && range.is_finite()) {
        let range = range.to_string();
        return Err(PlaneError::Range { range });
    }
    let error = mse(reference, distorted)?;
    let (width, height) = (reference.width(), reference.height());
    if width.min(height) < VIF_LEAST_SIDE {
        return Err(PlaneError::TooSmall {
            width,
            height,
            least: VIF_LEAST_SIDE,
        });
    }
    Ok(error)
}

/// The weights of a window along one axis.
fn weights(radius: usize) -> Vec<f64> {
    let length = 2 * radius + 1;
    let deviation = length as f64 / 5.0;
    let weight = |place: usize| {
        let distance = place as f64 - radius as f64;
        (-0.5 * (distance / deviation).powi(2)).exp()
    };
    let weights: Vec<f64> = (0..length).map(weight).collect();
    let sum: f64 = weights.iter().sum();
    weights.iter().map(|weight| weight / sum).collect()
}

/// The row or column that stands for one beyond the border. `length` is greater than the reach.
#[inline(always)]
fn mirrored(index: isize, length: usize) -> usize {
    let length = length.cast_signed();
    let inside = match index {
        index if index < 0 => -index,
        index if index >= length => 2 * length - 1 - index,
        index => index,
    };
    inside.cast_unsigned()
}

/// A picture whose rows are filled up to whole blocks of columns.
struct Levels {
    width: usize,
    height: usize,
    blocks: usize,
    samples: Vec<[f32; LANES]>,
}

impl Levels {
    fn filled(width: usize, height: usize) -> Self {
        let blocks = width.div_ceil(LANES);
        Self {
            width,
            height,
            blocks,
            samples: vec![[0.0; LANES]; blocks * height],
        }
    }

    fn of<P: Pixel>(
        picture: PlaneView<'_, P>,
        channel: usize,
        level: impl Fn(P::Sample) -> f32 + Sync,
    ) -> Self {
        let mut levels = Self::filled(picture.width(), picture.height());
        for (row, target) in picture.rows().zip(levels.samples.chunks_mut(levels.blocks)) {
            let samples = P::samples(row).iter().skip(channel).step_by(P::CHANNELS);
            for (target, sample) in target.as_flattened_mut().iter_mut().zip(samples) {
                *target = level(*sample);
            }
        }
        levels
    }

    fn row(&self, row: usize) -> &[[f32; LANES]] {
        &self.samples[row * self.blocks..][..self.blocks]
    }
}

/// Samples with the numbers that are summed.
#[inline(always)]
fn columns(samples: &[f32; LANES]) -> Columns {
    Columns::from_array(samples.map(f64::from))
}

/// What an eye has of the pictures, in bits.
#[derive(Clone, Copy, Debug, Default)]
struct Information {
    /// Of the reference, in the distorted picture.
    left: f64,
    /// Of the reference.
    given: f64,
}

impl Information {
    fn add(&mut self, other: Self) {
        self.left += other.left;
        self.given += other.given;
    }

    /// How much is left.
    fn quotient(self) -> f64 {
        match self.given > 0.0 {
            true => self.left / self.given,
            false => 1.0,
        }
    }
}

/// The sums over all windows of one scale.
fn information(pictures: &[Levels; 2], weights: &[f64]) -> Information {
    let height = pictures[0].height;
    let bands = (0..height.div_ceil(BAND)).into_par_iter().map(|band| {
        let mut found = Information::default();
        Batch::new().run(Band {
            pictures,
            weights,
            rows: band * BAND..height.min((band + 1) * BAND),
            found: &mut found,
        });
        found
    });
    // Sums of bands, in their order, do not depend on the number of threads.
    let bands: Vec<Information> = bands.collect();
    let mut all = Information::default();
    bands.into_iter().for_each(|band| all.add(band));
    all
}

/// Every second pixel of the blurred pictures.
fn halved(pictures: &[Levels; 2], weights: &[f64]) -> [Levels; 2] {
    let [width, height] = [pictures[0].width / 2, pictures[0].height / 2];
    pictures.each_ref().map(|picture| {
        let mut half = Levels::filled(width, height);
        let bands = half.samples.par_chunks_mut(BAND * half.blocks);
        bands.enumerate().for_each(|(band, target)| {
            Batch::new().run(Halving {
                picture,
                weights,
                first: band * BAND,
                target,
                width,
            });
        });
        half
    })
}

/// Rows of windows.
struct Band<'a> {
    pictures: &'a [Levels; 2],
    weights: &'a [f64],
    rows: std::ops::Range<usize>,
    found: &'a mut Information,
}

impl Work for Band<'_> {
    #[inline(always)]
    fn run(self) {
        let [reference, distorted] = self.pictures;
        let width = reference.width;
        let mut wide: [Wide; 5] = std::array::from_fn(|_| Wide::new(reference, self.weights));
        for row in self.rows {
            for block in 0..reference.blocks {
                let mut sums = [Columns::splat(0.0); 5];
                for (tap, weight) in self.weights.iter().enumerate() {
                    let row = wide[0].source(row, tap, reference.height);
                    let [a, b] =
                        [reference, distorted].map(|picture| columns(&picture.row(row)[block]));
                    let weight = Columns::splat(*weight);
                    let (weighted_a, weighted_b) = (weight * a, weight * b);
                    sums[0] += weighted_a;
                    sums[1] += weighted_b;
                    sums[2] += weighted_a * a;
                    sums[3] += weighted_b * b;
                    sums[4] += weighted_a * b;
                }
                for (wide, sum) in wide.iter_mut().zip(sums) {
                    wide.put(block, sum);
                }
            }
            wide.iter_mut().for_each(|wide| wide.continue_by(width));
            let mut logarithms = Logarithms::default();
            for block in 0..reference.blocks {
                let means = wide
                    .each_ref()
                    .map(|wide| wide.mean(block, self.weights).to_array());
                let count = (width - block * LANES).min(LANES);
                logarithms.add(&means, count, self.found);
            }
            logarithms.finish(self.found);
        }
    }
}

/// Rows of the next scale.
struct Halving<'a> {
    picture: &'a Levels,
    weights: &'a [f64],
    /// The row of the result that is the first of the target.
    first: usize,
    target: &'a mut [[f32; LANES]],
    width: usize,
}

impl Work for Halving<'_> {
    #[inline(always)]
    fn run(self) {
        let mut wide = Wide::new(self.picture, self.weights);
        for (row, target) in self
            .target
            .chunks_mut(self.width.div_ceil(LANES))
            .enumerate()
        {
            for block in 0..self.picture.blocks {
                let mut sum = Columns::splat(0.0);
                for (tap, weight) in self.weights.iter().enumerate() {
                    let row = wide.source(2 * (self.first + row), tap, self.picture.height);
                    sum += Columns::splat(*weight) * columns(&self.picture.row(row)[block]);
                }
                wide.put(block, sum);
            }
            wide.continue_by(self.picture.width);
            let target = target.as_flattened_mut();
            for (block, target) in target[..self.width].chunks_mut(LANES / 2).enumerate() {
                let blurred = wide.mean(block, self.weights).to_array();
                for (target, blurred) in target.iter_mut().zip(blurred.iter().step_by(2)) {
                    *target = *blurred as f32;
                }
            }
        }
    }
}

/// A row with the columns that windows reach beyond the border.
struct Wide {
    samples: Vec<f64>,
    radius: usize,
}

impl Wide {
    fn new(picture: &Levels, weights: &[f64]) -> Self {
        let radius = weights.len() / 2;
        Self {
            samples: vec![0.0; picture.blocks * LANES + 2 * radius],
            radius,
        }
    }

    /// The row of the picture for a weight of the window around a row.
    #[inline(always)]
    fn source(&self, row: usize, tap: usize, height: usize) -> usize {
        mirrored(
            (row + tap).cast_signed() - self.radius.cast_signed(),
            height,
        )
    }

    #[inline(always)]
    fn put(&mut self, block: usize, columns: Columns) {
        let place = self.radius + block * LANES;
        self.samples[place..place + LANES].copy_from_slice(&columns.to_array());
    }

    /// Fills the columns beyond the border.
    #[inline(always)]
    fn continue_by(&mut self, width: usize) {
        for beyond in 0..self.radius {
            let right = width + beyond;
            for (place, index) in [
                (beyond, beyond.cast_signed() - self.radius.cast_signed()),
                (self.radius + right, right.cast_signed()),
            ] {
                self.samples[place] = self.samples[self.radius + mirrored(index, width)];
            }
        }
    }

    /// The weighted means around the columns of a block.
    #[inline(always)]
    fn mean(&self, block: usize, weights: &[f64]) -> Columns {
        let window = &self.samples[block * LANES..][..LANES + 2 * self.radius];
        let mut sum = Columns::splat(0.0);
        for (weight, columns) in weights.iter().zip(window.windows(LANES)) {
            let columns = columns.first_chunk().copied().unwrap_or_default();
            sum += Columns::splat(*weight) * Columns::from_array(columns);
        }
        sum
    }
}

/// Sums of logarithms, as logarithms of products.
struct Logarithms {
    left: [f64; LANES],
    given: [f64; LANES],
    /// How many blocks were multiplied.
    blocks: usize,
}

/// Factors are below 1 + 100² · 128² / 2 < 2²⁷, so that products of this number stay below 2¹⁰²³.
const FACTORS: usize = 32;

impl Default for Logarithms {
    fn default() -> Self {
        Self {
            left: [1.0; LANES],
            given: [1.0; LANES],
            blocks: 0,
        }
    }
}

impl Logarithms {
    /// Adds the terms of the first `count` columns of a block: `means` are those of the reference,
    /// of the distorted picture, of their squares and of their product.
    #[inline(always)]
    fn add(&mut self, means: &[[f64; LANES]; 5], count: usize, found: &mut Information) {
        let [a, b, squares_a, squares_b, products] = means;
        let (mut left, mut given) = ([1.0; LANES], [1.0; LANES]);
        for lane in 0..LANES {
            let reference = (squares_a[lane] - a[lane] * a[lane]).max(0.0);
            let distorted = (squares_b[lane] - b[lane] * b[lane]).max(0.0);
            let both = (products[lane] - a[lane] * b[lane]).max(0.0);
            let is_flat = reference < LEAST_VARIANCE;
            let gain = match is_flat || distorted < LEAST_VARIANCE {
                true => 0.0,
                false => both / reference,
            };
            let noise = (distorted - gain * both).max(0.0);
            let gain = gain.min(MOST_GAIN);
            left[lane] = 1.0 + gain * gain * reference / (noise + EYE_NOISE);
            given[lane] = if is_flat {
                1.0
            } else {
                1.0 + reference / EYE_NOISE
            };
        }
        for lane in 0..LANES {
            let is_inside = lane < count;
            self.left[lane] *= if is_inside { left[lane] } else { 1.0 };
            self.given[lane] *= if is_inside { given[lane] } else { 1.0 };
        }
        self.blocks += 1;
        if self.blocks == FACTORS {
            std::mem::take(self).finish(found);
        }
    }

    #[inline(always)]
    fn finish(self, found: &mut Information) {
        let bits = |factors: [f64; LANES]| factors.into_iter().map(f64::log2).sum::<f64>();
        found.left += bits(self.left);
        found.given += bits(self.given);
    }
}

//! Measures in which some pixels count for more than others.

use ga_runtime::batch::{Batch, Work};

use super::peak_ratio;
use crate::plane::{Plane, PlaneError, PlaneView, same_size};
use crate::sample::{Pixel, Sample};

/// A weight for each pixel, such as how much attention people pay to it: not negative, finite, and
/// not all zero. Only ratios of weights matter.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::quality::{Weights, weighted_mse};
///
/// let a = Plane::filled(4, 1, 100u8);
/// let b = Plane::from_values(4, 1, vec![100u8, 100, 110, 100])?;
/// let weights = Weights::new(Plane::from_values(4, 1, vec![1.0, 1.0, 3.0, 0.0])?)?;
/// assert_eq!(weighted_mse(&a, &b, &weights)?, 60.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Weights {
    plane: Plane,
}

impl Weights {
    /// The weights of the pixels of a picture.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Weight`] for the first weight that is negative or not finite,
    /// [`PlaneError::ZeroWeights`] when no weight is positive.
    pub fn new(plane: Plane) -> Result<Self, PlaneError> {
        let mut range = [f32::INFINITY, f32::NEG_INFINITY];
        let mut finite = true;
        Batch::new().run(Extremes {
            values: plane.values(),
            range: &mut range,
            finite: &mut finite,
        });
        let is_sound = finite && range[0] >= 0.0;
        if !is_sound && !plane.is_empty() {
            let sound = |weight: &f32| weight.is_finite() && *weight >= 0.0;
            let index = plane.values().iter().position(|weight| !sound(weight));
            let index = index.unwrap_or_default();
            return Err(PlaneError::Weight {
                column: index % plane.width(),
                row: index / plane.width(),
                weight: plane.values()[index],
            });
        }
        if range[1] > 0.0 {
            Ok(Self { plane })
        } else {
            Err(PlaneError::ZeroWeights)
        }
    }

    /// The weights, a number for each pixel.
    #[must_use]
    pub fn plane(&self) -> &Plane {
        &self.plane
    }

    /// The weights, a number for each pixel.
    #[must_use]
    pub fn into_plane(self) -> Plane {
        self.plane
    }
}

/// The weighted mean squared error Σ w (a − b)² / Σ w over all pixels; the mean over the channels.
///
/// # Errors
///
/// [`PlaneError::Differs`] when the sizes of the pictures and of the weights are not all equal,
/// [`PlaneError::ZeroWeights`] when there are no pixels.
pub fn weighted_mse<'a, P: Pixel>(
    a: impl Into<PlaneView<'a, P>>,
    b: impl Into<PlaneView<'a, P>>,
    weights: &Weights,
) -> Result<f64, PlaneError> {
    let (a, b) = (a.into(), b.into());
    same_size(a, b)?;
    same_size(a, weights.plane.view())?;
    let mut sums = [0.0; 2];
    Batch::new().run(WeightedError {
        a,
        b,
        weights: &weights.plane,
        sums: &mut sums,
    });
    let [errors, weights] = sums;
    if weights > 0.0 {
        Ok(errors / (weights * P::CHANNELS as f64))
    } else {
        Err(PlaneError::ZeroWeights)
    }
}

/// The weighted peak signal-to-noise ratio in decibels, 10 log₁₀(range² / [`weighted_mse`]), with
/// the `range` of [`psnr`](super::psnr). It is infinite where no pixel of positive weight differs.
///
/// # Errors
///
/// As [`weighted_mse`], and [`PlaneError::Range`] for a range that is not positive and finite.
pub fn weighted_psnr<'a, P: Pixel>(
    a: impl Into<PlaneView<'a, P>>,
    b: impl Into<PlaneView<'a, P>>,
    weights: &Weights,
    range: f64,
) -> Result<f64, PlaneError> {
    let mse = weighted_mse(a, b, weights)?;
    if range > 0.0 && range.is_finite() {
        Ok(peak_ratio(mse, range))
    } else {
        let range = range.to_string();
        Err(PlaneError::Range { range })
    }
}

/// Σ w v and Σ w. The sums are taken in double precision, in eight parts.
#[inline(always)]
pub(super) fn weighted_sums(weights: &[f32], values: &[f32]) -> [f64; 2] {
    let mut sums = [[0.0; 8]; 2];
    let ((weights, weights_rest), (values, values_rest)) =
        (weights.as_chunks::<8>(), values.as_chunks::<8>());
    for (weights, values) in weights.iter().zip(values) {
        for lane in 0..8 {
            let weight = f64::from(weights[lane]);
            sums[0][lane] += weight * f64::from(values[lane]);
            sums[1][lane] += weight;
        }
    }
    let mut total = sums.map(|sums| sums.iter().sum::<f64>());
    for (weight, value) in weights_rest.iter().zip(values_rest) {
        let weight = f64::from(*weight);
        total[0] += weight * f64::from(*value);
        total[1] += weight;
    }
    total
}

struct WeightedError<'a, 's, P> {
    a: PlaneView<'a, P>,
    b: PlaneView<'a, P>,
    weights: &'a Plane,
    sums: &'s mut [f64; 2],
}

impl<P: Pixel> Work for WeightedError<'_, '_, P> {
    #[inline(always)]
    fn run(self) {
        let mut squares = vec![0.0f32; self.a.width()];
        for ((a, b), weights) in self.a.rows().zip(self.b.rows()).zip(self.weights.rows()) {
            let a = P::samples(a).chunks_exact(P::CHANNELS);
            let b = P::samples(b).chunks_exact(P::CHANNELS);
            for (square, (a, b)) in squares.iter_mut().zip(a.zip(b)) {
                *square = 0.0;
                for (a, b) in a.iter().zip(b) {
                    let difference = a.to_f32() - b.to_f32();
                    *square += difference * difference;
                }
            }
            let [errors, weight] = weighted_sums(weights, &squares);
            self.sums[0] += errors;
            self.sums[1] += weight;
        }
    }
}

struct Extremes<'a, 'r> {
    values: &'a [f32],
    range: &'r mut [f32; 2],
    finite: &'r mut bool,
}

impl Work for Extremes<'_, '_> {
    #[inline(always)]
    fn run(self) {
        let (mut least, mut greatest) = ([f32::INFINITY; 8], [f32::NEG_INFINITY; 8]);
        // 0 x is 0 for finite numbers alone.
        let mut zeros = [0.0f32; 8];
        let (pieces, rest) = self.values.as_chunks::<8>();
        for piece in pieces {
            for lane in 0..8 {
                // Comparisons need fewer instructions than the minimum of numbers that may be NaN.
                let value = piece[lane];
                least[lane] = if value < least[lane] {
                    value
                } else {
                    least[lane]
                };
                greatest[lane] = if value > greatest[lane] {
                    value
                } else {
                    greatest[lane]
                };
                zeros[lane] += 0.0 * value;
            }
        }
        for value in rest {
            least[0] = least[0].min(*value);
            greatest[0] = greatest[0].max(*value);
            zeros[0] += 0.0 * value;
        }
        *self.range = [
            least.into_iter().fold(f32::INFINITY, f32::min),
            greatest.into_iter().fold(f32::NEG_INFINITY, f32::max),
        ];
        *self.finite = zeros.iter().all(|zero| *zero == 0.0);
    }
}

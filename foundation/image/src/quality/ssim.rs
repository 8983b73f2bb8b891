//! Structural similarity.

use ga_runtime::batch::{Batch, Work};
use ga_runtime::scalar::Lanes;

use super::weighted::{Weights, weighted_sums};
use crate::filter::{Border, Gaussian};
use crate::plane::{Plane, PlaneError, PlaneView, same_size};
use crate::sample::{Pixel, Sample};

/// The structural similarity index of two pictures (Wang, Bovik, Sheikh, Simoncelli 2004).
///
/// In each window of 11 × 11 pixels, weighted by a Gaussian with σ = 1.5, μ, σ² and σ_ab are the
/// means, variances and the covariance (divided by the sum of the weights), and
///
/// SSIM = (2 μ_a μ_b + C₁)(2 σ_ab + C₂) / ((μ_a² + μ_b² + C₁)(σ_a² + σ_b² + C₂)),
/// C₁ = (0.01 range)², C₂ = (0.03 range)².
///
/// The mean is taken over all windows that lie within the picture, and over the channels. This is
/// `structural_similarity(a, b, gaussian_weights=True, sigma=1.5, use_sample_covariance=False,
/// data_range=range)` of scikit-image; the difference is below 10⁻⁶.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::quality::Ssim;
///
/// let picture = Plane::from_fn(40, 30, |column, row| (7 * column * row % 256) as u8);
/// let noisy = picture.map(|v| v ^ 8);
/// let ssim = Ssim::new(255.0);
/// assert_eq!(ssim.compare(&picture, &picture)?.ssim, 1.0);
/// assert!(ssim.compare(&picture, &noisy)?.ssim < 0.999);
/// assert_eq!(ssim.map(&picture, &noisy)?.width(), 40);
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ssim {
    range: f32,
}

/// What [`Ssim::compare`] finds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Similarity {
    /// The mean of SSIM: 1 for equal pictures.
    pub ssim: f64,
    /// The mean of its factor of contrast and structure, (2 σ_ab + C₂) / (σ_a² + σ_b² + C₂), which
    /// measures at several scales multiply.
    pub contrast_structure: f64,
}

/// What [`Ssim::compare_weighted`] finds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightedSimilarity {
    /// Σ w SSIM / Σ w, with the weight w of the pixel in the middle of each window.
    pub weighted_ssim: f64,
    /// The means in which all windows count the same.
    pub similarity: Similarity,
}

/// Pixels on either side of the middle of a window: 3.5 σ, rounded.
const RADIUS: usize = 5;

/// The side of a window.
pub(super) const WINDOW: usize = 2 * RADIUS + 1;

impl Ssim {
    /// For pictures whose numbers lie within a range of this length, from 0: 255 for 8 bits.
    #[must_use]
    pub fn new(range: f32) -> Self {
        Self { range }
    }

    /// The similarity of two pictures.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the sizes differ, [`PlaneError::TooSmall`] when a side has less
    /// than 11 pixels, [`PlaneError::Range`] for a range that is not positive and finite.
    pub fn compare<'a, P: Pixel>(
        &self,
        a: impl Into<PlaneView<'a, P>>,
        b: impl Into<PlaneView<'a, P>>,
    ) -> Result<Similarity, PlaneError> {
        let (a, b) = (a.into(), b.into());
        self.check(a, b, WINDOW)?;
        let mut sums = [0.0; 2];
        for channel in 0..P::CHANNELS {
            self.run(a, b, channel, &mut |_, _, ssim, contrast_structure| {
                sums[0] += sum(ssim);
                sums[1] += sum(contrast_structure);
            });
        }
        Ok(Similarity::of_sums(sums, a))
    }

    /// The similarity of two pictures, and the mean of SSIM with a weight for each pixel, in one
    /// pass. The windows are those of [`compare`](Self::compare): pixels that are less than five
    /// from the border are in the middle of none, and their weights do not take part.
    ///
    /// # Errors
    ///
    /// As [`compare`](Self::compare), [`PlaneError::Differs`] when the weights have another size;
    /// [`PlaneError::ZeroWeights`] when all weights that take part are zero.
    pub fn compare_weighted<'a, P: Pixel>(
        &self,
        a: impl Into<PlaneView<'a, P>>,
        b: impl Into<PlaneView<'a, P>>,
        weights: &Weights,
    ) -> Result<WeightedSimilarity, PlaneError> {
        let (a, b) = (a.into(), b.into());
        self.check(a, b, WINDOW)?;
        let weights = weights.plane();
        same_size(a, weights.view())?;
        let mut sums = [0.0; 2];
        let mut weighted = [0.0; 2];
        for channel in 0..P::CHANNELS {
            self.run(a, b, channel, &mut |column, row, ssim, structure| {
                sums[0] += sum(ssim);
                sums[1] += sum(structure);
                let weights = &weights.row(row + RADIUS)[column + RADIUS..][..ssim.len()];
                let [value, weight] = weighted_sums(weights, ssim);
                weighted[0] += value;
                weighted[1] += weight;
            });
        }
        let [value, weight] = weighted;
        if weight > 0.0 {
            Ok(WeightedSimilarity {
                weighted_ssim: value / weight,
                similarity: Similarity::of_sums(sums, a),
            })
        } else {
            Err(PlaneError::ZeroWeights)
        }
    }

    /// SSIM in the window around each pixel, as the mean over the channels. The pictures are
    /// continued by [`Border::Reflect`], as scikit-image does for its full image. The mean of the
    /// map without its outermost five rows and columns on each side is
    /// [`ssim`](Similarity::ssim).
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the sizes differ, [`PlaneError::TooSmall`] when there are no
    /// pixels, [`PlaneError::Range`] for a range that is not positive and finite.
    pub fn map<'a, P: Pixel>(
        &self,
        a: impl Into<PlaneView<'a, P>>,
        b: impl Into<PlaneView<'a, P>>,
    ) -> Result<Plane, PlaneError> {
        let (a, b) = (a.into(), b.into());
        self.check(a, b, 1)?;
        let (continued_a, continued_b) = (continued(a), continued(b));
        let mut map = Plane::filled(a.width(), a.height(), 0.0);
        let share = 1.0 / P::CHANNELS as f32;
        for channel in 0..P::CHANNELS {
            let (a, b) = (continued_a.view(), continued_b.view());
            self.run(a, b, channel, &mut |column, row, ssim, _| {
                for (sum, ssim) in map.row_mut(row)[column..].iter_mut().zip(ssim) {
                    *sum += share * ssim;
                }
            });
        }
        Ok(map)
    }

    fn check<P: Pixel>(
        &self,
        a: PlaneView<'_, P>,
        b: PlaneView<'_, P>,
        least: usize,
    ) -> Result<(), PlaneError> {
        if !(self.range > 0.0 && self.range.is_finite()) {
            let range = self.range.to_string();
            return Err(PlaneError::Range { range });
        }
        same_size(a, b)?;
        if a.width().min(a.height()) < least {
            return Err(PlaneError::TooSmall {
                width: a.width(),
                height: a.height(),
                least,
            });
        }
        Ok(())
    }

    /// Hands the values in the windows to `take`, piece by piece: the column and row of the first
    /// window of a piece, SSIM, contrast and structure.
    fn run<P: Pixel>(
        &self,
        a: PlaneView<'_, P>,
        b: PlaneView<'_, P>,
        channel: usize,
        take: &mut impl FnMut(usize, usize, &[f32], &[f32]),
    ) {
        Batch::new().run(Windows {
            a,
            b,
            channel,
            constants: Constants::new(self.range),
            take,
        });
    }
}

impl Similarity {
    /// Of the sums of SSIM and of its factor over all windows and channels of a picture.
    fn of_sums<P: Pixel>(sums: [f64; 2], picture: PlaneView<'_, P>) -> Self {
        let [columns, rows] = [picture.width(), picture.height()].map(|side| side - 2 * RADIUS);
        let [ssim, contrast_structure] =
            sums.map(|sum| sum / (columns * rows * P::CHANNELS) as f64);
        Self {
            ssim,
            contrast_structure,
        }
    }
}

#[inline(always)]
fn sum(values: &[f32]) -> f64 {
    let (pieces, rest) = values.as_chunks::<8>();
    let mut sums = [0.0; 8];
    for piece in pieces {
        for lane in 0..8 {
            sums[lane] += f64::from(piece[lane]);
        }
    }
    sums.iter().sum::<f64>() + rest.iter().copied().map(f64::from).sum::<f64>()
}

/// The picture with five more pixels on each side.
fn continued<P: Pixel>(picture: PlaneView<'_, P>) -> Plane<P> {
    let place = |index: usize, length| {
        Border::Reflect.index(index.cast_signed() - RADIUS.cast_signed(), length)
    };
    let (width, height) = (picture.width(), picture.height());
    Plane::from_fn(width + 2 * RADIUS, height + 2 * RADIUS, |column, row| {
        picture.row(place(row, height))[place(column, width)]
    })
}

struct Constants {
    /// The weights of a window along one axis, from the middle outwards.
    weights: [f32; RADIUS + 1],
    /// Twice the middle of the range, which is subtracted from sums.
    middle: f32,
    c1: f32,
    c2: f32,
}

impl Constants {
    fn new(range: f32) -> Self {
        let mut weights = [1.0; RADIUS + 1];
        if let Ok(gaussian) = Gaussian::truncated(1.5, 3.5) {
            for (to, from) in weights.iter_mut().zip(&gaussian.weights()[RADIUS..]) {
                *to = *from as f32;
            }
        }
        Self {
            weights,
            middle: range,
            c1: (0.01 * range).powi(2),
            c2: (0.03 * range).powi(2),
        }
    }
}

/// Columns that are processed together: the rows in use stay in the first cache.
const TILE: usize = 128;

/// A row of each of the four quantities that are averaged, with the columns around a tile.
type Wide = [[f32; TILE + 2 * RADIUS]; 4];

/// Neighbouring columns.
type Columns = Lanes<f32, 8>;

const LANES: usize = 8;

/// A row of their means along rows.
type Means = [[Columns; TILE / LANES]; 4];

/// A value for each column of a tile.
type Row = [[f32; LANES]; TILE / LANES];

/// The windows of two pictures.
///
/// With s = a + b and d = a − b, 2 μ_a μ_b = μ_a² + μ_b² − μ_d² and μ_a² + μ_b² = (μ_s² + μ_d²) /
/// 2, and the same holds for variances. So four means are enough, those of s, d, s² and d², and
/// SSIM = (1 − μ_d² / (μ_a² + μ_b² + C₁)) (1 − σ_d² / (σ_a² + σ_b² + C₂)), which subtracts small
/// numbers where the pictures are similar: single precision suffices.
struct Windows<'a, 't, P, F> {
    a: PlaneView<'a, P>,
    b: PlaneView<'a, P>,
    channel: usize,
    constants: Constants,
    take: &'t mut F,
}

impl<P: Pixel, F: FnMut(usize, usize, &[f32], &[f32])> Work for Windows<'_, '_, P, F> {
    #[inline(always)]
    fn run(self) {
        let columns = self.a.width() - 2 * RADIUS;
        for left in (0..columns).step_by(TILE) {
            let width = (columns - left).min(TILE);
            let mut wide: Wide = [[0.0; TILE + 2 * RADIUS]; 4];
            // Source row `i` is in place `i % WINDOW`.
            let mut ring: [Means; WINDOW] = [[[Columns::splat(0.0); TILE / LANES]; 4]; WINDOW];
            let mut ssim: Row = [[0.0; LANES]; TILE / LANES];
            let mut contrast_structure = ssim;
            for (row, (a, b)) in self.a.rows().zip(self.b.rows()).enumerate() {
                let used = left * P::CHANNELS..(left + width + 2 * RADIUS) * P::CHANNELS;
                let a = &P::samples(a)[used.clone()];
                let b = &P::samples(b)[used];
                self.combine::<P::Sample>(a, b, &mut wide);
                for (means, wide) in ring[row % WINDOW].iter_mut().zip(&wide) {
                    along_row(wide, &self.constants.weights, means);
                }
                let Some(top) = row.checked_sub(2 * RADIUS) else {
                    continue;
                };
                let rows: [&Means; WINDOW] = std::array::from_fn(|i| &ring[(top + i) % WINDOW]);
                self.constants
                    .compare(rows, &mut ssim, &mut contrast_structure);
                (self.take)(
                    left,
                    top,
                    &ssim.as_flattened()[..width],
                    &contrast_structure.as_flattened()[..width],
                );
            }
        }
    }
}

impl<P: Pixel, F> Windows<'_, '_, P, F> {
    /// s, d, s² and d² of a row.
    #[inline(always)]
    fn combine<S: Sample>(&self, a: &[S], b: &[S], wide: &mut Wide) {
        let middle = self.constants.middle;
        let [sums, differences, sum_squares, difference_squares] = wide;
        let pixels = a.chunks_exact(P::CHANNELS).zip(b.chunks_exact(P::CHANNELS));
        let means = sums.iter_mut().zip(differences.iter_mut());
        let squares = sum_squares.iter_mut().zip(difference_squares.iter_mut());
        for ((pixels, (sum, difference)), (sum_square, difference_square)) in
            pixels.zip(means).zip(squares)
        {
            let (a, b) = (
                pixels.0[self.channel].to_f32(),
                pixels.1[self.channel].to_f32(),
            );
            *sum = a + b - middle;
            *difference = a - b;
            *sum_square = *sum * *sum;
            *difference_square = *difference * *difference;
        }
    }
}

/// The weighted means of each eleven neighbours in a row.
#[inline(always)]
fn along_row(
    wide: &[f32; TILE + 2 * RADIUS],
    weights: &[f32; RADIUS + 1],
    means: &mut [Columns; TILE / LANES],
) {
    for (i, mean) in means.iter_mut().enumerate() {
        // One check for all neighbours.
        let Some(window) = wide[LANES * i..].first_chunk::<{ LANES + 2 * RADIUS }>() else {
            return;
        };
        let columns = |start: usize| {
            let numbers = window[start..].first_chunk::<LANES>();
            Columns::from_array(numbers.copied().unwrap_or_default())
        };
        let mut sum = Columns::splat(weights[0]) * columns(RADIUS);
        for (d, weight) in weights.iter().enumerate().skip(1) {
            let pair = columns(RADIUS - d) + columns(RADIUS + d);
            sum += Columns::splat(*weight) * pair;
        }
        *mean = sum;
    }
}

impl Constants {
    /// SSIM, and its factor of contrast and structure, from eleven rows of means.
    #[inline(always)]
    fn compare(&self, rows: [&Means; WINDOW], ssim: &mut Row, contrast_structure: &mut Row) {
        let [c1, c2, middle, one, half] =
            [self.c1, self.c2, self.middle, 1.0, 0.5].map(Columns::splat);
        let mut means: Means = [[Columns::splat(0.0); TILE / LANES]; 4];
        for (quantity, means) in means.iter_mut().enumerate() {
            let rows = rows.map(|row| &row[quantity]);
            for (i, mean) in means.iter_mut().enumerate() {
                let mut sum = Columns::splat(self.weights[0]) * rows[RADIUS][i];
                for d in 1..=RADIUS {
                    let pair = rows[RADIUS - d][i] + rows[RADIUS + d][i];
                    sum += Columns::splat(self.weights[d]) * pair;
                }
                *mean = sum;
            }
        }
        for i in 0..TILE / LANES {
            let (sum, difference) = (means[0][i], means[1][i]);
            let difference_square = difference * difference;
            let sum_variance = means[2][i] - sum * sum;
            let difference_variance = means[3][i] - difference_square;
            let whole_sum = sum + middle;
            let squares = half * (whole_sum * whole_sum + difference_square) + c1;
            let variances = half * (sum_variance + difference_variance) + c2;
            let structure = one - difference_variance / variances;
            contrast_structure[i] = structure.to_array();
            ssim[i] = ((one - difference_square / squares) * structure).to_array();
        }
    }
}

//! Fundamental matrices, for cameras that are not calibrated.

use ga_runtime::vga3::Vector;

use super::degenerate::{check_finite, check_lines};
use super::matrix::{FundamentalMatrix, null_space};
use crate::feature::PixelPair;
use crate::geometry_error::ViewGeometryError;
use crate::normalisation::Normalisation;
use ga_numerics::polynomial::real_roots;
use ga_numerics::ransac::{Consensus, Search};

/// How a fundamental matrix is searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FundamentalOptions {
    /// Pairs of pixels with a smaller Sampson distance agree with a matrix, in pixels.
    pub threshold: f64,
    /// The seed of the random samples.
    pub seed: u64,
}

impl Default for FundamentalOptions {
    /// 1 px, seed 1.
    fn default() -> Self {
        Self {
            threshold: 1.0,
            seed: 1,
        }
    }
}

/// A fundamental matrix, and the pairs that agree with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Fundamental {
    /// The matrix.
    pub matrix: FundamentalMatrix,
    /// The indices of the pairs that agree, rising.
    pub inliers: Vec<usize>,
    /// The root mean square of their Sampson distances, in pixels.
    pub root_mean_square: f64,
}

/// The fundamental matrices of seven pairs of pixels: one or three, and none for degenerate pairs.
///
/// The seven equations leave a pencil of matrices, in which those of determinant 0 are the roots of
/// a cubic polynomial (R. Hartley and A. Zisserman, *Multiple View Geometry in Computer Vision*,
/// 2nd edition, section 11.1.2).
#[must_use]
pub fn seven_point(pairs: &[PixelPair; 7]) -> Vec<FundamentalMatrix> {
    let Some(frames) = frames(pairs) else {
        return Vec::new();
    };
    let normalised = pairs.map(|pair| frames.normalised(pair));
    let Some([a, b]) = null_space::<2>(&normalised) else {
        return Vec::new();
    };
    let rows = |m: &[f64; 9]| [0, 3, 6].map(|k| Vector::new(m[k], m[k + 1], m[k + 2]));
    let (a, b) = (rows(&a), rows(&b));
    let along =
        |x: f64| -> [Vector<f64>; 3] { std::array::from_fn(|k| a[k] * x + b[k] * (1.0 - x)) };
    let determinant = |m: [Vector<f64>; 3]| m[0].dot(m[1].cross(m[2]));
    // The cubic polynomial through its values at four places.
    let [d0, d1, d2, d3] = [-1.0, 0.0, 1.0, 2.0].map(|x| determinant(along(x)));
    let second = 0.5 * (d0 + d2) - d1;
    let third = (d3 - 3.0 * d2 + 3.0 * d1 - d0) / 6.0;
    let first = 0.5 * (d2 - d0) - third;
    let roots = real_roots(&[d1, first, second, third]);
    let matrices = roots.into_iter().filter_map(|x| frames.restored(along(x)));
    matrices.collect()
}

/// The fundamental matrix of eight or more pairs of pixels, by the least sum of squares of the
/// equations in normalised coordinates, made singular (R. Hartley, "In defense of the eight-point
/// algorithm", IEEE Transactions on Pattern Analysis and Machine Intelligence 19, 1997).
///
/// # Errors
/// [`ViewGeometryError`] for fewer than eight pairs, numbers that are not finite, and pixels on a
/// line.
pub fn eight_point(pairs: &[PixelPair]) -> Result<FundamentalMatrix, ViewGeometryError> {
    const NEEDED: usize = 8;
    if pairs.len() < NEEDED {
        return Err(ViewGeometryError::TooFew {
            found: pairs.len(),
            needed: NEEDED,
        });
    }
    check_finite(pairs)?;
    check_lines(pairs, 0.0)?;
    let found = frames(pairs).and_then(|frames| {
        let normalised: Vec<_> = pairs.iter().map(|pair| frames.normalised(*pair)).collect();
        let [m] = null_space::<1>(&normalised)?;
        let rows = [0, 3, 6].map(|k| Vector::new(m[k], m[k + 1], m[k + 2]));
        let singular = FundamentalMatrix::normalised(rows)?.of_rank_two()?;
        frames.restored(singular.rows().map(Vector::from))
    });
    found.ok_or(ViewGeometryError::Undetermined)
}

/// The fundamental matrix with which most pairs of pixels agree: random samples of seven, and then
/// the eight-point algorithm on all pairs that agree, as long as more do.
///
/// # Errors
/// [`ViewGeometryError`] for fewer than eight pairs, a threshold that is not positive and finite,
/// numbers that are not finite, pixels on a line, and no matrix with which eight pairs agree.
pub fn estimate_fundamental(
    pairs: &[PixelPair],
    options: &FundamentalOptions,
) -> Result<Fundamental, ViewGeometryError> {
    const NEEDED: usize = 8;
    if pairs.len() < NEEDED {
        return Err(ViewGeometryError::TooFew {
            found: pairs.len(),
            needed: NEEDED,
        });
    }
    if !(options.threshold.is_finite() && options.threshold > 0.0) {
        return Err(ViewGeometryError::MatchThreshold(options.threshold));
    }
    check_finite(pairs)?;
    check_lines(pairs, 0.0)?;
    let search = Search {
        threshold: options.threshold,
        confidence: 0.9999,
        least_samples: 50,
        samples: 20_000,
        seed: options.seed,
    };
    let problem = Pixels(pairs);
    let found = search.run(&problem, 1);
    let mut best = found
        .into_iter()
        .next()
        .ok_or(ViewGeometryError::Undetermined)?;
    loop {
        let agreeing = search.inliers(&problem, &best.model);
        let selected: Vec<PixelPair> = agreeing.iter().map(|&k| pairs[k]).collect();
        if selected.len() < NEEDED {
            return Err(ViewGeometryError::NoConsensus {
                agreeing: selected.len(),
                pairs: pairs.len(),
            });
        }
        let refined = eight_point(&selected)?;
        match search.rate(&problem, refined, best.cost) {
            Some(better) => best = better,
            None => break,
        }
    }
    let inliers = search.inliers(&problem, &best.model);
    let squares = inliers
        .iter()
        .map(|&k| problem.squared_error(&best.model, k));
    let mean = squares.sum::<f64>() / inliers.len() as f64;
    Ok(Fundamental {
        matrix: best.model,
        root_mean_square: mean.sqrt(),
        inliers,
    })
}

struct Pixels<'a>(&'a [PixelPair]);

impl Consensus for Pixels<'_> {
    type Model = FundamentalMatrix;

    const SAMPLE: usize = 7;

    fn count(&self) -> usize {
        self.0.len()
    }

    fn fit(&self, sample: &[usize], models: &mut Vec<FundamentalMatrix>) {
        models.extend(seven_point(&std::array::from_fn(|k| self.0[sample[k]])));
    }

    fn squared_error(&self, model: &FundamentalMatrix, observation: usize) -> f64 {
        let PixelPair { left, right } = self.0[observation];
        model.sampson_distance(left, right).powi(2)
    }
}

/// The normalisations of the left and of the right view.
struct Frames([Normalisation; 2]);

fn frames(pairs: &[PixelPair]) -> Option<Frames> {
    Some(Frames([
        Normalisation::new(pairs.iter().map(|pair| pair.left))?,
        Normalisation::new(pairs.iter().map(|pair| pair.right))?,
    ]))
}

impl Frames {
    fn normalised(&self, pair: PixelPair) -> [Vector<f64>; 2] {
        let [left, right] = [self.0[0].apply(pair.left), self.0[1].apply(pair.right)];
        [left, right].map(|[x, y]| Vector::new(x, y, 1.0))
    }

    /// The matrix for pixels of one for normalised ones, `Tᵣᵀ F Tₗ`.
    fn restored(&self, rows: [Vector<f64>; 3]) -> Option<FundamentalMatrix> {
        let [left, right] = self.0.map(|frame| frame.scale);
        let [[u, v], [x, y]] = self.0.map(|frame| frame.centre);
        let by_left = |row: Vector<f64>| {
            let [a, b] = [row.e1 * left, row.e2 * left];
            Vector::new(a, b, row.e3 - a * u - b * v)
        };
        let [first, second, third] = rows.map(by_left);
        let (first, second) = (first * right, second * right);
        FundamentalMatrix::normalised([first, second, third - first * x - second * y])
    }
}

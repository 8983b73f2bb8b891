//! The row in the left view as a linear function of the pixel in the right view.

use nalgebra_035::{Matrix3, Vector3};

use crate::feature::PixelPair;
use crate::geometry_error::ViewGeometryError;
use ga_numerics::ransac::Consensus;

/// Points count as lying on one line where the smallest eigenvalue of their moments is below this
/// part of the largest.
const ON_ONE_LINE: f64 = 1e-10;

/// `v_left = a u_right + b v_right + c`, in pixels from the middle of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowModel {
    a: f64,
    b: f64,
    c: f64,
}

impl RowModel {
    /// The number of pairs that determine it.
    pub const NEEDED: usize = 3;

    /// Two views of one scene do not have rows that run backwards, or that are squeezed to a small
    /// part of the picture.
    #[must_use]
    pub fn is_plausible(&self) -> bool {
        self.b > 0.1 && (0.2..5.0).contains(&self.zoom())
    }

    /// The rotation of the right camera about its axis in radians.
    #[must_use]
    pub fn rotation(&self) -> f64 {
        (-self.a).atan2(self.b)
    }

    /// How much larger things are in the right view.
    #[must_use]
    pub fn zoom(&self) -> f64 {
        1.0 / self.a.hypot(self.b)
    }

    /// The row in the right view, in its middle column, of the middle row of the left view.
    #[must_use]
    pub fn vertical_offset(&self) -> f64 {
        -self.c / self.b
    }
}

/// Pairs of points from the middle of the picture.
pub struct Rows {
    /// `[u_right, v_right, v_left]`.
    pairs: Vec<[f64; 3]>,
    /// Half of the longer side, by which coordinates are divided in systems of equations.
    scale: f64,
    /// What each pair counts in a fit.
    weights: Vec<f64>,
}

impl Rows {
    /// The pairs of views of one size, `[width, height]`.
    ///
    /// # Errors
    /// [`ViewGeometryError`] where there are too few pairs, where one is not finite, and where all
    /// lie on one line.
    pub fn new(pairs: &[PixelPair], size: [usize; 2]) -> Result<Self, ViewGeometryError> {
        if pairs.len() < RowModel::NEEDED {
            return Err(ViewGeometryError::TooFewMatches {
                found: pairs.len(),
                needed: RowModel::NEEDED,
            });
        }
        let [middle_u, middle_v] = size.map(|count| 0.5 * (count as f64 - 1.0));
        let mut rows = Vec::with_capacity(pairs.len());
        for (index, pair) in pairs.iter().enumerate() {
            let numbers = pair.left.iter().chain(&pair.right);
            if !numbers.copied().all(f64::is_finite) {
                return Err(ViewGeometryError::MatchNotFinite(index));
            }
            let [u, v] = pair.right;
            rows.push([u - middle_u, v - middle_v, pair.left[1] - middle_v]);
        }
        let rows = Self {
            pairs: rows,
            scale: middle_u.max(middle_v).max(1.0),
            weights: vec![1.0; pairs.len()],
        };
        let all: Vec<usize> = (0..pairs.len()).collect();
        match rows.fitted(&all) {
            Some(_) => Ok(rows),
            None => Err(ViewGeometryError::OnOneLine),
        }
    }

    /// Lets a pair count for this much in a fit; all count for 1 before.
    pub fn set_weight(&mut self, index: usize, weight: f64) {
        self.weights[index] = weight;
    }

    /// The model that fits some pairs best; `None` where they do not determine one.
    #[must_use]
    pub fn fitted(&self, chosen: &[usize]) -> Option<RowModel> {
        let (mut moments, mut target) = (Matrix3::zeros(), Vector3::zeros());
        for &index in chosen {
            let [u, v, row] = self.pairs[index].map(|x| x / self.scale);
            let place = Vector3::new(u, v, 1.0);
            let weight = self.weights[index];
            moments += weight * place * place.transpose();
            target += weight * row * place;
        }
        let eigenvalues = moments.symmetric_eigenvalues();
        let (least, most) = (eigenvalues.min(), eigenvalues.max());
        if least.is_nan() || least <= ON_ONE_LINE * most {
            return None;
        }
        let solution = moments.cholesky()?.solve(&target);
        let model = RowModel {
            a: solution.x,
            b: solution.y,
            c: solution.z * self.scale,
        };
        Some(model)
    }

    /// How far the model is from the row of a pair, in pixels.
    #[must_use]
    pub fn residual(&self, model: &RowModel, index: usize) -> f64 {
        let [u, v, row] = self.pairs[index];
        model.a * u + model.b * v + model.c - row
    }

    /// The pairs that a model is nearer to than the threshold in pixels, rising.
    #[must_use]
    pub fn agreeing(&self, model: &RowModel, threshold: f64) -> Vec<usize> {
        (0..self.pairs.len())
            .filter(|&index| self.residual(model, index).abs() < threshold)
            .collect()
    }
}

impl Consensus for Rows {
    type Model = RowModel;

    const SAMPLE: usize = RowModel::NEEDED;

    fn count(&self) -> usize {
        self.pairs.len()
    }

    fn fit(&self, sample: &[usize], models: &mut Vec<RowModel>) {
        models.extend(self.fitted(sample).filter(RowModel::is_plausible));
    }

    fn squared_error(&self, model: &RowModel, observation: usize) -> f64 {
        self.residual(model, observation).powi(2)
    }
}

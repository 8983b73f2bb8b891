//! Rounds by an algebraic fit, from moments.

use super::place::Place;
use crate::geometry::cga3::matrix::{Matrix, symmetric, symmetric_eigen};
use crate::scalar::Real;
use crate::vga3::Vector;

/// Sums over weighted points of the vectors `(x², x)`, where x has one coordinate fewer.
#[derive(Clone, Copy)]
pub(super) struct SquareMoments<S, const M: usize> {
    /// The mean of the vectors.
    pub(super) mean: [S; M],
    /// Their mean products about the mean.
    pub(super) products: Matrix<S, M>,
}

impl<S: Real<Mask = bool>, const M: usize> SquareMoments<S, M> {
    /// The moments of vectors with weights of the given sum.
    #[inline]
    pub(super) fn of(vectors: impl Iterator<Item = (S, [S; M])>, total: S) -> Self {
        let zero = S::zero();
        let (mut mean, mut products) = ([zero; M], [[zero; M]; M]);
        for (weight, vector) in vectors {
            for row in 0..M {
                let weighted = vector[row] * weight;
                mean[row] += weighted;
                for column in 0..=row {
                    products[row][column] = weighted.mul_add(vector[column], products[row][column]);
                }
            }
        }
        mean = mean.map(|sum| sum / total);
        for row in 0..M {
            for column in 0..=row {
                products[row][column] =
                    mean[row].neg_mul_add(mean[column], products[row][column] / total);
            }
        }
        let products = symmetric(products);
        Self { mean, products }
    }

    /// The coefficients `[A, B…]` and C of the round `A x² + B·x + C = 0` with the least sum of
    /// squares at the points, relative to the mean square of its gradient there, and that quotient:
    /// the mean squared distance to first order (Taubin, Estimation of planar curves, surfaces and
    /// nonplanar space curves defined by implicit equations, IEEE Transactions on Pattern Analysis
    /// and Machine Intelligence 13, 1991). The points must be relative to their centroid.
    ///
    /// In conformal algebra the sum is `Σ (x·σ)²` for the dual sphere σ. The gradient has the mean
    /// square `4A² mean(x²) + B²`, where the fit of Pratt (Direct least-squares fitting of
    /// algebraic surfaces, SIGGRAPH 1987) has `σ² = B² − 4AC`.
    pub(super) fn round(&self) -> ([S; M], S, S) {
        let scale = (self.mean[0].sqrt() * S::from_integer(2)).recip();
        let mut matrix = self.products;
        matrix[0] = matrix[0].map(|entry| entry * scale);
        for row in &mut matrix {
            row[0] *= scale;
        }
        let pairs = symmetric_eigen(matrix);
        let (least, mut coefficients) = pairs[M - 1];
        coefficients[0] *= scale;
        let constant = coefficients
            .iter()
            .zip(self.mean)
            .fold(S::zero(), |sum, (&a, mean)| a.neg_mul_add(mean, sum));
        (coefficients, constant, least)
    }
}

impl<S: Real<Mask = bool>> SquareMoments<S, 3> {
    /// The place of the circle of the plane with an orthonormal pair of axes, in which the moments
    /// were taken, or of the cylinder over it.
    pub(super) fn place(&self, [u, v]: [Vector<S>; 2], normal: Vector<S>) -> Option<Place<S>> {
        let ([a, x, y], c, _) = self.round();
        Place::of_round([a, c], u * x + v * y, Some(normal))
    }
}

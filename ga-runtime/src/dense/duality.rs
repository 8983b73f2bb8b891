//! Complements, duals and the regressive product.

use alloc::vec;

use super::Multivector;
use super::blade::{self, Sign};
use crate::scalar::{Field, Ring};

impl<S: Ring> Multivector<S> {
    /// The right complement: the linear map that takes a basis blade B to the blade with B ∧
    /// complement(B) = I, up to sign the one of all other vectors. It does not depend on the
    /// metric.
    ///
    /// ```
    /// use ga_runtime::dense::Algebra;
    /// # fn main() -> Result<(), ga_runtime::dense::DenseError> {
    /// let space = Algebra::<i64>::with_signature(3, 0, 0)?;
    /// assert_eq!(space.blade(0b010)?.right_complement().to_string(), "-e13");
    /// # Ok(())
    /// # }
    /// ```
    pub fn right_complement(&self) -> Self {
        self.complement(sign_of_join)
    }

    /// The left complement, the inverse of the right one: complement(B) ∧ B = I for basis blades.
    pub fn left_complement(&self) -> Self {
        self.complement(|blade, rest| sign_of_join(rest, blade))
    }

    fn complement(&self, sign: impl Fn(usize, usize) -> Sign) -> Self {
        let all = self.algebra().size() - 1;
        let mut coefficients = vec![S::zero(); self.algebra().size()];
        for (blade, value) in self.terms() {
            let rest = all ^ blade;
            coefficients[rest] = sign(blade, rest).times(value);
        }
        Self::from_parts(self.algebra().clone(), coefficients)
    }
}

impl<S: Field> Multivector<S> {
    /// The dual a I⁻¹, or the right complement if the metric is singular.
    pub fn dual(&self) -> Self {
        let determinant = self.algebra().determinant();
        if !determinant.is_invertible() {
            self.right_complement()
        } else {
            // I⁻¹ = ~I / det, as I ~I is the determinant of the metric.
            self.geometric(&self.algebra().pseudoscalar().reverse())
                .scale(determinant.recip())
        }
    }

    /// The inverse of [`dual`](Self::dual): a I, or the left complement if the metric is singular.
    pub fn undual(&self) -> Self {
        if !self.algebra().determinant().is_invertible() {
            self.left_complement()
        } else {
            self.geometric(&self.algebra().pseudoscalar())
        }
    }

    /// The regressive product a ∨ b = undual(dual(a) ∧ dual(b)): the meet of two blades whose join
    /// is the whole space.
    ///
    /// # Panics
    ///
    /// If the operands belong to different algebras.
    pub fn vee(&self, other: &Self) -> Self {
        self.dual().wedge(&other.dual()).undual()
    }
}

/// The sign of sorting the vectors of two blades without a common vector, one list after the other.
fn sign_of_join(left: usize, right: usize) -> Sign {
    let swaps = blade::vectors(right)
        .map(|vector| {
            blade::vectors(left)
                .filter(|&passed| passed > vector)
                .count()
        })
        .sum();
    Sign::of_swaps(swaps)
}

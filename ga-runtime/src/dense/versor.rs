//! Versors: products of vectors, and their action.

use super::Multivector;
use crate::scalar::{Field, Ring};

impl<S: Ring> Multivector<S> {
    /// The scalar ⟨a ~a⟩₀. It is negative for some multivectors in most metrics.
    pub fn norm_squared(&self) -> S {
        self.scalar_product(&self.reverse())
    }

    /// The sandwich a x ~a. For a unit even versor this is its action on x.
    ///
    /// # Panics
    ///
    /// If the operands belong to different algebras.
    pub fn sandwich(&self, operand: &Self) -> Self {
        self.geometric(operand).geometric(&self.reverse())
    }
}

impl<S: Field> Multivector<S> {
    /// The inverse of a versor, V⁻¹ = ~V / (V ~V), or `None` if V ~V has no scalar part.
    ///
    /// That V is a versor, so that V ~V is a scalar, is not checked, since floating-point scalars
    /// satisfy it only up to rounding. Over exact scalars, V V⁻¹ can be compared with one.
    pub fn inverse(&self) -> Option<Self> {
        let norm_squared = self.norm_squared();
        (norm_squared != S::zero()).then(|| self.reverse().scale(norm_squared.recip()))
    }

    /// The action of a versor: V x V⁻¹ for an even one, V x̂ V⁻¹ with the grade involution for an
    /// odd one. So a vector v reflects in the hyperplane that is orthogonal to it, and the product
    /// of two versors acts as one after the other.
    ///
    /// `None` if the multivector is neither even nor odd, or has no inverse.
    ///
    /// # Panics
    ///
    /// If the operands belong to different algebras.
    ///
    /// ```
    /// use ga_runtime::dense::Algebra;
    /// # fn main() -> Result<(), ga_runtime::dense::DenseError> {
    /// let space = Algebra::with_signature(3, 0, 0)?;
    /// let mirror = space.vector([0.0, 0.0, 2.0])?;
    /// let image = mirror.transform(&space.vector([1.0, 2.0, 3.0])?);
    /// assert_eq!(image, Some(space.vector([1.0, 2.0, -3.0])?));
    /// # Ok(())
    /// # }
    /// ```
    pub fn transform(&self, operand: &Self) -> Option<Self> {
        let inverse = self.inverse()?;
        let involuted = self.involute();
        if *self == involuted {
            Some(self.geometric(operand).geometric(&inverse))
        } else if *self == -involuted {
            Some(self.geometric(&operand.involute()).geometric(&inverse))
        } else {
            None
        }
    }
}

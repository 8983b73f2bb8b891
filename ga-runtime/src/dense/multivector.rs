//! A multivector with all its coefficients, and its linear operations.

use alloc::vec::Vec;

use super::blade::{self, Sign};
use super::{Algebra, DenseError};
use crate::scalar::Ring;

/// A multivector of an [`Algebra`], one coefficient for each of the 2ⁿ basis blades.
///
/// # Panics
///
/// Sums and products, as methods and as operators, panic if the operands belong to different
/// algebras. That is an error in the program, whatever its input.
///
/// ```
/// use ga_runtime::dense::Algebra;
/// # fn main() -> Result<(), ga_runtime::dense::DenseError> {
/// let plane = Algebra::with_signature(2, 0, 0)?;
/// let quarter_turn = plane.sparse([(0b11, -1)])?;
/// let e1 = plane.blade(0b01)?;
/// assert_eq!(&quarter_turn * &e1, plane.blade(0b10)?);
/// assert_eq!(&quarter_turn * &quarter_turn, plane.scalar(-1));
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Multivector<S> {
    algebra: Algebra<S>,
    coefficients: Vec<S>,
}

impl<S: Ring> Multivector<S> {
    /// The algebra of which it is an element.
    pub fn algebra(&self) -> &Algebra<S> {
        &self.algebra
    }

    /// All coefficients, indexed by the bitmasks of the basis blades.
    pub fn coefficients(&self) -> &[S] {
        &self.coefficients
    }

    /// The coefficient of the basis blade of a bitmask; zero for a blade that the algebra does not
    /// have.
    pub fn coefficient(&self, blade: usize) -> S {
        self.coefficients.get(blade).copied().unwrap_or(S::zero())
    }

    /// Sets the coefficient of the basis blade of a bitmask.
    ///
    /// # Errors
    ///
    /// [`DenseError::NoSuchBlade`].
    pub fn set_coefficient(&mut self, blade: usize, value: S) -> Result<(), DenseError> {
        let dimension = self.algebra.dimension();
        let coefficient = self
            .coefficients
            .get_mut(blade)
            .ok_or(DenseError::NoSuchBlade { blade, dimension })?;
        *coefficient = value;
        Ok(())
    }

    /// The coefficients that are not zero, with the bitmasks of their blades, in rising order.
    pub fn terms(&self) -> impl Iterator<Item = (usize, S)> + '_ {
        self.coefficients
            .iter()
            .copied()
            .enumerate()
            .filter(|(_, value)| *value != S::zero())
    }

    /// Whether all coefficients are zero.
    pub fn is_zero(&self) -> bool {
        self.terms().next().is_none()
    }

    /// The part of one grade, ⟨a⟩ₖ; zero if there is no such grade.
    pub fn grade(&self, grade: usize) -> Self {
        self.map(|blade, value| {
            if blade::grade(blade) == grade {
                value
            } else {
                S::zero()
            }
        })
    }

    /// The grades of which some coefficient is not zero, in rising order.
    pub fn grades(&self) -> Vec<usize> {
        let mut grades: Vec<usize> = self.terms().map(|(blade, _)| blade::grade(blade)).collect();
        grades.sort_unstable();
        grades.dedup();
        grades
    }

    /// The product with a scalar.
    pub fn scale(&self, factor: S) -> Self {
        self.map(|_, value| value * factor)
    }

    /// The reverse ~a: the factors of every product of vectors in reverse order. A blade of grade k
    /// changes its sign by (−1)^(k (k − 1) / 2).
    pub fn reverse(&self) -> Self {
        // The first vector passes k − 1 others, the next k − 2, and so on.
        self.with_signs(|grade| grade * grade.saturating_sub(1) / 2)
    }

    /// The grade involution â: every vector negated. A blade of grade k changes its sign by (−1)ᵏ.
    pub fn involute(&self) -> Self {
        self.with_signs(|grade| grade)
    }

    /// The Clifford conjugate: reverse and grade involution in one. A blade of grade k changes its
    /// sign by (−1)^(k (k + 1) / 2).
    pub fn conjugate(&self) -> Self {
        self.with_signs(|grade| grade * (grade + 1) / 2)
    }

    pub(super) fn from_parts(algebra: Algebra<S>, coefficients: Vec<S>) -> Self {
        debug_assert_eq!(coefficients.len(), algebra.size());
        Self {
            algebra,
            coefficients,
        }
    }

    pub(crate) fn map(&self, function: impl Fn(usize, S) -> S) -> Self {
        let coefficients = self
            .coefficients
            .iter()
            .enumerate()
            .map(|(blade, &value)| function(blade, value))
            .collect();
        Self::from_parts(self.algebra.clone(), coefficients)
    }

    pub(super) fn combine(&self, other: &Self, function: impl Fn(S, S) -> S) -> Self {
        self.require_same_algebra(other);
        let coefficients = self
            .coefficients
            .iter()
            .zip(&other.coefficients)
            .map(|(&a, &b)| function(a, b))
            .collect();
        Self::from_parts(self.algebra.clone(), coefficients)
    }

    pub(super) fn require_same_algebra(&self, other: &Self) {
        assert!(
            self.algebra == other.algebra,
            "multivectors of different algebras have no sum and no product"
        );
    }

    /// Each blade with the sign of the number of swaps that the function returns for its grade.
    fn with_signs(&self, swaps: impl Fn(usize) -> usize) -> Self {
        self.map(|blade, value| Sign::of_swaps(swaps(blade::grade(blade))).times(value))
    }
}

impl<S: Ring> PartialEq for Multivector<S> {
    fn eq(&self, other: &Self) -> bool {
        self.algebra == other.algebra && self.coefficients == other.coefficients
    }
}

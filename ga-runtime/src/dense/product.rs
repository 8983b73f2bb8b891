//! The products that are defined by the metric alone.

use alloc::vec;
use alloc::vec::Vec;

use super::{Algebra, Multivector, blade};
use crate::scalar::{Field, Ring};

impl<S: Ring> Multivector<S> {
    /// The geometric product a b.
    ///
    /// # Panics
    ///
    /// If the operands belong to different algebras; so does every product.
    pub fn geometric(&self, other: &Self) -> Self {
        self.multiply(other, Recursion::Geometric)
    }

    /// The outer product a ∧ b, Σ ⟨aᵣ bₛ⟩ of grade r + s.
    pub fn wedge(&self, other: &Self) -> Self {
        self.multiply(other, Recursion::Wedge)
    }

    /// The left contraction a ⌋ b, Σ ⟨aᵣ bₛ⟩ of grade s − r: what remains of b when a is removed
    /// from it.
    pub fn left_contraction(&self, other: &Self) -> Self {
        self.multiply(other, Recursion::LeftContraction)
    }

    /// The right contraction a ⌊ b, Σ ⟨aᵣ bₛ⟩ of grade r − s: what remains of a when b is removed
    /// from it.
    pub fn right_contraction(&self, other: &Self) -> Self {
        other.reverse().left_contraction(&self.reverse()).reverse()
    }

    /// The scalar part ⟨a b⟩₀ of the geometric product. Neither operand is reversed.
    pub fn scalar_product(&self, other: &Self) -> S {
        self.left_contraction(other).coefficient(0)
    }

    /// The inner product Σ ⟨aᵣ bₛ⟩ of grade |r − s|, where a scalar multiplies: Dorst's "fat dot".
    pub fn dot(&self, other: &Self) -> Self {
        let both = self.algebra().scalar(self.scalar_product(other));
        self.left_contraction(other) + self.right_contraction(other) - both
    }

    /// The inner product Σ ⟨aᵣ bₛ⟩ of grade |r − s| over r, s ≠ 0: that of Hestenes, where a scalar
    /// gives zero.
    pub fn hestenes(&self, other: &Self) -> Self {
        let without_scalar =
            |a: &Self| a.map(|blade, value| if blade == 0 { S::zero() } else { value });
        without_scalar(self).dot(&without_scalar(other))
    }

    /// The commutator product (a b − b a) / 2.
    pub fn commutator(&self, other: &Self) -> Self
    where
        S: Field,
    {
        (self.geometric(other) - other.geometric(self)).scale(S::from_ratio(1, 2))
    }

    fn multiply(&self, other: &Self, recursion: Recursion) -> Self {
        self.require_same_algebra(other);
        let product =
            recursion.product(self.algebra(), 0, self.coefficients(), other.coefficients());
        Self::from_parts(self.algebra().clone(), product)
    }
}

/// The three products that are built up one basis vector of the left operand at a time.
#[derive(Clone, Copy)]
enum Recursion {
    Geometric,
    Wedge,
    LeftContraction,
}

impl Recursion {
    /// The product of `left`, which contains no basis vector before `first`, and any `right`.
    fn product<S: Ring>(
        self,
        algebra: &Algebra<S>,
        first: usize,
        left: &[S],
        right: &[S],
    ) -> Vec<S> {
        if first == algebra.dimension() {
            return right.iter().map(|&value| left[0] * value).collect();
        }
        let Some((mut without, cofactor)) = split(first, left) else {
            return self.product(algebra, first + 1, left, right);
        };
        let metric = &algebra.metric()[first];
        let inner = self.product(algebra, first + 1, &cofactor, right);
        let mut product = vec![S::zero(); right.len()];
        if matches!(self, Self::Geometric | Self::Wedge) {
            add_wedge(first, &inner, &mut product);
        }
        if matches!(self, Self::Geometric | Self::LeftContraction) {
            add_contraction(metric, &inner, &mut product);
        }
        if matches!(self, Self::Geometric) {
            let negated: Vec<S> = cofactor.iter().map(|&value| -value).collect();
            add_contraction(metric, &negated, &mut without);
        }
        if without.iter().any(|&value| value != S::zero()) {
            for (sum, value) in
                product
                    .iter_mut()
                    .zip(self.product(algebra, first + 1, &without, right))
            {
                *sum += value;
            }
        }
        product
    }
}

/// Writes a multivector that contains no vector before e as a′ + e ∧ a″ and returns a′ and a″;
/// `None` if a″ is zero.
fn split<S: Ring>(vector: usize, coefficients: &[S]) -> Option<(Vec<S>, Vec<S>)> {
    let bit = 1 << vector;
    let mut without = coefficients.to_vec();
    let mut cofactor = vec![S::zero(); coefficients.len()];
    let mut found = false;
    // Blades that contain earlier vectors have no coefficients here.
    for blade in (bit..coefficients.len()).step_by(2 * bit) {
        let value = core::mem::replace(&mut without[blade], S::zero());
        found |= value != S::zero();
        cofactor[blade ^ bit] = value;
    }
    found.then_some((without, cofactor))
}

/// Adds e ∧ a to the sum, for the basis vector e.
fn add_wedge<S: Ring>(vector: usize, coefficients: &[S], sum: &mut [S]) {
    for (blade, &value) in coefficients.iter().enumerate() {
        if value == S::zero() {
            continue;
        }
        if let Some((sign, joined)) = blade::wedge(vector, blade) {
            sum[joined] += sign.times(value);
        }
    }
}

/// Adds e ⌋ a to the sum, for the basis vector e with the given inner products with all basis
/// vectors.
fn add_contraction<S: Ring>(metric: &[S], coefficients: &[S], sum: &mut [S]) {
    for (blade, &value) in coefficients.iter().enumerate() {
        if value == S::zero() {
            continue;
        }
        for (met, sign, rest) in blade::contraction(blade) {
            if metric[met] != S::zero() {
                sum[rest] += sign.times(metric[met] * value);
            }
        }
    }
}

//! Inner products, by one of several rules.

use crate::algebra::{Algebra, Product, Ratio};
use crate::ir::{Arena, Multivector};

/// How `a · b` of two vectors is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum InnerRule {
    /// By coefficients.
    #[default]
    Plain,
    /// `a·b = −½ (a − b)²` for `a² = b² = 0`, since `(a − b)² = a² − 2 a·b + b²`. Of two points of
    /// weight 1 it is −½ times their squared distance: differences before squares, so that nothing
    /// large cancels.
    Distance,
    /// The same, and outer products of vectors by inner products of the vectors, where that does
    /// not cancel; see [`gram`](super::gram).
    Gram,
}

impl InnerRule {
    /// Every rule, in the order in which they are tried.
    pub const ALL: [Self; 3] = [Self::Plain, Self::Distance, Self::Gram];

    /// Lowers the inner product of two multivectors; `None` where the rule does not apply.
    #[must_use]
    pub fn lower(
        self,
        arena: &mut Arena,
        algebra: &Algebra,
        left: &Multivector,
        right: &Multivector,
    ) -> Option<Multivector> {
        let is_vector =
            |value: &Multivector| value.terms().iter().all(|(blade, _)| blade.grade() == 1);
        if self == Self::Plain
            || !(is_vector(left) && is_vector(right) && left.facts.null && right.facts.null)
        {
            return None;
        }
        let difference = left.sum(arena, &right.scaled(Ratio::integer(-1)));
        let square =
            difference.product(arena, algebra, Product::ScalarProduct, &difference, |_| {
                true
            });
        Some(square.scaled(-Ratio::ONE / Ratio::integer(2)))
    }
}

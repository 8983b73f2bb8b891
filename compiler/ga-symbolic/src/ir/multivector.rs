//! Multivectors whose coefficients are values of an arena.

use super::{Arena, Facts, Value};
use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::order::Order as _;

/// A sparse sum of blades, sorted by blade, with what is known of it.
#[derive(Clone, Debug, Default)]
pub struct Multivector {
    terms: Vec<(Blade, Value)>,
    /// What is known of the whole.
    pub facts: Facts,
}

impl Multivector {
    /// A multivector of the given coefficients; zeros are dropped and equal blades are added.
    pub fn new(arena: &mut Arena, terms: impl IntoIterator<Item = (Blade, Value)>) -> Self {
        let mut terms: Vec<(Blade, Value)> = terms.into_iter().collect();
        terms.order_by_key(|(blade, _)| *blade);
        let mut sums = Vec::new();
        for same in terms.chunk_by(|(a, _), (b, _)| a == b) {
            let value = match same {
                [(_, single)] => *single,
                _ => arena.sum(same.iter().map(|(_, value)| *value)),
            };
            if !value.is_zero() {
                sums.push((same[0].0, value));
            }
        }
        Self {
            terms: sums,
            facts: Facts::default(),
        }
    }

    /// The blades that may be present, with their values.
    #[must_use]
    pub fn terms(&self) -> &[(Blade, Value)] {
        &self.terms
    }

    /// The value of a blade.
    #[must_use]
    pub fn coefficient(&self, blade: Blade) -> Value {
        self.terms
            .iter()
            .find(|(other, _)| *other == blade)
            .map_or(Value::ZERO, |(_, value)| *value)
    }

    /// The same coefficients with other facts.
    #[must_use]
    pub fn with_facts(mut self, facts: Facts) -> Self {
        self.facts = facts;
        self
    }

    /// The multivector with a wrong sign in its last coefficient that is not constant, for tests of
    /// the checks.
    #[must_use]
    pub(crate) fn with_last_negated(mut self) -> Self {
        let is_open = |(_, value): &&mut (Blade, Value)| value.as_constant().is_none();
        if let Some((_, value)) = self.terms.iter_mut().rev().find(is_open) {
            *value = -*value;
        }
        self
    }

    /// The part whose blades satisfy a condition, without facts.
    #[must_use]
    pub fn filtered(&self, keep: impl Fn(Blade) -> bool) -> Self {
        Self {
            terms: self
                .terms
                .iter()
                .copied()
                .filter(|(blade, _)| keep(*blade))
                .collect(),
            facts: Facts::default(),
        }
    }

    /// The multivector times a constant.
    #[must_use]
    pub fn scaled(&self, factor: Ratio) -> Self {
        Self {
            terms: self
                .terms
                .iter()
                .map(|&(blade, value)| (blade, value.scaled(factor)))
                .filter(|(_, value)| !value.is_zero())
                .collect(),
            facts: Facts::default(),
        }
    }

    /// The sum of two multivectors.
    #[must_use]
    pub fn sum(&self, arena: &mut Arena, other: &Self) -> Self {
        let both: Vec<_> = self.terms.iter().chain(&other.terms).copied().collect();
        Self::new(arena, both)
    }

    /// A bilinear product; `keep` says which blades of it are wanted.
    #[must_use]
    pub fn product(
        &self,
        arena: &mut Arena,
        algebra: &Algebra,
        product: Product,
        other: &Self,
        keep: impl Fn(Blade) -> bool,
    ) -> Self {
        let mut terms = Vec::new();
        for &(left, a) in &self.terms {
            for &(right, b) in &other.terms {
                for &(blade, factor) in product.of_blades(algebra, left, right).iter() {
                    if keep(blade) {
                        terms.push((blade, arena.product(a, b).scaled(factor)));
                    }
                }
            }
        }
        Self::new(arena, terms)
    }

    /// A linear operation on one operand.
    #[must_use]
    pub fn unary(&self, arena: &mut Arena, algebra: &Algebra, operation: Unary) -> Self {
        let terms: Vec<_> = self
            .terms
            .iter()
            .flat_map(|&(blade, value)| {
                operation
                    .of_blade(algebra, blade)
                    .into_iter()
                    .map(move |(result, factor)| (result, value.scaled(factor)))
            })
            .collect();
        Self::new(arena, terms)
    }
}

//! Sums of products of powers, whose variables are nodes that a formula does not expand.

use std::collections::BTreeMap;

use crate::algebra::Ratio;
use crate::ir::NodeId;

/// A product of powers in rising order; exponents are not zero, negative ones divide.
pub(super) type Monomial = Vec<(NodeId, i32)>;

/// A polynomial whose exponents may be negative. The variables are nodes: inputs, functions, and
/// what would grow too large if it were expanded.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Polynomial {
    pub(super) terms: BTreeMap<Monomial, Ratio>,
}

impl Polynomial {
    pub(super) fn constant(value: Ratio) -> Self {
        Self::term(Monomial::new(), value)
    }

    pub(super) fn variable(node: NodeId) -> Self {
        Self::term(vec![(node, 1)], Ratio::ONE)
    }

    pub(super) fn term(monomial: Monomial, factor: Ratio) -> Self {
        let mut terms = BTreeMap::new();
        if !factor.is_zero() {
            terms.insert(monomial, factor);
        }
        Self { terms }
    }

    pub(super) fn len(&self) -> usize {
        self.terms.len()
    }

    pub(super) fn add_scaled(&mut self, other: &Self, factor: Ratio) {
        for (monomial, &coefficient) in &other.terms {
            let entry = self.terms.entry(monomial.clone()).or_insert(Ratio::ZERO);
            *entry = *entry + coefficient * factor;
        }
        self.terms.retain(|_, coefficient| !coefficient.is_zero());
    }

    pub(super) fn product(&self, other: &Self) -> Self {
        let mut result = Self::default();
        for (left, &a) in &self.terms {
            for (right, &b) in &other.terms {
                let term = Self::term(joined(left, right), a * b);
                result.add_scaled(&term, Ratio::ONE);
            }
        }
        result
    }

    /// The inverse of a single term.
    pub(super) fn inverse(&self) -> Option<Self> {
        let (monomial, factor) = self.terms.first_key_value()?;
        if self.len() > 1 {
            return None;
        }
        let inverted = monomial.iter().map(|&(node, power)| (node, -power));
        Some(Self::term(inverted.collect(), factor.recip()?))
    }

    /// The variables, each as often as it occurs in a term.
    pub(super) fn variables(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.terms.keys().flatten().map(|&(node, _)| node)
    }

    /// The positive factor that leaves coprime integers, and the polynomial that remains.
    pub(super) fn split_content(&self) -> (Ratio, Self) {
        let content = Ratio::content(self.terms.values().copied());
        let Some((content, inverse)) = content.and_then(|c| Some((c, c.recip()?))) else {
            return (Ratio::ONE, self.clone());
        };
        let mut rest = Self::default();
        rest.add_scaled(self, inverse);
        (content, rest)
    }
}

fn joined(left: &Monomial, right: &Monomial) -> Monomial {
    let mut powers: BTreeMap<NodeId, i32> = left.iter().copied().collect();
    for &(node, power) in right {
        *powers.entry(node).or_insert(0) += power;
    }
    powers.retain(|_, power| *power != 0);
    powers.into_iter().collect()
}

//! Outer products of vectors, by one of several rules that agree everywhere.

use crate::algebra::{Algebra, Blade, Product, Ratio};
use crate::ir::{Arena, Multivector, Node, NodeId, Value};

/// How `v₁ ∧ v₂ ∧ … ∧ vₖ` is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum JoinRule {
    /// From left to right, as it is written.
    #[default]
    LeftFirst,
    /// From right to left, equal by associativity.
    RightFirst,
    /// The first two and the rest separately, so that both consist of 2×2 minors:
    /// `(v₁ ∧ v₂) ∧ (v₃ ∧ v₄)`, equal by associativity (Laplace's expansion of determinants).
    Minors,
    /// `v₁ ∧ (v₂ − λ₂ v₁) ∧ … `, equal since `v₁ ∧ v₁ = 0`. With λ the quotient of constant
    /// coefficients of one blade, that blade is gone from all factors but the first: of points of
    /// weight 1 only differences are left. The differences are multiplied first.
    ///
    /// A factor that was computed as `v₁ + d` has the difference d, by which the difference of sums
    /// of squares follows, too: `x² − y² = (x − y)(x + y)`.
    Difference,
}

impl JoinRule {
    /// Every rule, in the order in which they are tried.
    pub const ALL: [Self; 4] = [
        Self::LeftFirst,
        Self::RightFirst,
        Self::Minors,
        Self::Difference,
    ];

    /// Lowers the outer product of some factors; `None` where the rule does not apply.
    #[must_use]
    pub fn lower(
        self,
        arena: &mut Arena,
        algebra: &Algebra,
        factors: &[Multivector],
    ) -> Option<Multivector> {
        match self {
            Self::LeftFirst => Some(left_first(arena, algebra, factors)),
            Self::RightFirst => right_first(arena, algebra, factors),
            Self::Minors => {
                let (head, tail) = factors.split_at_checked(2)?;
                if tail.len() < 2 {
                    return None;
                }
                let head = left_first(arena, algebra, head);
                let tail = left_first(arena, algebra, tail);
                Some(wedge(arena, algebra, &head, &tail))
            }
            Self::Difference => difference(arena, algebra, factors),
        }
    }
}

fn wedge(
    arena: &mut Arena,
    algebra: &Algebra,
    left: &Multivector,
    right: &Multivector,
) -> Multivector {
    left.product(arena, algebra, Product::Wedge, right, |_| true)
}

pub(super) fn left_first(
    arena: &mut Arena,
    algebra: &Algebra,
    factors: &[Multivector],
) -> Multivector {
    let mut factors = factors.iter();
    let first = factors.next().cloned().unwrap_or_default();
    factors.fold(first, |product, factor| {
        wedge(arena, algebra, &product, factor)
    })
}

fn right_first(
    arena: &mut Arena,
    algebra: &Algebra,
    factors: &[Multivector],
) -> Option<Multivector> {
    let mut factors = factors.iter().rev();
    let last = factors.next().cloned()?;
    Some(factors.fold(last, |product, factor| {
        wedge(arena, algebra, factor, &product)
    }))
}

fn difference(
    arena: &mut Arena,
    algebra: &Algebra,
    factors: &[Multivector],
) -> Option<Multivector> {
    let factors = differences(arena, factors)?;
    let (first, rest) = factors.split_first()?;
    let rest = left_first(arena, algebra, rest);
    Some(wedge(arena, algebra, first, &rest))
}

/// The first factor, and the others less multiples of it; `None` where none has a constant
/// coefficient of the same blade.
pub(super) fn differences(arena: &mut Arena, factors: &[Multivector]) -> Option<Vec<Multivector>> {
    let [first, rest @ ..] = factors else {
        return None;
    };
    let weight = first
        .terms()
        .iter()
        .filter_map(|(blade, value)| Some((*blade, value.as_constant()?)))
        .find(|(blade, _)| {
            let is_vector = |factor: &Multivector| constant(factor, *blade).is_some();
            is_vectors(factors) && rest.iter().any(is_vector)
        });
    let (blade, weight) = weight?;
    let rest = rest.iter().map(|factor| match constant(factor, blade) {
        Some(other) => difference_of(arena, factor, &first.scaled(-(other / weight))),
        None => factor.clone(),
    });
    Some(std::iter::once(first.clone()).chain(rest).collect())
}

/// The sum of two vectors. A coefficient that is a sum with the opposite of the other among its
/// terms is what is left of that sum: `(a + b) − a = b`, before anything is rounded.
fn difference_of(arena: &mut Arena, left: &Multivector, right: &Multivector) -> Multivector {
    let sum = left.sum(arena, right);
    let terms: Vec<(Blade, Value)> = sum
        .terms()
        .iter()
        .map(|&(blade, value)| {
            let (left, right) = (left.coefficient(blade), right.coefficient(blade));
            let exact = cancelled(arena, left, right);
            let exact = exact.or_else(|| squares(arena, left, right));
            (blade, exact.unwrap_or(value))
        })
        .collect();
    Multivector::new(arena, terms)
}

fn cancelled(arena: &mut Arena, sum: Value, opposite: Value) -> Option<Value> {
    for (whole, term) in [(sum, opposite), (opposite, sum)] {
        let Node::Sum(terms) = arena.node(whole.node) else {
            continue;
        };
        let terms: Vec<Value> = terms.iter().map(|t| t.scaled(whole.factor)).collect();
        if terms.contains(&-term) {
            let rest = terms.into_iter().filter(|other| *other != -term);
            return Some(arena.sum(rest));
        }
    }
    None
}

/// The difference of two sums of squares by `x² − y² = (x − y)(x + y)`, where each `x − y` is known
/// before x is rounded.
fn squares(arena: &mut Arena, sum: Value, opposite: Value) -> Option<Value> {
    let (mut left, mut right) = (Vec::new(), Vec::new());
    gather(arena, sum, &mut left)?;
    gather(arena, opposite, &mut right)?;
    if left.len() != right.len() {
        return None;
    }
    let mut terms = Vec::with_capacity(left.len());
    for (x, factor) in left {
        let x = Value::of(x);
        let term = right.iter().find_map(|&(y, other)| {
            let difference = cancelled(arena, x, -Value::of(y))?;
            (other == -factor).then_some((difference, Value::of(y)))
        });
        let (difference, y) = term?;
        let both = arena.sum([x, y]);
        terms.push(arena.product(difference, both).scaled(factor));
    }
    Some(arena.sum(terms))
}

/// The squares that a value is a sum of, with their factors; `None` if it is not such a sum.
fn gather(arena: &Arena, value: Value, squares: &mut Vec<(NodeId, Ratio)>) -> Option<()> {
    match arena.node(value.node) {
        Node::Sum(terms) => {
            let mut terms = terms.iter();
            terms.try_for_each(|term| gather(arena, term.scaled(value.factor), squares))
        }
        Node::Product(a, b) if a == b => {
            squares.push((*a, value.factor));
            Some(())
        }
        _ => None,
    }
}

/// The coefficient of a blade where it is a constant other than zero.
fn constant(factor: &Multivector, blade: Blade) -> Option<Ratio> {
    let value = factor.coefficient(blade).as_constant()?;
    (!value.is_zero()).then_some(value)
}

fn is_vectors(factors: &[Multivector]) -> bool {
    let mut blades = factors.iter().flat_map(Multivector::terms);
    blades.all(|(blade, _)| blade.grade() == 1)
}

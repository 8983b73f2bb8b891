//! Joins of differences: `a ∧ b = a ∧ (b − λ a)`, since `a ∧ a = 0`.
//!
//! With λ the quotient of two constant coefficients, such as the weights of points, that coefficient
//! is gone from all factors but the first. The difference is taken before anything is rounded, so
//! that afterwards the factors can be moved apart. As [`JoinRule::Difference`] does within one
//! product, for what acts on the product.
//!
//! [`JoinRule::Difference`]: crate::lower::JoinRule::Difference

use crate::algebra::Product;
use crate::forms::FormRule;
use crate::forms::classes::{ClassId, Classes, Operation, Term, Way};

const RULE: Option<FormRule> = Some(FormRule::Difference);

pub(super) fn apply(classes: &mut Classes<'_>, id: ClassId, way: &Way) {
    let Operation::Product(Product::Wedge, factors) = &way.operation else {
        return;
    };
    let is_vector = |id: &ClassId| classes.grade(*id) == Some(1) && !classes.class(*id).is_constant;
    let Some(&first) = factors.iter().find(|id| is_vector(id)) else {
        return;
    };
    // Only what acts on the product gains.
    if !classes.is_moved(id) {
        return;
    }
    let Some(&(blade, weight)) = classes.constants(first).first() else {
        return;
    };
    let mut whole: Option<Term> = None;
    let mut has_changed = false;
    for &factor in factors {
        let other = classes
            .constants(factor)
            .into_iter()
            .find(|(other, _)| *other == blade);
        let next = match other {
            Some((_, other)) if factor != first && classes.grade(factor) == Some(1) => {
                has_changed = true;
                let multiple = Term::of(first).scaled(-(other / weight));
                match classes.sum(&[Term::of(factor), multiple], RULE) {
                    Some(difference) => difference,
                    None => return,
                }
            }
            _ => Term::of(factor),
        };
        whole = match whole {
            None => Some(next),
            Some(whole) => classes.product(Product::Wedge, whole, next, RULE),
        };
        if whole.is_none() || !has_changed && factor == factors[factors.len() - 1] {
            return;
        }
    }
}

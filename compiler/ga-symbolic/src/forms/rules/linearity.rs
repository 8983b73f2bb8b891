//! An action is linear: `M (a + b) ~M = M a ~M + M b ~M`, `M (s a) ~M = s M a ~M` and
//! `M (a/s) ~M = (M a ~M)/s` for a scalar s.
//!
//! Of a sum the whole is moved, not its parts: the difference of two images cancels where that of
//! two near points does not. With scalars either is tried.

use crate::algebra::Product;
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

const RULE: Option<FormRule> = Some(FormRule::Linearity);

pub(super) fn apply(classes: &mut Classes<'_>, _: ClassId, way: &Way) {
    match &way.operation {
        Operation::Sandwich(versor, operand) => inwards(classes, *versor, *operand),
        Operation::Sum(terms) => outwards(classes, terms),
        Operation::Quotient(a, divisor) => {
            for other in classes.class(*a).ways.clone() {
                if let Operation::Sandwich(versor, operand) = other.operation
                    && let Some(part) =
                        classes.quotient(Term::of(operand), Term::of(*divisor), RULE)
                {
                    classes.sandwich(Term::of(versor), part, RULE);
                }
            }
        }
        Operation::Product(Product::Geometric, factors) => {
            let [scalar, a] = factors.as_slice() else {
                return;
            };
            if !classes.is_scalar(*scalar) {
                return;
            }
            for other in classes.class(*a).ways.clone() {
                if let Operation::Sandwich(versor, operand) = other.operation
                    && let Some(part) = classes.product(
                        Product::Geometric,
                        Term::of(*scalar),
                        Term::of(operand),
                        RULE,
                    )
                {
                    classes.sandwich(Term::of(versor), part, RULE);
                }
            }
        }
        _ => {}
    }
}

fn inwards(classes: &mut Classes<'_>, versor: ClassId, operand: ClassId) {
    if classes.class(operand).is_leaf() {
        return;
    }
    let versor = Term::of(versor);
    for way in classes.class(operand).ways.clone() {
        match &way.operation {
            Operation::Quotient(a, divisor) => {
                if let Some(image) = classes.sandwich(versor, Term::of(*a), RULE) {
                    classes.quotient(image, Term::of(*divisor), RULE);
                }
            }
            Operation::Product(Product::Geometric, factors) => {
                let [scalar, rest @ ..] = factors.as_slice() else {
                    continue;
                };
                if !classes.is_scalar(*scalar) {
                    continue;
                }
                let scalar = Term::of(*scalar);
                if let Some(rest) = classes.chain(Product::Geometric, rest, RULE)
                    && let Some(image) = classes.sandwich(versor, rest, RULE)
                {
                    classes.product(Product::Geometric, scalar, image, RULE);
                }
            }
            _ => {}
        }
    }
}

/// The image of a sum of what all terms are images of.
fn outwards(classes: &mut Classes<'_>, terms: &[Term]) {
    let Some(first) = terms.first() else { return };
    for way in classes.class(first.class).ways.clone() {
        let Operation::Sandwich(versor, _) = way.operation else {
            continue;
        };
        let originals: Option<Vec<Term>> = terms
            .iter()
            .map(|term| {
                let mut ways = classes.class(term.class).ways.iter();
                ways.find_map(|way| match way.operation {
                    Operation::Sandwich(other, operand) if other == versor => {
                        Some(Term::of(operand).scaled(way.factor * term.factor))
                    }
                    _ => None,
                })
            })
            .collect();
        if let Some(whole) = originals.and_then(|originals| classes.sum(&originals, RULE)) {
            classes.sandwich(Term::of(versor), whole, RULE);
        }
    }
}

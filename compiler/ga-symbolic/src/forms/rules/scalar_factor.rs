//! A scalar factor moves outwards: `(s a) ∘ b = s (a ∘ b) = a ∘ (s b)` for every bilinear product,
//! and `L(s a) = s L(a)` for reversal, duals, grades, coefficients and all else that is linear.
//!
//! Outside it is multiplied in once, and terms that cancel inside do so before it is. Of the square
//! of `t B` only t² is left beside what B² has in any case.

use crate::algebra::Product;
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

const RULE: Option<FormRule> = Some(FormRule::ScalarFactor);

pub(super) fn apply(classes: &mut Classes<'_>, _: ClassId, way: &Way) {
    match &way.operation {
        Operation::Unary(unary, a) => {
            if let Some((scalars, rest)) = separated(classes, *a)
                && let Some(image) = classes.unary(*unary, rest, RULE)
            {
                times(classes, scalars, image);
            }
        }
        Operation::Coefficient(a, blade) => {
            if let Some((scalars, rest)) = separated(classes, *a)
                && let Some(part) = classes.coefficient(rest, *blade)
            {
                times(classes, scalars, part);
            }
        }
        Operation::Product(product, factors) if *product != Product::Geometric => {
            let mut scalars = Vec::new();
            let mut parts = Vec::new();
            for factor in factors {
                match separated(classes, *factor) {
                    Some((own, rest)) => {
                        scalars.extend(own);
                        parts.push(rest);
                    }
                    None => parts.push(Term::of(*factor)),
                }
            }
            let mut parts = parts.into_iter();
            if !scalars.is_empty()
                && let Some(first) = parts.next()
                && let Some(whole) = parts.try_fold(first, |whole, part| {
                    classes.product(*product, whole, part, RULE)
                })
            {
                times(classes, scalars, whole);
            }
        }
        _ => {}
    }
}

/// The scalar factors of a class, and the product of the others.
fn separated(classes: &mut Classes<'_>, id: ClassId) -> Option<(Vec<ClassId>, Term)> {
    let (factors, scale) = classes.factors(Product::Geometric, id)?;
    let is_scalar = |factor: &ClassId| classes.is_scalar(*factor);
    let count = factors
        .iter()
        .take_while(|factor| is_scalar(factor))
        .count();
    if count == 0 || count == factors.len() {
        return None;
    }
    let (scalars, rest) = factors.split_at(count);
    let rest = classes.chain(Product::Geometric, rest, RULE)?;
    Some((scalars.to_vec(), rest.scaled(scale)))
}

fn times(classes: &mut Classes<'_>, mut factors: Vec<ClassId>, rest: Term) {
    factors.push(rest.class);
    classes.chain(Product::Geometric, &factors, RULE);
}

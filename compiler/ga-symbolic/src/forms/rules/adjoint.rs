//! A versor moves from one factor to the other: `⟨a M b ~M⟩₀ = ⟨~M a M b⟩₀`, since the scalar part
//! of a product does not change when its last factor goes to the front.
//!
//! For a unit versor M the reverse is the inverse, so the inner products that are scalars follow.
//! An outer product that is a pseudoscalar is the scalar product with a dual, which an action keeps
//! up to a sign.

use crate::algebra::{Product, Unary};
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

const RULE: Option<FormRule> = Some(FormRule::Adjoint);

pub(super) fn apply(classes: &mut Classes<'_>, id: ClassId, way: &Way) {
    let Operation::Product(product, factors) = &way.operation else {
        return;
    };
    let [a, b] = factors.as_slice() else { return };
    let top = classes.algebra.pseudoscalar().grade();
    if *product == Product::Geometric || ![Some(0), Some(top)].contains(&classes.grade(id)) {
        return;
    }
    for (fixed, moved) in [(*a, *b), (*b, *a)] {
        for other in classes.class(moved).ways.clone() {
            let Operation::Sandwich(versor, original) = other.operation else {
                continue;
            };
            if classes.is_unit(versor)
                && let Some(inverse) =
                    classes.unary(Unary::Reverse, Term::of(versor), Some(FormRule::Reversal))
                && let Some(image) = classes.sandwich(inverse, Term::of(fixed), RULE)
            {
                let original = Term::of(original);
                if moved == *b {
                    classes.product(*product, image, original, RULE);
                } else {
                    classes.product(*product, original, image, RULE);
                }
            }
        }
    }
}

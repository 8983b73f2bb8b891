//! The reversal of a product: `~(a b) = ~b ~a`.
//!
//! The reversal turns the order of the vectors round in every blade. It is linear, and of a product
//! of vectors `~(v₁ … vₖ) = vₖ … v₁`; since products of vectors span the algebra, it is an
//! anti-automorphism. The grade involution `^(a b) = â b̂` is an automorphism for the same reason.
//! The products that are made of grades of the geometric product follow: `~(a ∧ b) = ~b ∧ ~a`.

use crate::algebra::{Product, Unary};
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

pub(super) fn apply(classes: &mut Classes<'_>, _: ClassId, way: &Way) {
    let rule = Some(FormRule::Reversal);
    let Operation::Unary(unary @ (Unary::Reverse | Unary::Involute | Unary::Conjugate), a) =
        way.operation
    else {
        return;
    };
    if let Some((terms, _)) = classes.terms(a) {
        let parts: Vec<Term> = terms
            .iter()
            .filter_map(|term| {
                let part = classes.unary(unary, Term::of(term.class), rule)?;
                Some(part.scaled(term.factor))
            })
            .collect();
        classes.sum(&parts, rule);
    }
    for product in [Product::Geometric, Product::Wedge] {
        let Some((mut factors, _)) = classes.factors(product, a) else {
            continue;
        };
        if unary != Unary::Involute {
            factors.reverse();
        }
        let parts: Option<Vec<ClassId>> = factors
            .iter()
            .map(|factor| Some(classes.unary(unary, Term::of(*factor), rule)?.class))
            .collect();
        if let Some(parts) = parts {
            classes.chain(product, &parts, rule);
        }
    }
}

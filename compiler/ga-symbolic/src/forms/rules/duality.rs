//! Duals: `undual(dual a ∧ dual b) = a ∨ b`, which is the definition of the regressive product, and
//! `a I⁻¹ = dual a`, `a I = undual a` for the pseudoscalar I, where it has an inverse.
//!
//! With the signs of the squares, `dual` and `undual` differ by a sign at most where I has an
//! inverse, so either is tried.

use crate::algebra::{Product, Unary};
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

const RULE: Option<FormRule> = Some(FormRule::Duality);

pub(super) fn apply(classes: &mut Classes<'_>, _: ClassId, way: &Way) {
    match &way.operation {
        Operation::Unary(Unary::Dual, a) if !classes.algebra.is_degenerate() => {
            classes.unary(Unary::Undual, Term::of(*a), RULE);
        }
        Operation::Unary(Unary::Undual, a) => {
            if !classes.algebra.is_degenerate() {
                classes.unary(Unary::Dual, Term::of(*a), RULE);
            }
            let Some((factors, _)) = classes.factors(Product::Wedge, *a) else {
                return;
            };
            let [a, b] = factors.as_slice() else { return };
            if let Some(a) = classes.unary(Unary::Undual, Term::of(*a), RULE)
                && let Some(b) = classes.unary(Unary::Undual, Term::of(*b), RULE)
            {
                classes.product(Product::Vee, a, b, RULE);
            }
        }
        Operation::Product(Product::Vee, factors) => {
            let [a, b] = factors.as_slice() else { return };
            if let Some(a) = classes.unary(Unary::Dual, Term::of(*a), RULE)
                && let Some(b) = classes.unary(Unary::Dual, Term::of(*b), RULE)
                && let Some(joined) = classes.product(Product::Wedge, a, b, RULE)
            {
                classes.unary(Unary::Undual, joined, RULE);
            }
        }
        Operation::Product(_, factors) => {
            let [a, b] = factors.as_slice() else { return };
            let top = classes.algebra.pseudoscalar();
            let is_top = |id: ClassId| {
                let class = classes.class(id);
                class.is_constant && classes.blades(id) == [top]
            };
            let other = match (is_top(*a), is_top(*b)) {
                (false, true) => *a,
                (true, false) => *b,
                _ => return,
            };
            if !classes.algebra.is_degenerate() {
                classes.unary(Unary::Dual, Term::of(other), RULE);
            }
        }
        _ => {}
    }
}

//! The action of a product is one action after the other: `(a b) X ~(a b) = a (b X ~b) ~a`, since
//! `~(a b) = ~b ~a`.
//!
//! With odd versors the grade involution goes along: b acts as `b X̂ ~b`, and the involution of
//! that is `b X ~b` again. In one direction a versor is split into its factors, in the other two
//! versors are composed.

use crate::algebra::Product;
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

/// The longest product that is split at each place. A longer one is split before its last factor
/// only, and so on, until all act one after the other.
const LONGEST: usize = 6;

pub(super) fn apply(classes: &mut Classes<'_>, _: ClassId, way: &Way) {
    let rule = Some(FormRule::Composition);
    let Operation::Sandwich(versor, operand) = way.operation else {
        return;
    };
    if let Some((factors, _)) = classes.factors(Product::Geometric, versor)
        && factors
            .iter()
            .all(|factor| classes.parity(*factor).is_some())
    {
        let first = match factors.len() {
            length if length > LONGEST => length - 1,
            _ => 1,
        };
        for place in first..factors.len() {
            let (outer, inner) = factors.split_at(place);
            let (Some(outer), Some(inner)) = (
                classes.chain(Product::Geometric, outer, rule),
                classes.chain(Product::Geometric, inner, rule),
            ) else {
                continue;
            };
            if let Some(image) = classes.sandwich(inner, Term::of(operand), rule) {
                classes.sandwich(outer, image, rule);
            }
        }
    }
    for other in classes.class(operand).ways.clone() {
        if let Operation::Sandwich(inner, operand) = other.operation
            && let Some(both) =
                classes.product(Product::Geometric, Term::of(versor), Term::of(inner), rule)
            && !classes.is_scalar(both.class)
        {
            classes.sandwich(both, Term::of(operand), rule);
        }
    }
}

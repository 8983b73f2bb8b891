//! A product that begins with a versor and ends with its reverse is an action: `M X ~M` for an even
//! M, and `M X ~M = −M X̂ ~M` for an odd M and an odd X. Next to each other, `M ~M = 1` for a
//! unit versor.
//!
//! Inside a longer product this holds for any two factors, since the product is associative. What
//! stands between the two is taken first, so that of `a b X ~b ~a` first b acts and then a.

use crate::algebra::{Product, Ratio, Unary};
use crate::forms::FormRule;
use crate::forms::classes::{ClassId, Classes, Operation, Term, Way};
use crate::member::numbers;

pub(super) fn apply(classes: &mut Classes<'_>, _: ClassId, way: &Way) {
    let Operation::Product(Product::Geometric, factors) = &way.operation else {
        return;
    };
    for (first, &versor) in factors.iter().enumerate() {
        if classes.is_scalar(versor) {
            continue;
        }
        let Some(reverse) = reverse(classes, versor) else {
            continue;
        };
        for (last, other) in factors.iter().enumerate().skip(first + 1) {
            if *other != reverse.class {
                continue;
            }
            let Some(image) = between(classes, versor, &factors[first + 1..last]) else {
                continue;
            };
            // What is left, with the image in place of the action.
            let mut rest = factors[..first].to_vec();
            rest.push(image.class);
            rest.extend(&factors[last + 1..]);
            classes.chain(Product::Geometric, &rest, Some(FormRule::Conjugation));
        }
    }
}

/// `M X ~M`.
fn between(classes: &mut Classes<'_>, versor: ClassId, middle: &[ClassId]) -> Option<Term> {
    let rule = Some(FormRule::Conjugation);
    if middle.is_empty() {
        return if classes.is_unit(versor) {
            classes.one()
        } else {
            None
        };
    }
    let middle = classes.chain(Product::Geometric, middle, rule)?;
    let is_odd = classes.parity(versor)?;
    let sign = match is_odd {
        false => Ratio::ONE,
        true if classes.parity(middle.class)? => -Ratio::ONE,
        true => Ratio::ONE,
    };
    let image = classes.sandwich(Term::of(versor), middle, rule)?;
    Some(image.scaled(sign))
}

/// The known class of the reverse.
fn reverse(classes: &Classes<'_>, id: ClassId) -> Option<Term> {
    if let Some(known) = classes.known(&Operation::Unary(Unary::Reverse, id)) {
        return Some(known);
    }
    let algebra = classes.algebra;
    let values = classes.each(id, |value| numbers::unary(algebra, Unary::Reverse, value));
    classes.find(&values, &[id])
}

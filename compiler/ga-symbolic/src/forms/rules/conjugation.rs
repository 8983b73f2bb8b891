//! A product that begins with a versor and ends with its reverse is an action: `M X ~M` for an even
//! M, and `M X ~M = −M X̂ ~M` for an odd M and an odd X. Next to each other, `M ~M = 1` for a
//! unit versor.
//!
//! Inside a longer product this holds for any two factors, since the product is associative. The
//! first factor of which the reverse follows is taken with its last reverse, so that
//! `a b X ~b ~a` is the action of a on the action of b; composed actions follow from that.

use crate::algebra::{Product, Ratio, Unary};
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;
use crate::member::numbers;

pub(super) fn apply(classes: &mut Classes<'_>, _: ClassId, way: &Way) {
    let Operation::Product(Product::Geometric, factors) = &way.operation else {
        return;
    };
    if let Some((first, last)) = ends(classes, factors) {
        replaced(classes, factors, first, last, Some(FormRule::Conjugation));
    }
}

/// A product as an action, if it is one from its first factor to its last.
pub(in crate::forms) fn as_action(
    classes: &mut Classes<'_>,
    parts: &[ClassId],
    rule: Option<FormRule>,
) -> Option<Term> {
    let (factors, scale) = classes.flat(Product::Geometric, parts);
    let (first, last) = ends(classes, &factors)?;
    if (first, last) != (0, factors.len() - 1) || factors.len() < 3 {
        return None;
    }
    let middle = &factors[1..last];
    let middle = match as_action(classes, middle, rule) {
        Some(image) => image,
        None => classes.chain(Product::Geometric, middle, rule)?,
    };
    let image = acted(classes, factors[0], middle, rule)?;
    let reverse = reverse(classes, factors[0])?;
    Some(image.scaled(scale / reverse.factor))
}

/// The first factor of which the reverse follows, and the last place where it does.
fn ends(classes: &Classes<'_>, factors: &[ClassId]) -> Option<(usize, usize)> {
    factors.iter().enumerate().find_map(|(first, versor)| {
        if classes.is_scalar(*versor) {
            return None;
        }
        let reverse = reverse(classes, *versor)?;
        let last = factors.iter().rposition(|other| *other == reverse.class)?;
        (last > first).then_some((first, last))
    })
}

/// Adds the product with the action between two places in place of its factors.
fn replaced(
    classes: &mut Classes<'_>,
    factors: &[ClassId],
    first: usize,
    last: usize,
    rule: Option<FormRule>,
) {
    let versor = factors[first];
    let middle = &factors[first + 1..last];
    let image = if middle.is_empty() {
        if !classes.is_unit(versor) {
            return;
        }
        classes.one()
    } else {
        let middle = match as_action(classes, middle, rule) {
            Some(image) => Some(image),
            None => classes.chain(Product::Geometric, middle, rule),
        };
        middle.and_then(|middle| acted(classes, versor, middle, rule))
    };
    let Some(image) = image else { return };
    let mut rest = factors[..first].to_vec();
    rest.push(image.class);
    rest.extend(&factors[last + 1..]);
    classes.chain(Product::Geometric, &rest, rule);
}

/// `M X ~M` as an action.
fn acted(
    classes: &mut Classes<'_>,
    versor: ClassId,
    middle: Term,
    rule: Option<FormRule>,
) -> Option<Term> {
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

//! The action of a unit versor by commutators, on a multivector and blade by blade.

use super::sandwich::is_odd;
use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::ir::{Arena, Multivector, Value};

/// `X + [M, X] ~M`, which is `M X ~M` for an even unit versor M with `[M, X] = M X − X M`, and
/// `M X̂ ~M` for an odd one with `[M, X] = M X̂ − X M`.
pub(super) fn commutator(
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    operand: &Multivector,
) -> Multivector {
    let reverse = versor.unary(arena, algebra, Unary::Reverse);
    let change = if is_odd(versor) {
        let image = operand.unary(arena, algebra, Unary::Involute);
        let first = versor.product(arena, algebra, Product::Geometric, &image, |_| true);
        let second = operand.product(arena, algebra, Product::Geometric, versor, |_| true);
        first.sum(arena, &second.scaled(Ratio::integer(-1)))
    } else {
        versor
            .product(arena, algebra, Product::Commutator, operand, |_| true)
            .scaled(Ratio::integer(2))
    };
    let kept = kept(versor, operand);
    let change = change.product(arena, algebra, Product::Geometric, &reverse, kept);
    operand.sum(arena, &change)
}

/// `Σ x (M b ~M)` over the blades b of X with coefficients x, b involuted for an odd M, for a unit versor M.
pub(super) fn linear_map(
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    image: &Multivector,
) -> Multivector {
    let mut terms = Vec::new();
    for &(blade, value) in image.terms() {
        let basis = Multivector::new(arena, [(blade, Value::ONE)]);
        let column = commutator(arena, algebra, versor, &basis);
        for &(row, entry) in column.terms() {
            terms.push((row, arena.product(entry, value)));
        }
    }
    Multivector::new(arena, terms)
}

/// Which blades the action can have: those of the operand's grades for a unit versor, any for
/// another.
pub(super) fn kept(versor: &Multivector, image: &Multivector) -> impl Fn(Blade) -> bool + use<> {
    let all = !versor.facts.unit_versor;
    let grades = image
        .terms()
        .iter()
        .fold(0_u32, |set, (blade, _)| set | 1 << blade.grade());
    move |blade| all || grades & 1 << blade.grade() != 0
}

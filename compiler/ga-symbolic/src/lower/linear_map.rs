//! The action of a unit versor by commutators, on a multivector and blade by blade.

use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::ir::{Arena, Multivector, Value};

/// `X + [M, X] ~M`, which is `M X ~M` for an even unit versor M with `[M, X] = M X − X M`, and
/// `M X̂ ~M` for an odd one with `[M, X] = M X̂ − X M`.
pub(super) fn acted(
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    operand: &Multivector,
) -> Multivector {
    let reverse = versor.unary(arena, algebra, Unary::Reverse);
    let kept = kept(versor, operand);
    let change = commutator(arena, algebra, versor, operand).product(
        arena,
        algebra,
        Product::Geometric,
        &reverse,
        kept,
    );
    operand.sum(arena, &change)
}

/// `[M, X]` as above.
pub(super) fn commutator(
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    operand: &Multivector,
) -> Multivector {
    if !is_odd(versor) {
        return versor
            .product(arena, algebra, Product::Commutator, operand, |_| true)
            .scaled(Ratio::integer(2));
    }
    let image = operand.unary(arena, algebra, Unary::Involute);
    let first = versor.product(arena, algebra, Product::Geometric, &image, |_| true);
    let second = operand.product(arena, algebra, Product::Geometric, versor, |_| true);
    first.sum(arena, &second.scaled(Ratio::integer(-1)))
}

/// `Σ x (M b ~M)` over the blades b of X with coefficients x, b involuted for an odd M,
/// for a unit versor M.
pub(super) fn linear_map(
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    image: &Multivector,
) -> Multivector {
    let mut terms = Vec::new();
    for &(blade, value) in image.terms() {
        let basis = Multivector::new(arena, [(blade, Value::ONE)]);
        let column = acted(arena, algebra, versor, &basis);
        for &(row, entry) in column.terms() {
            terms.push((row, arena.product(entry, value)));
        }
    }
    Multivector::new(arena, terms)
}

/// Which blades the action can have: those of the operand's grades for a unit versor, any for
/// another.
pub(super) fn kept(versor: &Multivector, operand: &Multivector) -> impl Fn(Blade) -> bool + use<> {
    let all = !versor.facts.unit_versor;
    let grades = grades(operand);
    move |blade| all || grades(blade)
}

/// The blades of the grades of a multivector.
pub(super) fn grades(value: &Multivector) -> impl Fn(Blade) -> bool + use<> {
    let grades = value
        .terms()
        .iter()
        .fold(0_u32, |set, (blade, _)| set | 1 << blade.grade());
    move |blade| grades & 1 << blade.grade() != 0
}

pub(super) fn is_odd(versor: &Multivector) -> bool {
    let mut blades = versor.terms().iter().map(|(blade, _)| blade);
    blades.len() > 0 && blades.all(|blade| blade.involute_is_negative())
}

//! The image of a null vector under a versor, by half of it.
//!
//! Let x be a null vector and i, o a null pair of the basis with a constant `c = x·i` other than
//! zero: x is a point, i infinity, o the origin. Then `x i x = 2 c x − i x² = 2 c x`, and for any
//! versor V
//!
//! `V x ~V = (V x) i ~(V x) / 2c = K i ~K / 2c` with `K = V x`.
//!
//! What i destroys from the right does not matter: if `N i = 0`, then also
//! `i ~N = ~(N i) = 0`, and `(K + N) i ~(K + N) = K i ~K`. So K is reduced to blades without i,
//! and x may be taken without its coefficient of i. What remains of K is two multivectors of the
//! algebra without o and i, which for conformal algebras are the two entries of a column of the
//! 2 × 2 matrix by which Vahlen describes V. For points of space these are two quaternions, from
//! which weight, place and square follow by one product each.
//!
//! # By a commutator
//!
//! Let V be an even unit versor, and A and B of blades without i and o with `V i = A i` and
//! `i V = i B`: V keeps infinity, as similarities do. Then `~V i = ~(i V) = ~B i`, and for
//! `y = V x ~V`
//!
//! `y i = V x ~B i = x V ~B i + [V, x] ~B i = x i + [V, x] i ~B` with `[V, x] = V x − x V`,
//!
//! since `V ~B i = V ~V i = i`, and [V, x] may be reduced as K. The part of grade 2 gives the
//! coefficients of y but that of i. With `~V i V = ~B B i` the weight of y is `~B B` times that of
//! x, and since `A ~A` is its reciprocal, `y² = 0` gives the last coefficient without a division.

use super::linear_map::{commutator, is_odd};
use super::null_pair::NullPair;
use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::ir::{Arena, Multivector, Value};

/// Lowers the image of a null vector; `None` where no basis vector serves.
pub(super) fn lower(
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    operand: &Multivector,
) -> Option<Multivector> {
    let (pair, weight) = pair_of(algebra, operand)?;
    let left = half_image(arena, algebra, pair, versor, operand);
    let null = vector(arena, pair.null);
    let reverse = left.unary(arena, algebra, Unary::Reverse);
    let left = left.product(arena, algebra, Product::Geometric, &null, |_| true);
    let is_unit = versor.facts.unit_versor;
    let image = left.product(arena, algebra, Product::Geometric, &reverse, |blade| {
        !is_unit || blade.grade() == 1
    });
    let sign = if is_odd(versor) { -1 } else { 1 };
    let twice = Ratio::integer(2 * sign) * weight * pair.inner;
    Some(image.scaled(twice.recip()?))
}

/// Lowers the image of a null vector by a commutator; `None` where the versor does not keep
/// infinity, or has no scaling.
pub(super) fn by_commutator(
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    operand: &Multivector,
) -> Option<Multivector> {
    let (pair, weight) = pair_of(algebra, operand)?;
    let has_partner = |value: &Multivector| {
        let mut blades = value.terms().iter();
        blades.any(|(blade, _)| blade.contains(pair.partner))
    };
    let matrix = pair.folded(arena, versor);
    let is_unit = versor.facts.unit_versor && !is_odd(versor);
    if !is_unit || !has_partner(versor) || has_partner(&matrix) {
        return None;
    }
    let reverse = versor.unary(arena, algebra, Unary::Reverse);
    let reverse = pair.folded(arena, &reverse);
    let short = operand.filtered(|blade| !blade.contains(pair.null));
    let change = commutator(arena, algebra, versor, &short);
    let change = pair.folded(arena, &change);
    let null = vector(arena, pair.null);
    let change = change
        .product(arena, algebra, Product::Geometric, &null, |_| true)
        .product(arena, algebra, Product::Geometric, &reverse, |blade| {
            blade.grade() == 2 && pair.is_upper(blade)
        });
    let change = pair.without_null(arena, &change);
    let place = short.filtered(|blade| pair.rest(blade) == blade);
    let place = place.sum(arena, &change);
    let norm = |arena: &mut Arena, value: &Multivector| {
        let reverse = value.unary(arena, algebra, Unary::Reverse);
        value
            .product(arena, algebra, Product::ScalarProduct, &reverse, |_| true)
            .coefficient(Blade::SCALAR)
    };
    let (factor, reciprocal) = (norm(arena, &reverse), norm(arena, &matrix));
    let square = place
        .product(arena, algebra, Product::ScalarProduct, &place, |_| true)
        .coefficient(Blade::SCALAR);
    let last = arena.product(square, reciprocal);
    let twice = Ratio::integer(-2) * pair.inner * weight;
    let ends = [
        (Blade::vector(pair.partner), factor.scaled(weight)),
        (Blade::vector(pair.null), last.scaled(twice.recip()?)),
    ];
    let ends = Multivector::new(arena, ends);
    Some(place.sum(arena, &ends))
}

/// `V x`, reduced.
pub(super) fn half_image(
    arena: &mut Arena,
    algebra: &Algebra,
    pair: NullPair,
    versor: &Multivector,
    operand: &Multivector,
) -> Multivector {
    let short = operand.filtered(|blade| !blade.contains(pair.null));
    let half = versor.product(arena, algebra, Product::Geometric, &short, |_| true);
    pair.folded(arena, &half)
}

/// The pair by which a null vector has a constant weight, its coefficient of o, and that weight.
pub(super) fn pair_of(algebra: &Algebra, operand: &Multivector) -> Option<(NullPair, Ratio)> {
    let is_vector = operand.terms().iter().all(|(blade, _)| blade.grade() == 1);
    if !operand.facts.null || !is_vector {
        return None;
    }
    NullPair::all(algebra).find_map(|pair| {
        let partner = Blade::vector(pair.partner);
        let weight = operand.coefficient(partner).as_constant()?;
        (!weight.is_zero()).then_some((pair, weight))
    })
}

pub(super) fn vector(arena: &mut Arena, index: usize) -> Multivector {
    Multivector::new(arena, [(Blade::vector(index), Value::ONE)])
}

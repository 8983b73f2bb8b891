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

use super::null_pair::NullPair;
use super::sandwich::is_odd;
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

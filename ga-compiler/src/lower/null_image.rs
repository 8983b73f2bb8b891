//! The image of a null vector under a versor, by half of it.
//!
//! Let x be a null vector and i a basis vector with `i² = 0` and a constant `c = x·i` other than
//! zero: x is a point, i is infinity. Then `x i x = 2 c x − i x² = 2 c x`, and for any versor V
//!
//! `V x ~V = (V x) i ~(V x) / 2c = K i ~K / 2c` with `K = V x`.
//!
//! What i destroys from the right does not matter: if `N i = 0`, then also
//! `i ~N = ~(N i) = 0`, and `(K + N) i ~(K + N) = K i ~K`. Let o be the only basis vector with
//! `o·i ≠ 0`, orthogonal to all others too. For a blade E of the others,
//!
//! - `(E∧i) i = 0`, so x may be taken without its coefficient of i, and K without these blades;
//! - `(E∧o∧i) i = E (o i − o·i) i = −(o·i) E i`, so `E∧o∧i` may be replaced by `−(o·i) E`.
//!
//! What remains of K is two multivectors of the algebra without o and i, which for conformal
//! algebras are the two entries of a column of the 2 × 2 matrix by which Vahlen describes V. For
//! points of weight 1 in space these are two quaternions, from which weight, place and square
//! follow by one product each.

use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::ir::{Arena, Multivector, Value};

/// Lowers the image of a null vector; `None` where no basis vector serves.
pub(super) fn lower(
    arena: &mut Arena,
    algebra: &Algebra,
    versor: &Multivector,
    operand: &Multivector,
    is_odd: bool,
) -> Option<Multivector> {
    let is_vector = operand.terms().iter().all(|(blade, _)| blade.grade() == 1);
    if !operand.facts.null || !is_vector {
        return None;
    }
    let (pair, weight) = pairs(algebra).find_map(|pair| {
        let weight = operand
            .coefficient(Blade::vector(pair.partner))
            .as_constant()?;
        (!weight.is_zero()).then_some((pair, weight))
    })?;
    let short = operand.filtered(|blade| !blade.contains(pair.null));
    let half = versor.product(arena, algebra, Product::Geometric, &short, |_| true);
    let half = pair.folded(arena, &half);
    let null = Multivector::new(arena, [(Blade::vector(pair.null), Value::ONE)]);
    let left = half.product(arena, algebra, Product::Geometric, &null, |_| true);
    let reverse = half.unary(arena, algebra, Unary::Reverse);
    let is_unit = versor.facts.unit_versor;
    let image = left.product(arena, algebra, Product::Geometric, &reverse, |blade| {
        !is_unit || blade.grade() == 1
    });
    let sign = if is_odd { -1 } else { 1 };
    let twice = Ratio::integer(2 * sign) * weight * pair.inner;
    Some(image.scaled(twice.recip()?))
}

/// Two basis vectors, one of them null, that are orthogonal to all others and not to each other.
#[derive(Clone, Copy)]
pub(super) struct Pair {
    /// The vector i, with `i² = 0`.
    pub(super) null: usize,
    /// The vector o.
    pub(super) partner: usize,
    /// `o·i`.
    pub(super) inner: Ratio,
}

/// The pairs of an algebra.
pub(super) fn pairs(algebra: &Algebra) -> impl Iterator<Item = Pair> {
    let metric = algebra.metric();
    let all = 0..algebra.dimension();
    let partners = move |index: usize| {
        let mut others = (0..metric.dimension()).filter(move |&o| !metric.get(index, o).is_zero());
        (others.next(), others.next())
    };
    all.filter_map(move |null| {
        let (Some(partner), None) = partners(null) else {
            return None;
        };
        let is_free = (0..metric.dimension())
            .all(|other| [null, partner].contains(&other) || metric.get(partner, other).is_zero());
        (partner != null && is_free).then(|| Pair {
            null,
            partner,
            inner: metric.get(null, partner),
        })
    })
}

impl Pair {
    /// A multivector N of blades without i for which `N i = M i`.
    pub(super) fn folded(self, arena: &mut Arena, value: &Multivector) -> Multivector {
        let terms: Vec<_> = value
            .terms()
            .iter()
            .filter_map(|&(blade, value)| {
                if !blade.contains(self.null) {
                    return Some((blade, value));
                }
                if !blade.contains(self.partner) {
                    return None;
                }
                let rest = blade.without(self.null).without(self.partner);
                // The sign of E∧o∧i against the blade in rising order.
                let with_partner = Blade(rest.0 | 1 << self.partner);
                let is_negative = rest.wedge_is_negative(Blade::vector(self.partner))
                    != with_partner.wedge_is_negative(Blade::vector(self.null));
                let factor = if is_negative { self.inner } else { -self.inner };
                Some((rest, value.scaled(factor)))
            })
            .collect();
        Multivector::new(arena, terms)
    }
}

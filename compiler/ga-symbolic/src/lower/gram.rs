//! Inner products of outer products of vectors, by inner products of the vectors.
//!
//! `⟨(a₁∧…∧aₖ)(b₁∧…∧bₖ)⟩₀ = (−1)^(k(k−1)/2) det(aᵢ·bⱼ)`, Gram's determinant. For null vectors of
//! the same weight each entry is −½ times a squared distance, see
//! [`InnerRule::Distance`](super::InnerRule::Distance), and those of a vector with itself are zero.
//!
//! A determinant of several terms cancels where the vectors are nearly dependent, as for slivers
//! and for points that nearly coincide. So it is only taken
//!
//! - where all its terms are multiples of one product: the square of a circle through three points
//!   is the product of the squared distances between them;
//! - for two pairs of points, in differences: with `u = b − a` and `w = d − c`
//!
//!   `⟨(a∧b)(c∧d)⟩₀ = ⟨(a∧u)(c∧w)⟩₀ = (a·w)(u·c) − (a·c)(u·w)`,
//!
//!   where `p·(q − r) = ½ (q − r)·((p − q) + (p − r))` for null vectors, by `p·q = −½ (p − q)²`.
//!   Every factor is a difference of points or a sum of such.

use crate::algebra::{Algebra, Blade, Product, Ratio};
use crate::ir::{Arena, Multivector, Value};
use crate::order::Order as _;

/// The largest determinant.
const LARGEST: usize = 4;

/// Lowers `⟨(a₁∧…∧aₖ)(b₁∧…∧bₖ)⟩₀`; `None` where it would cancel.
pub(super) fn lower(
    arena: &mut Arena,
    algebra: &Algebra,
    left: &[Multivector],
    right: &[Multivector],
) -> Option<Multivector> {
    let size = left.len();
    let is_vector = |value: &Multivector| value.terms().iter().all(|(b, _)| b.grade() == 1);
    let all_vectors = left.iter().chain(right).all(is_vector);
    if size != right.len() || !(2..=LARGEST).contains(&size) || !all_vectors {
        return None;
    }
    let value = match (left, right) {
        ([a, b], [c, d]) if !is_same(a, c) || !is_same(b, d) => {
            in_differences(arena, algebra, [a, b, c, d])?
        }
        _ => monomial(arena, algebra, left, right)?,
    };
    let sign = if size % 4 >= 2 { -1 } else { 1 };
    let value = value.scaled(Ratio::integer(sign));
    Some(Multivector::new(arena, [(Blade::SCALAR, value)]))
}

fn is_same(a: &Multivector, b: &Multivector) -> bool {
    a.terms() == b.terms()
}

/// The determinant, if it is a multiple of one product.
fn monomial(
    arena: &mut Arena,
    algebra: &Algebra,
    left: &[Multivector],
    right: &[Multivector],
) -> Option<Value> {
    let mut rows = Vec::new();
    for a in left {
        let row: Option<Vec<Value>> = right.iter().map(|b| entry(arena, algebra, a, b)).collect();
        rows.push(row?);
    }
    let mut common: Option<Vec<usize>> = None;
    let mut total = Value::ZERO;
    for (columns, is_odd) in permutations(rows.len()) {
        let mut factors: Vec<Value> = rows
            .iter()
            .zip(&columns)
            .map(|(row, &at)| row[at])
            .collect();
        if factors.iter().any(|value| value.is_zero()) {
            continue;
        }
        factors.order_by_key(|value| value.node);
        let nodes: Vec<usize> = factors.iter().map(|value| value.node.index()).collect();
        if *common.get_or_insert_with(|| nodes.clone()) != nodes {
            return None;
        }
        let product = factors
            .into_iter()
            .fold(Value::ONE, |product, factor| arena.product(product, factor));
        total = arena.sum([total, if is_odd { -product } else { product }]);
    }
    Some(total)
}

/// `a·b` of two vectors: a product of coefficients where one of them is constant, or a distance.
fn entry(arena: &mut Arena, algebra: &Algebra, a: &Multivector, b: &Multivector) -> Option<Value> {
    if a.facts.null && b.facts.null {
        let difference = a.sum(arena, &b.scaled(Ratio::integer(-1)));
        let square = inner(arena, algebra, &difference, &difference);
        return Some(square.scaled(Ratio::new(-1, 2)?));
    }
    let product = inner(arena, algebra, a, b);
    product.as_constant().map(Value::constant)
}

/// `(a·c)(b·d) − (a·d)(b·c)` for null vectors of the same weight.
fn in_differences(
    arena: &mut Arena,
    algebra: &Algebra,
    vectors: [&Multivector; 4],
) -> Option<Value> {
    let [a, b, c, d] = vectors;
    let first = a.terms().iter().find(|(blade, value)| {
        let has_weight = |vector: &&Multivector| vector.coefficient(*blade) == *value;
        let is_weight = value.as_constant().is_some() && vectors.iter().all(has_weight);
        is_weight
            && algebra
                .geometric(*blade, *blade)
                .iter()
                .all(|(b, _)| *b != Blade::SCALAR)
    });
    if first.is_none() || !vectors.iter().all(|vector| vector.facts.null) {
        return None;
    }
    let mut difference =
        |x: &Multivector, y: &Multivector| x.sum(arena, &y.scaled(Ratio::integer(-1)));
    let (u, w) = (difference(b, a), difference(d, c));
    let (ac, ad, cb) = (difference(a, c), difference(a, d), difference(c, b));
    // (a − c) + (a − d) and (c − a) + (c − b).
    let from_a = ac.sum(arena, &ad);
    let from_c = cb.sum(arena, &ac.scaled(Ratio::integer(-1)));
    let half = Ratio::new(1, 2)?;
    let aw = inner(arena, algebra, &w, &from_a).scaled(half);
    let uc = inner(arena, algebra, &u, &from_c).scaled(half);
    let ac = inner(arena, algebra, &ac, &ac).scaled(-half);
    let uw = inner(arena, algebra, &u, &w);
    let [first, second] = [arena.product(ac, uw), arena.product(aw, uc)];
    Some(arena.difference(first, second))
}

fn inner(arena: &mut Arena, algebra: &Algebra, a: &Multivector, b: &Multivector) -> Value {
    a.product(arena, algebra, Product::ScalarProduct, b, |_| true)
        .coefficient(Blade::SCALAR)
}

/// The permutations of the numbers below `size`, each with whether it is odd.
fn permutations(size: usize) -> Vec<(Vec<usize>, bool)> {
    let mut all = vec![(Vec::new(), false)];
    for next in 0..size {
        let longer = |(shorter, is_odd): (Vec<usize>, bool)| {
            (0..=next).map(move |place| {
                let mut longer = shorter.clone();
                longer.insert(place, next);
                (longer, is_odd != ((next - place) % 2 == 1))
            })
        };
        all = all.into_iter().flat_map(longer).collect();
    }
    all
}

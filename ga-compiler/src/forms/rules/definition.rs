//! Products by their definitions: a product written as a part of the geometric product, or as a sum
//! or difference of two, is that product.
//!
//! - `⟨a b⟩` of grade r + s is `a ∧ b`, of grade s − r it is `a ⌋ b`, of grade r − s `a ⌊ b`, of
//!   grade 0 `⟨a b⟩₀`, for a of grade r and b of grade s.
//! - `(a b − b a)/2` is the commutator, and `(a b + b a)/2` is an inner product if one factor is a
//!   vector.
//!
//! Which product it is, is found by trying: what is equal at random points is equal.

use crate::algebra::{Product, Unary};
use crate::forms::FormRule;
use crate::forms::classes::{ClassId, Classes, Operation, Term, Way};
use crate::member::numbers;

const RULE: Option<FormRule> = Some(FormRule::Definition);

pub(super) fn apply(classes: &mut Classes<'_>, id: ClassId, way: &Way) {
    match &way.operation {
        Operation::Unary(Unary::Grade(grade), a) => {
            let Some((factors, _)) = classes.factors(Product::Geometric, *a) else {
                return;
            };
            let [a, b] = factors.as_slice() else { return };
            let (Some(r), Some(s)) = (classes.grade(*a), classes.grade(*b)) else {
                if *grade == 0 {
                    try_product(classes, id, Product::ScalarProduct, *a, *b);
                }
                return;
            };
            let tried = [
                (Product::ScalarProduct, Some(0)),
                (Product::Wedge, Some(r + s)),
                (Product::LeftContraction, s.checked_sub(r)),
                (Product::RightContraction, r.checked_sub(s)),
            ];
            for (product, of) in tried {
                if of == Some(*grade) {
                    try_product(classes, id, product, *a, *b);
                }
            }
        }
        Operation::Sum(terms) => {
            let [first, second] = terms.as_slice() else {
                return;
            };
            let pair = |term: &Term| classes.factors(Product::Geometric, term.class);
            let (Some((left, _)), Some((right, _))) = (pair(first), pair(second)) else {
                return;
            };
            let ([a, b], [c, d]) = (left.as_slice(), right.as_slice()) else {
                return;
            };
            if (a, b) != (d, c) {
                return;
            }
            for product in Product::ALL.into_iter().skip(1) {
                try_product(classes, id, product, *a, *b);
            }
        }
        _ => {}
    }
}

/// Adds a product, if it is a multiple of the class.
fn try_product(classes: &mut Classes<'_>, id: ClassId, product: Product, a: ClassId, b: ClassId) {
    let algebra = classes.algebra;
    let values = classes.each_of_two(a, b, |a, b| numbers::product(algebra, product, a, b));
    let values: Vec<_> = values
        .into_iter()
        .map(|mut value| {
            value.retain(|_, number| *number != crate::ir::Residue::ZERO);
            value
        })
        .collect();
    if classes
        .find(&values, &[a, b])
        .is_some_and(|term| term.class == id)
    {
        classes.product(product, Term::of(a), Term::of(b), RULE);
    }
}

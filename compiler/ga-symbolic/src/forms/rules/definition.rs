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
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;
use crate::member::numbers;

const RULE: Option<FormRule> = Some(FormRule::Definition);

pub(super) fn apply(classes: &mut Classes<'_>, id: ClassId, way: &Way) {
    match &way.operation {
        Operation::Unary(Unary::Grade(grade), a) => {
            if let Some((factors, _)) = classes.factors(Product::Geometric, *a) {
                part(classes, id, *grade, &factors);
            }
        }
        // The whole of it may be one part.
        Operation::Product(Product::LeftContraction | Product::RightContraction, factors) => {
            if let [a, b] = *factors.as_slice() {
                try_product(classes, id, Product::Geometric, a, b);
            }
        }
        Operation::Product(Product::Geometric, factors) if classes.is_scalar(id) => {
            part(classes, id, 0, factors);
        }
        Operation::Sum(terms) => {
            let [first, second] = terms.as_slice() else {
                return;
            };
            let chain = |term: &Term| classes.factors(Product::Geometric, term.class);
            if let (Some((left, _)), Some((right, _))) = (chain(first), chain(second)) {
                pair(classes, id, &left, &right);
            }
        }
        _ => {}
    }
}

/// The longest product that is tried.
const LONGEST: usize = 5;

/// A part of the product of two parts of a chain.
fn part(classes: &mut Classes<'_>, id: ClassId, grade: u32, factors: &[ClassId]) {
    if factors.len() > LONGEST {
        return;
    }
    for place in 1..factors.len() {
        let (left, right) = factors.split_at(place);
        if left.iter().all(|factor| classes.is_scalar(*factor)) {
            continue;
        }
        let (Some(left), Some(right)) = (
            classes.chain(Product::Geometric, left, RULE),
            classes.chain(Product::Geometric, right, RULE),
        ) else {
            return;
        };
        let (a, b) = (left.class, right.class);
        let tried = match (classes.grade(a), classes.grade(b)) {
            (Some(r), Some(s)) => [
                (Product::ScalarProduct, Some(0)),
                (Product::Wedge, Some(r + s)),
                (Product::LeftContraction, s.checked_sub(r)),
                (Product::RightContraction, r.checked_sub(s)),
            ],
            _ => [(Product::ScalarProduct, Some(0)); 4],
        };
        for (product, of) in tried {
            if of == Some(grade) {
                try_product(classes, id, product, a, b);
            }
        }
    }
}

/// A sum of `s a b` and a multiple of `s b a` with scalars s.
fn pair(classes: &mut Classes<'_>, id: ClassId, left: &[ClassId], right: &[ClassId]) {
    let scalars = left.iter().take_while(|id| classes.is_scalar(**id)).count();
    if left.len() != right.len() || left[..scalars] != right[..scalars] {
        return;
    }
    let (first, second) = (&left[scalars..], &right[scalars..]);
    for place in 1..first.len() {
        let (a, b) = first.split_at(place);
        if [b, a].concat() != second {
            continue;
        }
        let (Some(a), Some(b)) = (
            classes.chain(Product::Geometric, &left[..scalars + place], RULE),
            classes.chain(Product::Geometric, b, RULE),
        ) else {
            return;
        };
        for product in Product::ALL.into_iter().skip(1) {
            try_product(classes, id, product, a.class, b.class);
        }
    }
}

/// Adds a product, if it is a multiple of the class.
fn try_product(classes: &mut Classes<'_>, id: ClassId, product: Product, a: ClassId, b: ClassId) {
    let algebra = classes.algebra;
    let values = classes.each_of_two(a, b, |a, b| numbers::product(algebra, product, a, b));
    let values: Vec<_> = values
        .into_iter()
        .map(|mut value| {
            value.retain(|_, number| !number.is_zero());
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

//! Products with a vector: `X v = X ∧ v + X ⌊ v`, and `v X = v ∧ X + v ⌋ X`.
//!
//! - `(X ∧ v) v = (X v − X ⌊ v) v = v² X − (X ⌊ v) v`: a rejection as a difference.
//! - `v X v = ±(v² X − 2 v ∧ (v ⌋ X))`, the sign being that of the grade involution of X. Divided
//!   by v², only the second term is: `X − 2 v ∧ ((v ⌋ X)/v²)`. The other way round, such a sum is
//!   an action, for which [`SandwichRule`] has more ways.
//!
//! A hyperplane A that is not in dual form is the dual of a vector v, so that `A X A = ±v X v` and
//! `(X ⌋ A) A = ±(X ∧ v) v`.
//!
//! [`SandwichRule`]: crate::lower::SandwichRule

use crate::algebra::{Product, Ratio, Unary};
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;
use crate::member::numbers;

const RULE: Option<FormRule> = Some(FormRule::Vector);

pub(super) fn apply(classes: &mut Classes<'_>, id: ClassId, way: &Way) {
    match &way.operation {
        Operation::Product(Product::Geometric, factors) => {
            if let [a, v] = *factors.as_slice() {
                rejection(classes, a, v, None);
            }
        }
        Operation::Quotient(a, divisor) => {
            for other in classes.class(*a).ways.clone() {
                match other.operation {
                    Operation::Sandwich(v, x) => reflection(classes, v, x, *divisor),
                    Operation::Product(Product::Geometric, factors) => {
                        if let [a, v] = *factors.as_slice() {
                            rejection(classes, a, v, Some(*divisor));
                        }
                    }
                    _ => {}
                }
            }
        }
        Operation::Sum(terms) => action(classes, id, terms),
        _ => {}
    }
}

/// A vector, or the vector that a hyperplane is the dual of.
fn vector(classes: &mut Classes<'_>, id: ClassId) -> Option<Term> {
    let grade = classes.grade(id)?;
    if classes.class(id).is_constant {
        None
    } else if grade == 1 {
        Some(Term::of(id))
    } else if grade + 1 == classes.algebra.pseudoscalar().grade()
        && !classes.algebra.is_degenerate()
    {
        classes.unary(Unary::Dual, Term::of(id), RULE)
    } else {
        None
    }
}

fn square(classes: &mut Classes<'_>, v: Term) -> Option<Term> {
    classes.product(Product::ScalarProduct, v, v, RULE)
}

/// `(X ∧ v) v`, and that divided by v².
fn rejection(classes: &mut Classes<'_>, a: ClassId, v: ClassId, divisor: Option<ClassId>) {
    for other in classes.class(a).ways.clone() {
        let Operation::Product(product, factors) = other.operation else {
            continue;
        };
        let x = match (product, factors.as_slice()) {
            (Product::Wedge, [x, last]) if *last == v => *x,
            (Product::Wedge, [first, x]) if *first == v => *x,
            (Product::LeftContraction, [x, last]) if *last == v => *x,
            (Product::RightContraction, [first, x]) if *first == v => *x,
            _ => continue,
        };
        // The others are projections.
        if (product == Product::Wedge) != (classes.grade(v) == Some(1)) {
            continue;
        }
        let Some(v) = vector(classes, v) else { return };
        let Some(square) = square(classes, v) else {
            return;
        };
        if divisor.is_some_and(|divisor| divisor != square.class) {
            continue;
        }
        let x = Term::of(x);
        let Some(inner) = classes.product(Product::RightContraction, x, v, RULE) else {
            continue;
        };
        let (whole, inner) = match divisor {
            None => (
                classes.product(Product::Geometric, square, x, RULE),
                Some(inner),
            ),
            Some(_) => (Some(x), classes.quotient(inner, square, RULE)),
        };
        if let (Some(whole), Some(inner)) = (whole, inner)
            && let Some(part) = classes.product(Product::Geometric, inner, v, RULE)
        {
            classes.sum(&[whole, part.scaled(-Ratio::ONE)], RULE);
        }
    }
}

/// `v X v / v²`.
fn reflection(classes: &mut Classes<'_>, v: ClassId, x: ClassId, divisor: ClassId) {
    let Some(v) = vector(classes, v) else { return };
    let x = Term::of(x);
    if let Some(square) = square(classes, v)
        && square.class == divisor
        && let Some(inner) = classes.product(Product::LeftContraction, v, x, RULE)
        && let Some(inner) = classes.quotient(inner, square, RULE)
        && let Some(part) = classes.product(Product::Wedge, v, inner, RULE)
    {
        classes.sum(&[x, part.scaled(Ratio::integer(-2))], RULE);
    }
}

/// A sum of a multiple of X and a multiple of a vector v as the action of v on X.
fn action(classes: &mut Classes<'_>, id: ClassId, terms: &[Term]) {
    let [first, second] = *terms else { return };
    let multiple = |classes: &Classes<'_>, id: ClassId| {
        let (factors, _) = classes.factors(Product::Geometric, id)?;
        match factors.as_slice() {
            [scalar, rest] if classes.is_scalar(*scalar) => Some(*rest),
            _ => None,
        }
    };
    for (part, whole) in [(first, second), (second, first)] {
        let Some(v) = multiple(classes, part.class) else {
            continue;
        };
        let x = multiple(classes, whole.class).unwrap_or(whole.class);
        if classes.grade(v) != Some(1) || classes.grade(x) != Some(1) || v == x {
            continue;
        }
        let algebra = classes.algebra;
        let values = classes.each_of_two(v, x, |v, x| numbers::sandwich(algebra, v, true, x));
        if classes
            .find(&values, &[v, x])
            .is_some_and(|term| term.class == id)
        {
            classes.sandwich(Term::of(v), Term::of(x), RULE);
        }
    }
}

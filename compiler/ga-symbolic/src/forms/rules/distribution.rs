//! Products are bilinear: `a (b + c) = a b + a c`, and `s (a b) = (s a) b = a (s b)` for a scalar
//! s.
//!
//! A first or last factor that several terms have in common is taken out. Sums are not multiplied
//! out, since differences would be taken after products, where they cancel. A scalar moves from the
//! product to each factor and back.

use crate::algebra::Product;
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

const RULE: Option<FormRule> = Some(FormRule::Distribution);

/// The greatest number of factors among which a scalar moves.
const LONGEST: usize = 3;

pub(super) fn apply(classes: &mut Classes<'_>, _: ClassId, way: &Way) {
    match &way.operation {
        Operation::Sum(terms) => take_out(classes, terms),
        Operation::Product(product, factors) => {
            move_scalar(classes, *product, factors);
        }
        _ => {}
    }
}

/// Moves a scalar in front of a product to each of its factors, or out of a factor.
fn move_scalar(classes: &mut Classes<'_>, product: Product, factors: &[ClassId]) {
    if let (Product::Geometric, [scalar, rest]) = (product, factors)
        && classes.is_scalar(*scalar)
        && !classes.is_scalar(*rest)
    {
        for way in classes.class(*rest).ways.clone() {
            let Operation::Product(inner, parts) = &way.operation else {
                continue;
            };
            if *inner == Product::Geometric || parts.len() > LONGEST {
                continue;
            }
            for (place, part) in parts.iter().enumerate() {
                if let Some(part) =
                    classes.product(Product::Geometric, Term::of(*scalar), Term::of(*part), RULE)
                {
                    with(classes, *inner, parts, place, part);
                }
            }
        }
    } else if product != Product::Geometric {
        for (place, factor) in factors.iter().enumerate() {
            let Some((inner, _)) = classes.factors(Product::Geometric, *factor) else {
                continue;
            };
            let [scalar, rest @ ..] = inner.as_slice() else {
                continue;
            };
            if !classes.is_scalar(*scalar) {
                continue;
            }
            if let Some(rest) = classes.chain(Product::Geometric, rest, RULE)
                && let Some(whole) = with(classes, product, factors, place, rest)
            {
                classes.product(Product::Geometric, Term::of(*scalar), whole, RULE);
            }
        }
    }
}

/// The product with another factor at a place.
fn with(
    classes: &mut Classes<'_>,
    product: Product,
    factors: &[ClassId],
    place: usize,
    by: Term,
) -> Option<Term> {
    let mut whole: Option<Term> = None;
    for (number, factor) in factors.iter().enumerate() {
        let factor = if number == place {
            by
        } else {
            Term::of(*factor)
        };
        whole = Some(match whole {
            None => factor,
            Some(whole) => classes.product(product, whole, factor, RULE)?,
        });
    }
    whole
}

/// Takes out a factor that several terms have in common.
fn take_out(classes: &mut Classes<'_>, terms: &[Term]) {
    for product in [
        Product::Geometric,
        Product::Wedge,
        Product::LeftContraction,
        Product::RightContraction,
        Product::ScalarProduct,
        Product::Commutator,
    ] {
        let ends: Vec<Option<(Vec<ClassId>, Term)>> = terms
            .iter()
            .map(|term| {
                let (factors, scale) = classes.factors(product, term.class)?;
                let term = term.scaled(scale);
                (factors.len() > 1).then_some((factors, term))
            })
            .collect();
        for is_first in [true, false] {
            let mut done: Vec<ClassId> = Vec::new();
            for (factors, _) in ends.iter().flatten() {
                let common = if is_first {
                    factors[0]
                } else {
                    factors[factors.len() - 1]
                };
                if done.contains(&common) {
                    continue;
                }
                done.push(common);
                take_out_of(classes, product, terms, &ends, common, is_first);
            }
        }
    }
}

fn take_out_of(
    classes: &mut Classes<'_>,
    product: Product,
    terms: &[Term],
    ends: &[Option<(Vec<ClassId>, Term)>],
    common: ClassId,
    is_first: bool,
) {
    let (mut inside, mut outside) = (Vec::new(), Vec::new());
    for (term, end) in terms.iter().zip(ends) {
        let rest = end.as_ref().and_then(|(factors, scaled)| {
            let (found, rest) = if is_first {
                (factors[0], &factors[1..])
            } else {
                (factors[factors.len() - 1], &factors[..factors.len() - 1])
            };
            (found == common).then_some((rest, scaled.factor))
        });
        let Some((rest, factor)) = rest else {
            outside.push(*term);
            continue;
        };
        let Some(rest) = classes.chain(product, rest, RULE) else {
            return;
        };
        inside.push(rest.scaled(factor));
    }
    if inside.len() < 2 {
        return;
    }
    let Some(inside) = classes.sum(&inside, RULE) else {
        return;
    };
    let common = Term::of(common);
    let (left, right) = if is_first {
        (common, inside)
    } else {
        (inside, common)
    };
    if let Some(whole) = classes.product(product, left, right, RULE) {
        outside.push(whole);
        classes.sum(&outside, RULE);
    }
}

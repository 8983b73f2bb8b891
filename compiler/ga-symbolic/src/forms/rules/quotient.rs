//! Quotients by scalars and products: `(a/s) b = (a b)/s = a (b/s)`, by linearity. The divisor is
//! the same in all of them, so that they exist for the same operands; so it is in `a/s = (1/s) a`.
//! In `(a/s)/(b/s) = a/b` the divisor s cancels.

use crate::algebra::{Product, Ratio};
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

const RULE: Option<FormRule> = Some(FormRule::Quotient);

pub(super) fn apply(classes: &mut Classes<'_>, id: ClassId, way: &Way) {
    match &way.operation {
        Operation::Product(product, factors) => {
            for (place, factor) in factors.iter().enumerate() {
                if let Some((dividend, divisor, scale)) = quotient(classes, *factor)
                    && let Some(whole) = replaced(classes, *product, factors, place, dividend)
                {
                    let whole = whole.scaled(scale);
                    classes.quotient(whole, Term::of(divisor), RULE);
                }
            }
        }
        Operation::Quotient(a, divisor) => {
            reduced(classes, id, way.factor, *a, *divisor);
            if let Some(one) = classes.one()
                && *a != one.class
                && let Some(inverse) = classes.quotient(one, Term::of(*divisor), RULE)
            {
                classes.product(Product::Geometric, inverse, Term::of(*a), RULE);
            }
            for other in classes.class(*a).ways.clone() {
                let Operation::Product(product, factors) = &other.operation else {
                    continue;
                };
                for (place, factor) in factors.iter().enumerate() {
                    // Only where the quotient occurs elsewhere anyway.
                    let operation = Operation::Quotient(*factor, *divisor);
                    if let Some(part) = classes.known(&operation) {
                        replaced(classes, *product, factors, place, part.class);
                    }
                }
            }
        }
        _ => {}
    }
}

/// `(a/s)/(b/s) = a/b`, which the class has as a way: it exists where that does, too.
fn reduced(classes: &mut Classes<'_>, id: ClassId, factor: Ratio, a: ClassId, b: ClassId) {
    let quotients = |id: ClassId| {
        let ways = classes.class(id).ways.iter();
        ways.filter_map(|way| match way.operation {
            Operation::Quotient(a, divisor) => Some((a, divisor, way.factor)),
            _ => None,
        })
        .collect::<Vec<_>>()
    };
    let (dividends, divisors) = (quotients(a), quotients(b));
    for (a, common, first) in &dividends {
        for (b, _, second) in divisors.iter().filter(|(_, other, _)| other == common) {
            let term = Term {
                class: id,
                factor: *second / (factor * *first),
            };
            classes.add_way(Operation::Quotient(*a, *b), term, RULE);
        }
    }
}

fn quotient(classes: &Classes<'_>, id: ClassId) -> Option<(ClassId, ClassId, Ratio)> {
    let mut ways = classes.class(id).ways.iter();
    ways.find_map(|way| match way.operation {
        Operation::Quotient(a, divisor) => Some((a, divisor, way.factor)),
        _ => None,
    })
}

/// The product with another factor at a place.
fn replaced(
    classes: &mut Classes<'_>,
    product: Product,
    factors: &[ClassId],
    place: usize,
    by: ClassId,
) -> Option<Term> {
    let mut whole: Option<Term> = None;
    for (number, factor) in factors.iter().enumerate() {
        let factor = Term::of(if number == place { by } else { *factor });
        whole = Some(match whole {
            None => factor,
            Some(whole) => classes.product(product, whole, factor, RULE)?,
        });
    }
    whole
}

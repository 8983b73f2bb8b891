//! Powers of a unit versor: `M² = M (M + ~M) − 1`, since `M ~M = 1`. Of `M + ~M` only the scalar
//! and what else the reversal keeps is left, twice: of a rotor `M² = 2 s M − 1`.
//!
//! A power of even exponent is a square: `M⁴ = (M²)²`, by associativity; so `M⁵ = M M⁴`.

use crate::algebra::{Product, Ratio, Unary};
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;

const RULE: Option<FormRule> = Some(FormRule::Power);

pub(super) fn apply(classes: &mut Classes<'_>, id: ClassId, way: &Way) {
    let Operation::Product(Product::Geometric, factors) = &way.operation else {
        return;
    };
    let Some((&base, rest)) = factors.split_first() else {
        return;
    };
    if rest.iter().any(|factor| *factor != base) {
        group_powers(classes, id, way, factors);
        return;
    }
    if factors.len() == 2 && classes.is_unit(base) {
        let whole = Term::of(base);
        if let Some(reverse) = classes.unary(Unary::Reverse, whole, RULE)
            && let Some(double) = classes.sum(&[whole, reverse], RULE)
            && let Some(product) = classes.grouped(&[double.class, base], RULE)
            && let Some(one) = classes.one()
        {
            let minus = one.scaled(-one.factor);
            classes.sum(&[product.scaled(double.factor), minus], RULE);
        }
    } else if factors.len() % 2 == 1 {
        if let Some(rest) = classes.chain(Product::Geometric, rest, RULE) {
            let term = Term {
                class: id,
                factor: Ratio::ONE / (way.factor * rest.factor),
            };
            let operation = Operation::Product(Product::Geometric, vec![base, rest.class]);
            classes.add_way(operation, term, RULE);
        }
    } else if let Some(half) =
        classes.chain(Product::Geometric, &factors[1 + rest.len() / 2..], RULE)
    {
        let scale = way.factor * half.factor * half.factor;
        let operation = Operation::Product(Product::Geometric, vec![half.class; 2]);
        let term = Term {
            class: id,
            factor: Ratio::ONE / scale,
        };
        classes.add_way(operation, term, RULE);
    }
}

/// Takes powers inside a chain as one factor.
fn group_powers(classes: &mut Classes<'_>, id: ClassId, way: &Way, factors: &[ClassId]) {
    for (start, base) in factors.iter().enumerate() {
        if start > 0 && factors[start - 1] == *base {
            continue;
        }
        let run = factors[start..].iter().take_while(|other| *other == base);
        let end = start + run.count();
        if end - start < 2 || classes.is_scalar(*base) {
            continue;
        }
        let Some(power) = classes.chain(Product::Geometric, &factors[start..end], RULE) else {
            continue;
        };
        let mut grouped = factors[..start].to_vec();
        grouped.push(power.class);
        grouped.extend(&factors[end..]);
        let term = Term {
            class: id,
            factor: Ratio::ONE / (way.factor * power.factor),
        };
        classes.add_way(Operation::Product(Product::Geometric, grouped), term, RULE);
    }
}

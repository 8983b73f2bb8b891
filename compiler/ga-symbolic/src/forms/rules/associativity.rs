//! Products in another grouping: `(a b) c = a (b c)`, for the geometric and for the outer product.
//!
//! Chains are flat. A group that occurs elsewhere too is one factor again, so that it is computed
//! once; and a product of three and more is tried in
//! two parts at each place.

use crate::algebra::{Product, Ratio};
use crate::forms::FormRule;
use crate::forms::class::{ClassId, Operation, Term, Way};
use crate::forms::classes::Classes;
use crate::limit::SearchLimit;

const RULE: Option<FormRule> = Some(FormRule::Associativity);

/// The longest product in which groups are looked for.
const LONGEST_SEARCHED: usize = 32;

/// The longest product of which all groupings are tried.
const LONGEST: usize = 4;

pub(super) fn apply(classes: &mut Classes<'_>, id: ClassId, way: &Way) {
    let Operation::Product(product @ (Product::Geometric | Product::Wedge), factors) =
        &way.operation
    else {
        return;
    };
    // Powers are grouped by another rule.
    if way.rule == RULE || factors.iter().all(|factor| *factor == factors[0]) {
        return;
    }
    let whole = factors.len();
    if whole > LONGEST_SEARCHED {
        classes.reached.push(SearchLimit::Factors);
        return;
    }
    for start in 0..whole {
        for end in start + 2..=whole {
            let part = &factors[start..end];
            let operation = Operation::Product(*product, part.to_vec());
            if end - start < whole
                && let Some(group) = classes.known(&operation)
            {
                let mut grouped = factors[..start].to_vec();
                let mut factor = Ratio::ONE;
                let mut rest = &factors[start..];
                // Where it comes again, it is one factor again.
                while let Some((first, others)) = rest.split_first() {
                    if rest.starts_with(part) {
                        grouped.push(group.class);
                        factor = factor * group.factor;
                        rest = &rest[part.len()..];
                    } else {
                        grouped.push(*first);
                        rest = others;
                    }
                }
                add(classes, id, way, *product, grouped, factor);
            }
        }
    }
    if *product == Product::Geometric && (3..=LONGEST).contains(&whole) {
        for place in 1..whole {
            let (left, right) = factors.split_at(place);
            if let Some(left) = classes.chain(*product, left, RULE)
                && let Some(right) = classes.chain(*product, right, RULE)
            {
                let grouped = vec![left.class, right.class];
                add(
                    classes,
                    id,
                    way,
                    *product,
                    grouped,
                    left.factor * right.factor,
                );
            }
        }
    }
}

/// Adds a grouping, the chain being the given multiple of it.
fn add(
    classes: &mut Classes<'_>,
    id: ClassId,
    way: &Way,
    product: Product,
    grouped: Vec<ClassId>,
    factor: Ratio,
) {
    let term = Term {
        class: id,
        factor: Ratio::ONE / (way.factor * factor),
    };
    classes.add_way(Operation::Product(product, grouped), term, RULE);
}

//! Products in another grouping: `(a b) c = a (b c)`, for the geometric and for the outer product.
//!
//! Chains are flat, so what is written in groups has lost them. A group that occurs elsewhere too
//! is one factor again, so that it is computed once; and a product of three and more is tried in
//! two parts at each place.

use crate::algebra::{Product, Ratio};
use crate::forms::FormRule;
use crate::forms::classes::{ClassId, Classes, Operation, Term, Way};

const RULE: Option<FormRule> = Some(FormRule::Associativity);

/// The longest product of which all groupings are tried.
const LONGEST: usize = 4;

pub(super) fn apply(classes: &mut Classes<'_>, id: ClassId, way: &Way) {
    let Operation::Product(product @ (Product::Geometric | Product::Wedge), factors) =
        &way.operation
    else {
        return;
    };
    for start in 0..factors.len() {
        for end in start + 2..=factors.len() {
            if end - start == factors.len() {
                continue;
            }
            let group = &factors[start..end];
            let operation = Operation::Product(*product, group.to_vec());
            let is_split = *product == Product::Geometric
                && factors.len() <= LONGEST
                && (start == 0 || end == factors.len());
            let group = match classes.known(&operation) {
                Some(known) => known,
                None if is_split => match classes.chain(*product, group, RULE) {
                    Some(made) => made,
                    None => continue,
                },
                None => continue,
            };
            let mut grouped = factors[..start].to_vec();
            grouped.push(group.class);
            grouped.extend(&factors[end..]);
            // factor · chain is the multivector of the class, and the chain a multiple of this.
            let term = Term {
                class: id,
                factor: Ratio::ONE / (way.factor * group.factor),
            };
            classes.add_way(Operation::Product(*product, grouped), term, RULE);
        }
    }
}

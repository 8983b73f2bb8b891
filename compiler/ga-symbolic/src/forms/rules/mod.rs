//! The rules, each in a file of its own, and their application until nothing new comes out.

mod adjoint;
mod associativity;
mod composition;
mod conjugation;
mod definition;
mod difference;
mod distribution;
mod duality;
mod invariant_part;
mod linearity;
mod outermorphism;
mod power;
mod quotient;
mod reversal;
mod scalar_factor;
mod vector;

pub(super) use conjugation::as_action;
pub(super) use difference::Images;
pub(super) use outermorphism::cancels;

use rustc_hash::FxHashMap;

use super::class::{ClassId, Operation, Way};
use super::classes::Classes;
use crate::algebra::Product;
use crate::limit::SearchLimit;

/// A rule: looks at one way to a class and proposes others.
type Apply = fn(&mut Classes<'_>, ClassId, &Way);

/// A rule, and which ways it looks at.
struct Applied {
    apply: Apply,
    /// Whether it looks at products that are actions too.
    is_for_actions: bool,
    /// Whether it finds too many ways to be used in long programs.
    is_for_short: bool,
}

impl Applied {
    const fn new(apply: Apply) -> Self {
        Self {
            apply,
            is_for_actions: false,
            is_for_short: false,
        }
    }
}

const RULES: [Applied; 16] = [
    Applied {
        is_for_actions: true,
        ..Applied::new(reversal::apply)
    },
    Applied {
        is_for_actions: true,
        ..Applied::new(conjugation::apply)
    },
    Applied::new(definition::apply),
    Applied::new(duality::apply),
    Applied::new(composition::apply),
    Applied::new(difference::apply),
    Applied::new(outermorphism::apply),
    Applied::new(linearity::apply),
    Applied::new(invariant_part::apply),
    Applied::new(power::apply),
    Applied::new(quotient::apply),
    Applied::new(vector::apply),
    Applied::new(adjoint::apply),
    Applied::new(scalar_factor::apply),
    Applied {
        is_for_short: true,
        ..Applied::new(distribution::apply)
    },
    Applied {
        is_for_short: true,
        ..Applied::new(associativity::apply)
    },
];

/// The number of ways of a program beyond which it is long: functions with exponentials and
/// logarithms are.
const LONG: usize = 22;

/// How many ways may be found beyond those that the program has.
const MOST_WAYS: usize = 240;

/// Applies all rules to all ways, those that are found included, up to a bound. A rule looks at the
/// ways to what an operation reads, so it is applied again where there are more of those.
pub(super) fn saturate(classes: &mut Classes<'_>) {
    let limit = classes.ways + MOST_WAYS;
    let is_long = classes.ways > LONG;
    let mut seen: FxHashMap<(ClassId, usize), usize> = FxHashMap::default();
    loop {
        let mut has_changed = false;
        let mut place = 0;
        while place < classes.len() {
            let Some(id) = classes.ids().nth(place) else {
                break;
            };
            let mut number = 0;
            while number < classes.class(id).ways.len() {
                let way = &classes.class(id).ways[number];
                let reads = way.operation.reads();
                let below = reads.iter().map(|read| classes.class(*read).ways.len());
                let below = below.sum();
                if seen.insert((id, number), below) != Some(below) {
                    has_changed = true;
                    let way = way.clone();
                    // A number is left alone, `M ~M` for instance.
                    let is_moved = !classes.is_scalar(id) && classes.has_action(id);
                    let is_product =
                        matches!(way.operation, Operation::Product(Product::Geometric, _));
                    for rule in &RULES {
                        if is_long && rule.is_for_short {
                            continue;
                        }
                        // A product that is an action is not looked at in another way.
                        if !rule.is_for_actions && is_product && is_moved {
                            break;
                        }
                        (rule.apply)(classes, id, &way);
                    }
                    if classes.ways > limit {
                        classes.reached.push(SearchLimit::Ways);
                        return;
                    }
                }
                number += 1;
            }
            place += 1;
        }
        if !has_changed {
            return;
        }
    }
}

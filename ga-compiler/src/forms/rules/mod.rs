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
mod vector;

pub(super) use conjugation::as_action;
pub(super) use difference::Images;
pub(super) use outermorphism::cancels;

use rustc_hash::FxHashMap;

use super::classes::{ClassId, Classes, Operation, Way};
use crate::algebra::Product;

/// A rule: looks at one way to a class and proposes others.
type Apply = fn(&mut Classes<'_>, ClassId, &Way);

const RULES: [Apply; 15] = [
    reversal::apply,
    conjugation::apply,
    definition::apply,
    duality::apply,
    composition::apply,
    difference::apply,
    outermorphism::apply,
    linearity::apply,
    invariant_part::apply,
    power::apply,
    quotient::apply,
    vector::apply,
    adjoint::apply,
    distribution::apply,
    associativity::apply,
];

/// How many of the rules are for all products.
const EARLY: usize = 2;

/// The number of ways of a program beyond which the rules that find most ways, distribution and
/// associativity, are left out: functions with exponentials and logarithms are that long.
const LONG: usize = 22;
const LATE: usize = 2;

/// How many ways may be found beyond those that the program has.
const MOST_WAYS: usize = 240;

/// Applies all rules to all ways, those that are found included, up to a bound. A rule looks at the
/// ways to what an operation reads, so it is applied again where there are more of those.
pub(super) fn saturate(classes: &mut Classes<'_>) {
    let limit = classes.ways + MOST_WAYS;
    let late = if classes.ways > LONG { LATE } else { 0 };
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
                    for (number, apply) in RULES[..RULES.len() - late].iter().enumerate() {
                        // A product that is an action is not looked at in another way.
                        let is_product =
                            matches!(way.operation, Operation::Product(Product::Geometric, _));
                        if number >= EARLY && is_product && is_moved {
                            break;
                        }
                        apply(classes, id, &way);
                    }
                    if classes.ways > limit {
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

//! The rules, each in a file of its own, and their application until nothing new comes out.

mod associativity;
mod composition;
mod conjugation;
mod definition;
mod duality;
mod invariant_part;
mod linearity;
mod outermorphism;
mod power;
mod quotient;
mod reversal;

use super::classes::{ClassId, Classes, Way};

/// A rule: looks at one way to a class and proposes others.
type Apply = fn(&mut Classes<'_>, ClassId, &Way);

const RULES: [Apply; 11] = [
    reversal::apply,
    conjugation::apply,
    definition::apply,
    duality::apply,
    composition::apply,
    outermorphism::apply,
    linearity::apply,
    invariant_part::apply,
    power::apply,
    quotient::apply,
    associativity::apply,
];

/// How many ways may be found beyond those that the program has.
const MOST_WAYS: usize = 120;

/// Applies all rules to all ways, those that are found included, up to a bound.
pub(super) fn saturate(classes: &mut Classes<'_>) {
    let limit = classes.ways + MOST_WAYS;
    let mut done: Vec<usize> = Vec::new();
    loop {
        let mut has_changed = false;
        let mut place = 0;
        while place < classes.len() {
            done.resize(classes.len(), 0);
            let Some(id) = classes.ids().nth(place) else {
                break;
            };
            while done[place] < classes.class(id).ways.len() {
                let way = classes.class(id).ways[done[place]].clone();
                done[place] += 1;
                has_changed = true;
                for apply in RULES {
                    apply(classes, id, &way);
                }
                if classes.ways > limit {
                    return;
                }
            }
            place += 1;
        }
        if !has_changed {
            return;
        }
    }
}

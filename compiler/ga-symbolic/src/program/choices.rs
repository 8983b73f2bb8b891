//! Which outcomes of comparisons the points of a witness must show, and how to find outcomes that
//! lead there.
//!
//! A comparison holds at random at a point. A conjunction of many would never hold at the few
//! points that are taken, so that the branch behind it would go unseen.

use rustc_hash::FxHashMap;

use super::{Program, Step, StepId};
use crate::ir::{Function, NumberSequence};
use crate::member;

/// Conditions with the outcomes that are wanted of them at one point.
pub(super) type Goal = Vec<(StepId, bool)>;

/// How many branches of choices within choices are looked at.
const MOST_BRANCHES: usize = 64;

/// How often outcomes are drawn. Each time one operand of a disjunction is drawn that shall hold.
const TRIES: u64 = 64;

/// What points must show because of a step: both outcomes of a condition that is made of others,
/// and every branch of a choice.
pub(super) fn goals(program: &Program<'_>, id: StepId) -> Vec<Goal> {
    match program.step(id) {
        Step::Function(Function::And | Function::Or | Function::Not, _) => {
            vec![vec![(id, true)], vec![(id, false)]]
        }
        Step::Select(..) => branches(program, id),
        _ => Vec::new(),
    }
}

/// The branches of a choice and of the choices that it chooses from.
fn branches(program: &Program<'_>, id: StepId) -> Vec<Goal> {
    let mut found = Vec::new();
    let mut open = vec![(id, Goal::new())];
    while let Some((id, path)) = open.pop() {
        let Step::Select(condition, a, b) = *program.step(id) else {
            found.push(path);
            continue;
        };
        for (branch, holds) in [(a, true), (b, false)] {
            let is_known = path.contains(&(condition, holds));
            if path.contains(&(condition, !holds)) {
                continue;
            }
            let mut path = path.clone();
            if !is_known {
                path.push((condition, holds));
            }
            open.push((branch, path));
        }
        if found.len() + open.len() > MOST_BRANCHES {
            break;
        }
    }
    found.extend(open.into_iter().map(|(_, path)| path));
    found
}

/// Outcomes of comparisons by which conditions have the wanted outcomes; `None` if none are found.
pub(super) fn outcomes(program: &Program<'_>, goal: &Goal) -> Option<Goal> {
    (0..TRIES).find_map(|seed| attempt(program, goal, &mut member::sequence(seed)))
}

fn attempt(program: &Program<'_>, goal: &Goal, sequence: &mut NumberSequence) -> Option<Goal> {
    let mut decided: FxHashMap<StepId, bool> = FxHashMap::default();
    let mut outcomes = Goal::new();
    let mut open = goal.clone();
    while let Some((id, holds)) = open.pop() {
        match decided.insert(id, holds) {
            Some(before) if before == holds => continue,
            Some(_) => return None,
            None => {}
        }
        match program.step(id) {
            Step::Function(Function::Not, arguments) => open.push((arguments[0], !holds)),
            Step::Function(function @ (Function::And | Function::Or), arguments) => {
                if (*function == Function::And) == holds {
                    open.extend(arguments.iter().map(|part| (*part, holds)));
                } else {
                    open.push((arguments[sequence.below(2)], holds));
                }
            }
            _ => outcomes.push((id, holds)),
        }
    }
    Some(outcomes)
}

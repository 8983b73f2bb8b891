//! Whether random points show the outcomes of comparisons and the roots of a program.

use super::point::{Point, is_real, is_variable_root};
use super::{Program, Step, StepId};
use crate::ir::{Function, Residue};

/// How many points are taken at most until every comparison has held and failed, and every two of
/// them in each combination.
const POINTS_WITH_CHOICES: usize = 48;

/// Whether every root is a residue or a real number at some point: the root of `−x²` never is.
pub(super) fn has_real_roots(program: &Program<'_>, points: &[Point]) -> bool {
    let mut roots = program
        .steps()
        .map(|(id, _)| id)
        .filter(|&id| is_variable_root(program, id));
    roots.all(|id| {
        let exists = |point: &Point| {
            point.scalar(id).real().is_known() || is_real(&point.values[id.index()])
        };
        points.is_empty() || points.iter().any(exists)
    })
}

/// Whether the points show the outcomes of the program's comparisons, one by one and in pairs.
/// They do so for the comparisons among the first `covered` steps.
pub(super) fn is_covered(program: &Program<'_>, points: &[Point], covered: usize) -> bool {
    let random = |(id, step)| match step {
        &Step::Function(function, ref arguments) if function.properties().is_random_choice => {
            // A comparison gives 0 or 1; the smaller or the larger number is the first or not.
            let reference = (!function.is_condition()).then_some(arguments[0]);
            Some((id, reference))
        }
        _ => None,
    };
    if points.len() >= POINTS_WITH_CHOICES
        || program
            .steps_from(covered)
            .filter_map(random)
            .next()
            .is_none()
    {
        return true;
    }
    let choices: Vec<(StepId, Option<StepId>)> = program.steps().filter_map(random).collect();
    // The points where each has one outcome, as bits.
    let outcomes = choices.iter().map(|(id, reference)| {
        let scalar = |point: &Point, id: StepId| point.scalar(id).residue();
        let holds = |point: &Point| match reference {
            Some(first) => scalar(point, *id) == scalar(point, *first),
            None => is_true(point, *id),
        };
        points
            .iter()
            .fold(0_u64, |bits, point| bits << 1 | u64::from(holds(point)))
    });
    let outcomes: Vec<u64> = outcomes.collect();
    let every = (1_u64 << points.len()) - 1;
    let shows_all = |a: u64, b: u64| {
        let combinations = [a & b, a & !b, !a & b, !a & !b];
        combinations.iter().all(|points| points & every != 0)
    };
    let is_both = |a: u64| a != 0 && a != every;
    choices.iter().enumerate().all(|(place, (id, _))| {
        id.index() < covered
            || is_both(outcomes[place])
                && (0..place).all(|other| shows_all(outcomes[place], outcomes[other]))
    })
}

pub(super) fn is_comparison(function: Function) -> bool {
    function.is_condition() && function.properties().is_random_choice
}

pub(super) fn is_true(point: &Point, id: StepId) -> bool {
    point.scalar(id).residue() != Some(Residue::ZERO)
}

//! Programs to classes.

use super::FormRule;
use super::class::{Operation, Term};
use super::classes::Classes;
use super::make::Made;
use super::rules;
use crate::algebra::{Blade, Product, Ratio, Unary};
use crate::ir::Function;
use crate::member::{Numbers, numbers};
use crate::program::{Program, Step, StepId, Witness};

/// The classes of the steps that some steps need; `None` for those that are zero or not needed.
/// There are none at all where the values at the points of the witness do not tell what is equal:
/// where there are choices, which do not show every outcome, and where a step is zero only as far
/// as it exists, and what is wanted exists elsewhere too.
pub(super) fn import(
    classes: &mut Classes<'_>,
    program: &Program<'_>,
    witness: &Witness,
    uniform: &[bool],
    wanted: &[StepId],
) -> Option<Vec<Made>> {
    let values = |id: StepId| -> Vec<Numbers> { witness.values(id).cloned().collect() };
    let mut made: Vec<Made> = vec![None; program.len()];
    // Operands and the number 1 come first, so that what equals them is them.
    for (id, step) in program.steps() {
        if let Step::Operand(number) = step {
            made[id.index()] = classes.insert(Operation::Operand(*number), |_| values(id), None);
            if let Some(term) = made[id.index()]
                && uniform.get(*number) == Some(&true)
            {
                classes.set_uniform(term.class);
            }
        }
    }
    classes.one();
    let is_needed = needed(program, wanted);
    let is_inner = inner_products(program, wanted, &is_needed);
    for (id, step) in program.steps().filter(|(id, _)| is_needed[id.index()]) {
        let get = |id: &StepId| made[id.index()];
        if is_inner[id.index()] {
            continue;
        }
        let next = match step {
            Step::Operand(_) => made[id.index()],
            Step::Constant(blade, factor) => {
                if factor.is_zero() {
                    None
                } else {
                    classes.blade(*blade).map(|term| term.scaled(*factor))
                }
            }
            Step::Unary(Unary::Reverse, a) => get(a).and_then(|a| reversed(classes, a)),
            Step::Unary(unary, a) => get(a).and_then(|a| classes.unary(*unary, a, None)),
            Step::Binary(Product::Geometric, ..) => {
                let mut parts = Some(Vec::new());
                gather(program, &is_inner, &made, id, &mut parts);
                parts.and_then(|parts| product_of(classes, &parts))
            }
            Step::Binary(product, a, b) => get(a)
                .zip(get(b))
                .and_then(|(a, b)| classes.product(*product, a, b, None)),
            Step::Sandwich(a, b) => get(a)
                .zip(get(b))
                .and_then(|(a, b)| classes.sandwich(a, b, None)),
            Step::Sum(a, b) => {
                let terms: Vec<Term> = [a, b].into_iter().filter_map(get).collect();
                classes.sum(&terms, None)
            }
            Step::Quotient(a, b) => get(a)
                .zip(get(b))
                .and_then(|(a, b)| classes.quotient(a, b, None)),
            Step::Negative(a) => get(a).map(|a| a.scaled(Ratio::integer(-1))),
            Step::Coefficient(a, blade) => get(a).and_then(|a| classes.coefficient(a, *blade)),
            Step::Select(..) => return None,
            Step::Function(function, _)
                if function.is_condition() || function.properties().is_random_choice =>
            {
                return None;
            }
            // A root besides it keeps the sign of its argument the same at all points.
            Step::Function(Function::Absolute, arguments)
                if !program.is_constant(id) && has_one_sign(witness, id, arguments[0]) =>
            {
                return None;
            }
            Step::Function(function, arguments) => {
                function_of(classes, *function, arguments.iter().map(get), values(id))
            }
        };
        made[id.index()] = next;
    }
    let mut wanted = wanted.iter();
    wanted
        .all(|id| classes.covers_zeros(made[id.index()]))
        .then_some(made)
}

/// Whether a step is wanted, or one reads it that is.
pub(super) fn needed(program: &Program<'_>, wanted: &[StepId]) -> Vec<bool> {
    let mut is_needed = vec![false; program.len()];
    for id in wanted {
        is_needed[id.index()] = true;
    }
    for (id, step) in program.steps().rev() {
        if is_needed[id.index()] {
            for read in step.reads() {
                is_needed[read.index()] = true;
            }
        }
    }
    is_needed
}

/// Whether an absolute value is its argument at all points, or its negative at all.
fn has_one_sign(witness: &Witness, absolute: StepId, argument: StepId) -> bool {
    let scalars = |id: StepId| {
        let values = witness.values(id);
        values.map(|value| numbers::coefficient(value, Blade::SCALAR))
    };
    scalars(absolute).eq(scalars(argument)) || scalars(absolute).eq(scalars(argument).map(|x| -x))
}

/// Zero, as a multiple of one.
fn zero(one: Made) -> Made {
    one.map(|one| one.scaled(Ratio::ZERO))
}

/// The geometric products that nothing but another geometric product reads, once.
fn inner_products(program: &Program<'_>, wanted: &[StepId], is_needed: &[bool]) -> Vec<bool> {
    let mut readers: Vec<Vec<StepId>> = vec![Vec::new(); program.len()];
    for (id, step) in program.steps().filter(|(id, _)| is_needed[id.index()]) {
        for read in step.reads() {
            readers[read.index()].push(id);
        }
    }
    let is_product = |id: StepId| matches!(program.step(id), Step::Binary(Product::Geometric, ..));
    program
        .steps()
        .map(|(id, _)| {
            let is_read_once = matches!(readers[id.index()].as_slice(), [by] if is_product(*by));
            is_product(id) && is_read_once && !wanted.contains(&id)
        })
        .collect()
}

/// The factors of a product; none if one of them is zero.
fn gather(
    program: &Program<'_>,
    is_inner: &[bool],
    made: &[Made],
    id: StepId,
    parts: &mut Option<Vec<Term>>,
) {
    let mut open = vec![id];
    while let Some(part) = open.pop() {
        match (program.step(part), made[part.index()], &mut *parts) {
            (Step::Binary(_, a, b), ..) if part == id || is_inner[part.index()] => {
                open.extend([*b, *a]);
            }
            (_, Some(term), Some(parts)) => parts.push(term),
            _ => *parts = None,
        }
    }
}

/// A geometric product of several, actions in it taken first.
fn product_of(classes: &mut Classes<'_>, parts: &[Term]) -> Made {
    let mut factor = Ratio::ONE;
    let mut ids = Vec::new();
    for part in parts {
        factor = factor * part.factor;
        ids.push(part.class);
    }
    let whole = match rules::as_action(classes, &ids, None) {
        Some(whole) => Some(whole),
        None => {
            let whole = classes.chain(Product::Geometric, &ids, None);
            if let Some(whole) = whole {
                classes.add_written(&ids, whole);
            }
            whole
        }
    };
    whole.map(|term| term.scaled(factor))
}

fn function_of(
    classes: &mut Classes<'_>,
    function: Function,
    arguments: impl Iterator<Item = Made>,
    values: Vec<Numbers>,
) -> Made {
    let zero = zero(classes.one())?;
    let arguments = arguments.map(|argument| argument.unwrap_or(zero)).collect();
    classes.function(function, arguments, values)
}

/// `~(a b) = ~b ~a`, factor by factor.
pub(super) fn reversed(classes: &mut Classes<'_>, a: Term) -> Made {
    let whole = classes.unary(Unary::Reverse, a, None);
    if let Some((factors, _)) = classes.factors(Product::Geometric, a.class) {
        let mut parts = Vec::new();
        for factor in factors.iter().rev() {
            parts.push(classes.unary(Unary::Reverse, Term::of(*factor), None)?);
        }
        let ids: Vec<_> = parts.iter().map(|part| part.class).collect();
        classes.chain(Product::Geometric, &ids, Some(FormRule::Reversal));
    }
    whole
}

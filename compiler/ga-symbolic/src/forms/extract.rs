//! Programs from classes: one way for each class.

use super::class::{ClassId, Operation, Term};
use super::classes::Classes;
use super::selection::Selection;
use super::{Form, FormRule};
use crate::algebra::{Blade, Product, Ratio};
use crate::define::TypeDefinition;
use crate::ir::{Facts, Number};
use crate::member::{membership, numbers};
use crate::order::Order as _;
use crate::program::{Parity, Program, Step, StepId};

/// What is known of the classes from the program.
pub(super) struct Known<'a> {
    pub(super) facts: Vec<(ClassId, Facts)>,
    pub(super) kinds: Vec<&'a TypeDefinition>,
}

/// The program of a selection, the wanted steps in it, and the rules that were used. A broken rule
/// negates what it gives.
pub(super) fn extract<'a>(
    classes: &mut Classes<'_>,
    operands: &[&'a TypeDefinition],
    known: &Known<'a>,
    selection: &Selection,
    wanted: &[Option<Term>],
    broken: Option<FormRule>,
) -> Form<'a> {
    let mut program = Program::new(operands);
    let mut steps: Vec<Option<StepId>> = vec![None; classes.len()];
    let mut rules = Vec::new();
    for &id in &selection.order {
        let way = classes.class(id).ways[selection.ways[id.index()]].clone();
        let mut step = emit(&mut program, &steps, &way.operation);
        let mut factor = way.factor;
        if let Some(rule) = way.rule {
            // Two wrong signs might cancel.
            let is_broken = broken == Some(rule) && !rules.contains(&rule);
            rules.push(rule);
            if is_broken {
                factor = -factor;
            }
        }
        let is_leaf = matches!(way.operation, Operation::Operand(_) | Operation::Blade(_));
        if !is_leaf {
            state(classes, &mut program, known, id, Ratio::ONE / factor, step);
        }
        step = scaled(&mut program, step, factor);
        steps[id.index()] = Some(step);
        if !is_leaf {
            state(classes, &mut program, known, id, Ratio::ONE, step);
        }
    }
    rules.order();
    rules.dedup();
    let zero = Step::Constant(Blade::SCALAR, Ratio::ZERO);
    let wanted = wanted
        .iter()
        .map(|term| match term {
            Some(term) => {
                let step = value(&mut program, &steps, *term);
                if term.factor != Ratio::ONE {
                    state(classes, &mut program, known, term.class, term.factor, step);
                }
                step
            }
            None => program.push(zero.clone()),
        })
        .collect();
    Form {
        program,
        wanted,
        rules,
        frame: 0,
    }
}

fn value(program: &mut Program<'_>, steps: &[Option<StepId>], term: Term) -> StepId {
    match steps[term.class.index()] {
        Some(step) if !term.factor.is_zero() => scaled(program, step, term.factor),
        _ => program.push(Step::Constant(Blade::SCALAR, Ratio::ZERO)),
    }
}

fn scaled(program: &mut Program<'_>, step: StepId, factor: Ratio) -> StepId {
    if factor == Ratio::ONE {
        step
    } else if factor == -Ratio::ONE {
        program.push(Step::Negative(step))
    } else {
        let factor = program.push(Step::Constant(Blade::SCALAR, factor));
        program.push(Step::Binary(Product::Geometric, factor, step))
    }
}

fn emit(program: &mut Program<'_>, steps: &[Option<StepId>], operation: &Operation) -> StepId {
    let of = |program: &mut Program<'_>, id: ClassId| value(program, steps, Term::of(id));
    let step = match operation {
        Operation::Operand(number) => Step::Operand(*number),
        Operation::Blade(blade) => Step::Constant(*blade, Ratio::ONE),
        Operation::Unary(unary, a) => Step::Unary(*unary, of(program, *a)),
        Operation::Coefficient(a, blade) => Step::Coefficient(of(program, *a), *blade),
        Operation::Sandwich(a, b) => Step::Sandwich(of(program, *a), of(program, *b)),
        Operation::Quotient(a, b) => Step::Quotient(of(program, *a), of(program, *b)),
        Operation::Product(product, factors) => {
            let ids: Vec<StepId> = factors.iter().map(|id| of(program, *id)).collect();
            return joined(program, &ids, |a, b| Step::Binary(*product, a, b));
        }
        Operation::Sum(terms) => {
            let ids: Vec<StepId> = terms
                .iter()
                .map(|term| value(program, steps, *term))
                .collect();
            return joined(program, &ids, Step::Sum);
        }
        Operation::Function(function, arguments) => {
            let ids = arguments
                .iter()
                .map(|term| value(program, steps, *term))
                .collect();
            Step::Function(*function, ids)
        }
    };
    program.push(step)
}

fn joined(
    program: &mut Program<'_>,
    ids: &[StepId],
    step: impl Fn(StepId, StepId) -> Step,
) -> StepId {
    let (first, rest) = ids.split_first().expect("an operation reads something");
    rest.iter()
        .fold(*first, |whole, next| program.push(step(whole, *next)))
}

/// States what is known of a step that is a multiple of a class.
fn state<'a>(
    classes: &mut Classes<'_>,
    program: &mut Program<'a>,
    known: &Known<'a>,
    id: ClassId,
    factor: Ratio,
    step: StepId,
) {
    let is_plain = factor == Ratio::ONE;
    let stated = known
        .facts
        .iter()
        .find(|(other, _)| is_plain && *other == id);
    let mut facts = stated.map(|(_, facts)| *facts).unwrap_or_default();
    let algebra = classes.algebra;
    if classes.grade(id) == Some(1) {
        let mut values = classes.class(id).values.iter();
        facts.null |= values.all(|value| {
            let square = numbers::product(algebra, Product::ScalarProduct, value, value);
            square.values().all(|number| number.is_zero())
        });
        let scale = Number::from_ratio(factor);
        let is_member = |kind: &&&TypeDefinition| {
            let mut values = classes.class(id).values.iter();
            values.all(|value| {
                membership(algebra, Some(kind), &numbers::scaled(value, scale)).is_empty()
            })
        };
        if let Some(kind) = known.kinds.iter().find(is_member) {
            program.state_kind(step, kind);
        }
    }
    program.state_support(step, classes.support(id, factor));
    facts.unit_versor |= factor.abs() == Ratio::ONE && classes.known_unit(id);
    program.state(step, facts);
    program.state_parity(
        step,
        match classes.parity(id) {
            Some(false) => Parity::Even,
            Some(true) => Parity::Odd,
            None => Parity::Mixed,
        },
    );
}

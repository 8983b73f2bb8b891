//! The plain meaning of a program at a random point.

use super::{Parity, Program, Step, StepId};
use crate::algebra::{Algebra, Blade};
use crate::ir::{Function, Number, Outcomes, Parts, Residue};
use crate::member::{Numbers, numbers};

/// The value of every step for given members of the operands' types, operation by operation as they
/// are written: no identity, no fact, no graph. `None` where a root does not exist or a divisor is
/// zero at this point.
#[must_use]
pub fn evaluate(
    algebra: &Algebra,
    program: &Program<'_>,
    members: &[Numbers],
) -> Option<Vec<Numbers>> {
    let mut values = Vec::with_capacity(program.steps.len());
    for (id, _) in program.steps() {
        let found = evaluate_step(algebra, program, id, members, &values, &Outcomes::default());
        if !found.present.residue {
            return None;
        }
        values.push(found.value);
    }
    Some(values)
}

/// What a step is at a point.
pub(super) struct Found {
    pub(super) value: Numbers,
    /// Which parts its value has. A part is missing where a divisor is zero, a root does not exist,
    /// or a sign cannot be decided, or where it was missing before.
    pub(super) present: Parts,
    /// Which parts of its operands it lost.
    pub(super) lost: Parts,
}

/// The value of one step, from those of the steps before it, with outcomes that are taken for some
/// comparisons.
pub(super) fn evaluate_step(
    algebra: &Algebra,
    program: &Program<'_>,
    id: StepId,
    members: &[Numbers],
    values: &[Numbers],
    outcomes: &Outcomes,
) -> Found {
    let value = |id: StepId| &values[id.index()];
    let scalar = |id: StepId| numbers::coefficient(value(id), Blade::SCALAR);
    let value = match program.step(id) {
        Step::Operand(number) => members[*number].clone(),
        Step::Constant(blade, factor) => Numbers::from([(*blade, Number::from_ratio(*factor))]),
        Step::Unary(operation, a) => numbers::unary(algebra, *operation, value(*a)),
        Step::Binary(product, a, b) => numbers::product(algebra, *product, value(*a), value(*b)),
        Step::Sandwich(m, x) => {
            let parity = program.parity(*m);
            let is_odd = parity.map_or_else(|| numbers::is_odd(value(*m)), |p| p == Parity::Odd);
            numbers::sandwich(algebra, value(*m), is_odd, value(*x))
        }
        Step::Sum(a, b) => {
            let mut sum = value(*a).clone();
            for (&blade, &number) in value(*b) {
                numbers::add(&mut sum, blade, number);
            }
            sum
        }
        Step::Quotient(a, b) => {
            let divisor = scalar(*b);
            let inverse = divisor.recip();
            let value = numbers::scaled(value(*a), inverse);
            return Found::new(value, divisor.parts(), inverse.parts());
        }
        Step::Negative(a) => numbers::scaled(value(*a), -Number::ONE),
        Step::Coefficient(a, blade) => {
            Numbers::from([(Blade::SCALAR, numbers::coefficient(value(*a), *blade))])
        }
        Step::Select(condition, a, b) => {
            let condition = scalar(*condition);
            let chosen = |holds: bool| value(if holds { *a } else { *b });
            let by_residue = chosen(condition.residue() != Some(Residue::ZERO));
            let by_real = chosen(condition.real().holds());
            let real = Parts {
                residue: false,
                real: true,
            };
            let both = numbers::with_parts_of(by_residue, by_real, real);
            numbers::only(&both, condition.parts())
        }
        Step::Function(function, arguments) => {
            let arguments: Vec<_> = arguments.iter().map(|&id| scalar(id)).collect();
            let result = Number::function(*function, &arguments, outcomes);
            let every = arguments.iter().map(|x| x.parts());
            let before = every.fold(Parts::BOTH, Parts::and);
            let value = Numbers::from([(Blade::SCALAR, result)]);
            let before = if *function == Function::Select {
                result.parts()
            } else {
                before
            };
            return Found::new(value, before, result.parts());
        }
    };
    Found::new(value, Parts::BOTH, Parts::BOTH)
}

impl Found {
    fn new(value: Numbers, before: Parts, present: Parts) -> Self {
        let lost = before.without(present);
        Self {
            value,
            present,
            lost,
        }
    }
}

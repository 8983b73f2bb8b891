//! The plain meaning of a program, over the prime field.

use super::{Parity, Program, Step, StepId};
use crate::algebra::{Algebra, Blade};
use crate::ir::{Outcomes, Residue};
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
        let value = evaluate_step(algebra, program, id, members, &values, &Outcomes::default())?;
        values.push(value);
    }
    Some(values)
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
) -> Option<Numbers> {
    let value = |id: StepId| &values[id.index()];
    let scalar = |id: StepId| numbers::coefficient(value(id), Blade::SCALAR);
    Some(match program.step(id) {
        Step::Operand(number) => members[*number].clone(),
        Step::Constant(blade, factor) => Numbers::from([(*blade, Residue::from_ratio(*factor))]),
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
            if divisor == Residue::ZERO {
                return None;
            }
            numbers::scaled(value(*a), divisor.recip())
        }
        Step::Negative(a) => numbers::scaled(value(*a), -Residue::ONE),
        Step::Coefficient(a, blade) => {
            Numbers::from([(Blade::SCALAR, numbers::coefficient(value(*a), *blade))])
        }
        Step::Select(condition, a, b) => {
            let holds = scalar(*condition) != Residue::ZERO;
            value(if holds { *a } else { *b }).clone()
        }
        Step::Function(function, arguments) => {
            let arguments: Vec<_> = arguments.iter().map(|&id| scalar(id)).collect();
            let result = function.evaluate_with(&arguments, outcomes);
            let is_constant = program.is_constant(id);
            let result = result.or_else(|| is_constant.then(|| function.stand_in(&arguments)));
            Numbers::from([(Blade::SCALAR, result?)])
        }
    })
}

//! A random point of the operands' types, and the values of a program's steps there.

use super::choices::Goal;
use super::evaluate::evaluate_step;
use super::{Program, Step, StepId};
use crate::algebra::{Algebra, Blade};
use crate::ir::{Function, Number, Outcomes, Parts, Residue};
use crate::member::{self, Numbers, numbers};

/// A point of the operands' types, and what the steps are there.
#[derive(Clone, Debug, Default)]
pub(super) struct Point {
    pub(super) members: Vec<Numbers>,
    pub(super) values: Vec<Numbers>,
    /// Steps whose value exists in neither part here.
    pub(super) missing: Vec<StepId>,
    /// The outcomes that some comparisons have here.
    pub(super) wanted: Goal,
    /// The same by the numbers that are compared.
    pub(super) outcomes: Outcomes,
}

/// What a point is drawn again for.
pub(super) struct Patience {
    /// Whether a root must be a residue.
    pub(super) with_real_roots: bool,
    /// The parts that must exist.
    pub(super) parts: Parts,
}

impl Point {
    /// Evaluates the missing steps, up to the first that loses a part which is waited for.
    pub(super) fn extend(
        &mut self,
        algebra: &Algebra,
        program: &Program<'_>,
        patience: &Patience,
    ) -> Result<(), (StepId, Parts)> {
        for (id, step) in program.steps_from(self.values.len()) {
            if let Step::Function(function, arguments) = step
                && let Some((_, holds)) = self.wanted.iter().find(|(wanted, _)| *wanted == id)
            {
                let numbers = arguments.iter().map(|part| self.scalar(*part).residue());
                let numbers: Option<Vec<_>> = numbers.collect();
                if let Some(numbers) = numbers {
                    self.outcomes.set(*function, &numbers, *holds);
                }
            }
            let (members, values) = (&self.members, &self.values);
            let found = evaluate_step(algebra, program, id, members, values, &self.outcomes);
            let mut lost = found.lost;
            lost.residue |=
                patience.with_real_roots && is_variable_root(program, id) && !is_real(&found.value);
            let awaited = lost.and(patience.parts);
            if awaited.residue {
                let parts = Parts {
                    real: false,
                    ..awaited
                };
                return Err((id, parts));
            }
            if awaited.real {
                return Err((id, awaited));
            }
            if !found.present.any() {
                self.missing.push(id);
            }
            self.values.push(found.value);
        }
        Ok(())
    }

    /// The scalar that a step is.
    pub(super) fn scalar(&self, id: StepId) -> Number {
        numbers::coefficient(&self.values[id.index()], Blade::SCALAR)
    }

    /// Takes some parts of some operands of another point; of all, if none are named.
    pub(super) fn redraw(&mut self, operands: &[usize], other: Self, parts: Parts) {
        self.values.clear();
        self.missing.clear();
        self.outcomes = Outcomes::default();
        for (operand, member) in other.members.into_iter().enumerate() {
            if operands.is_empty() || operands.contains(&operand) {
                let own = &mut self.members[operand];
                *own = numbers::with_parts_of(own, &member, parts);
            }
        }
    }
}

/// A point at which nothing is evaluated yet.
pub(super) fn start(
    algebra: &Algebra,
    program: &Program<'_>,
    seed: u64,
    with_reals: bool,
) -> Option<Point> {
    let mut sequence = member::sequence(seed).with_reals(with_reals);
    let members = program.operands.iter();
    let members: Option<Vec<_>> = members
        .map(|kind| member::sample(algebra, kind, &mut sequence))
        .collect();
    members.map(|members| Point {
        members,
        ..Point::default()
    })
}

/// Whether a step is a root of what depends on operands.
pub(super) fn is_variable_root(program: &Program<'_>, id: StepId) -> bool {
    is_root(program.step(id)) && !program.is_constant(id)
}

pub(super) fn is_root(step: &Step) -> bool {
    matches!(
        step,
        Step::Function(Function::SquareRoot | Function::Hypotenuse, _)
    )
}

pub(super) fn is_real(value: &Numbers) -> bool {
    let mut residues = value.values().filter_map(|number| number.residue());
    residues.all(Residue::is_real)
}

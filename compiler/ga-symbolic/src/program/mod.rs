//! Programs: the operations of a function in the order in which they are computed, each stored
//! once.
//!
//! A [`Program`] stands between the source and the graph. Its steps are operations on whole
//! multivectors; which rule works a step out, and which of its coefficients are needed at all, is
//! decided when it is lowered. Calls of other functions are copied in, so that rules apply
//! across them.

pub mod build;
mod choices;
pub mod conformal;
mod coverage;
mod elementary;
mod evaluate;
mod formulas;
mod limits;
mod mismatch;
mod operation_error;
mod parametrised;
mod place;
mod point;
mod step;
mod witness;

pub use evaluate::evaluate;
pub use limits::MAX_STEPS;
pub use mismatch::{Mismatch, Remedy, with_remedy};
pub use operation_error::OperationError;
pub use parametrised::{Parametrised, is_same};
pub use step::{Parity, Step, StepId};
pub use witness::Witness;

use std::collections::HashMap;

use crate::algebra::{Blade, Product, Ratio};
use crate::define::TypeDefinition;
use crate::expression::Expression;
use crate::ir::Facts;

/// The blades of a step, each with its coefficient where that is the same for all operands.
pub type Support = Vec<(Blade, Option<Ratio>)>;

/// The steps of a function. A step comes after everything that it reads.
#[derive(Clone, Default)]
pub struct Program<'a> {
    /// The types of the operands; a plain number is [`TypeDefinition::scalar`].
    pub operands: Vec<&'a TypeDefinition>,
    steps: Vec<Step>,
    constant: Vec<bool>,
    /// The fractions that some steps are.
    numbers: Vec<Option<Ratio>>,
    known: HashMap<Step, StepId>,
    facts: HashMap<StepId, Facts>,
    kinds: HashMap<StepId, &'a TypeDefinition>,
    parities: HashMap<StepId, Parity>,
    operations: HashMap<StepId, Vec<StepId>>,
    written: HashMap<StepId, &'a TypeDefinition>,
    has_signs: bool,
    supports: HashMap<StepId, Support>,
}

impl<'a> Program<'a> {
    /// The program that only names its operands.
    #[must_use]
    pub fn new(operands: &[&'a TypeDefinition]) -> Self {
        let mut program = Self::default();
        for kind in operands {
            program.operand(kind);
        }
        program
    }

    /// The program of one expression, and its last step.
    #[must_use]
    pub fn of_expression(
        operands: &[&'a TypeDefinition],
        expression: &Expression,
    ) -> (Self, StepId) {
        let mut program = Self::new(operands);
        let result = program.expression(expression);
        (program, result)
    }

    /// A further operand.
    pub fn operand(&mut self, kind: &'a TypeDefinition) -> StepId {
        let number = self.operands.len();
        self.operands.push(kind);
        self.push(Step::Operand(number))
    }

    /// A step; one that is there already is not added again.
    pub fn push(&mut self, step: Step) -> StepId {
        if let Some(&id) = self.known.get(&step) {
            return id;
        }
        let number = self.number(&step);
        let step = match (step, number) {
            // Functions of fractions and choices by them are exact.
            (Step::Function(..), Some(number)) => {
                return self.push(Step::Constant(Blade::SCALAR, number));
            }
            (Step::Select(condition, a, b), _) => match self.numbers[condition.index()] {
                Some(holds) => return if holds.is_zero() { b } else { a },
                None => Step::Select(condition, a, b),
            },
            (step, _) => step,
        };
        self.numbers.push(number);
        let id = StepId(self.steps.len());
        let is_constant = !matches!(step, Step::Operand(_))
            && step.reads().iter().all(|read| self.is_constant(*read));
        self.constant.push(is_constant);
        // The root of a square is its absolute value.
        self.has_signs |= match &step {
            Step::Function(function, _) => function.properties().depends_on_signs,
            Step::Select(..) => true,
            _ => false,
        };
        self.steps.push(step.clone());
        self.known.insert(step, id);
        id
    }

    /// The fraction that a step is, if it is a number and made of numbers.
    fn number(&self, step: &Step) -> Option<Ratio> {
        let of = |id: &StepId| self.numbers[id.index()];
        let number = match step {
            Step::Constant(Blade::SCALAR, value) => *value,
            Step::Binary(Product::Geometric, a, b) => of(a)? * of(b)?,
            Step::Sum(a, b) => of(a)? + of(b)?,
            Step::Quotient(a, b) => of(a)? * of(b)?.recip()?,
            Step::Negative(a) => -of(a)?,
            Step::Coefficient(a, Blade::SCALAR) => of(a)?,
            Step::Function(function, arguments) => {
                let arguments: Option<Vec<Ratio>> = arguments.iter().map(of).collect();
                function.exact(&arguments?)?
            }
            _ => return None,
        };
        (!number.is_out_of_range()).then_some(number)
    }

    /// The step at a place.
    #[must_use]
    pub fn step(&self, id: StepId) -> &Step {
        &self.steps[id.index()]
    }

    /// Whether a step has the same value for all operands.
    #[must_use]
    pub fn is_constant(&self, id: StepId) -> bool {
        self.constant[id.index()]
    }

    /// All steps in order.
    pub fn steps(&self) -> impl DoubleEndedIterator<Item = (StepId, &Step)> {
        let ids = (0..self.steps.len()).map(StepId);
        ids.zip(&self.steps)
    }

    /// The steps from a place on.
    pub(crate) fn steps_from(&self, place: usize) -> impl Iterator<Item = (StepId, &Step)> {
        let rest = self.steps.get(place..).unwrap_or_default();
        (place..).map(StepId).zip(rest)
    }

    /// Whether there are absolute values or roots.
    pub(crate) fn has_signs(&self) -> bool {
        self.has_signs
    }

    /// The number of steps.
    #[must_use]
    pub fn len(&self) -> usize {
        self.steps.len()
    }

    /// Whether there is no step.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    /// States facts of a step beyond what its operation tells.
    pub fn state(&mut self, id: StepId, facts: Facts) {
        let known = self.facts.entry(id).or_default();
        *known = known.and(facts);
    }

    /// The facts that were stated of a step.
    #[must_use]
    pub fn stated(&self, id: StepId) -> Facts {
        self.facts.get(&id).copied().unwrap_or_default()
    }

    /// States the parity of a step, which its terms need not show: those of one parity may cancel.
    pub fn state_parity(&mut self, id: StepId, parity: Parity) {
        self.parities.insert(id, parity);
    }

    /// The parity that was stated of a step.
    #[must_use]
    pub fn parity(&self, id: StepId) -> Option<Parity> {
        self.parities.get(&id).copied()
    }

    /// States that a step is what an operation of several steps gives, and its operands.
    pub fn state_operation(&mut self, id: StepId, operands: Vec<StepId>) {
        self.operations.entry(id).or_insert(operands);
    }

    /// The operands of the operation that gives a step, as it is written: those that were stated,
    /// or else the steps that it reads.
    #[must_use]
    pub fn operands_of(&self, id: StepId) -> Vec<StepId> {
        let stated = self.operations.get(&id).cloned();
        stated.unwrap_or_else(|| self.step(id).reads())
    }

    /// The place of a step, if there is one like it.
    #[must_use]
    pub fn find(&self, step: &Step) -> Option<StepId> {
        self.known.get(step).copied()
    }

    /// States the type by which a step is declared where it is written.
    pub fn state_written(&mut self, id: StepId, kind: &'a TypeDefinition) {
        self.written.entry(id).or_insert(kind);
    }

    /// The type by which a step is declared, if it is.
    #[must_use]
    pub fn written(&self, id: StepId) -> Option<&'a TypeDefinition> {
        self.written.get(&id).copied()
    }

    /// States the blades that a step has. Others cancel, though its terms need not show it.
    pub fn state_support(&mut self, id: StepId, support: Support) {
        self.supports.insert(id, support);
    }

    /// The blades that were stated of a step.
    #[must_use]
    pub fn support(&self, id: StepId) -> Option<&Support> {
        self.supports.get(&id)
    }

    /// States that a step is always a member of a type.
    pub fn state_kind(&mut self, id: StepId, kind: &'a TypeDefinition) {
        self.kinds.insert(id, kind);
    }

    /// The type that a step was stated to be a member of.
    #[must_use]
    pub fn kind(&self, id: StepId) -> Option<&'a TypeDefinition> {
        self.kinds.get(&id).copied()
    }

    /// Whether the type of some step is known.
    #[must_use]
    pub fn has_kinds(&self) -> bool {
        !self.kinds.is_empty()
    }

    /// The steps of an expression over the operands; the last one is its value.
    pub fn expression(&mut self, expression: &Expression) -> StepId {
        let step = match expression {
            Expression::Operand(number) => Step::Operand(*number),
            Expression::Constant(value) => Step::Constant(Blade::SCALAR, *value),
            Expression::Unary(operation, a) => Step::Unary(*operation, self.expression(a)),
            Expression::Binary(product, a, b) => {
                Step::Binary(*product, self.expression(a), self.expression(b))
            }
            Expression::Sandwich(a, b) => Step::Sandwich(self.expression(a), self.expression(b)),
            Expression::Sum(a, b) => Step::Sum(self.expression(a), self.expression(b)),
            Expression::Quotient(a, b) => Step::Quotient(self.expression(a), self.expression(b)),
            Expression::Negative(a) => Step::Negative(self.expression(a)),
        };
        self.push(step)
    }
}

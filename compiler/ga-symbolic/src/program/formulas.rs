//! Formulas of some operands: how they are taken out of programs, put into others and evaluated.

use super::build::Builder;
use super::{OperationError, Program, Step, StepId, evaluate};
use crate::algebra::{Algebra, Product};
use crate::define::Formulas;
use crate::ir::Function;
use crate::member::Numbers;

impl Formulas {
    /// The formulas of some steps of a program in some others, which become the operands.
    #[must_use]
    pub fn of_program(program: &Program<'_>, operands: &[StepId], results: &[StepId]) -> Self {
        let mut own = Program::default();
        let mut images: Vec<Option<StepId>> = vec![None; program.len()];
        for (number, id) in operands.iter().enumerate() {
            images[id.index()] = Some(own.push(Step::Operand(number)));
        }
        let mut is_needed = vec![false; program.len()];
        for id in results {
            is_needed[id.index()] = true;
        }
        for (id, step) in program.steps().rev() {
            if is_needed[id.index()] && images[id.index()].is_none() {
                for read in step.reads() {
                    is_needed[read.index()] = true;
                }
            }
        }
        for (id, step) in program.steps() {
            if is_needed[id.index()] && images[id.index()].is_none() {
                let step = step.mapped(|read| images[read.index()].unwrap_or(read));
                images[id.index()] = Some(own.push(step));
            }
        }
        let results = results.iter().filter_map(|id| images[id.index()]);
        Self {
            results: results.collect(),
            steps: own.steps().map(|(_, step)| step.clone()).collect(),
        }
    }

    /// The same with `a (1/s)` for each quotient `a/s`, where 1/s is zero if s is: so they have a
    /// value for every operand.
    #[must_use]
    pub fn with_values_everywhere(&self) -> Self {
        let mut own = Program::default();
        let mut images: Vec<StepId> = Vec::with_capacity(self.steps.len());
        for step in &self.steps {
            let step = step.mapped(|read| images[read.index()]);
            images.push(match step {
                Step::Quotient(a, divisor) if !own.is_constant(divisor) => {
                    let inverse = own.push(Step::Function(Function::Reciprocal, vec![divisor]));
                    own.push(Step::Binary(Product::Geometric, inverse, a))
                }
                step => own.push(step),
            });
        }
        Self {
            results: self.results.iter().map(|id| images[id.index()]).collect(),
            steps: own.steps().map(|(_, step)| step.clone()).collect(),
        }
    }

    /// Adds the steps to a program over some of its steps.
    ///
    /// # Errors
    /// A step that has no value there.
    pub fn insert(
        &self,
        builder: &mut Builder<'_>,
        operands: &[StepId],
    ) -> Result<Vec<StepId>, OperationError> {
        let mut images: Vec<StepId> = Vec::with_capacity(self.steps.len());
        for step in &self.steps {
            images.push(match step {
                Step::Operand(number) => operands[*number],
                step => builder.push(step.mapped(|read| images[read.index()]))?,
            });
        }
        Ok(self.results.iter().map(|id| images[id.index()]).collect())
    }

    /// The values for some operands; `None` where one does not exist.
    #[must_use]
    pub fn evaluate(&self, algebra: &Algebra, operands: &[Numbers]) -> Option<Vec<Numbers>> {
        let mut own = Program::default();
        for step in &self.steps {
            own.push(step.clone());
        }
        let values = evaluate(algebra, &own, operands)?;
        let results = self.results.iter();
        Some(results.map(|id| values[id.index()].clone()).collect())
    }
}

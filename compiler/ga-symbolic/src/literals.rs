//! Long numbers as operands of their own.
//!
//! Numbers in a function are exact fractions, which rules can combine. The product of several long
//! ones needs more than 128 bits. Then the program is compiled once more with its numbers as
//! operands, which no rule combines; what depends on them alone is left to Rust's compiler.

use crate::algebra::{Blade, Product, Ratio};
use crate::define::TypeDefinition;
use crate::program::{Program, Step, StepId};

/// The largest numerator and denominator of a number that stays a fraction.
const LARGEST: i128 = 64;

/// A program whose long numbers are operands, after those that it has.
pub struct Opaque<'a> {
    /// The program.
    pub program: Program<'a>,
    /// The numbers, in the order of their operands.
    pub literals: Vec<Ratio>,
    /// The steps that stand for those of the program that it was made of.
    steps: Vec<StepId>,
}

impl<'a> Opaque<'a> {
    /// Makes operands of the long numbers of a program. `scalar` is the type of plain numbers.
    pub fn new(program: &Program<'a>, scalar: &'a TypeDefinition) -> Self {
        let mut literals: Vec<Ratio> = Vec::new();
        for (_, step) in program.steps() {
            if let Step::Constant(_, value) = step
                && value.height() > LARGEST
                && !literals.contains(value)
            {
                literals.push(*value);
            }
        }
        let count = program.operands.len();
        let operands = program.operands.iter().copied();
        let operands: Vec<_> = operands.chain(literals.iter().map(|_| scalar)).collect();
        let mut result = Self {
            program: Program::new(&operands),
            literals,
            steps: Vec::with_capacity(program.len()),
        };
        for (id, step) in program.steps() {
            let next = result.step(step, count);
            result.program.state(next, program.stated(id));
            if let Some(parity) = program.parity(id) {
                result.program.state_parity(next, parity);
            }
            if let Some(kind) = program.kind(id) {
                result.program.state_kind(next, kind);
            }
            result.steps.push(next);
        }
        result
    }

    /// The step that stands for one of the former program.
    pub fn image(&self, id: StepId) -> StepId {
        self.steps[id.index()]
    }

    fn step(&mut self, step: &Step, operands: usize) -> StepId {
        if let Step::Constant(blade, value) = step
            && let Some(place) = self.literals.iter().position(|other| other == value)
        {
            let number = self.program.push(Step::Operand(operands + place));
            if *blade == Blade::SCALAR {
                return number;
            }
            let blade = self.program.push(Step::Constant(*blade, Ratio::ONE));
            return self
                .program
                .push(Step::Binary(Product::Geometric, number, blade));
        }
        let step = step.mapped(|id| self.steps[id.index()]);
        self.program.push(step)
    }
}

//! Warnings about values that are always zero, which is probably a mistake.

use super::{Bound, Resolver};
use crate::algebra::{Product, Ratio};
use crate::diag::Warning;
use crate::ir::Function;
use crate::parse::{Formula, FormulaKind};
use crate::program::{Step, StepId};

impl Resolver<'_, '_> {
    /// Notes a product of values that are not zero, if it is zero for all operands. What is written
    /// in a function that is called is noted where that function is compiled itself.
    pub(super) fn note_product(
        &mut self,
        formula: &Formula,
        product: Product,
        [a, b]: [StepId; 2],
        result: StepId,
    ) {
        let witness = &self.builder.witness;
        let is_surprising = self.callers.len() == 1
            && witness.is_zero(result)
            && !witness.is_zero(a)
            && !witness.is_zero(b);
        if !is_surprising || self.zeros.contains(&result) {
            return;
        }
        let grades = |id: StepId| {
            let blades = witness.blades(id);
            let grades: Vec<u32> = blades.iter().map(|blade| blade.grade()).collect();
            (grades.iter().copied().min(), grades.iter().copied().max())
        };
        let (first, second) = (grades(a), grades(b));
        let reason = match product {
            Product::LeftContraction if first.0 > second.1 => {
                "; the left contraction `a | b` is zero where a has a higher grade than b"
            }
            Product::RightContraction if first.1 < second.0 => {
                "; the right contraction of a by b is zero where a has a lower grade than b"
            }
            _ => "",
        };
        self.zeros.push(result);
        self.warnings.push(Warning {
            span: formula.place().start(),
            message: format!("`{formula}` is zero for all operands{reason}"),
        });
    }

    /// Whether a step depends on a quotient or on a function of operands that does not exist, or
    /// has another form, somewhere: `abs(x) - x` is zero at the points where x has a root.
    fn has_limits(&self, id: StepId) -> bool {
        let program = &self.builder.program;
        let mut is_read = vec![false; program.len()];
        is_read[id.index()] = true;
        for (id, step) in program
            .steps()
            .rev()
            .filter(|(id, _)| !program.is_constant(*id))
        {
            if !is_read[id.index()] {
                continue;
            }
            match step {
                Step::Quotient(_, divisor) if !program.is_constant(*divisor) => return true,
                Step::Function(
                    Function::SquareRoot | Function::Absolute | Function::Hypotenuse,
                    _,
                ) => return true,
                _ => {}
            }
            for read in step.reads() {
                is_read[read.index()] = true;
            }
        }
        false
    }

    /// Notes the parts of the result that are always zero, unless they are written as zero.
    pub(super) fn note_result(&mut self, formula: &Formula, value: &Bound) {
        let is_written = matches!(formula.kind, FormulaKind::Number(Ratio::ZERO));
        match (value, &formula.kind) {
            (Bound::One(id), _) => {
                let is_zero = self.builder.witness.is_zero(*id) && !self.has_limits(*id);
                if is_zero && !is_written && !self.zeros.contains(id) {
                    self.zeros.push(*id);
                    self.warnings.push(Warning {
                        span: formula.place().start(),
                        message: format!("the result `{formula}` is zero for all operands"),
                    });
                }
            }
            (Bound::Parts(parts), FormulaKind::Tuple(formulas) | FormulaKind::Array(formulas)) => {
                for (part, formula) in parts.iter().zip(formulas) {
                    self.note_result(formula, part);
                }
            }
            (Bound::Parts(_) | Bound::Condition(_), _) => {}
        }
    }
}

//! Warnings about values that are always zero, which is hardly what their author means.

use super::super::StepId;
use super::{Bound, Resolver};
use crate::algebra::{Product, Ratio};
use crate::diag::Warning;
use crate::parse::{Formula, FormulaKind};

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

    /// Notes the parts of the result that are always zero, unless they are written as zero.
    pub(super) fn note_result(&mut self, formula: &Formula, value: &Bound) {
        let is_written = matches!(formula.kind, FormulaKind::Number(Ratio::ZERO));
        match (value, &formula.kind) {
            (Bound::One(id), _) => {
                let is_zero = self.builder.witness.is_zero(*id);
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

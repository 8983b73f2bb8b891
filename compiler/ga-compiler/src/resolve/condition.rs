//! Conditions, and values that depend on them.

use super::error::{ResolveError, ResolveErrorKind};
use super::{Bound, Resolver, Result};
use crate::ir::Function;
use crate::parse::{Formula, Operator, Place};
use crate::program::Step;
use crate::program::StepId;

/// The operation that chooses one of two values by a condition: `select(x < y, a, b)`.
pub(super) const SELECT: &str = "select";

impl<'s> Resolver<'_, 's> {
    /// `a < b` and the like.
    pub(super) fn comparison(
        &mut self,
        operator: Operator,
        [a, b]: [StepId; 2],
        place: Place,
    ) -> Result<StepId> {
        for operand in [a, b] {
            if !self.builder.witness.is_scalar(operand) {
                let found = self.builder.blade_names(operand);
                let kind = ResolveErrorKind::ComparedNotScalar(operator.symbol(), found);
                return Err(ResolveError::new(kind, place));
            }
        }
        match operator {
            Operator::LessOrEqual => self.condition_step(Function::LessOrEqual, vec![a, b], place),
            Operator::Greater => self.condition_step(Function::Less, vec![b, a], place),
            Operator::GreaterOrEqual => {
                self.condition_step(Function::LessOrEqual, vec![b, a], place)
            }
            Operator::Equal => self.condition_step(Function::Equal, vec![a, b], place),
            Operator::NotEqual => {
                let equal = self.condition_step(Function::Equal, vec![a, b], place)?;
                self.condition_step(Function::Not, vec![equal], place)
            }
            _ => self.condition_step(Function::Less, vec![a, b], place),
        }
    }

    /// `!a`, `a && b` or `a || b`.
    pub(super) fn condition_step(
        &mut self,
        function: Function,
        arguments: Vec<StepId>,
        place: Place,
    ) -> Result<StepId> {
        let step = self.builder.push(Step::Function(function, arguments));
        step.map_err(|error| ResolveError::new(ResolveErrorKind::Operator(error), place))
    }

    /// The value of a formula that must be a condition; `what` needs it.
    pub(super) fn condition(&mut self, formula: &'s Formula, what: &'static str) -> Result<StepId> {
        let value = self.formula(formula)?;
        as_condition(value, formula, what)
    }

    /// `select(condition, a, b)`: element by element where a and b are tuples or arrays.
    pub(super) fn select(
        &mut self,
        formula: &Formula,
        [condition, a, b]: [&'s Formula; 3],
    ) -> Result<Bound> {
        let condition = self.condition(condition, SELECT)?;
        let (first, second) = (self.formula(a)?, self.formula(b)?);
        self.one_of(formula, condition, &first, &second)
    }

    fn one_of(
        &mut self,
        formula: &Formula,
        condition: StepId,
        a: &Bound,
        b: &Bound,
    ) -> Result<Bound> {
        match (a, b) {
            (Bound::One(a), Bound::One(b)) => {
                let step = self.builder.push(Step::Select(condition, *a, *b));
                step.map(Bound::One).map_err(|error| {
                    let kind = ResolveErrorKind::Operation(SELECT, error);
                    ResolveError::new(kind, formula.place())
                })
            }
            (Bound::Parts(first), Bound::Parts(second)) if first.len() == second.len() => {
                let pairs = first.iter().zip(second.iter());
                let parts: Result<_> = pairs
                    .map(|(a, b)| self.one_of(formula, condition, a, b))
                    .collect();
                Ok(Bound::Parts(parts?))
            }
            (Bound::Condition(_), _) | (_, Bound::Condition(_)) => {
                let kind = ResolveErrorKind::ConditionAsValue;
                Err(ResolveError::new(kind, formula.place()))
            }
            (a, b) => {
                let kind = ResolveErrorKind::UnequalChoices(a.count(), b.count());
                Err(ResolveError::new(kind, formula.place()))
            }
        }
    }
}

/// A value that must be a condition; `what` needs it.
pub(super) fn as_condition(value: Bound, formula: &Formula, what: &'static str) -> Result<StepId> {
    match value {
        Bound::Condition(id) => Ok(id),
        Bound::One(_) | Bound::Parts(_) => {
            let kind = ResolveErrorKind::NotCondition(what);
            Err(ResolveError::new(kind, formula.place()))
        }
    }
}

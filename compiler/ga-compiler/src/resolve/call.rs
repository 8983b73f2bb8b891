//! Calls: of operations, of coefficients, and of functions, which are copied in.

use std::collections::BTreeMap;

use syn::Ident;

use super::condition::SELECT;
use super::error::{ResolveError, ResolveErrorKind};
use super::limits::{MAX_CALL_DEPTH, MAX_CALLS};
use super::operation::{GRADE, Operation};
use super::place::{ENDPOINTS, POINT};
use super::power::POWER;
use super::{Bound, Resolver, Result};
use crate::algebra::Unary;
use crate::member::numbers;
use crate::nearest::nearest;
use crate::parse::{Block, Formula, FormulaKind, FunctionSyntax, Place};
use crate::program::{Step, StepId};

impl<'s> Resolver<'_, 's> {
    /// A call of a function or an operation; the name of a blade gives its coefficient.
    pub(super) fn call(
        &mut self,
        formula: &'s Formula,
        name: &Ident,
        arguments: &'s [Formula],
    ) -> Result<Bound> {
        let text = name.to_string();
        if let Some((callee, block)) = self.block.function(&text) {
            return self.inline(formula, name, callee, block, arguments);
        }
        if text == GRADE {
            check_count(name, 2, arguments)?;
            return self.part_of_grade(formula, &arguments[0], &arguments[1]);
        }
        if text == POWER {
            check_count(name, 2, arguments)?;
            return self.power(formula, &arguments[0], &arguments[1]);
        }
        if text == SELECT {
            if let [condition, a, b] = arguments {
                return self.select(formula, [condition, a, b]);
            }
            check_count(name, 3, arguments)?;
        }
        if text == POINT || text == ENDPOINTS {
            if let [operand] = arguments {
                return match text == POINT {
                    true => self.point(formula, operand),
                    false => self.endpoints(formula, operand),
                };
            }
            check_count(name, 1, arguments)?;
        }
        if let Some((known, operation)) = Operation::from_name(&text) {
            check_count(name, operation.arity(), arguments)?;
            return self.apply(formula, known, operation, arguments);
        }
        if let [operand] = arguments
            && self.definition.algebra.names().resolve(&text).is_ok()
        {
            return self.coefficient(operand, name);
        }
        let known = Operation::names().map(str::to_owned);
        let hint = nearest(&text, self.block.names().chain(known));
        let kind = ResolveErrorKind::UnknownOperation(text, hint);
        Err(ResolveError::new(kind, Place::of(name.span())))
    }

    fn apply(
        &mut self,
        formula: &Formula,
        name: &'static str,
        operation: Operation,
        arguments: &'s [Formula],
    ) -> Result<Bound> {
        let operands: Result<Vec<_>> = arguments.iter().map(|a| self.single(a)).collect();
        let operands = operands?;
        if let (Operation::Product(product), [left, right], [a, b]) =
            (operation, arguments, operands.as_slice())
        {
            self.check_scalars(formula, product, [left, right], [*a, *b])?;
        }
        let step = operation.apply(&mut self.builder, &operands);
        let step = step.map_err(|error| {
            let kind = ResolveErrorKind::Operation(name, error);
            ResolveError::new(kind, formula.place())
        })?;
        if let (Operation::Product(product), [a, b]) = (operation, operands.as_slice()) {
            self.note_product(formula, product, [*a, *b], step);
        }
        Ok(Bound::One(step))
    }

    fn part_of_grade(
        &mut self,
        formula: &Formula,
        operand: &'s Formula,
        grade: &Formula,
    ) -> Result<Bound> {
        let FormulaKind::Number(number) = grade.kind else {
            let kind = ResolveErrorKind::GradeNotWhole;
            return Err(ResolveError::new(kind, grade.place()));
        };
        if !number.is_integer() || number.is_negative() {
            let kind = ResolveErrorKind::GradeNotWhole;
            return Err(ResolveError::new(kind, grade.place()));
        }
        // No blade has a grade beyond the range.
        let grade = u32::try_from(number.numerator()).unwrap_or(u32::MAX);
        let operand = self.single(operand)?;
        let step = self.builder.push(Step::Unary(Unary::Grade(grade), operand));
        step.map(Bound::One).map_err(|error| {
            let kind = ResolveErrorKind::Operation(GRADE, error);
            ResolveError::new(kind, formula.place())
        })
    }

    /// A call of another function: its body in place of the call.
    fn inline(
        &mut self,
        formula: &'s Formula,
        name: &Ident,
        function: &'s FunctionSyntax,
        block: &'s Block,
        arguments: &'s [Formula],
    ) -> Result<Bound> {
        self.check_call(name, function)?;
        check_count(name, function.operands.len(), arguments)?;
        let mut scope = BTreeMap::new();
        for (operand, argument) in function.operands.iter().zip(arguments) {
            let value = self.formula(argument)?;
            let shape = self.shape(&operand.shape)?;
            let what = format!("operand `{}` of `{name}`", operand.name);
            let mut parts = Vec::new();
            self.fit(argument, &value, &shape, &what, &mut parts)?;
            if operand.is_blade
                && let Some((part, _)) = parts.iter().find(|(part, _)| !self.is_blade(*part))
            {
                let found = self.builder.blade_names(*part);
                let kind = ResolveErrorKind::NotBlade(what, found);
                return Err(ResolveError::new(kind, argument.place()));
            }
            scope.insert(operand.name.to_string(), value);
        }
        std::mem::swap(&mut self.scope, &mut scope);
        let caller = std::mem::replace(&mut self.block, block);
        self.callers.push(function);
        let value = self.body(function);
        self.callers.pop();
        self.block = caller;
        self.scope = scope;
        let value = value?;
        let shape = self.shape(&function.result)?;
        let what = format!("the value of `{name}`");
        self.fit(formula, &value, &shape, &what, &mut Vec::new())?;
        Ok(value)
    }

    /// Whether a step is an outer product of vectors.
    fn is_blade(&self, step: StepId) -> bool {
        let algebra = &self.definition.algebra;
        let mut values = self.builder.witness.values(step);
        values.all(|value| numbers::is_blade(algebra, value))
    }

    /// Checks that a call does not lead back to a function that is being copied in, and that there
    /// are not too many.
    fn check_call(&mut self, name: &Ident, function: &FunctionSyntax) -> Result<()> {
        let error = |kind| Err(ResolveError::new(kind, Place::of(name.span())));
        let mut callers = self.callers.iter();
        if let Some(first) = callers.position(|caller| std::ptr::eq(*caller, function)) {
            let name = |caller: &&FunctionSyntax| {
                caller.name.as_ref().map_or(String::new(), Ident::to_string)
            };
            let circle = self.callers[first..].iter().map(name).collect();
            return error(ResolveErrorKind::Recursion(circle));
        }
        if self.callers.len() > MAX_CALL_DEPTH {
            return error(ResolveErrorKind::CallsTooDeep(name.to_string()));
        }
        self.calls += 1;
        if self.calls > MAX_CALLS {
            return error(ResolveErrorKind::TooManyCalls);
        }
        Ok(())
    }
}

fn check_count(name: &Ident, wanted: usize, arguments: &[Formula]) -> Result<()> {
    if arguments.len() == wanted {
        return Ok(());
    }
    let kind = ResolveErrorKind::OperandCount(name.to_string(), wanted, arguments.len());
    Err(ResolveError::new(kind, Place::of(name.span())))
}

//! Formulas: names, numbers, operators and elements.

use syn::Ident;

use super::condition::as_condition;
use super::error::{ResolveError, ResolveErrorKind};
use super::limits::MAX_LEVELS;
use super::{Bound, Resolver, Result};
use crate::algebra::{Blade, NameError, Product, Ratio};
use crate::define::{Role, TypeDefinition};
use crate::ir::Function;
use crate::nearest::nearest;
use crate::parse::{Formula, FormulaKind, Operator, Place};
use crate::program::build::Outcome;
use crate::program::{Step, StepId};

impl<'s> Resolver<'_, 's> {
    /// The value of a formula.
    pub(super) fn formula(&mut self, formula: &'s Formula) -> Result<Bound> {
        if self.level == MAX_LEVELS {
            let kind = ResolveErrorKind::LevelsTooDeep;
            return Err(ResolveError::new(kind, formula.place()));
        }
        self.level += 1;
        let value = match &formula.kind {
            FormulaKind::Parenthesised(inner) => self.formula(inner),
            FormulaKind::Name(name) => self.name(name),
            FormulaKind::Number(value) => {
                let step = self.builder.number(*value);
                operator_value(step, formula.place())
            }
            FormulaKind::Negative(operand) => self.negative(formula, operand),
            FormulaKind::Not(operand) => self
                .condition(operand, "!")
                .and_then(|id| self.condition_step(Function::Not, vec![id], formula.place()))
                .map(Bound::Condition),
            FormulaKind::Binary(..) => self.row(formula),
            FormulaKind::Call(name, arguments) => self.call(formula, name, arguments),
            FormulaKind::Coefficient(operand, name) => self.coefficient(operand, name),
            FormulaKind::Element(operand, place) => self.element(formula, operand, *place),
            FormulaKind::Tuple(parts) | FormulaKind::Array(parts) => self.parts(parts),
        };
        self.level -= 1;
        value
    }

    /// The value of a formula that must be one multivector.
    pub(super) fn single(&mut self, formula: &'s Formula) -> Result<StepId> {
        let value = self.formula(formula)?;
        as_multivector(&value, formula)
    }

    /// The coefficient of a blade: `operand.name` or `name(operand)`.
    pub(super) fn coefficient(&mut self, operand: &'s Formula, name: &Ident) -> Result<Bound> {
        let value = self.single(operand)?;
        let error = |kind| Err(ResolveError::new(kind, Place::of(name.span())));
        let types = &self.definition.types;
        if let Some(parameter) = self.parametrised.named(types, value, &name.to_string()) {
            return Ok(Bound::One(parameter));
        }
        let algebra = &self.definition.algebra;
        let Ok(named) = algebra.names().resolve(&name.to_string()) else {
            return error(ResolveErrorKind::UnknownBlade(name.to_string()));
        };
        if !self.builder.witness.blades(value).contains(&named.blade)
            && !self.has_blade(value, named.blade)
        {
            return error(ResolveErrorKind::MissingBlade {
                formula: operand.to_string(),
                blade: name.to_string(),
                found: self.builder.blade_names(value),
            });
        }
        let mut step = self.builder.push(Step::Coefficient(value, named.blade));
        if named.is_negative {
            step = step.and_then(|id| self.builder.push(Step::Negative(id)));
        }
        operator_value(step, operand.place())
    }

    /// Whether a step is an operand whose type lists the blade, even if it is always zero.
    fn has_blade(&self, value: StepId, blade: Blade) -> bool {
        match self.builder.program.step(value) {
            Step::Operand(number) => self.builder.program.operands[*number]
                .coefficient(blade)
                .is_some(),
            _ => false,
        }
    }

    fn negative(&mut self, formula: &Formula, operand: &'s Formula) -> Result<Bound> {
        let operand = self.single(operand)?;
        let step = self.builder.push(Step::Negative(operand));
        operator_value(step, formula.place())
    }

    /// Operators in a row, from the left, without recursion: `a + b - c`.
    fn row(&mut self, formula: &'s Formula) -> Result<Bound> {
        let (mut first, mut operations) = (formula, Vec::new());
        while let FormulaKind::Binary(operator, left, right) = &first.kind {
            operations.push((*operator, &**left, &**right, first));
            first = left;
        }
        let mut value = self.formula(first)?;
        for (operator, left, right, whole) in operations.into_iter().rev() {
            value = self.binary(operator, (left, value), right, whole)?;
        }
        Ok(value)
    }

    /// An operator on a value that is known, with its formula, and on another formula; `whole` is
    /// the formula of both.
    fn binary(
        &mut self,
        operator: Operator,
        (left, value): (&Formula, Bound),
        right: &'s Formula,
        whole: &Formula,
    ) -> Result<Bound> {
        let place = whole.place();
        let junction = match operator {
            Operator::Both => Some(Function::And),
            Operator::Either => Some(Function::Or),
            _ => None,
        };
        if let Some(junction) = junction {
            let first = as_condition(value, left, operator.symbol())?;
            let second = self.condition(right, operator.symbol())?;
            let step = self.condition_step(junction, vec![first, second], place);
            return step.map(Bound::Condition);
        }
        let value = as_multivector(&value, left)?;
        let operand = self.single(right)?;
        if operator.is_comparison() {
            let step = self.comparison(operator, [value, operand], place);
            return step.map(Bound::Condition);
        }
        if operator == Operator::Divide && !self.builder.witness.is_scalar(operand) {
            let found = self.builder.blade_names(operand);
            let kind = ResolveErrorKind::DivisorNotScalar(found);
            return Err(ResolveError::new(kind, right.place()));
        }
        if let Some(product) = product(operator) {
            self.check_scalars(whole, product, [left, right], [value, operand])?;
        }
        let step = self
            .operation(operator, value, operand)
            .map_err(|error| ResolveError::new(ResolveErrorKind::Operator(error), place))?;
        if let Some(product) = product(operator) {
            self.note_product(whole, product, [value, operand], step);
        }
        Ok(Bound::One(step))
    }

    /// The value of an operator on multivectors.
    fn operation(&mut self, operator: Operator, a: StepId, b: StepId) -> Outcome {
        let step = match (product(operator), operator) {
            (Some(product), _) => Step::Binary(product, a, b),
            (None, Operator::Divide) => Step::Quotient(a, b),
            (None, Operator::Subtract) => Step::Sum(a, self.builder.push(Step::Negative(b))?),
            // Operators on conditions do not come here.
            (None, _) => Step::Sum(a, b),
        };
        self.builder.push(step)
    }

    fn parts(&mut self, parts: &'s [Formula]) -> Result<Bound> {
        let parts: Result<_> = parts.iter().map(|part| self.formula(part)).collect();
        Ok(Bound::Parts(parts?))
    }

    fn element(&mut self, formula: &Formula, operand: &'s Formula, place: usize) -> Result<Bound> {
        let Bound::Parts(parts) = self.formula(operand)? else {
            let kind = ResolveErrorKind::NoElements;
            return Err(ResolveError::new(kind, operand.place()));
        };
        parts.get(place).cloned().ok_or_else(|| {
            let kind = ResolveErrorKind::ElementOutOfRange(parts.len());
            ResolveError::new(kind, formula.place())
        })
    }

    fn name(&mut self, name: &Ident) -> Result<Bound> {
        let place = Place::of(name.span());
        let name = name.to_string();
        if let Some(bound) = self.scope.get(&name) {
            return Ok(bound.clone());
        }
        if let Some(kind) = self.definition.type_named(&name) {
            if kind.is_constant() {
                return operator_value(self.constant_member(kind), place);
            }
            let kind = ResolveErrorKind::TypeAsValue(name);
            return Err(ResolveError::new(kind, place));
        }
        let known = self.definition.algebra.names().resolve(&name);
        if known.is_err()
            && name == "pi"
            && let Some(value) = pi()
        {
            return operator_value(self.builder.number(value), place);
        }
        let kind = match known {
            Ok(named) => {
                let sign = if named.is_negative { -1 } else { 1 };
                let step = Step::Constant(named.blade, Ratio::integer(sign));
                return operator_value(self.builder.push(step), place);
            }
            Err(NameError::Ambiguous(readings)) => ResolveErrorKind::AmbiguousBlade(name, readings),
            Err(_) => {
                let hint = nearest(&name, self.scope.keys().cloned());
                ResolveErrorKind::UnknownName(name, hint)
            }
        };
        Err(ResolveError::new(kind, place))
    }

    /// The only member of a type without stored coefficients.
    fn constant_member(&mut self, kind: &TypeDefinition) -> Outcome {
        let mut sum = self.builder.number(Ratio::ZERO)?;
        for (place, coefficient) in kind.coefficients.iter().enumerate() {
            let Role::Constant(value) = coefficient.role else {
                continue;
            };
            let value = if coefficient.is_negative {
                -value
            } else {
                value
            };
            let blade = self
                .builder
                .push(Step::Constant(coefficient.blade, value))?;
            sum = if place == 0 {
                blade
            } else {
                self.builder.push(Step::Sum(sum, blade))?
            };
        }
        Ok(sum)
    }
}

/// π, to more digits than double precision has.
fn pi() -> Option<Ratio> {
    Ratio::new(314_159_265_358_979_323_846_264_338_328, 10_i128.pow(29))
}

/// The product that an operator stands for.
const fn product(operator: Operator) -> Option<Product> {
    match operator {
        Operator::Multiply => Some(Product::Geometric),
        Operator::Xor => Some(Product::Wedge),
        Operator::Or => Some(Product::LeftContraction),
        Operator::And => Some(Product::Vee),
        _ => None,
    }
}

/// A value that must be one multivector.
fn as_multivector(value: &Bound, formula: &Formula) -> Result<StepId> {
    let kind = match value {
        Bound::One(id) => return Ok(*id),
        Bound::Parts(_) => ResolveErrorKind::SeveralValues,
        Bound::Condition(_) => ResolveErrorKind::ConditionAsValue,
    };
    Err(ResolveError::new(kind, formula.place()))
}

/// The value of an operator, a name or a number.
pub(super) fn operator_value(step: Outcome, place: Place) -> Result<Bound> {
    step.map(Bound::One)
        .map_err(|error| ResolveError::new(ResolveErrorKind::Operator(error), place))
}

//! From syntax to programs: names get their meaning here, and what has none is refused at its
//! token.

use proc_macro2::Span;
use syn::{Error, Ident, Result};

use super::build::{Builder, Outcome};
use super::mismatch::Mismatch;
use super::nearest::nearest;
use super::{Program, Step, StepId, Witness};
use crate::algebra::{Blade, NameError, Product, Ratio, Unary};
use crate::define::{Definition, Role, SCALAR_TYPE, TypeDefinition};
use crate::ir::Function;
use crate::parse::{
    Block, Formula, FormulaKind, FunctionSyntax, LetSyntax, Operator, PatternSyntax, ShapeSyntax,
};
use crate::signature::{Operand, Shape};

/// How deep calls of other functions may go.
const MAX_DEPTH: usize = 64;

/// How many calls of other functions may be copied into one.
const MAX_CALLS: usize = 4096;

/// A function whose names have their meaning.
pub struct Resolved<'a> {
    /// The steps.
    pub program: Program<'a>,
    /// Their values at random points.
    pub witness: Witness,
    /// The operands.
    pub operands: Vec<Operand>,
    /// For each operand of the program, whether it is uniform.
    pub uniform: Vec<bool>,
    /// The type of the result.
    pub result: Shape,
    /// The steps that come out, each with its type.
    pub outputs: Vec<(StepId, Option<&'a TypeDefinition>)>,
}

/// What a name stands for.
#[derive(Clone)]
enum Bound {
    One(StepId),
    Parts(Vec<Bound>),
}

/// Resolves a function; `block` holds the functions that it may call.
///
/// # Errors
/// The first name, type or operation that has no meaning, at its token; a result that is no member
/// of its type.
pub fn resolve<'a>(
    definition: &'a Definition,
    function: &FunctionSyntax,
    block: &Block,
) -> Result<Resolved<'a>> {
    resolve_with(definition, function, block, &|mismatch| {
        mismatch.to_string()
    })
}

/// The same, where `explain` says in words why a value is not of its declared type.
///
/// # Errors
/// As for [`resolve`].
pub fn resolve_with<'a>(
    definition: &'a Definition,
    function: &FunctionSyntax,
    block: &Block,
    explain: &dyn Fn(&Mismatch<'_, '_>) -> String,
) -> Result<Resolved<'a>> {
    let mut resolver = Resolver {
        definition,
        builder: Builder {
            algebra: &definition.algebra,
            program: Program::default(),
            witness: Witness::default(),
            operands: Vec::new(),
        },
        block,
        explain,
        scope: Vec::new(),
        depth: 0,
        calls: 0,
    };
    let mut uniform = Vec::new();
    let scalar = scalar_type();
    for operand in &function.operands {
        let shape = resolver.shape(&operand.shape)?;
        let bound = resolver.operand(&shape, scalar);
        uniform.resize(resolver.builder.program.operands.len(), operand.is_uniform);
        resolver.bind(&operand.name, bound);
        resolver.builder.operands.push(Operand {
            name: operand.name.clone(),
            shape,
            is_uniform: operand.is_uniform,
        });
    }
    if !resolver
        .builder
        .witness
        .extend(&definition.algebra, &resolver.builder.program)
    {
        return Err(Error::new(
            Span::call_site(),
            "no members of the operands' types were found",
        ));
    }
    let result = resolver.shape(&function.result)?;
    let value = resolver.body(function)?;
    let mut outputs = Vec::new();
    resolver.fit(&function.value, &value, &result, "the result", &mut outputs)?;
    state_kinds(definition, &mut resolver.builder);
    let Builder {
        program,
        witness,
        operands,
        ..
    } = resolver.builder;
    Ok(Resolved {
        program,
        witness,
        operands,
        uniform,
        result,
        outputs,
    })
}

/// States which steps are members of a type with derived coefficients: points that have been moved,
/// for instance.
fn state_kinds<'a>(definition: &'a Definition, builder: &mut Builder<'a>) {
    let is_derived = |kind: &&TypeDefinition| {
        let mut roles = kind.coefficients.iter().map(|c| &c.role);
        roles.any(|role| matches!(role, Role::Derived(_)))
    };
    let kinds: Vec<_> = definition.types.iter().filter(is_derived).collect();
    let products: Vec<StepId> = builder
        .program
        .steps()
        .filter(|(_, step)| {
            matches!(
                step,
                Step::Binary(Product::Geometric, ..) | Step::Sandwich(..) | Step::Quotient(..)
            )
        })
        .map(|(id, _)| id)
        .collect();
    for id in products {
        let is_member = |kind: &&&TypeDefinition| {
            let reasons = builder.witness.reasons(builder.algebra, id, Some(kind));
            reasons.is_empty()
        };
        if let Some(kind) = kinds.iter().find(is_member) {
            builder.program.state_kind(id, kind);
        }
    }
}

/// The type of plain numbers, which every algebra shares.
fn scalar_type() -> &'static TypeDefinition {
    thread_local! {
        static SCALAR: &'static TypeDefinition = Box::leak(Box::new(TypeDefinition::scalar()));
    }
    SCALAR.with(|kind| *kind)
}

struct Resolver<'a, 's> {
    definition: &'a Definition,
    builder: Builder<'a>,
    block: &'s Block,
    explain: &'s dyn Fn(&Mismatch<'_, '_>) -> String,
    scope: Vec<(Ident, Bound)>,
    depth: usize,
    calls: usize,
}

impl<'a, 's> Resolver<'a, 's> {
    fn shape(&self, syntax: &ShapeSyntax) -> Result<Shape> {
        Shape::resolve(self.definition, syntax)
    }

    fn operand(&mut self, shape: &Shape, scalar: &'static TypeDefinition) -> Bound {
        let kind = match shape {
            Shape::Scalar => scalar,
            Shape::Type(index) => &self.definition.types[*index],
            Shape::Array(element, count) => {
                let parts = (0..*count).map(|_| self.operand(element, scalar));
                return Bound::Parts(parts.collect());
            }
            Shape::Tuple(parts) => {
                let parts = parts.iter().map(|part| self.operand(part, scalar));
                return Bound::Parts(parts.collect());
            }
        };
        Bound::One(self.builder.program.operand(kind))
    }

    /// Names of values and of functions are kept apart, so that a value may be called like a
    /// function.
    fn bind(&mut self, name: &Ident, bound: Bound) {
        self.scope.push((name.clone(), bound));
    }

    fn body(&mut self, function: &FunctionSyntax) -> Result<Bound> {
        for statement in &function.statements {
            self.statement(statement)?;
        }
        self.formula(&function.value)
    }

    fn statement(&mut self, statement: &LetSyntax) -> Result<()> {
        let value = self.formula(&statement.value)?;
        if let Some(shape) = &statement.shape {
            let shape = self.shape(shape)?;
            self.fit(&statement.value, &value, &shape, "this", &mut Vec::new())?;
        }
        self.destructure(&statement.pattern, value)
    }

    fn destructure(&mut self, pattern: &PatternSyntax, value: Bound) -> Result<()> {
        match (pattern, value) {
            (PatternSyntax::Name(name), value) => {
                self.bind(name, value);
                Ok(())
            }
            (PatternSyntax::Wildcard, _) => Ok(()),
            (PatternSyntax::Parts(_, patterns), Bound::Parts(parts))
                if patterns.len() == parts.len() =>
            {
                let pairs = patterns.iter().zip(parts);
                pairs
                    .into_iter()
                    .try_for_each(|(pattern, part)| self.destructure(pattern, part))
            }
            (PatternSyntax::Parts(span, patterns), value) => {
                let found = match value {
                    Bound::One(_) => "one value".to_owned(),
                    Bound::Parts(parts) => format!("{} values", parts.len()),
                };
                let message = format!("the pattern has {} parts for {found}", patterns.len());
                Err(Error::new(*span, message))
            }
        }
    }

    /// Checks a value against a type, and lists the steps with their types.
    fn fit(
        &mut self,
        place: &Formula,
        value: &Bound,
        shape: &Shape,
        what: &str,
        outputs: &mut Vec<(StepId, Option<&'a TypeDefinition>)>,
    ) -> Result<()> {
        let part_of = |index: usize| match &place.kind {
            FormulaKind::Tuple(parts) | FormulaKind::Array(parts) => parts.get(index),
            _ => None,
        };
        let shapes: Vec<&Shape> = match (value, shape) {
            (Bound::One(id), Shape::Scalar | Shape::Type(_)) => {
                let kind = match shape {
                    Shape::Type(index) => Some(&self.definition.types[*index]),
                    _ => None,
                };
                self.check(place, *id, kind, what)?;
                outputs.push((*id, kind));
                return Ok(());
            }
            (Bound::Parts(parts), Shape::Array(element, count)) if parts.len() == *count => {
                vec![&**element; *count]
            }
            (Bound::Parts(parts), Shape::Tuple(shapes)) if parts.len() == shapes.len() => {
                shapes.iter().collect()
            }
            (value, shape) => {
                let found = match value {
                    Bound::One(_) => "one value".to_owned(),
                    Bound::Parts(parts) => format!("{} values", parts.len()),
                };
                let wanted = shape.to_text(self.definition);
                return Err(place.error(format!("{what} is {found}, where `{wanted}` is declared")));
            }
        };
        let Bound::Parts(parts) = value else {
            return Ok(());
        };
        for (index, (part, shape)) in parts.iter().zip(shapes).enumerate() {
            let inner = part_of(index).unwrap_or(place);
            self.fit(inner, part, shape, what, outputs)?;
        }
        Ok(())
    }

    fn check(
        &mut self,
        place: &Formula,
        id: StepId,
        kind: Option<&'a TypeDefinition>,
        what: &str,
    ) -> Result<()> {
        let algebra = &self.definition.algebra;
        let reasons = self.builder.witness.reasons(algebra, id, kind);
        if reasons.is_empty() {
            if let Some(kind) = kind {
                self.builder.program.state(id, kind.facts);
            }
            return Ok(());
        }
        let name = kind.map_or(SCALAR_TYPE.to_owned(), |kind| kind.name.to_string());
        let mismatch = Mismatch::new(&self.builder, self.definition, id, kind, reasons);
        let message = (self.explain)(&mismatch);
        Err(place.error(format!("{what} is no `{name}`: {message}")))
    }

    fn formula(&mut self, formula: &Formula) -> Result<Bound> {
        let one = |step: Outcome| {
            step.map(Bound::One)
                .map_err(|message| formula.error(message))
        };
        match &formula.kind {
            FormulaKind::Parenthesised(inner) => self.formula(inner),
            FormulaKind::Name(name) => self.name(name),
            FormulaKind::Number(value) => one(self.builder.number(*value)),
            FormulaKind::Negative(operand) => {
                let operand = self.single(operand)?;
                one(self.builder.push(Step::Negative(operand)))
            }
            FormulaKind::Binary(operator, a, b) => {
                let (a, right) = (self.single(a)?, self.single(b)?);
                if *operator == Operator::Divide && !self.builder.witness.is_scalar(right) {
                    let found = self.builder.blade_names(right);
                    let message = format!(
                        "the divisor is no scalar, it has {found}; `a * inverse(b)` divides by a blade or a versor"
                    );
                    return Err(b.error(message));
                }
                one(self.binary(*operator, a, right))
            }
            FormulaKind::Call(name, arguments) => self.call(formula, name, arguments),
            FormulaKind::Coefficient(operand, name) => {
                let value = self.single(operand)?;
                self.coefficient(operand, value, name)
            }
            FormulaKind::Element(operand, place) => {
                let Bound::Parts(parts) = self.formula(operand)? else {
                    return Err(operand.error("this is one value, without elements"));
                };
                let count = parts.len();
                let part = parts.into_iter().nth(*place);
                part.ok_or_else(|| {
                    formula.error(format!("there are {count} elements, the first is 0"))
                })
            }
            FormulaKind::Tuple(parts) | FormulaKind::Array(parts) => {
                let parts: Result<_> = parts.iter().map(|part| self.formula(part)).collect();
                Ok(Bound::Parts(parts?))
            }
        }
    }

    /// The value of a formula that must be one multivector.
    fn single(&mut self, formula: &Formula) -> Result<StepId> {
        match self.formula(formula)? {
            Bound::One(id) => Ok(id),
            Bound::Parts(_) => Err(formula.error("this is several values, where one is needed")),
        }
    }

    fn binary(&mut self, operator: Operator, a: StepId, b: StepId) -> Outcome {
        let product = match operator {
            Operator::Multiply => Product::Geometric,
            Operator::Xor => Product::Wedge,
            Operator::Or => Product::LeftContraction,
            Operator::And => Product::Vee,
            Operator::Divide => return self.builder.push(Step::Quotient(a, b)),
            Operator::Add => return self.builder.push(Step::Sum(a, b)),
            Operator::Subtract => {
                let negative = self.builder.push(Step::Negative(b))?;
                return self.builder.push(Step::Sum(a, negative));
            }
        };
        self.builder.push(Step::Binary(product, a, b))
    }

    fn name(&mut self, name: &Ident) -> Result<Bound> {
        let bound = self.scope.iter().rev().find(|(known, _)| known == name);
        if let Some((_, bound)) = bound {
            return Ok(bound.clone());
        }
        let constant = self.definition.type_named(&name.to_string());
        if let Some(kind) = constant {
            if !kind.is_constant() {
                let message = format!("`{name}` is a type, not a value");
                return Err(Error::new(name.span(), message));
            }
            return self
                .constant_member(kind)
                .map(Bound::One)
                .map_err(|message| Error::new(name.span(), message));
        }
        match self.definition.algebra.names().resolve(&name.to_string()) {
            Ok(named) => {
                let sign = if named.is_negative { -1 } else { 1 };
                let step = Step::Constant(named.blade, Ratio::integer(sign));
                let id = self.builder.push(step);
                id.map(Bound::One)
                    .map_err(|message| Error::new(name.span(), message))
            }
            Err(NameError::Ambiguous(readings)) => {
                let readings = readings.join(" or ");
                let message = format!("`{name}` can be read as {readings}");
                Err(Error::new(name.span(), message))
            }
            Err(_) => {
                let scope = self.scope.iter().map(|(known, _)| known.to_string());
                let near = nearest(&name.to_string(), scope);
                let message =
                    format!("unknown name `{name}`: no operand, no `let`, no blade{near}");
                Err(Error::new(name.span(), message))
            }
        }
    }

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

    fn coefficient(&mut self, operand: &Formula, value: StepId, name: &Ident) -> Result<Bound> {
        let algebra = &self.definition.algebra;
        let Ok(named) = algebra.names().resolve(&name.to_string()) else {
            let message = format!("`{name}` is no blade of the algebra");
            return Err(Error::new(name.span(), message));
        };
        if !self.builder.witness.blades(value).contains(&named.blade)
            && !self.has_blade(value, named.blade)
        {
            let found = self.builder.blade_names(value);
            let message = format!("`{operand}` has no blade {name}; it has {found}");
            return Err(Error::new(name.span(), message));
        }
        let id = self.builder.push(Step::Coefficient(value, named.blade));
        let signed = match id {
            Ok(id) if named.is_negative => self.builder.push(Step::Negative(id)),
            other => other,
        };
        signed
            .map(Bound::One)
            .map_err(|message| operand.error(message))
    }

    /// Whether a step is an operand whose type lists the blade, be it zero.
    fn has_blade(&self, value: StepId, blade: Blade) -> bool {
        match self.builder.program.step(value) {
            Step::Operand(number) => self.builder.program.operands[*number]
                .coefficient(blade)
                .is_some(),
            _ => false,
        }
    }

    fn call(&mut self, formula: &Formula, name: &Ident, arguments: &[Formula]) -> Result<Bound> {
        let text = name.to_string();
        if let Some(callee) = self.block.function(&text) {
            return self.inline(formula, name, callee, arguments);
        }
        let Some(operation) = Operation::from_name(&text) else {
            if let [operand] = arguments
                && self.definition.algebra.names().resolve(&text).is_ok()
            {
                let value = self.single(operand)?;
                return self.coefficient(operand, value, name);
            }
            let known = self.block.names();
            let known = known.chain(Operation::names().map(str::to_owned));
            let near = nearest(&text, known);
            let message = format!(
                "the algebra has no operation `{text}`, and this block no function of that name{near}"
            );
            return Err(Error::new(name.span(), message));
        };
        let wanted = operation.arity();
        if arguments.len() != wanted {
            let plural = if wanted == 1 { "" } else { "s" };
            let message = format!(
                "`{text}` takes {wanted} operand{plural}, not {}",
                arguments.len()
            );
            return Err(Error::new(name.span(), message));
        }
        if let Operation::Grade = operation {
            let grade = match &arguments[1].kind {
                FormulaKind::Number(value) if value.is_integer() && !value.is_negative() => {
                    u32::try_from(value.numerator()).unwrap_or(u32::MAX)
                }
                _ => return Err(arguments[1].error("the grade must be a whole number")),
            };
            let operand = self.single(&arguments[0])?;
            let step = self.builder.push(Step::Unary(Unary::Grade(grade), operand));
            return step
                .map(Bound::One)
                .map_err(|message| formula.error(message));
        }
        let operands: Result<Vec<_>> = arguments.iter().map(|a| self.single(a)).collect();
        operation
            .apply(&mut self.builder, &operands?)
            .map(Bound::One)
            .map_err(|message| {
                let link = if message.starts_with("the ") { ":" } else { "" };
                formula.error(format!("`{text}`{link} {message}"))
            })
    }

    /// A call of another function: its body in place of the call.
    fn inline(
        &mut self,
        formula: &Formula,
        name: &Ident,
        (function, block): (&'s FunctionSyntax, &'s Block),
        arguments: &[Formula],
    ) -> Result<Bound> {
        self.calls += 1;
        if self.calls > MAX_CALLS {
            let message = format!(
                "more than {MAX_CALLS} calls are copied into this function; bind results that are used twice with `let`"
            );
            return Err(Error::new(name.span(), message));
        }
        if self.depth == MAX_DEPTH {
            let message =
                format!("`{name}` calls itself; functions are copied in where they are called");
            return Err(Error::new(name.span(), message));
        }
        if arguments.len() != function.operands.len() {
            let message = format!(
                "`{name}` takes {} operands, not {}",
                function.operands.len(),
                arguments.len()
            );
            return Err(Error::new(name.span(), message));
        }
        let mut scope = Vec::new();
        for (operand, argument) in function.operands.iter().zip(arguments) {
            let value = self.formula(argument)?;
            let shape = self.shape(&operand.shape)?;
            let what = format!("operand `{}` of `{name}`", operand.name);
            self.fit(argument, &value, &shape, &what, &mut Vec::new())?;
            scope.push((operand.name.clone(), value));
        }
        std::mem::swap(&mut self.scope, &mut scope);
        let caller = std::mem::replace(&mut self.block, block);
        self.depth += 1;
        let value = self.body(function);
        self.depth -= 1;
        self.block = caller;
        self.scope = scope;
        let value = value?;
        let shape = self.shape(&function.result)?;
        self.fit(
            formula,
            &value,
            &shape,
            &format!("the value of `{name}`"),
            &mut Vec::new(),
        )?;
        Ok(value)
    }
}

/// An operation with a name.
#[derive(Clone, Copy)]
enum Operation {
    Unary(Unary),
    Grade,
    Product(Product),
    Sandwich,
    Function(Function),
    Reciprocal,
    Exponential,
    Logarithm,
    Norm,
    NormSquared,
    Normalize,
    Inverse,
}

impl Operation {
    const NAMES: [(&'static str, Self); 30] = [
        ("reverse", Self::Unary(Unary::Reverse)),
        ("rev", Self::Unary(Unary::Reverse)),
        ("involute", Self::Unary(Unary::Involute)),
        ("conjugate", Self::Unary(Unary::Conjugate)),
        ("dual", Self::Unary(Unary::Dual)),
        ("undual", Self::Unary(Unary::Undual)),
        ("grade", Self::Grade),
        ("geometric", Self::Product(Product::Geometric)),
        ("wedge", Self::Product(Product::Wedge)),
        ("left_contraction", Self::Product(Product::LeftContraction)),
        (
            "right_contraction",
            Self::Product(Product::RightContraction),
        ),
        ("scalar_product", Self::Product(Product::ScalarProduct)),
        ("commutator", Self::Product(Product::Commutator)),
        ("vee", Self::Product(Product::Vee)),
        ("sandwich", Self::Sandwich),
        ("transform", Self::Sandwich),
        ("sqrt", Self::Function(Function::SquareRoot)),
        ("abs", Self::Function(Function::Absolute)),
        ("sin", Self::Function(Function::Sine)),
        ("cos", Self::Function(Function::Cosine)),
        ("atan2", Self::Function(Function::ArcTangent)),
        ("ln", Self::Function(Function::NaturalLogarithm)),
        ("recip", Self::Reciprocal),
        ("exp", Self::Exponential),
        ("log", Self::Logarithm),
        ("norm", Self::Norm),
        ("norm_squared", Self::NormSquared),
        ("normalize", Self::Normalize),
        ("inverse", Self::Inverse),
        ("inv", Self::Inverse),
    ];

    fn names() -> impl Iterator<Item = &'static str> {
        Self::NAMES.iter().map(|(name, _)| *name)
    }

    fn from_name(name: &str) -> Option<Self> {
        let found = Self::NAMES.iter().find(|(known, _)| *known == name);
        found.map(|(_, operation)| *operation)
    }

    fn arity(self) -> usize {
        match self {
            Self::Grade | Self::Product(_) | Self::Sandwich => 2,
            Self::Function(function) => function.arity(),
            _ => 1,
        }
    }

    fn apply(self, builder: &mut Builder<'_>, operands: &[StepId]) -> Outcome {
        let first = operands[0];
        match self {
            Self::Unary(operation) => builder.push(Step::Unary(operation, first)),
            Self::Product(product) => builder.push(Step::Binary(product, first, operands[1])),
            Self::Sandwich => builder.push(Step::Sandwich(first, operands[1])),
            Self::Function(function) => builder.function(function, operands),
            Self::Reciprocal => {
                let one = builder.number(Ratio::ONE)?;
                if !builder.witness.is_scalar(first) {
                    let found = builder.blade_names(first);
                    return Err(format!("takes a scalar, and this has {found}"));
                }
                builder.push(Step::Quotient(one, first))
            }
            Self::Exponential => builder.exponential(first),
            Self::Logarithm => builder.logarithm(first),
            Self::Norm => builder.norm(first),
            Self::NormSquared => builder.norm_squared(first),
            Self::Normalize => builder.normalize(first),
            Self::Inverse => builder.inverse(first),
            Self::Grade => Err("takes a whole number".to_owned()),
        }
    }
}

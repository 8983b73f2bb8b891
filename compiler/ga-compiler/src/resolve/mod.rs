//! From syntax to programs: names get their meaning here, and an error points at the token of a
//! name that has none.

mod blade;
mod call;
mod condition;
mod error;
mod formula;
mod limits;
mod operands;
mod operation;
mod parameters;
mod place;
mod power;
mod scalars;
mod shape;
#[cfg(test)]
mod tests;
mod zero;

pub(crate) use blade::as_blade;
pub use error::{ResolveError, ResolveErrorKind, ValueCount};
pub(crate) use parameters::resolve_parameters;
pub(crate) use shape::resolve_shape;

use std::collections::BTreeMap;
use std::rc::Rc;

use syn::Ident;

use crate::algebra::Product;
use crate::define::{Definition, Role, SCALAR_TYPE, TypeDefinition};
use crate::diag::Warning;
use crate::parse::{
    Block, Formula, FormulaKind, FunctionSyntax, LetSyntax, PatternSyntax, Place, ShapeSyntax,
};
use crate::program::build::Builder;
use crate::program::{Mismatch, Parametrised, Program, Step, StepId, Witness};
use crate::signature::{Operand, Shape};

type Result<T> = std::result::Result<T, ResolveError>;

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
    /// The steps of the result, each with its type.
    pub outputs: Vec<(StepId, Option<&'a TypeDefinition>)>,
    /// What is allowed but is probably a mistake.
    pub warnings: Vec<Warning>,
}

/// Resolves a function; `block` holds the functions that it may call.
///
/// # Errors
/// The first name, type or operation that has no meaning, at its token; a result that is not a
/// member of its type.
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
/// What is read for a type by parameters may be of a blade only: `line & sphere` is a point pair if
/// the line is one. So where a value is not of such a type, operands of flats are taken for blades.
///
/// # Errors
/// As for [`resolve`].
pub fn resolve_with<'a>(
    definition: &'a Definition,
    function: &FunctionSyntax,
    block: &Block,
    explain: &dyn Fn(&Mismatch<'_, '_>) -> String,
) -> Result<Resolved<'a>> {
    let resolved = resolve_assuming(definition, function, block, explain, false);
    match resolved {
        Err(error) if is_of_parameters(definition, error.kind()) => {
            resolve_assuming(definition, function, block, explain, true).map_err(|_| error)
        }
        resolved => resolved,
    }
}

/// Whether a value is not of a type by parameters.
fn is_of_parameters(definition: &Definition, error: &ResolveErrorKind) -> bool {
    let ResolveErrorKind::TypeMismatch(_, name, _) = error else {
        return false;
    };
    let kind = definition.type_named(name);
    kind.is_some_and(|kind| kind.parameters.is_some())
}

fn resolve_assuming<'a>(
    definition: &'a Definition,
    function: &FunctionSyntax,
    block: &Block,
    explain: &dyn Fn(&Mismatch<'_, '_>) -> String,
    are_blades: bool,
) -> Result<Resolved<'a>> {
    let mut resolver = Resolver::new(definition, block, explain);
    resolver.are_blades = are_blades;
    resolver.callers.push(function);
    let uniform = resolver.operands(function)?;
    let result = resolver.shape(&function.result)?;
    let value = resolver.body(function)?;
    let mut outputs = Vec::new();
    resolver.fit(&function.value, &value, &result, "the result", &mut outputs)?;
    resolver.note_result(&function.value, &value);
    state_kinds(definition, &mut resolver.builder);
    let warnings = std::mem::take(&mut resolver.warnings);
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
        warnings,
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
                Step::Binary(Product::Geometric, ..)
                    | Step::Sandwich(..)
                    | Step::Quotient(..)
                    | Step::Select(..)
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

/// What a name stands for, or a formula gives.
#[derive(Clone)]
enum Bound {
    /// A multivector.
    One(StepId),
    /// A condition.
    Condition(StepId),
    /// The elements of a tuple or an array; shared, since names may be read many times.
    Parts(Rc<[Bound]>),
}

impl Bound {
    fn count(&self) -> ValueCount {
        match self {
            Self::One(_) => ValueCount::One,
            Self::Condition(_) => ValueCount::Condition,
            Self::Parts(parts) => ValueCount::Several(parts.len()),
        }
    }
}

struct Resolver<'a, 's> {
    definition: &'a Definition,
    builder: Builder<'a>,
    /// The functions that may be called.
    block: &'s Block,
    explain: &'s dyn Fn(&Mismatch<'_, '_>) -> String,
    /// The values that have a name; of several of one name the last.
    scope: BTreeMap<String, Bound>,
    /// The functions that are being copied in, each called by the one before.
    callers: Vec<&'s FunctionSyntax>,
    /// How many calls have been copied in.
    calls: usize,
    /// How many formulas are being computed, each a part of the one before.
    level: usize,
    warnings: Vec<Warning>,
    /// The steps of which was said that they are always zero.
    zeros: Vec<StepId>,
    /// The values of types by parameters.
    parametrised: Parametrised,
    /// Whether operands of flats are taken for blades, marked so or not.
    are_blades: bool,
}

impl<'a, 's> Resolver<'a, 's> {
    fn new(
        definition: &'a Definition,
        block: &'s Block,
        explain: &'s dyn Fn(&Mismatch<'_, '_>) -> String,
    ) -> Self {
        Self {
            definition,
            builder: Builder {
                algebra: &definition.algebra,
                program: Program::default(),
                witness: Witness::default(),
                operands: Vec::new(),
            },
            block,
            explain,
            scope: BTreeMap::new(),
            callers: Vec::new(),
            calls: 0,
            level: 0,
            warnings: Vec::new(),
            zeros: Vec::new(),
            parametrised: Parametrised::default(),
            are_blades: false,
        }
    }

    /// Draws random members of the operands' types.
    fn draw(&mut self, place: Place) -> Result<()> {
        let Builder {
            algebra,
            program,
            witness,
            ..
        } = &mut self.builder;
        if witness.extend(algebra, program) {
            return Ok(());
        }
        Err(ResolveError::new(ResolveErrorKind::NoOperands, place))
    }

    fn shape(&self, syntax: &ShapeSyntax) -> Result<Shape> {
        resolve_shape(self.definition, syntax)
    }

    /// Names of values and of functions are kept apart, so that a value may have the name of a
    /// function.
    fn bind(&mut self, name: &Ident, bound: Bound) {
        self.scope.insert(name.to_string(), bound);
    }

    fn body(&mut self, function: &'s FunctionSyntax) -> Result<Bound> {
        for statement in &function.statements {
            self.statement(statement)?;
        }
        self.formula(&function.value)
    }

    fn statement(&mut self, statement: &'s LetSyntax) -> Result<()> {
        let value = self.formula(&statement.value)?;
        if let Some(shape) = &statement.shape {
            let shape = self.shape(shape)?;
            self.fit(&statement.value, &value, &shape, "this", &mut Vec::new())?;
        }
        self.destructure(&statement.pattern, &value)
    }

    fn destructure(&mut self, pattern: &PatternSyntax, value: &Bound) -> Result<()> {
        match (pattern, value) {
            (PatternSyntax::Name(name), value) => {
                self.bind(name, value.clone());
                Ok(())
            }
            (PatternSyntax::Wildcard, _) => Ok(()),
            (PatternSyntax::Parts(_, patterns), Bound::Parts(parts))
                if patterns.len() == parts.len() =>
            {
                let mut pairs = patterns.iter().zip(parts.iter());
                pairs.try_for_each(|(pattern, part)| self.destructure(pattern, part))
            }
            (PatternSyntax::Parts(span, patterns), value) => {
                let kind = ResolveErrorKind::PatternParts(patterns.len(), value.count());
                Err(ResolveError::new(kind, Place::of(*span)))
            }
        }
    }

    /// Checks a value against a type, and lists the steps with their types. `what` names the value
    /// in errors.
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
        let (parts, shapes): (_, Vec<&Shape>) = match (value, shape) {
            (Bound::One(id), Shape::Type(index))
                if self.definition.types[*index].parameters.is_some() =>
            {
                return self.fit_parameters(place, *id, *index, what, outputs);
            }
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
                (parts, vec![&**element; *count])
            }
            (Bound::Parts(parts), Shape::Tuple(shapes)) if parts.len() == shapes.len() => {
                (parts, shapes.iter().collect())
            }
            (value, shape) => {
                let declared = shape.to_text(self.definition);
                let kind =
                    ResolveErrorKind::ShapeMismatch(what.to_owned(), value.count(), declared);
                return Err(ResolveError::new(kind, place.place()));
            }
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
                self.builder.program.state_written(id, kind);
            }
            return Ok(());
        }
        let name = kind.map_or(SCALAR_TYPE.to_owned(), |kind| kind.name.to_string());
        let mismatch = Mismatch::new(&self.builder, self.definition, id, kind, reasons);
        let reason = (self.explain)(&mismatch);
        let kind = ResolveErrorKind::TypeMismatch(what.to_owned(), name, reason);
        Err(ResolveError::new(kind, place.place()))
    }
}

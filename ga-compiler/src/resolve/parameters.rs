//! Types by parameters: their formulas in a declaration, and the parameters of values in functions.

use std::collections::BTreeMap;

use super::error::{ResolveError, ResolveErrorKind};
use super::{Bound, Resolver, Result};
use crate::algebra::{Product, Ratio, Unary};
use crate::define::{Coefficient, Definition, Formulas, Parameter, Parameters, TypeDefinition};
use crate::ir::Function;
use crate::member::numbers;
use crate::parse::{Block, Formula, ParametersSyntax, Place};
use crate::program::{Mismatch, OperationError, Step, StepId};

/// The name of the multivector in the formulas of a type.
const SELF: &str = "self";

/// A value of a type by parameters.
pub(super) struct Parametrised {
    /// The multivector.
    pub(super) value: StepId,
    /// The type.
    pub(super) index: usize,
    /// Its parameters.
    pub(super) parameters: Vec<StepId>,
}

/// Resolves the formulas of a type; the coefficients of its hull are those that it may have.
/// `parameters` have their types already.
///
/// # Errors
/// The first name or operation that has no meaning, or reading that is not the inverse.
pub(crate) fn resolve_parameters(
    definition: &Definition,
    syntax: &ParametersSyntax,
    parameters: Vec<Parameter>,
    hull: &TypeDefinition,
) -> Result<(Parameters, Vec<Coefficient>)> {
    let block = Block::default();
    let explain = |mismatch: &Mismatch<'_, '_>| mismatch.to_string();
    let mut resolver = Resolver::new(definition, &block, &explain);
    let place = syntax.value.place();
    let mut operands = Vec::new();
    for parameter in &parameters {
        let kind = parameter
            .index
            .map_or(&definition.scalar, |index| &definition.types[index]);
        let step = resolver.builder.program.operand(kind);
        resolver.bind(&parameter.name, Bound::One(step));
        operands.push(step);
    }
    resolver.draw(place)?;
    let value = resolver.single(&syntax.value)?;
    let blades = resolver.builder.witness.blades(value);
    let names: Vec<String> = blades
        .iter()
        .filter(|blade| hull.coefficient(**blade).is_none())
        .map(|blade| definition.algebra.names().name(*blade))
        .collect();
    if !names.is_empty() {
        let kind = ResolveErrorKind::NotInHull(hull.name.to_string(), names.join(", "));
        return Err(ResolveError::new(kind, place));
    }
    let coefficients = hull.coefficients.iter();
    let coefficients = coefficients.filter(|c| blades.contains(&c.blade)).cloned();
    let of_value = |results: &[StepId], operands: &[StepId]| {
        Formulas::of_program(&resolver.builder.program, operands, results)
    };
    let formulas = of_value(&[value], &operands);
    let readings = match syntax.readings.is_empty() {
        true => None,
        false => {
            let read = resolver.readings(syntax, &parameters, value)?;
            let program = &resolver.builder.program;
            let readings = Formulas::of_program(program, &[value], &read);
            resolver.check_readings(syntax, &formulas, &read, value)?;
            Some(readings.with_values_everywhere())
        }
    };
    let parameters = Parameters {
        list: parameters,
        value: formulas,
        readings,
    };
    Ok((parameters, coefficients.collect()))
}

impl<'a, 's> Resolver<'a, 's> {
    /// The steps of the parameters that are read of a value.
    fn readings(
        &mut self,
        syntax: &'s ParametersSyntax,
        parameters: &[Parameter],
        value: StepId,
    ) -> Result<Vec<StepId>> {
        self.scope = BTreeMap::from([(SELF.to_owned(), Bound::One(value))]);
        let mut read: Vec<Option<StepId>> = vec![None; parameters.len()];
        for reading in &syntax.readings {
            let error = |kind| ResolveError::new(kind, Place::of(reading.name.span()));
            let place = parameters.iter().position(|p| p.name == reading.name);
            let name = reading.name.to_string();
            match (reading.is_let, place) {
                (true, Some(_)) => return Err(error(ResolveErrorKind::LetOfParameter(name))),
                (true, None) => {
                    let bound = self.formula(&reading.value)?;
                    self.bind(&reading.name, bound);
                }
                (false, None) => return Err(error(ResolveErrorKind::NotParameter(name))),
                (false, Some(place)) if read[place].is_some() => {
                    return Err(error(ResolveErrorKind::ReadTwice(name)));
                }
                (false, Some(place)) => {
                    let step = self.single(&reading.value)?;
                    let shape = parameters[place].shape();
                    let bound = Bound::One(step);
                    let what = format!("what is read for `{name}`");
                    self.fit(&reading.value, &bound, &shape, &what, &mut Vec::new())?;
                    self.bind(&reading.name, bound);
                    read[place] = Some(step);
                }
            }
        }
        let missing = parameters
            .iter()
            .zip(&read)
            .find(|(_, read)| read.is_none());
        if let Some((parameter, _)) = missing {
            let kind = ResolveErrorKind::NotRead(parameter.name.to_string());
            return Err(ResolveError::new(kind, Place::of(parameter.name.span())));
        }
        Ok(read.into_iter().flatten().collect())
    }

    /// Checks that the parameters that are read give the multivector from which they are read.
    fn check_readings(
        &mut self,
        syntax: &ParametersSyntax,
        formulas: &Formulas,
        read: &[StepId],
        value: StepId,
    ) -> Result<()> {
        let place = syntax.value.place();
        let again = formulas.insert(&mut self.builder, read);
        let again =
            again.map_err(|error| ResolveError::new(ResolveErrorKind::Operator(error), place))?;
        if self.is_same(again[0], value) {
            return Ok(());
        }
        // The reading that gives another number points at the fault, if there is one.
        let parameters = &syntax.list;
        let differs = |(number, step): (usize, &StepId)| {
            let operand = self.builder.program.find(&Step::Operand(number))?;
            (!self.is_same(*step, operand)).then_some(&parameters[number].0)
        };
        let name = read.iter().enumerate().find_map(differs);
        let reading = syntax.readings.iter().find(|r| Some(&r.name) == name);
        let place = reading.map_or(place, |reading| reading.value.place());
        let name = name.map_or_else(String::new, ToString::to_string);
        Err(ResolveError::new(ResolveErrorKind::NotInverse(name), place))
    }

    /// Whether two steps are equal at the points of the witness.
    fn is_same(&self, a: StepId, b: StepId) -> bool {
        let witness = &self.builder.witness;
        let mut pairs = witness.values(a).zip(witness.values(b));
        pairs.all(|(a, b)| numbers::equal(a, b))
    }

    /// An operand of a type by parameters, which are the next operands of the program.
    pub(super) fn parametrised_operand(
        &mut self,
        index: usize,
        steps: &mut impl Iterator<Item = StepId>,
        place: Place,
    ) -> Result<Bound> {
        let definition = self.definition;
        let Some(parameters) = &definition.types[index].parameters else {
            return Ok(Bound::Parts([].into()));
        };
        let steps: Vec<StepId> = steps.take(parameters.list.len()).collect();
        let value = parameters.value.insert(&mut self.builder, &steps);
        let value = value.map_err(|e| ResolveError::new(ResolveErrorKind::Operator(e), place))?;
        self.parametrised.push(Parametrised {
            value: value[0],
            index,
            parameters: steps,
        });
        Ok(Bound::One(value[0]))
    }

    /// Checks a value against a type by parameters, and lists the steps of these with their types.
    pub(super) fn fit_parameters(
        &mut self,
        place: &Formula,
        value: StepId,
        index: usize,
        what: &str,
        outputs: &mut Vec<(StepId, Option<&'a TypeDefinition>)>,
    ) -> Result<()> {
        let found = self.parameters_of(place, value, index, what)?;
        let definition = self.definition;
        let parameters = definition.types[index].parameters.iter();
        let kinds = parameters.flat_map(|parameters| &parameters.list);
        let kinds = kinds.map(|p| p.index.map(|index| &definition.types[index]));
        outputs.extend(found.into_iter().zip(kinds));
        Ok(())
    }

    /// The parameter of that name of a value, where its type has one.
    pub(super) fn parameter(&self, value: StepId, name: &str) -> Option<StepId> {
        self.parametrised.iter().find_map(|known| {
            let kind = &self.definition.types[known.index];
            let list = &kind.parameters.as_ref()?.list;
            let place = list.iter().position(|p| p.name == name)?;
            (known.value == value).then(|| known.parameters[place])
        })
    }

    /// The parameters of a value that is to be of a type by parameters, if it is.
    fn parameters_of(
        &mut self,
        place: &Formula,
        value: StepId,
        index: usize,
        what: &str,
    ) -> Result<Vec<StepId>> {
        if let Some(known) = self.known_parameters(value, index) {
            return Ok(known);
        }
        let definition = self.definition;
        let kind = &definition.types[index];
        let Some(parameters) = &kind.parameters else {
            return Ok(Vec::new());
        };
        let found = match &parameters.readings {
            None => self.moved_parameters(parameters, value, index),
            Some(readings) => {
                self.check(place, value, Some(kind), what)?;
                let read = self.read_parameters(parameters, readings, value, index);
                Some(read.map_err(|error| {
                    ResolveError::new(ResolveErrorKind::Operator(error), place.place())
                })?)
            }
        };
        let Some(found) = found else {
            self.check(place, value, Some(kind), what)?;
            return Ok(Vec::new());
        };
        for (step, parameter) in found.iter().zip(&parameters.list) {
            if let Some(index) = parameter.index {
                let kind = &definition.types[index];
                self.builder.program.state(*step, kind.facts);
                self.builder.program.state_written(*step, kind);
            }
        }
        self.parametrised.push(Parametrised {
            value,
            index,
            parameters: found.clone(),
        });
        Ok(found)
    }

    fn known_parameters(&self, value: StepId, index: usize) -> Option<Vec<StepId>> {
        let known = self.parametrised.iter();
        let mut known = known.filter(|known| known.value == value && known.index == index);
        known.next().map(|known| known.parameters.clone())
    }

    /// The parameters that are read of a value. Where it is what a versor makes of a value whose
    /// parameters are known, those are taken that stay, are moved or change by a power of the scale
    /// of the versor; of a multiple, those of the multivector without the factor. So what is the
    /// same is not computed.
    fn read_parameters(
        &mut self,
        parameters: &Parameters,
        readings: &Formulas,
        value: StepId,
        index: usize,
    ) -> std::result::Result<Vec<StepId>, OperationError> {
        let mut read = readings.insert(&mut self.builder, &[value])?;
        let originals = self.action(value).and_then(|(versor, original)| {
            let originals = self.known_parameters(original, index)?;
            Some((versor, originals))
        });
        let mut options: Vec<Vec<StepId>> = vec![Vec::new(); read.len()];
        if let Some((versor, originals)) = originals {
            let scales = self.scales(parameters, versor, &originals)?;
            for (place, original) in originals.into_iter().enumerate() {
                let mut figures = vec![original];
                if parameters.list[place].index.is_some() {
                    figures.push(self.builder.push(Step::Sandwich(versor, original))?);
                }
                options[place] = self.multiples(&figures, &scales)?;
            }
        }
        let (factors, rest) = self.factored(value)?;
        if let Some(factor) = factors {
            let plain = readings.insert(&mut self.builder, &[rest])?;
            for (place, step) in plain.into_iter().enumerate() {
                options[place].push(step);
                options[place].push(self.builder.geometric(factor, step)?);
            }
        }
        for (read, options) in read.iter_mut().zip(options) {
            let same = options
                .into_iter()
                .find(|option| self.is_same(*option, *read));
            *read = same.unwrap_or(*read);
        }
        Ok(read)
    }

    /// The weight of the image of a point among the parameters, its square and the reciprocals of
    /// them; nothing where it is 1.
    fn scales(
        &mut self,
        parameters: &Parameters,
        versor: StepId,
        originals: &[StepId],
    ) -> std::result::Result<Vec<StepId>, OperationError> {
        let weights = parameters
            .list
            .iter()
            .map(|parameter| parameter.kind.facts.weight);
        let mut weights = weights.zip(originals);
        let Some((blade, point)) = weights.find_map(|(weight, point)| Some((weight?, *point)))
        else {
            return Ok(Vec::new());
        };
        let builder = &mut self.builder;
        let image = builder.push(Step::Sandwich(versor, point))?;
        let scale = builder.push(Step::Coefficient(image, blade))?;
        let one = builder.number(Ratio::ONE)?;
        if self.is_same(scale, one) {
            return Ok(Vec::new());
        }
        let builder = &mut self.builder;
        let inverse = builder.function(Function::Reciprocal, &[scale])?;
        let squares = [
            builder.geometric(scale, scale)?,
            builder.geometric(inverse, inverse)?,
        ];
        Ok(vec![scale, inverse, squares[0], squares[1]])
    }

    /// Some values and their products with each of some scalars.
    fn multiples(
        &mut self,
        values: &[StepId],
        scalars: &[StepId],
    ) -> std::result::Result<Vec<StepId>, OperationError> {
        let mut multiples = values.to_vec();
        for value in values {
            for scalar in scalars {
                multiples.push(self.builder.geometric(*scalar, *value)?);
            }
        }
        Ok(multiples)
    }

    /// The product of the scalar factors of a value, if it has any, and the rest of it.
    fn factored(
        &mut self,
        value: StepId,
    ) -> std::result::Result<(Option<StepId>, StepId), OperationError> {
        let step = self.builder.program.step(value).clone();
        let parts = match step {
            Step::Binary(..) | Step::Unary(..) | Step::Negative(_) | Step::Sandwich(..) => {
                step.reads()
            }
            _ => return Ok((None, value)),
        };
        let is_scalar = |part: &StepId| {
            self.builder.witness.is_scalar(*part) && !self.builder.program.is_constant(*part)
        };
        if let Step::Binary(Product::Geometric, a, b) = step {
            for (scalar, other) in [(a, b), (b, a)] {
                if is_scalar(&scalar) && !is_scalar(&other) {
                    let (factor, rest) = self.factored(other)?;
                    let whole = match factor {
                        None => scalar,
                        Some(factor) => self.builder.geometric(scalar, factor)?,
                    };
                    return Ok((Some(whole), rest));
                }
            }
        }
        // A versor acts twice, so that its factors are another matter.
        let is_action = matches!(step, Step::Sandwich(..));
        let (mut factors, mut images) = (None, Vec::new());
        for (place, part) in parts.iter().enumerate() {
            if is_action && place == 0 {
                images.push(*part);
                continue;
            }
            let (factor, rest) = self.factored(*part)?;
            images.push(rest);
            factors = match (factors, factor) {
                (Some(a), Some(b)) => Some(self.builder.geometric(a, b)?),
                (one, other) => one.or(other),
            };
        }
        if factors.is_none() {
            return Ok((None, value));
        }
        let mut images = images.into_iter();
        let step = step.mapped(|part| images.next().unwrap_or(part));
        Ok((factors, self.builder.push(step)?))
    }

    /// The parameters of what a versor makes of a value, if they are what it makes of some of that
    /// value's, and the others of it.
    fn moved_parameters(
        &mut self,
        parameters: &Parameters,
        value: StepId,
        index: usize,
    ) -> Option<Vec<StepId>> {
        let (versor, original) = self.action(value)?;
        let original = self.known_parameters(original, index)?;
        let figures: Vec<usize> = (0..original.len())
            .filter(|place| parameters.list[*place].index.is_some())
            .collect();
        let choices = 0..1_usize << figures.len().min(MOST_FIGURES);
        for fixed in choices {
            let mut candidate = original.clone();
            for (bit, place) in figures.iter().enumerate() {
                if fixed >> bit & 1 == 0 {
                    let step = Step::Sandwich(versor, original[*place]);
                    candidate[*place] = self.builder.push(step).ok()?;
                }
            }
            let is_member = |(step, parameter): (&StepId, &Parameter)| {
                let kind = parameter.index.map(|index| &self.definition.types[index]);
                let algebra = &self.definition.algebra;
                self.builder
                    .witness
                    .reasons(algebra, *step, kind)
                    .is_empty()
            };
            if !candidate.iter().zip(&parameters.list).all(is_member) {
                continue;
            }
            let made = parameters.value.insert(&mut self.builder, &candidate);
            if made.is_ok_and(|made| self.is_same(made[0], value)) {
                return Some(candidate);
            }
        }
        None
    }

    /// The versor and the operand of an action, `sandwich(m, x)` or `m * x * rev(m)`.
    fn action(&self, value: StepId) -> Option<(StepId, StepId)> {
        let program = &self.builder.program;
        match *program.step(value) {
            Step::Sandwich(versor, operand) => Some((versor, operand)),
            Step::Binary(Product::Geometric, left, right) => {
                let Step::Unary(Unary::Reverse, versor) = *program.step(right) else {
                    return None;
                };
                match *program.step(left) {
                    Step::Binary(Product::Geometric, first, operand) if first == versor => {
                        Some((versor, operand))
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }
}

/// The most parameters of which is tried whether they are moved.
const MOST_FIGURES: usize = 4;

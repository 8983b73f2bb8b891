//! Types by parameters: their formulas in a declaration, and the parameters of values in functions.

use std::collections::BTreeMap;

use super::error::{ResolveError, ResolveErrorKind};
use super::formula::operator_value;
use super::{Bound, Resolver, Result};
use crate::define::{Coefficient, Definition, Formulas, Parameter, Parameters, TypeDefinition};
use crate::parse::{Block, Formula, ParametersSyntax, Place};
use crate::program::{Mismatch, Step, StepId, is_same};

/// The name of the multivector in the formulas of a type.
const SELF: &str = "self";

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
        if is_same(&self.builder, again[0], value) {
            return Ok(());
        }
        // The reading that gives another number points at the fault, if there is one.
        let parameters = &syntax.list;
        let differs = |(number, step): (usize, &StepId)| {
            let operand = self.builder.program.find(&Step::Operand(number))?;
            (!is_same(&self.builder, *step, operand)).then_some(&parameters[number].0)
        };
        let name = read.iter().enumerate().find_map(differs);
        let reading = syntax.readings.iter().find(|r| Some(&r.name) == name);
        let place = reading.map_or(place, |reading| reading.value.place());
        let name = name.map_or_else(String::new, ToString::to_string);
        Err(ResolveError::new(ResolveErrorKind::NotInverse(name), place))
    }

    /// An operand of a type by parameters, which are the next operands of the program.
    pub(super) fn parametrised_operand(
        &mut self,
        index: usize,
        parameters: &Parameters,
        steps: &mut impl Iterator<Item = StepId>,
        place: Place,
    ) -> Result<Bound> {
        let steps = steps.take(parameters.list.len()).collect();
        let known = &mut self.parametrised;
        let value = known.value(&mut self.builder, parameters, index, steps);
        operator_value(value, place)
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
        let types = &self.definition.types;
        let Some(parameters) = &types[index].parameters else {
            return Ok(());
        };
        let is_known = self.parametrised.known(value, index).is_some();
        if !is_known && parameters.readings.is_some() {
            self.check(place, value, Some(&types[index]), what)?;
        }
        let read = self
            .parametrised
            .read(&mut self.builder, types, value, index);
        let read = read
            .map_err(|error| ResolveError::new(ResolveErrorKind::Operator(error), place.place()))?;
        let Some(read) = read else {
            return self.check(place, value, Some(&types[index]), what);
        };
        let kinds = parameters.list.iter();
        let kinds = kinds.map(|p| p.index.map(|index| &types[index]));
        outputs.extend(read.into_iter().zip(kinds));
        Ok(())
    }
}

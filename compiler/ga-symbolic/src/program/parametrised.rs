//! Values of types by parameters in a program: their multivectors, and what is read of results.
//!
//! Readings are formulas of a multivector, so that much of what they compute is known. Of what a
//! versor makes of a value whose parameters are known, those parameters are taken that stay, that
//! are moved, or that change by a power of the scale of the versor. Of a multiple, those of the
//! multivector without the factor are read. That they are the same is looked up at the points of
//! the witness.

use super::build::{Builder, Outcome};
use super::{OperationError, Step, StepId};
use crate::algebra::{Product, Ratio, Unary};
use crate::define::{Formulas, Parameter, Parameters, TypeDefinition};
use crate::ir::Function;
use crate::member::numbers;

/// The greatest number of parameters that are tried for being moved, where there are no readings.
const MOST_FIGURES: usize = 4;

type Result<T> = std::result::Result<T, OperationError>;

/// The values of types by parameters that are known in a program.
#[derive(Default)]
pub struct Parametrised(Vec<Known>);

struct Known {
    /// The multivector.
    value: StepId,
    /// Its type, as an index.
    index: usize,
    parameters: Vec<StepId>,
}

impl Parametrised {
    /// The multivector of some parameters of a type.
    ///
    /// # Errors
    /// A step that has no value.
    pub fn value(
        &mut self,
        builder: &mut Builder<'_>,
        parameters: &Parameters,
        index: usize,
        steps: Vec<StepId>,
    ) -> Outcome {
        let value = parameters.value.insert(builder, &steps)?[0];
        self.add(value, index, steps);
        Ok(value)
    }

    fn add(&mut self, value: StepId, index: usize, parameters: Vec<StepId>) {
        self.0.push(Known {
            value,
            index,
            parameters,
        });
    }

    /// The parameter of that name of a value, where its type has one.
    #[must_use]
    pub fn named(&self, types: &[TypeDefinition], value: StepId, name: &str) -> Option<StepId> {
        self.0.iter().find_map(|known| {
            let list = &types[known.index].parameters.as_ref()?.list;
            let place = list.iter().position(|p| p.name == name)?;
            (known.value == value).then(|| known.parameters[place])
        })
    }

    /// The parameters of a value of a type, where they are known.
    #[must_use]
    pub fn known(&self, value: StepId, index: usize) -> Option<Vec<StepId>> {
        let mut known = self.0.iter();
        let known = known.find(|known| known.value == value && known.index == index);
        known.map(|known| known.parameters.clone())
    }

    /// The parameters of a value, which is a member of a type. Where that has no readings, only
    /// those of what a versor makes of a value are found.
    ///
    /// # Errors
    /// A step that has no value.
    pub fn read<'a>(
        &mut self,
        builder: &mut Builder<'a>,
        types: &'a [TypeDefinition],
        value: StepId,
        index: usize,
    ) -> Result<Option<Vec<StepId>>> {
        let Some(parameters) = &types[index].parameters else {
            return Ok(None);
        };
        let found = match (self.known(value, index), &parameters.readings) {
            (Some(known), _) => return Ok(Some(known)),
            (None, Some(readings)) => {
                Some(self.by_readings(builder, parameters, readings, value, index)?)
            }
            (None, None) => self.by_action(builder, types, parameters, value, index),
        };
        let Some(found) = found else {
            return Ok(None);
        };
        for (step, parameter) in found.iter().zip(&parameters.list) {
            if let Some(index) = parameter.index {
                let kind = &types[index];
                builder.program.state(*step, kind.facts);
                builder.program.state_written(*step, kind);
            }
        }
        self.add(value, index, found.clone());
        Ok(Some(found))
    }

    fn by_readings(
        &self,
        builder: &mut Builder<'_>,
        parameters: &Parameters,
        readings: &Formulas,
        value: StepId,
        index: usize,
    ) -> Result<Vec<StepId>> {
        let mut read = readings.insert(builder, &[value])?;
        let mut options: Vec<Vec<StepId>> = vec![Vec::new(); read.len()];
        if let Some((versor, original)) = action(builder, value)
            && let Some(originals) = self.found(builder, parameters, readings, original, index)?
        {
            let scales = scales(builder, parameters, versor, &originals)?;
            for (place, original) in originals.into_iter().enumerate() {
                let mut figures = vec![original];
                if parameters.list[place].index.is_some() {
                    figures.push(builder.push(Step::Sandwich(versor, original))?);
                }
                options[place] = multiples(builder, &figures, &scales)?;
            }
        }
        if let Step::Quotient(dividend, divisor) = *builder.program.step(value)
            && let Some(plain) = self.found(builder, parameters, readings, dividend, index)?
        {
            for (place, step) in plain.into_iter().enumerate() {
                options[place].push(step);
                options[place].push(builder.push(Step::Quotient(step, divisor))?);
            }
        }
        let (factor, rest) = factored(builder, value)?;
        if let Some(factor) = factor {
            let plain = readings.insert(builder, &[rest])?;
            for (place, step) in plain.into_iter().enumerate() {
                options[place].push(step);
                options[place].push(builder.geometric(factor, step)?);
            }
        }
        for (read, options) in read.iter_mut().zip(options) {
            let same = options
                .into_iter()
                .find(|option| is_same(builder, *option, *read));
            *read = same.unwrap_or(*read);
        }
        Ok(read)
    }

    /// The parameters of a value that may be a member, known or read.
    fn found(
        &self,
        builder: &mut Builder<'_>,
        parameters: &Parameters,
        readings: &Formulas,
        value: StepId,
        index: usize,
    ) -> Result<Option<Vec<StepId>>> {
        if let Some(known) = self.known(value, index) {
            return Ok(Some(known));
        }
        let read = self.by_readings(builder, parameters, readings, value, index)?;
        let written = parameters.value.insert(builder, &read)?[0];
        Ok(is_same(builder, written, value).then_some(read))
    }

    /// The parameters of what a versor makes of a value, if some of that value's, moved, and the
    /// others of it give the same multivector.
    fn by_action(
        &self,
        builder: &mut Builder<'_>,
        types: &[TypeDefinition],
        parameters: &Parameters,
        value: StepId,
        index: usize,
    ) -> Option<Vec<StepId>> {
        let (versor, original) = action(builder, value)?;
        let original = self.known(original, index)?;
        let figures: Vec<usize> = (0..original.len())
            .filter(|place| parameters.list[*place].index.is_some())
            .take(MOST_FIGURES)
            .collect();
        for fixed in 0..1_usize << figures.len() {
            let mut candidate = original.clone();
            for (bit, place) in figures.iter().enumerate() {
                if fixed >> bit & 1 == 0 {
                    let step = Step::Sandwich(versor, original[*place]);
                    candidate[*place] = builder.push(step).ok()?;
                }
            }
            let is_member = |(step, parameter): (&StepId, &Parameter)| {
                let kind = parameter.index.map(|index| &types[index]);
                builder
                    .witness
                    .reasons(builder.algebra, *step, kind)
                    .is_empty()
            };
            if !candidate.iter().zip(&parameters.list).all(is_member) {
                continue;
            }
            let made = parameters.value.insert(builder, &candidate);
            if made.is_ok_and(|made| is_same(builder, made[0], value)) {
                return Some(candidate);
            }
        }
        None
    }
}

/// Whether two steps are equal at the points of the witness.
#[must_use]
pub fn is_same(builder: &Builder<'_>, a: StepId, b: StepId) -> bool {
    let witness = &builder.witness;
    let mut pairs = witness.values(a).zip(witness.values(b));
    pairs.all(|(a, b)| numbers::equal(a, b))
}

/// The versor and the operand of an action, `sandwich(m, x)` or `m * x * rev(m)`, or of the outer
/// product of the images that a versor makes, or the negative of one.
fn action(builder: &mut Builder<'_>, value: StepId) -> Option<(StepId, StepId)> {
    let program = &builder.program;
    match *program.step(value) {
        Step::Sandwich(versor, operand) => Some((versor, operand)),
        Step::Negative(image) => {
            let (versor, operand) = action(builder, image)?;
            Some((versor, builder.push(Step::Negative(operand)).ok()?))
        }
        Step::Binary(Product::Wedge, left, right) => {
            let (versor, left) = action(builder, left)?;
            let (other, right) = action(builder, right)?;
            let whole = builder.push(Step::Binary(Product::Wedge, left, right));
            (versor == other).then_some((versor, whole.ok()?))
        }
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

/// The weight of the image of a point among the parameters, its square and the reciprocals of
/// them; nothing where it is 1.
fn scales(
    builder: &mut Builder<'_>,
    parameters: &Parameters,
    versor: StepId,
    originals: &[StepId],
) -> Result<Vec<StepId>> {
    let weights = parameters.list.iter().map(|p| p.kind.facts.weight);
    let mut weights = weights.zip(originals);
    let Some((blade, point)) = weights.find_map(|(weight, point)| Some((weight?, *point))) else {
        return Ok(Vec::new());
    };
    let image = builder.push(Step::Sandwich(versor, point))?;
    let scale = builder.push(Step::Coefficient(image, blade))?;
    let one = builder.number(Ratio::ONE)?;
    if is_same(builder, scale, one) {
        return Ok(Vec::new());
    }
    let inverse = builder.function(Function::Reciprocal, &[scale])?;
    let squares = [
        builder.geometric(scale, scale)?,
        builder.geometric(inverse, inverse)?,
    ];
    Ok(vec![scale, inverse, squares[0], squares[1]])
}

/// Some values and their products with each of some scalars.
fn multiples(
    builder: &mut Builder<'_>,
    values: &[StepId],
    scalars: &[StepId],
) -> Result<Vec<StepId>> {
    let mut multiples = values.to_vec();
    for value in values {
        for scalar in scalars {
            multiples.push(builder.geometric(*scalar, *value)?);
        }
    }
    Ok(multiples)
}

/// The product of the scalar factors of a value, if it has any, and the rest of it.
fn factored(builder: &mut Builder<'_>, value: StepId) -> Result<(Option<StepId>, StepId)> {
    let step = builder.program.step(value).clone();
    let is_linear = matches!(
        step,
        Step::Binary(..) | Step::Unary(..) | Step::Negative(_) | Step::Sandwich(..)
    );
    if !is_linear || builder.program.is_constant(value) {
        return Ok((None, value));
    }
    let is_scalar = |part: StepId| builder.witness.is_scalar(part);
    if let Step::Binary(Product::Geometric, a, b) = step {
        for (scalar, other) in [(a, b), (b, a)] {
            if is_scalar(scalar) && !is_scalar(other) && !builder.program.is_constant(scalar) {
                let (factor, rest) = factored(builder, other)?;
                let whole = match factor {
                    None => scalar,
                    Some(factor) => builder.geometric(scalar, factor)?,
                };
                return Ok((Some(whole), rest));
            }
        }
    }
    let is_action = matches!(step, Step::Sandwich(..));
    let (mut factors, mut images) = (None, Vec::new());
    for (place, part) in step.reads().into_iter().enumerate() {
        // A versor acts twice, so that its factors are another matter.
        let (factor, rest) = match is_action && place == 0 {
            true => (None, part),
            false => factored(builder, part)?,
        };
        images.push(rest);
        factors = match (factors, factor) {
            (Some(a), Some(b)) => Some(builder.geometric(a, b)?),
            (one, other) => one.or(other),
        };
    }
    if factors.is_none() {
        return Ok((None, value));
    }
    let mut images = images.into_iter();
    let step = step.mapped(|part| images.next().unwrap_or(part));
    Ok((factors, builder.push(step)?))
}

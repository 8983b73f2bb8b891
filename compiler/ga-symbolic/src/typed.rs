//! Expressions over operands of declared types, those by parameters among them: what declared
//! products and conversions are compiled from.

use crate::define::{Definition, TypeDefinition};
use crate::expression::Expression;
use crate::kernel::{Kernel, wanted};
use crate::program::build::{Builder, Outcome};
use crate::program::{OperationError, Parametrised, Program, Step, StepId, Witness};
use crate::task::Task;

/// The kernel of an expression. Its inputs are the numbers that the operands are stored as, its
/// outputs those of the result. A result by parameters is read off, whether or not it is a member.
///
/// # Errors
/// A step of the formulas of a type by parameters that has no value.
pub fn compile(
    definition: &Definition,
    operands: &[&TypeDefinition],
    expression: &Expression,
    result: Option<&TypeDefinition>,
) -> Result<Kernel, OperationError> {
    let algebra = &definition.algebra;
    let mut kinds = operands.iter().copied().chain(result);
    if kinds.all(|kind| kind.parameters.is_none()) {
        let task = Task::of_expression(algebra, operands, expression, wanted(result));
        return Ok(task.compile());
    }
    let mut builder = Builder {
        algebra,
        program: Program::default(),
        witness: Witness::default(),
        operands: Vec::new(),
    };
    let mut numbers = Vec::new();
    for kind in operands {
        let list = kind
            .parameters
            .iter()
            .flat_map(|parameters| &parameters.list);
        let parts: Vec<StepId> = match kind.parameters {
            None => vec![builder.program.operand(kind)],
            Some(_) => list
                .map(|parameter| {
                    let kind = parameter.index.map(|index| &definition.types[index]);
                    builder.program.operand(kind.unwrap_or(&definition.scalar))
                })
                .collect(),
        };
        numbers.push(parts);
    }
    if !builder.witness.extend(algebra, &builder.program) {
        return Err(OperationError::NoValue);
    }
    let mut parametrised = Parametrised::default();
    let mut values = Vec::new();
    for (kind, steps) in operands.iter().zip(numbers) {
        values.push(match &kind.parameters {
            None => steps[0],
            Some(parameters) => {
                let index = place(definition, kind);
                parametrised.value(&mut builder, parameters, index, steps)?
            }
        });
    }
    let value = push(&mut builder, expression, &values)?;
    let outputs = match result {
        Some(kind) if kind.parameters.is_some() => {
            let index = place(definition, kind);
            let read = parametrised.read(&mut builder, &definition.types, value, index)?;
            let read = read.ok_or(OperationError::NoValue)?;
            let list = kind
                .parameters
                .iter()
                .flat_map(|parameters| &parameters.list);
            let kinds = list.map(|p| p.index.map(|index| &definition.types[index]));
            read.into_iter().zip(kinds.map(wanted)).collect()
        }
        _ => vec![(value, wanted(result))],
    };
    let task = Task::of_program(algebra, &builder.program, outputs)
        .with_witness(&builder.witness)
        .with_types(&definition.types)
        .taken_as_one();
    Ok(task.compile())
}

/// The place of a type in its declaration.
fn place(definition: &Definition, kind: &TypeDefinition) -> usize {
    let mut types = definition.types.iter();
    types.position(|other| other.name == kind.name).unwrap_or(0)
}

/// The steps of an expression over some values.
fn push(builder: &mut Builder<'_>, expression: &Expression, values: &[StepId]) -> Outcome {
    let mut part = |part: &Expression| push(builder, part, values);
    let step = match expression {
        Expression::Operand(number) => return Ok(values[*number]),
        Expression::Constant(value) => return builder.number(*value),
        Expression::Unary(operation, a) => Step::Unary(*operation, part(a)?),
        Expression::Binary(product, a, b) => Step::Binary(*product, part(a)?, part(b)?),
        Expression::Sandwich(a, b) => Step::Sandwich(part(a)?, part(b)?),
        Expression::Sum(a, b) => Step::Sum(part(a)?, part(b)?),
        Expression::Quotient(a, b) => Step::Quotient(part(a)?, part(b)?),
        Expression::Negative(a) => Step::Negative(part(a)?),
    };
    builder.push(step)
}

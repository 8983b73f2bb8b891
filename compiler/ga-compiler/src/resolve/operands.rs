//! The operands of a function: members of their types, drawn at random.

use super::blade::as_blade;
use super::limits::MAX_OPERANDS;
use super::{Bound, ResolveError, ResolveErrorKind, Resolver, Result};
use crate::define::{Definition, TypeDefinition};
use crate::ir::Facts;
use crate::member;
use crate::parse::{FunctionSyntax, OperandSyntax, Place};
use crate::program::StepId;
use crate::signature::{Operand, Shape};

impl<'a> Resolver<'a, '_> {
    /// Adds the operands to the program, and returns for each whether it is uniform.
    pub(super) fn operands(&mut self, function: &FunctionSyntax) -> Result<Vec<bool>> {
        let mut uniform = Vec::new();
        for operand in &function.operands {
            let shape = self.shape(&operand.shape)?;
            let place = Place::of(operand.name.span());
            if uniform.len().saturating_add(size(&shape)) > MAX_OPERANDS {
                return Err(ResolveError::new(ResolveErrorKind::TooManyOperands, place));
            }
            self.operand(&shape, operand)?;
            uniform.resize(self.builder.program.operands.len(), operand.is_uniform);
            self.builder.operands.push(Operand {
                name: operand.name.clone(),
                shape,
                is_uniform: operand.is_uniform,
            });
        }
        self.draw(function.value.place())?;
        let steps: Vec<StepId> = self.builder.program.steps().map(|(id, _)| id).collect();
        let mut steps = steps.into_iter();
        for (number, operand) in function.operands.iter().enumerate() {
            let shape = self.builder.operands[number].shape.clone();
            let bound = self.bound_operand(&shape, &mut steps, operand)?;
            self.bind(&operand.name, bound);
        }
        Ok(uniform)
    }

    /// What an operand stands for, from the next operands of the program.
    fn bound_operand(
        &mut self,
        shape: &Shape,
        steps: &mut impl Iterator<Item = StepId>,
        syntax: &OperandSyntax,
    ) -> Result<Bound> {
        let parts: Vec<Shape> = match shape {
            Shape::Array(element, count) => vec![(**element).clone(); *count],
            Shape::Tuple(parts) => parts.clone(),
            Shape::Scalar | Shape::Type(_) => {
                let parameters = match shape {
                    Shape::Type(index) => {
                        Some(*index).zip(self.definition.types[*index].parameters.as_ref())
                    }
                    _ => None,
                };
                return match parameters {
                    Some((index, parameters)) => {
                        let place = Place::of(syntax.name.span());
                        self.parametrised_operand(index, parameters, steps, place)
                    }
                    None => Ok(Bound::One(steps.next().expect("an operand of the program"))),
                };
            }
        };
        let parts = parts.iter();
        let parts = parts.map(|part| self.bound_operand(part, steps, syntax));
        Ok(Bound::Parts(parts.collect::<Result<_>>()?))
    }

    /// Adds the operands of a shape to the program.
    fn operand(&mut self, shape: &Shape, syntax: &OperandSyntax) -> Result<()> {
        if let Shape::Type(index) = shape
            && let Some(parameters) = &self.definition.types[*index].parameters
        {
            // Their members are what they are, marked or not.
            for parameter in &parameters.list {
                let kind = (parameter.index).map_or(&self.definition.scalar, |index| {
                    &self.definition.types[index]
                });
                self.builder.program.operand(kind);
            }
            return Ok(());
        }
        let kind = match shape {
            Shape::Scalar | Shape::Type(_) if syntax.is_blade => self.as_blade(shape, syntax)?,
            Shape::Scalar => &self.definition.scalar,
            Shape::Type(index) => {
                let kind = &self.definition.types[*index];
                match self.are_blades && is_flat(self.definition, *index) {
                    true => as_blade(self.definition, *index).unwrap_or(kind),
                    false => kind,
                }
            }
            Shape::Array(element, count) => {
                return (0..*count).try_for_each(|_| self.operand(element, syntax));
            }
            Shape::Tuple(parts) => {
                return parts.iter().try_for_each(|part| self.operand(part, syntax));
            }
        };
        self.builder.program.operand(kind);
        Ok(())
    }

    /// The type of an operand that is marked `blade`, with that fact.
    fn as_blade(&self, shape: &Shape, syntax: &OperandSyntax) -> Result<&'a TypeDefinition> {
        let definition = self.definition;
        let found = match shape {
            Shape::Type(index) => as_blade(definition, *index),
            _ => None,
        };
        found.ok_or_else(|| {
            let is_needless = match shape {
                Shape::Type(index) => {
                    let mut kind = definition.types[*index].clone();
                    kind.facts = Facts {
                        blade: true,
                        ..Facts::default()
                    };
                    member::facts_not_implied(&definition.algebra, &kind).is_empty()
                }
                _ => true,
            };
            let text = shape.to_text(definition);
            let kind = if is_needless {
                ResolveErrorKind::NeedlessBlade(text)
            } else {
                ResolveErrorKind::NoBlades(text)
            };
            ResolveError::new(kind, Place::of(syntax.name.span()))
        })
    }
}

/// Whether a type is not that of sums of a type by parameters, of which sums are meant to be.
fn is_flat(definition: &Definition, index: usize) -> bool {
    let mut types = definition.types.iter();
    !types.any(|kind| kind.parameters.is_some() && kind.hull == Some(index))
}

/// How many multivectors a value of that shape holds, as far as that can be counted. Empty arrays
/// and tuples count as one.
fn size(shape: &Shape) -> usize {
    let size = match shape {
        Shape::Scalar | Shape::Type(_) => 1,
        Shape::Array(element, count) => size(element).saturating_mul(*count),
        Shape::Tuple(parts) => parts
            .iter()
            .fold(0, |sum: usize, part| sum.saturating_add(size(part))),
    };
    size.max(1)
}

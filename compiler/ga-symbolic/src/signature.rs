//! What goes into a function and what comes out: names and types, without any code.

use proc_macro2::Ident;

use crate::define::{Definition, Parameter, SCALAR_TYPE, TypeDefinition};

/// An operand of a function.
#[derive(Clone, Debug)]
pub struct Operand {
    /// The name.
    pub name: Ident,
    /// The type.
    pub shape: Shape,
    /// Whether it stays the same over many calls, so that work on it alone is done once.
    pub is_uniform: bool,
}

/// The type of an operand or a result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A plain number.
    Scalar,
    /// A type of the algebra, by its place in the declaration.
    Type(usize),
    /// A fixed number of one shape.
    Array(Box<Shape>, usize),
    /// One of each.
    Tuple(Vec<Shape>),
}

impl Shape {
    /// The types in it, one after the other, those of its parameters for a type that has some;
    /// `None` for a plain number.
    #[must_use]
    pub fn leaves<'a>(&self, definition: &'a Definition) -> Vec<Option<&'a TypeDefinition>> {
        match self {
            Self::Scalar => vec![None],
            Self::Type(index) => match &definition.types[*index] {
                TypeDefinition {
                    parameters: Some(parameters),
                    ..
                } => {
                    let parts = parameters.list.iter();
                    let leaves = parts.flat_map(|part| part.shape().leaves(definition));
                    leaves.collect()
                }
                kind => vec![Some(kind)],
            },
            Self::Array(element, count) => element.leaves(definition).repeat(*count),
            Self::Tuple(parts) => parts
                .iter()
                .flat_map(|part| part.leaves(definition))
                .collect(),
        }
    }

    /// How many numbers are stored.
    #[must_use]
    pub fn stored(&self, definition: &Definition) -> usize {
        self.leaves(definition)
            .iter()
            .map(|leaf| leaf.map_or(1, |kind| kind.stored().count()))
            .sum()
    }

    /// As it is written in source.
    #[must_use]
    pub fn to_text(&self, definition: &Definition) -> String {
        match self {
            Self::Scalar => SCALAR_TYPE.to_owned(),
            Self::Type(index) => definition.types[*index].name.to_string(),
            Self::Array(element, count) => format!("[{}; {count}]", element.to_text(definition)),
            Self::Tuple(parts) => {
                let parts: Vec<_> = parts.iter().map(|part| part.to_text(definition)).collect();
                format!("({})", parts.join(", "))
            }
        }
    }
}

impl Parameter {
    /// The shape of its values.
    #[must_use]
    pub fn shape(&self) -> Shape {
        self.index.map_or(Shape::Scalar, Shape::Type)
    }
}

//! A compiled function: what `ga!` makes of its source, before any code is written.

use std::fmt;

use proc_macro2::Ident;
use syn::{Attribute, Error, Result, Visibility};

use crate::define::{Definition, TypeDefinition};
use crate::kernel::Kernel;
use crate::parse::ShapeSyntax;
use crate::program::nearest::nearest;

/// A function in an algebra, compiled.
#[derive(Clone)]
pub struct CompiledFunction {
    /// Doc comments and other attributes.
    pub attributes: Vec<Attribute>,
    /// The visibility.
    pub visibility: Visibility,
    /// The name; a closure has none.
    pub name: Option<Ident>,
    /// The operands in order.
    pub operands: Vec<Operand>,
    /// What comes out.
    pub result: Shape,
    /// The graph. Its inputs are the stored coefficients of all operands, its outputs those of the
    /// result, each in order of declaration, arrays and tuples element by element.
    pub kernel: Kernel,
}

impl fmt::Debug for CompiledFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("CompiledFunction")
            .field("name", &self.name)
            .field("operands", &self.operands)
            .field("result", &self.result)
            .field("kernel", &self.kernel)
            .finish_non_exhaustive()
    }
}

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

/// The name of the type of plain numbers.
pub const SCALAR_TYPE: &str = "Scalar";

impl Shape {
    /// The shape that a written type means.
    ///
    /// # Errors
    /// The first type that the algebra does not have, at its name.
    pub fn resolve(definition: &Definition, syntax: &ShapeSyntax) -> Result<Self> {
        match syntax {
            ShapeSyntax::Name(name) if name == SCALAR_TYPE => Ok(Self::Scalar),
            ShapeSyntax::Name(name) => {
                let types = &definition.types;
                let found = types.iter().position(|kind| kind.name == *name);
                found.map(Self::Type).ok_or_else(|| {
                    let known = types.iter().map(|kind| kind.name.to_string());
                    let known = known.chain([SCALAR_TYPE.to_owned()]);
                    let near = match name.to_string().as_str() {
                        "f32" | "f64" | "i64" | "S" => "; plain numbers are `Scalar`".to_owned(),
                        text => nearest(text, known),
                    };
                    Error::new(name.span(), format!("unknown type `{name}`{near}"))
                })
            }
            ShapeSyntax::Array(element, count) => {
                let element = Self::resolve(definition, element)?;
                Ok(Self::Array(Box::new(element), *count))
            }
            ShapeSyntax::Tuple(parts) => parts
                .iter()
                .map(|part| Self::resolve(definition, part))
                .collect::<Result<_>>()
                .map(Self::Tuple),
        }
    }

    /// The types in it, one after the other; `None` for a plain number.
    #[must_use]
    pub fn leaves<'a>(&self, definition: &'a Definition) -> Vec<Option<&'a TypeDefinition>> {
        match self {
            Self::Scalar => vec![None],
            Self::Type(index) => vec![Some(&definition.types[*index])],
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

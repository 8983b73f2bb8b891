//! Written types to shapes.

use super::error::{ResolveError, ResolveErrorKind};
use crate::define::{Definition, SCALAR_TYPE};
use crate::nearest::nearest;
use crate::parse::{Place, ShapeSyntax};
use crate::signature::Shape;

/// The shape that a written type means.
///
/// # Errors
/// The first type that the algebra does not have, at its name.
pub(crate) fn resolve_shape(
    definition: &Definition,
    syntax: &ShapeSyntax,
) -> Result<Shape, ResolveError> {
    match syntax {
        ShapeSyntax::Name(name) if name == SCALAR_TYPE => Ok(Shape::Scalar),
        ShapeSyntax::Name(name) => {
            let types = &definition.types;
            let found = types.iter().position(|kind| kind.name == *name);
            found.map(Shape::Type).ok_or_else(|| {
                let known = types.iter().map(|kind| kind.name.to_string());
                let known = known.chain([SCALAR_TYPE.to_owned()]);
                let text = name.to_string();
                let hint = match text.as_str() {
                    "f32" | "f64" | "i64" | "S" => "; plain numbers are `Scalar`".to_owned(),
                    _ => nearest(&text, known),
                };
                let kind = ResolveErrorKind::UnknownType(text, hint);
                ResolveError::new(kind, Place::of(name.span()))
            })
        }
        ShapeSyntax::Array(element, count) => {
            let element = resolve_shape(definition, element)?;
            Ok(Shape::Array(Box::new(element), *count))
        }
        ShapeSyntax::Tuple(parts) => parts
            .iter()
            .map(|part| resolve_shape(definition, part))
            .collect::<Result<_, _>>()
            .map(Shape::Tuple),
    }
}

//! Checks the types by parameters: their formulas, and the blades that follow from them.

use syn::Ident;
use syn::ext::IdentExt;

use super::types::{check_hull, establish_facts};
use crate::define::{Definition, Parameter, SCALAR_TYPE, TypeDefinition};
use crate::diag::Diagnostics;
use crate::nearest::nearest;
use crate::parse::{ParametersSyntax, TypeSyntax};
use crate::resolve::resolve_parameters;

/// Completes the types by parameters. `sound` says for each type whether it is free of errors.
pub(super) fn check(
    definition: &mut Definition,
    sound: &mut [bool],
    syntax: &[TypeSyntax],
    diagnostics: &mut Diagnostics,
) {
    for (index, kind) in syntax.iter().enumerate() {
        let Some(parameters) = &kind.parameters else {
            continue;
        };
        let is_sound = std::mem::replace(&mut sound[index], false);
        let list = check_list(definition, sound, syntax, parameters, diagnostics);
        let hull = hull(definition, kind, diagnostics)
            .filter(|place| is_of_blades(syntax, *place, kind, diagnostics));
        let (Some(list), Some(hull), true) = (list, hull, is_sound) else {
            continue;
        };
        if !sound[hull] {
            continue;
        }
        let hull = &definition.types[hull];
        match resolve_parameters(definition, parameters, list, hull) {
            Ok((parameters, coefficients)) => {
                let own = &mut definition.types[index];
                own.parameters = Some(parameters);
                own.coefficients = coefficients;
            }
            Err(error) => {
                diagnostics.push(error.into());
                continue;
            }
        }
        sound[index] = true;
        let before = diagnostics.count();
        let mut places = std::collections::HashMap::new();
        for (place, other) in syntax.iter().enumerate() {
            places.entry(other.name.to_string()).or_insert(place);
        }
        check_hull(
            index,
            kind,
            &places,
            &mut definition.types,
            sound,
            diagnostics,
        );
        if diagnostics.count() == before {
            let own = &mut definition.types[index];
            establish_facts(&definition.algebra, own, &kind.facts, diagnostics);
        }
        if diagnostics.count() == before && !definition.types[index].facts_are_implied {
            let message = format!(
                "the facts of `{}` do not hold for all of its parameters",
                kind.name
            );
            diagnostics.error(kind.name.span(), message);
        }
        sound[index] = diagnostics.count() == before;
    }
}

/// The parameters with their types; none where one is faulty.
fn check_list(
    definition: &Definition,
    sound: &[bool],
    syntax: &[TypeSyntax],
    parameters: &ParametersSyntax,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<Parameter>> {
    let before = diagnostics.count();
    let mut list: Vec<Parameter> = Vec::new();
    let mut is_complete = true;
    for (name, kind) in &parameters.list {
        let text = name.unraw().to_string();
        if definition.algebra.names().resolve(&text).is_ok() {
            let message = format!("`{name}` is a blade: choose another name for the parameter");
            diagnostics.error(name.span(), message);
        }
        if list.iter().any(|other| other.name == *name) {
            diagnostics.error(name.span(), format!("parameter `{name}` is listed twice"));
        }
        let index = kind.as_ref().filter(|kind| *kind != SCALAR_TYPE);
        let index = index.map(|kind| check_type(definition, syntax, kind, diagnostics));
        let index = match index {
            None => None,
            Some(Some(index)) => {
                is_complete &= sound[index];
                Some(index)
            }
            Some(None) => continue,
        };
        list.push(Parameter {
            name: name.clone(),
            kind: index.map_or_else(TypeDefinition::scalar, |index| {
                definition.types[index].clone()
            }),
            index,
        });
    }
    (diagnostics.count() == before && is_complete).then_some(list)
}

/// The type of a parameter.
fn check_type(
    definition: &Definition,
    syntax: &[TypeSyntax],
    kind: &Ident,
    diagnostics: &mut Diagnostics,
) -> Option<usize> {
    let types = &definition.types;
    let Some(index) = types.iter().position(|other| other.name == *kind) else {
        let known = types.iter().map(|kind| kind.name.to_string());
        let hint = nearest(&kind.to_string(), known.chain([SCALAR_TYPE.to_owned()]));
        diagnostics.error(kind.span(), format!("unknown type `{kind}`{hint}"));
        return None;
    };
    if syntax[index].parameters.is_some() {
        let message = format!("`{kind}` has parameters itself; a parameter is of a type of blades");
        diagnostics.error(kind.span(), message);
        return None;
    }
    if types[index].is_constant() {
        let message = format!("`{kind}` has one member, so that it is not a parameter");
        diagnostics.error(kind.span(), message);
        return None;
    }
    Some(index)
}

/// Whether the hull of a type is declared by blades; reports it otherwise.
fn is_of_blades(
    syntax: &[TypeSyntax],
    hull: usize,
    kind: &TypeSyntax,
    diagnostics: &mut Diagnostics,
) -> bool {
    let is_of_blades = syntax[hull].parameters.is_none();
    if !is_of_blades && let Some(hull) = &kind.hull {
        let message = format!("the hull `{hull}` must be declared by blades, not by parameters");
        diagnostics.error(hull.span(), message);
    }
    is_of_blades
}

/// The hull of a type by its name; reports where there is none.
fn hull(
    definition: &Definition,
    kind: &TypeSyntax,
    diagnostics: &mut Diagnostics,
) -> Option<usize> {
    let name = &kind.name;
    let Some(hull) = &kind.hull else {
        let message =
            format!("`{name}` has parameters, so its sums need a type: name it with `#[hull(…)]`");
        diagnostics.error(name.span(), message);
        return None;
    };
    let place = definition
        .types
        .iter()
        .position(|other| other.name == *hull);
    if place.is_none() {
        diagnostics.error(hull.span(), format!("unknown type `{hull}`"));
    }
    place
}

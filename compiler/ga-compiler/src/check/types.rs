//! Checks the types: their blades, what is constant or derived, their facts and hulls.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use heck::ToSnakeCase;
use proc_macro2::Span;
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::{Error, Ident};

use super::polynomial;
use crate::algebra::{Algebra, NameError, NamedBlade, Product};
use crate::define::{CONSTANTS, Coefficient, Role, SCALAR_TYPE, TypeDefinition};
use crate::diag::Diagnostics;
use crate::ir::Facts;
use crate::member;
use crate::parse::{CoefficientSyntax, FactSyntax, TypeSyntax};

/// The types, and for each whether it is free of errors, so that others can be checked against it.
/// `is_sound` says this of the algebra.
pub(super) fn check_stored(
    algebra: &Algebra,
    is_sound: bool,
    syntax: &[TypeSyntax],
    diagnostics: &mut Diagnostics,
) -> (Vec<TypeDefinition>, Vec<bool>) {
    let mut places: HashMap<String, usize> = HashMap::new();
    let mut names_in_methods: HashMap<String, &Ident> = HashMap::new();
    let (mut types, mut sound) = (Vec::new(), Vec::new());
    for (index, kind) in syntax.iter().enumerate() {
        let before = diagnostics.count();
        check_name(algebra, &kind.name, diagnostics);
        if let Entry::Vacant(place) = places.entry(kind.name.to_string()) {
            place.insert(index);
            let name = kind.name.unraw().to_string().to_snake_case();
            if let Some(other) = names_in_methods.insert(name.clone(), &kind.name) {
                let message = format!(
                    "methods name the types `{other}` and `{}` alike, `{name}`: choose another name",
                    kind.name
                );
                diagnostics.error(kind.name.span(), message);
            }
        } else {
            let message = format!("type `{}` is declared twice", kind.name);
            diagnostics.error(kind.name.span(), message);
        }
        if kind.coefficients.is_empty() && kind.parameters.is_none() {
            diagnostics.error(kind.name.span(), "a type lists at least one blade");
        }
        types.push(TypeDefinition {
            docs: kind.docs.iter().map(ToTokens::to_token_stream).collect(),
            name: kind.name.clone(),
            coefficients: check_coefficients(algebra, &kind.coefficients, diagnostics),
            facts: check_facts(algebra, &kind.facts, diagnostics),
            facts_are_implied: true,
            hull: None,
            parameters: None,
        });
        sound.push(diagnostics.count() == before);
    }
    let stored = || {
        let types = syntax.iter().enumerate();
        types.filter(|(_, kind)| kind.parameters.is_none())
    };
    for (index, kind) in stored() {
        let before = diagnostics.count();
        check_hull(index, kind, &places, &mut types, &sound, diagnostics);
        sound[index] &= diagnostics.count() == before;
    }
    for (index, kind) in stored() {
        sound[index] &= is_sound;
        if sound[index] {
            let before = diagnostics.count();
            establish_facts(algebra, &mut types[index], &kind.facts, diagnostics);
            sound[index] = diagnostics.count() == before;
        }
    }
    (types, sound)
}

/// Refuses names that mean something else in the emitted code.
fn check_name(algebra: &Algebra, name: &Ident, diagnostics: &mut Diagnostics) {
    let text = name.unraw().to_string();
    let meaning = match text.as_str() {
        SCALAR_TYPE => "stands for the coefficients",
        "S" => "is the scalar parameter of every type",
        constant if CONSTANTS.contains(&constant) => "is a constant of every algebra",
        other if algebra.names().resolve(other).is_ok() => "is a blade",
        _ => return,
    };
    diagnostics.error(
        name.span(),
        format!("`{name}` {meaning}: choose another name for the type"),
    );
}

/// Resolves the name of a blade, with an error that says what is wrong with it.
pub(super) fn resolve_blade(algebra: &Algebra, name: &Ident) -> Result<NamedBlade, Error> {
    let text = name.unraw().to_string();
    algebra.names().resolve(&text).map_err(|error| {
        let message = match error {
            NameError::Unknown => {
                format!("unknown basis vector in `{text}`; a blade is named by basis vectors joined after their common prefix")
            }
            NameError::Ambiguous(readings) => {
                format!("`{text}` is ambiguous: {}", readings.join(" or "))
            }
            NameError::Repeated(vector) => {
                format!("`{text}` names the basis vector `{vector}` twice")
            }
        };
        Error::new(name.span(), message)
    })
}

fn check_coefficients(
    algebra: &Algebra,
    syntax: &[CoefficientSyntax],
    diagnostics: &mut Diagnostics,
) -> Vec<Coefficient> {
    let mut coefficients: Vec<Coefficient> = Vec::new();
    let mut values = Vec::new();
    for CoefficientSyntax { blade, value } in syntax {
        let named = match resolve_blade(algebra, blade) {
            Ok(named) => named,
            Err(error) => {
                diagnostics.push(error);
                continue;
            }
        };
        if let Some(earlier) = coefficients.iter().find(|c| c.blade == named.blade) {
            let message = format!(
                "blade `{blade}` is listed twice, first as `{}`",
                earlier.name
            );
            diagnostics.error(blade.span(), message);
            continue;
        }
        if is_method(&blade.unraw().to_string()) {
            let message = format!(
                "`{blade}` is the name of a method of every type: choose other names of basis vectors"
            );
            diagnostics.error(blade.span(), message);
        }
        coefficients.push(Coefficient {
            name: blade.clone(),
            blade: named.blade,
            is_negative: named.is_negative,
            role: Role::Stored,
        });
        values.push(value.as_ref());
    }
    let names: Vec<_> = coefficients.iter().map(|c| c.name.clone()).collect();
    for (index, value) in values.iter().enumerate() {
        let Some(value) = value else { continue };
        let lookup = &mut |name: &Ident| {
            let place = names.iter().position(|other| other == name);
            match place {
                None => Err(Error::new(
                    name.span(),
                    format!("`{name}` is not a blade of this type"),
                )),
                Some(place) if values[place].is_some() => Err(Error::new(
                    name.span(),
                    format!(
                        "a derived blade may refer to stored blades only; `{name}` is not stored"
                    ),
                )),
                Some(place) => Ok(place),
            }
        };
        match polynomial::resolve(value, lookup) {
            Ok(polynomial) => {
                coefficients[index].role = match polynomial.as_constant() {
                    Some(constant) => Role::Constant(constant),
                    None => Role::Derived(polynomial),
                };
            }
            Err(error) => diagnostics.push(error),
        }
    }
    coefficients
}

/// Whether emitted code needs the name for something other than a blade.
fn is_method(name: &str) -> bool {
    let methods = [
        "new",
        "new_unchecked",
        "try_new",
        "tolerance",
        "normalize",
        "reverse",
        "involute",
        "conjugate",
        "grade",
        "norm_squared",
        "inverse",
        "try_inverse",
        "dual",
        "undual",
        "sandwich",
        "transform",
    ];
    methods.contains(&name) || Product::from_name(name).is_some()
}

fn check_facts(algebra: &Algebra, syntax: &[FactSyntax], diagnostics: &mut Diagnostics) -> Facts {
    let mut facts = Facts::default();
    for FactSyntax { name, blade } in syntax {
        match (name.to_string().as_str(), blade) {
            ("unit_versor", None) => facts.unit_versor = true,
            ("null", None) => facts.null = true,
            ("blade", None) => facts.blade = true,
            ("weight", Some(_)) if facts.weight.is_some() => {
                diagnostics.error(name.span(), "a type has one weight");
            }
            ("weight", Some(blade)) => match resolve_blade(algebra, blade) {
                Ok(named) if named.is_negative => diagnostics.error(
                    blade.span(),
                    format!(
                        "write the blade of a weight with its vectors in rising order: `{}`",
                        algebra.names().name(named.blade)
                    ),
                ),
                Ok(named) => facts.weight = Some(named.blade),
                Err(error) => diagnostics.push(error),
            },
            ("weight", None) => diagnostics.error(
                name.span(),
                "`weight` names the blade whose coefficient is 1: `weight(eo)`",
            ),
            _ => diagnostics.error(
                name.span(),
                "unknown fact; known are `unit_versor`, `null`, `blade` and `weight(…)`",
            ),
        }
    }
    facts
}

pub(super) fn check_hull(
    index: usize,
    syntax: &TypeSyntax,
    places: &HashMap<String, usize>,
    types: &mut [TypeDefinition],
    sound: &[bool],
    diagnostics: &mut Diagnostics,
) {
    let name = &syntax.name;
    let Some(hull) = &syntax.hull else {
        let kind = &types[index];
        if !kind.is_linear() && !kind.is_constant() {
            let message = format!(
                "`{name}` has constant or derived blades or facts, so its sums need a type: name it with `#[hull(…)]`"
            );
            diagnostics.error(name.span(), message);
        }
        return;
    };
    let Some(&place) = places.get(&hull.to_string()) else {
        diagnostics.error(hull.span(), format!("unknown type `{hull}`"));
        return;
    };
    if !sound[index] || !sound[place] {
        return;
    }
    if types[index].is_linear() {
        let message = format!("sums of `{name}` have the same type, so it needs no hull");
        diagnostics.error(hull.span(), message);
        return;
    }
    if !types[place].is_linear() {
        let message = format!("the hull `{hull}` must store all its blades and state no facts");
        diagnostics.error(hull.span(), message);
        return;
    }
    let missing: Vec<_> = types[index]
        .coefficients
        .iter()
        .filter(|c| types[place].coefficient(c.blade).is_none())
        .map(|c| format!("`{}`", c.name))
        .collect();
    if missing.is_empty() {
        types[index].hull = Some(place);
    } else {
        let message = format!("the hull `{hull}` has no blade {}", missing.join(", "));
        diagnostics.error(hull.span(), message);
    }
}

/// Decides whether the facts follow from the blades. Only `unit_versor` and `blade` may restrict
/// the stored coefficients, since only then it is known how to draw random members.
pub(super) fn establish_facts(
    algebra: &Algebra,
    kind: &mut TypeDefinition,
    syntax: &[FactSyntax],
    diagnostics: &mut Diagnostics,
) {
    let broken = member::facts_not_implied(algebra, kind);
    kind.facts_are_implied = broken.is_empty();
    for fact in broken {
        let span = syntax
            .iter()
            .find(|stated| stated.name == fact)
            .map_or_else(Span::call_site, |stated| stated.name.span());
        if fact == "blade" {
            if !member::is_family(algebra, kind) {
                let message = format!(
                    "the outer products of vectors among the blades of `{}` do not form one family \
                     in which no coefficient is always zero",
                    kind.name
                );
                diagnostics.error(span, message);
            }
        } else if fact != "unit_versor" {
            let message = format!(
                "`{fact}` does not follow from the blades of `{}`; make a blade derived so that it does{}",
                kind.name,
                match fact {
                    "null" => format!(" (the metric is {})", algebra.metric_text()),
                    _ => String::new(),
                }
            );
            diagnostics.error(span, message);
        } else if !member::is_family(algebra, kind) {
            let message = format!(
                "the unit versors among the blades of `{}` do not form a family that is generated by its bivectors \
                 (the metric is {})",
                kind.name,
                algebra.metric_text()
            );
            diagnostics.error(span, message);
        }
    }
}

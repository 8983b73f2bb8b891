//! Whether a multivector is a member of a type.

use super::numbers::{self, Numbers};
use super::reason::Reason;
use super::stored::{from_stored, stored};
use crate::algebra::{Algebra, Blade, Product, Unary};
use crate::define::{Parameters, Role, TypeDefinition};
use crate::ir::Number;

/// The reasons why a multivector is not a member of a type; none if it is one.
#[must_use]
pub fn membership(
    algebra: &Algebra,
    kind: Option<&TypeDefinition>,
    value: &Numbers,
) -> Vec<Reason> {
    let mut reasons = Vec::new();
    let leftover: Vec<_> = value
        .iter()
        .filter(|&(&blade, &v)| {
            let wanted = kind.map_or(blade == Blade::SCALAR, |k| k.coefficient(blade).is_some());
            !v.is_zero() && !wanted
        })
        .map(|(&blade, _)| (blade, algebra.names().name(blade)))
        .collect();
    if !leftover.is_empty() {
        reasons.push(Reason::LeftOver(leftover));
    }
    let Some(kind) = kind else { return reasons };
    let member = from_stored(kind, &stored(kind, value));
    for coefficient in &kind.coefficients {
        let found = numbers::coefficient(value, coefficient.blade);
        if found == numbers::coefficient(&member, coefficient.blade) {
            continue;
        }
        let (blade, name) = (coefficient.blade, coefficient.name.to_string());
        reasons.push(match &coefficient.role {
            Role::Constant(constant) => Reason::NotConstant(blade, name, *constant),
            Role::Stored | Role::Derived(_) => Reason::NotDerived(blade, name),
        });
    }
    if reasons.is_empty()
        && let Some(parameters) = &kind.parameters
    {
        reasons.extend(not_read(algebra, parameters, value));
    }
    if reasons.is_empty() {
        let broken = broken_facts(algebra, kind, &member);
        reasons.extend(broken.into_iter().map(Reason::Fact));
    }
    reasons
}

/// Why a value is not the multivector of the parameters that are read of it.
fn not_read(algebra: &Algebra, parameters: &Parameters, value: &Numbers) -> Option<Reason> {
    let Some(readings) = &parameters.readings else {
        return Some(Reason::NoReadings);
    };
    let members = readings.evaluate(algebra, std::slice::from_ref(value));
    let Some(members) = members else {
        return Some(Reason::NotReadable);
    };
    for (parameter, member) in parameters.list.iter().zip(&members) {
        let is_number = parameter.index.is_none();
        let kind = (!is_number).then_some(&parameter.kind);
        if !membership(algebra, kind, member).is_empty() {
            if value.values().all(|number| number.is_zero()) {
                return Some(Reason::Zero);
            }
            return Some(Reason::NotParameter(parameter.name.to_string()));
        }
    }
    let again = parameters.value.evaluate(algebra, &members)?.pop()?;
    (!numbers::equal(&again, value)).then_some(Reason::NotReadable)
}

/// The names of the facts of a type that a value does not satisfy.
pub(super) fn broken_facts(
    algebra: &Algebra,
    kind: &TypeDefinition,
    value: &Numbers,
) -> Vec<&'static str> {
    let mut broken = Vec::new();
    if kind.facts.unit_versor {
        let reverse = numbers::unary(algebra, Unary::Reverse, value);
        let mut norm = numbers::product(algebra, Product::Geometric, value, &reverse);
        let scalar = norm.remove(&Blade::SCALAR).unwrap_or(Number::ZERO);
        if scalar != Number::ONE || norm.values().any(|v| !v.is_zero()) {
            broken.push("unit_versor");
        }
    }
    if kind.facts.null {
        let square = numbers::product(algebra, Product::Geometric, value, value);
        if square.values().any(|v| !v.is_zero()) {
            broken.push("null");
        }
    }
    if kind.facts.blade && !numbers::is_blade(algebra, value) {
        broken.push("blade");
    }
    if let Some(blade) = kind.facts.weight
        && numbers::coefficient(value, blade) != Number::ONE
    {
        broken.push("weight");
    }
    broken
}

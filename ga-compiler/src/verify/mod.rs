//! Checks by evaluation over a prime field: what a result is, and that compiled code agrees with
//! its source.
//!
//! An expression is evaluated at random members of its operands' types, in the integers modulo 2⁶¹
//! − 1, by its plain meaning: no identity, no fact, no graph. An equation between polynomials that
//! holds at a random point of the variety holds everywhere with a probability of error below 2⁻⁵⁰
//! (Schwartz 1980, Zippel 1979), and each is tried at two points.

mod member;
pub(crate) mod numeric;
mod reason;

pub use member::{from_stored, sample, stored};
pub use numeric::Numbers;
pub use reason::Reason;

use crate::algebra::{Algebra, Blade, Product, Unary};
use crate::define::{Role, TypeDefinition};
use crate::expression::Expression;
use crate::ir::{Prime, PrimeSequence};
use crate::program::{self, Program};

/// How many random points are tried.
const POINTS: u64 = 2;

/// The reproducible sequence of residues of a seed.
#[must_use]
pub fn sequence(seed: u64) -> PrimeSequence {
    PrimeSequence::new(seed.wrapping_mul(0x2545_f491_4f6c_dd1d) ^ 0x6e75_6c6c_636f_6e65)
}

/// The names of the facts that do not hold for every choice of stored coefficients.
#[must_use]
pub fn facts_not_implied(algebra: &Algebra, kind: &TypeDefinition) -> Vec<&'static str> {
    let mut broken = Vec::new();
    for point in 0..POINTS {
        let mut sequence = sequence(point);
        let stored: Vec<_> = kind.stored().map(|_| sequence.next_prime()).collect();
        for fact in broken_facts(algebra, kind, &from_stored(kind, &stored)) {
            if !broken.contains(&fact) {
                broken.push(fact);
            }
        }
    }
    broken
}

/// Checks that the value of an expression is a member of a type, or a scalar, for all members of
/// its operands' types.
///
/// # Errors
/// Each reason why it is not.
pub fn result_fits(
    algebra: &Algebra,
    operands: &[&TypeDefinition],
    expression: &Expression,
    kind: Option<&TypeDefinition>,
) -> Result<(), Vec<String>> {
    let mut reasons = Vec::new();
    for point in 0..POINTS {
        let Some(result) = at_random(algebra, operands, expression, point) else {
            return Err(vec!["an operand has no members".to_owned()]);
        };
        for reason in membership(algebra, kind, &result) {
            let reason = reason.to_string();
            if !reasons.contains(&reason) {
                reasons.push(reason);
            }
        }
    }
    if reasons.is_empty() {
        Ok(())
    } else {
        Err(reasons)
    }
}

/// The blades that an expression's value really has.
#[must_use]
pub fn result_blades(
    algebra: &Algebra,
    operands: &[&TypeDefinition],
    expression: &Expression,
) -> Vec<Blade> {
    let mut blades = Vec::new();
    for point in 0..POINTS {
        let result = at_random(algebra, operands, expression, point).unwrap_or_default();
        for (blade, value) in result {
            if value != Prime::ZERO && !blades.contains(&blade) {
                blades.push(blade);
            }
        }
    }
    blades.sort();
    blades
}

fn at_random(
    algebra: &Algebra,
    operands: &[&TypeDefinition],
    expression: &Expression,
    point: u64,
) -> Option<Numbers> {
    let mut sequence = sequence(point);
    let members: Option<Vec<_>> = operands
        .iter()
        .map(|kind| sample(algebra, kind, &mut sequence))
        .collect();
    evaluate(algebra, operands, expression, &members?)
}

/// The value of an expression at given members of its operands' types; `None` where it divides by
/// zero there.
#[must_use]
pub fn evaluate(
    algebra: &Algebra,
    operands: &[&TypeDefinition],
    expression: &Expression,
    members: &[Numbers],
) -> Option<Numbers> {
    let (program, result) = Program::of_expression(operands, expression);
    let mut values = program::evaluate(algebra, &program, members)?;
    Some(values.swap_remove(result.index()))
}

/// Why a multivector is no member of a type; nothing if it is one.
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
            v != Prime::ZERO && !wanted
        })
        .map(|(&blade, _)| (blade, algebra.names().name(blade)))
        .collect();
    if !leftover.is_empty() {
        reasons.push(Reason::LeftOver(leftover));
    }
    let Some(kind) = kind else { return reasons };
    let member = from_stored(kind, &stored(kind, value));
    for coefficient in &kind.coefficients {
        let found = numeric::coefficient(value, coefficient.blade);
        if found == numeric::coefficient(&member, coefficient.blade) {
            continue;
        }
        let (blade, name) = (coefficient.blade, coefficient.name.to_string());
        reasons.push(match &coefficient.role {
            Role::Constant(constant) => Reason::NotConstant(blade, name, *constant),
            _ => Reason::NotDerived(blade, name),
        });
    }
    if reasons.is_empty() {
        let broken = broken_facts(algebra, kind, &member);
        reasons.extend(broken.into_iter().map(Reason::Fact));
    }
    reasons
}

fn broken_facts(algebra: &Algebra, kind: &TypeDefinition, value: &Numbers) -> Vec<&'static str> {
    let mut broken = Vec::new();
    if kind.facts.unit_versor {
        let reverse = numeric::unary(algebra, Unary::Reverse, value);
        let mut norm = numeric::product(algebra, Product::Geometric, value, &reverse);
        let scalar = norm.remove(&Blade::SCALAR).unwrap_or(Prime::ZERO);
        if scalar != Prime::ONE || norm.values().any(|&v| v != Prime::ZERO) {
            broken.push("unit_versor");
        }
    }
    if kind.facts.null {
        let square = numeric::product(algebra, Product::Geometric, value, value);
        if square.values().any(|&v| v != Prime::ZERO) {
            broken.push("null");
        }
    }
    if kind.facts.blade && !numeric::is_blade(algebra, value) {
        broken.push("blade");
    }
    if let Some(blade) = kind.facts.weight
        && numeric::coefficient(value, blade) != Prime::ONE
    {
        broken.push("weight");
    }
    broken
}

//! A value that is not of its declared type: why not, and what would help.

use crate::order::Order as _;
use std::fmt;

use super::build::Builder;
use super::{Program, Step, StepId};
use crate::define::{Definition, SCALAR_TYPE, TypeDefinition};
use crate::member::Reason;
use crate::signature::Operand;

/// A value that is not a member of the type that is declared for it.
pub struct Mismatch<'m, 'a> {
    /// The program up to here.
    pub program: &'m Program<'a>,
    /// The operands as they are declared.
    pub operands: &'m [Operand],
    /// The step that gives the value.
    pub step: StepId,
    /// Why the value is not a member.
    pub reasons: Vec<Reason>,
    /// What would help.
    pub remedy: Remedy<'a>,
}

/// What makes a value and its declared type agree.
#[derive(Clone)]
pub enum Remedy<'a> {
    /// To divide the value by one of its coefficients, of that name, gives a member of the type.
    Division(String, &'a TypeDefinition),
    /// To declare one of these types, the smallest first, of which the value is a member. `None` is
    /// the type of plain numbers.
    Types(Vec<Option<&'a TypeDefinition>>),
}

impl<'m, 'a> Mismatch<'m, 'a> {
    /// What is known of a step that is not a member of a type for the given reasons.
    #[must_use]
    pub fn new(
        builder: &'m Builder<'a>,
        definition: &'a Definition,
        step: StepId,
        kind: Option<&'a TypeDefinition>,
        reasons: Vec<Reason>,
    ) -> Self {
        let division = kind.and_then(|kind| division(builder, step, kind, &reasons));
        Self {
            program: &builder.program,
            operands: &builder.operands,
            step,
            remedy: division.unwrap_or_else(|| Remedy::Types(fitting(builder, definition, step))),
            reasons,
        }
    }
}

impl fmt::Display for Mismatch<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let reasons: Vec<String> = self.reasons.iter().map(Reason::to_string).collect();
        f.write_str(&with_remedy(reasons, &self.remedy))
    }
}

/// Reasons in words, followed by what would help.
pub fn with_remedy(mut reasons: Vec<String>, remedy: &Remedy<'_>) -> String {
    match remedy {
        Remedy::Division(coefficient, kind) => reasons.push(format!(
            "divide by it: with `let x = …` the quotient `x / x.{coefficient}` is a `{}`",
            kind.name
        )),
        Remedy::Types(kinds) if kinds.is_empty() => {}
        Remedy::Types(kinds) => {
            let name = |kind: &Option<&TypeDefinition>| match kind {
                Some(kind) => format!("`{}`", kind.name),
                None => format!("`{SCALAR_TYPE}`"),
            };
            let names: Vec<_> = kinds.iter().map(name).collect();
            reasons.push(format!("it fits {}", names.join(" or ")));
        }
    }
    reasons.join("; ")
}

/// A division that makes a constant coefficient what the type says, if that is all that is missing.
fn division<'a>(
    builder: &Builder<'_>,
    id: StepId,
    kind: &'a TypeDefinition,
    reasons: &[Reason],
) -> Option<Remedy<'a>> {
    let constant = reasons.iter().find_map(|reason| match reason {
        Reason::NotConstant(blade, name, value) => Some((*blade, name, *value)),
        _ => None,
    });
    let (blade, name, value) = constant?;
    let mut trial = builder.clone();
    let weight = trial.push(Step::Coefficient(id, blade)).ok()?;
    let constant = trial.number(value).ok()?;
    let weight = trial.push(Step::Quotient(weight, constant)).ok()?;
    let divided = trial.push(Step::Quotient(id, weight)).ok()?;
    let left = trial.witness.reasons(trial.algebra, divided, Some(kind));
    left.is_empty()
        .then(|| Remedy::Division(name.clone(), kind))
}

/// The declared types that the value is a member of, the smallest first.
fn fitting<'a>(
    builder: &Builder<'_>,
    definition: &'a Definition,
    id: StepId,
) -> Vec<Option<&'a TypeDefinition>> {
    if builder.witness.is_scalar(id) {
        return vec![None];
    }
    let is_member = |kind: &&TypeDefinition| {
        let reasons = builder.witness.reasons(builder.algebra, id, Some(kind));
        reasons.is_empty()
    };
    let mut fitting: Vec<_> = definition.types.iter().filter(is_member).collect();
    fitting.order_by_key(|kind| kind.coefficients.len());
    fitting.truncate(2);
    fitting.into_iter().map(Some).collect()
}

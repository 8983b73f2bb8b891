//! Why a value is not of its declared type, and what would be.

use super::build::Builder;
use super::{Step, StepId};
use crate::algebra::{Blade, NamedBlade};
use crate::define::{Definition, TypeDefinition};
use crate::emit::formula;
use crate::member::Reason;
use crate::task::Task;

/// How long a coefficient may be written out where several are listed.
const LONGEST: usize = 100;

/// The reasons with what was found, and types or divisions that help.
pub(super) fn explain(
    builder: &Builder<'_>,
    definition: &Definition,
    id: StepId,
    kind: Option<&TypeDefinition>,
    reasons: &[Reason],
) -> String {
    let mut text: Vec<String> = reasons
        .iter()
        .map(|reason| explain_reason(builder, definition, id, reason))
        .collect();
    if let Some(kind) = kind
        && let Some(division) = division(builder, id, kind, reasons)
    {
        text.push(division);
    } else {
        let fitting = fitting(builder, definition, id);
        if !fitting.is_empty() {
            text.push(format!("it fits {}", fitting.join(" or ")));
        }
    }
    text.join("; ")
}

fn explain_reason(
    builder: &Builder<'_>,
    definition: &Definition,
    id: StepId,
    reason: &Reason,
) -> String {
    let found = |blade: Blade| coefficient_text(builder, definition, id, blade);
    match reason {
        Reason::LeftOver(blades) => {
            let blades: Vec<_> = blades
                .iter()
                .map(|(blade, name)| match found(*blade) {
                    text if blades.len() <= 3 && text.len() <= LONGEST => {
                        format!("{name} = {text}")
                    }
                    _ => name.clone(),
                })
                .collect();
            format!("left over: {}", blades.join(", "))
        }
        Reason::NotConstant(blade, ..) => format!("{reason}, it is {}", found(*blade)),
        _ => reason.to_string(),
    }
}

/// The coefficient as a formula, where it is short.
fn coefficient_text(
    builder: &Builder<'_>,
    definition: &Definition,
    id: StepId,
    blade: Blade,
) -> String {
    let wanted = [NamedBlade {
        blade,
        is_negative: false,
    }];
    let program = &builder.program;
    let kernel = Task::of_program(builder.algebra, program, vec![(id, wanted.to_vec())]).compile();
    let (arena, value) = (&kernel.arena, kernel.outputs[0]);
    formula::of_value(definition, &builder.operands, arena, value)
}

/// A division that makes a constant coefficient what the type says, if that is all that is missing.
fn division(
    builder: &Builder<'_>,
    id: StepId,
    kind: &TypeDefinition,
    reasons: &[Reason],
) -> Option<String> {
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
    left.is_empty().then(|| {
        format!(
            "divide by it: with `let x = …` the quotient `x / x.{name}` is a `{}`",
            kind.name
        )
    })
}

/// The declared types that the value is a member of, the smallest first.
fn fitting(builder: &Builder<'_>, definition: &Definition, id: StepId) -> Vec<String> {
    if builder.witness.is_scalar(id) {
        return vec!["`Scalar`".to_owned()];
    }
    let mut fitting: Vec<&TypeDefinition> = definition
        .types
        .iter()
        .filter(|kind| {
            let reasons = builder.witness.reasons(builder.algebra, id, Some(kind));
            reasons.is_empty()
        })
        .collect();
    fitting.sort_by_key(|kind| kind.coefficients.len());
    fitting.truncate(2);
    fitting
        .iter()
        .map(|kind| format!("`{}`", kind.name))
        .collect()
}

//! Why a value is not of its declared type, with its coefficients as formulas.

use crate::algebra::{Blade, NamedBlade};
use crate::define::Definition;
use crate::emit::formula;
use crate::member::Reason;
use crate::program::{Mismatch, with_remedy};
use crate::task::Task;

/// How long a coefficient may be written out where several are listed.
const LONGEST: usize = 100;

/// The reasons with what was found, and types or divisions that help.
pub(crate) fn explain(definition: &Definition, mismatch: &Mismatch<'_, '_>) -> String {
    let found = |blade: Blade| coefficient(definition, mismatch, blade);
    let reasons = mismatch.reasons.iter().map(|reason| match reason {
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
        Reason::NotDerived(..)
        | Reason::NoReadings
        | Reason::NotParameter(_)
        | Reason::Zero
        | Reason::NotReadable
        | Reason::Fact(_) => reason.to_string(),
    });
    with_remedy(reasons.collect(), &mismatch.remedy)
}

/// The coefficient of a blade of the value as a formula.
fn coefficient(definition: &Definition, mismatch: &Mismatch<'_, '_>, blade: Blade) -> String {
    let named = NamedBlade {
        blade,
        is_negative: false,
    };
    let wanted = vec![(mismatch.step, vec![named])];
    let kernel = Task::of_program(&definition.algebra, mismatch.program, wanted).compile();
    let (arena, value) = (&kernel.arena, kernel.outputs[0]);
    formula::of_value(definition, mismatch.operands, arena, value)
}

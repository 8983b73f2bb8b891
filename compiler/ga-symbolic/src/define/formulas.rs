//! Formulas as data; `program` has what is done with them.

use crate::program::{Step, StepId};

/// Formulas as steps over operands of which nothing else is known.
#[derive(Clone, Debug)]
pub struct Formulas {
    pub(crate) steps: Vec<Step>,
    pub(crate) results: Vec<StepId>,
}

//! Programs of which forms are looked for.

use crate::algebra::Algebra;
use crate::program::{Program, StepId, Witness};

/// What forms are made of.
pub(crate) struct Source<'s, 'a> {
    pub(crate) algebra: &'a Algebra,
    pub(crate) program: &'s Program<'a>,
    /// The values of its steps.
    pub(crate) witness: &'s Witness,
    /// For each operand, whether it is uniform.
    pub(crate) uniform: &'s [bool],
    /// The steps that are wanted.
    pub(crate) wanted: &'s [StepId],
}

//! Forms of programs.

use crate::lower::FormRule;
use crate::program::{Program, StepId};

/// A program that gives the same as another.
pub(crate) struct Form<'a> {
    /// The program.
    pub(crate) program: Program<'a>,
    /// The wanted steps in it.
    pub(crate) wanted: Vec<StepId>,
    /// The rules that led to it.
    pub(crate) rules: Vec<FormRule>,
    /// From which of the program's points it is seen, counted from 1; 0 is as it is written.
    pub(crate) frame: usize,
}

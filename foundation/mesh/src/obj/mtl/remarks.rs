//! What deviates from the format in an MTL file that is being read.

use ga_files::{Deviations, Reading};

use super::MtlProblem;

/// What is wrong with the line being read and the lines before it.
pub(super) struct Remarks {
    pub(super) line: usize,
    pub(super) deviations: Deviations<MtlProblem>,
}

impl Remarks {
    /// None yet.
    pub(super) fn new(reading: Reading) -> Self {
        Self {
            line: 0,
            deviations: Deviations::new(reading),
        }
    }

    /// Adds a problem, which is an error where the file is read strictly.
    pub(super) fn tolerate(&mut self, problem: MtlProblem) -> Result<(), MtlProblem> {
        self.deviations.tolerate(self.line, problem)
    }

    /// Adds a problem that is no error in either reading.
    pub(super) fn note(&mut self, problem: MtlProblem) {
        self.deviations.note(self.line, problem);
    }
}

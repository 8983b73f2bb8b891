//! Steps that are computed by graphs of their own.

use std::rc::Rc;

use rustc_hash::FxHashMap;

use super::operand::{self, from_stored};
use crate::define::TypeDefinition;
use crate::ir::{Arena, Multivector, Value};
use crate::program::StepId;

/// The pieces of a program, by the steps that they give.
pub type Pieces<'a> = FxHashMap<StepId, Piece<'a>>;

/// A step with a graph that gives its stored coefficients as a member of a type.
pub struct Piece<'a> {
    /// The steps whose stored coefficients are the inputs, one after the other, with their types.
    pub operands: Vec<(StepId, &'a TypeDefinition)>,
    /// The type of the step.
    pub kind: &'a TypeDefinition,
    /// The graph.
    pub graph: Rc<(Arena, Vec<Value>)>,
}

impl Piece<'_> {
    /// The steps that it reads.
    pub(super) fn reads(&self) -> Vec<StepId> {
        self.operands.iter().map(|(step, _)| *step).collect()
    }

    /// The step, from the values of the steps before it. Multiples are held, so that they are
    /// multiplied once for all that reads them.
    pub(super) fn lower(&self, arena: &mut Arena, values: &[Multivector]) -> Multivector {
        let mut inputs = Vec::new();
        for (step, kind) in &self.operands {
            let stored = operand::stored(kind, &values[step.index()]);
            inputs.extend(stored.map(|value| arena.held(value)));
        }
        let (graph, outputs) = &*self.graph;
        let stored = arena.splice(graph, &inputs, outputs);
        from_stored(arena, self.kind, &stored)
    }
}

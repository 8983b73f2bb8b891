//! What is to be compiled: a program, the blades that are wanted of it, and by which rules.

use std::borrow::Cow;

use crate::algebra::{Algebra, NamedBlade};
use crate::define::TypeDefinition;
use crate::expression::Expression;
use crate::ir::{Arena, Multivector, Value};
use crate::kernel::Kernel;
use crate::lower::{self, Choices, Lowered};
use crate::passes;
use crate::program::{Program, StepId, Witness};

/// The number of operations above which a graph is left as it was built. The passes would take too
/// long on the product of two multivectors of 32 blades.
const LARGEST: usize = 600;

/// A program and what is wanted of it. [`Task::compile`] makes a [`Kernel`] of it.
///
/// ```
/// use ga_compiler::algebra::Product;
/// use ga_compiler::expression::Expression;
/// use ga_compiler::kernel::wanted;
/// use ga_compiler::task::Task;
///
/// let declaration = quote::quote! {
///     pub mod vga2 {
///         basis e1, e2;
///         signature 2, 0;
///         struct Vector { e1, e2 }
///     }
/// };
/// let definition = ga_compiler::check_types(declaration, quote::quote! { ga_runtime })?;
/// let vector = &definition.types[0];
/// let (a, b) = (Expression::Operand(0), Expression::Operand(1));
/// let inner = Expression::binary(Product::ScalarProduct, a, b);
/// let task =
///     Task::of_expression(&definition.algebra, &[vector, vector], &inner, wanted(None));
/// assert_eq!(task.compile().cost().multiplications, 2);
/// # Ok::<(), syn::Error>(())
/// ```
#[derive(Clone)]
pub struct Task<'a> {
    pub(crate) program: Cow<'a, Program<'a>>,
    /// The rules, where they are given; otherwise they are searched for.
    pub(crate) choices: Option<Choices>,
    pub(crate) algebra: &'a Algebra,
    pub(crate) wanted: Vec<(StepId, Vec<NamedBlade>)>,
    pub(crate) uniform: Vec<bool>,
    /// The values of the program's steps; without them no other forms of it are tried.
    pub(crate) witness: Option<&'a Witness>,
}

impl<'a> Task<'a> {
    /// The given blades of some steps of a program.
    #[must_use]
    pub fn of_program(
        algebra: &'a Algebra,
        program: &'a Program<'a>,
        wanted: Vec<(StepId, Vec<NamedBlade>)>,
    ) -> Self {
        Self::new(algebra, Cow::Borrowed(program), wanted)
    }

    /// The given blades of an expression over operands of some types.
    #[must_use]
    pub fn of_expression(
        algebra: &'a Algebra,
        operands: &[&'a TypeDefinition],
        expression: &Expression,
        wanted: Vec<NamedBlade>,
    ) -> Self {
        let (program, result) = Program::of_expression(operands, expression);
        Self::new(algebra, Cow::Owned(program), vec![(result, wanted)])
    }

    fn new(
        algebra: &'a Algebra,
        program: Cow<'a, Program<'a>>,
        wanted: Vec<(StepId, Vec<NamedBlade>)>,
    ) -> Self {
        Self {
            uniform: vec![false; program.operands.len()],
            program,
            choices: None,
            algebra,
            wanted,
            witness: None,
        }
    }

    /// The same with the values of the program's steps, by which equal ones are found.
    #[must_use]
    pub fn with_witness(mut self, witness: &'a Witness) -> Self {
        self.witness = Some(witness);
        self
    }

    /// The same, where `uniform` marks operands that stay the same over many calls. Operands beyond
    /// its end vary.
    #[must_use]
    pub fn with_uniform(mut self, uniform: &[bool]) -> Self {
        for (mark, is_uniform) in self.uniform.iter_mut().zip(uniform) {
            *mark = *is_uniform;
        }
        self
    }

    /// The same by given rules.
    #[must_use]
    pub fn with_choices(mut self, choices: impl Into<Choices>) -> Self {
        self.choices = Some(choices.into());
        self
    }

    /// The kernel by some rules.
    pub(crate) fn by_choices(&self, choices: &Choices) -> Kernel {
        self.optimised(self.lowered(choices))
    }

    /// The graph by some rules, before the passes.
    pub(crate) fn lowered(&self, choices: &Choices) -> LoweredTask {
        let mut arena = Arena::default();
        let mut uniform = Vec::new();
        let mut inputs = Vec::new();
        for (kind, is_uniform) in self.program.operands.iter().zip(&self.uniform) {
            inputs.push(lower::operand(&mut arena, kind, choices.all.held));
            uniform.resize(arena.inputs(), *is_uniform);
        }
        let steps: Vec<StepId> = self.wanted.iter().map(|(step, _)| *step).collect();
        let Lowered { values, acted } = lower::lower(
            &mut arena,
            self.algebra,
            &self.program,
            &inputs,
            &steps,
            choices,
        );
        let mut outputs = Vec::new();
        for (value, (_, blades)) in values.iter().zip(&self.wanted) {
            for named in blades {
                let found = value.coefficient(named.blade);
                outputs.push(if named.is_negative { -found } else { found });
            }
        }
        LoweredTask {
            arena,
            outputs,
            inputs,
            acted,
            choices: choices.clone(),
            uniform,
        }
    }

    /// The kernel of a graph.
    pub(crate) fn optimised(&self, lowered: LoweredTask) -> Kernel {
        let LoweredTask {
            mut arena,
            outputs,
            inputs,
            choices,
            uniform,
            ..
        } = lowered;
        let (arena, outputs) = if passes::cost(&arena, &outputs).total() > LARGEST {
            (arena, outputs)
        } else {
            let mut relations = Vec::new();
            for input in &inputs {
                relations.extend(passes::relations(&mut arena, self.algebra, input));
            }
            let graph = passes::optimise(arena, outputs, &uniform, &relations);
            finished(passes::reciprocal(&graph.0, &graph.1).unwrap_or(graph))
        };
        Kernel {
            arena,
            outputs,
            choices,
            uniform,
        }
    }
}

/// A program by some rules, before the passes.
pub(crate) struct LoweredTask {
    arena: Arena,
    outputs: Vec<Value>,
    inputs: Vec<Multivector>,
    /// The steps in which versors act.
    pub(crate) acted: Vec<StepId>,
    choices: Choices,
    uniform: Vec<bool>,
}

impl LoweredTask {
    /// The operations before the passes: those of each call, and all.
    pub(crate) fn rank(&self) -> (usize, usize) {
        let whole = passes::cost(&self.arena, &self.outputs).total();
        let varying = if self.uniform.contains(&true) {
            passes::varying_cost(&self.arena, &self.outputs, &self.uniform)
        } else {
            whole
        };
        (varying, whole)
    }

    /// The same number for the same graph.
    pub(crate) fn fingerprint(&self) -> u64 {
        self.arena.fingerprint(&self.outputs)
    }
}

/// The graph with the signs of its differences chosen, if that saves negations.
fn finished(graph: passes::Graph) -> passes::Graph {
    let rank = |graph: &passes::Graph| passes::cost(&graph.0, &graph.1).rank();
    match passes::choose_signs(&graph.0, &graph.1) {
        Some(changed) if rank(&changed) < rank(&graph) => changed,
        _ => graph,
    }
}

//! What is to be compiled: a program, the blades that are wanted of it, and by which rules.

use std::borrow::Cow;

use crate::algebra::{Algebra, NamedBlade};
use crate::define::TypeDefinition;
use crate::expression::Expression;
use crate::ir::{Arena, Multivector, Value};
use crate::kernel::Kernel;
use crate::limit::SearchLimit;
use crate::lower::{self, Choices, Lowered, Pieces, Rule};
use crate::passes::{self, Collected};
use crate::program::{Program, StepId, Witness};

/// The number of operations above which a graph is left as it was built.
const LARGEST: usize = 1 << 15;

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
    /// The declared types, by which steps are compiled by themselves.
    pub(crate) types: &'a [TypeDefinition],
    /// Whether it is one operation, of which no step is compiled by itself.
    pub(crate) is_one_operation: bool,
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
            types: &[],
            is_one_operation: false,
        }
    }

    /// The same with the values of the program's steps, by which equal ones are found.
    #[must_use]
    pub fn with_witness(mut self, witness: &'a Witness) -> Self {
        self.witness = Some(witness);
        self
    }

    /// The same with the declared types of the algebra, of which values between are members.
    #[must_use]
    pub fn with_types(mut self, types: &'a [TypeDefinition]) -> Self {
        self.types = types;
        self
    }

    /// The same, taken as one operation: the formulas of types by parameters are steps of its
    /// program, of which none is compiled by itself. That would take half of the time of an
    /// algebra's declaration, and makes none of cga3's products cheaper.
    #[must_use]
    pub(crate) fn taken_as_one(mut self) -> Self {
        self.is_one_operation = true;
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

    /// Whether an operand stays the same over many calls.
    pub(crate) fn has_uniform(&self) -> bool {
        self.uniform.contains(&true)
    }

    /// The ways to collect the uniform coefficients of a graph, the cheapest first.
    pub(crate) fn staged(&self, lowered: LoweredTask) -> Vec<Staged> {
        self.with_relations(lowered).staged()
    }

    /// The graph by some rules, before the passes.
    pub(crate) fn lowered(&self, choices: &Choices) -> LoweredTask {
        self.with_pieces(choices, &Pieces::default())
    }

    /// The same, where some steps are computed by graphs of their own.
    pub(crate) fn with_pieces(&self, choices: &Choices, pieces: &Pieces<'_>) -> LoweredTask {
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
            pieces,
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
        self.with_relations(lowered).kernel()
    }

    fn with_relations(&self, lowered: LoweredTask) -> LoweredGraph {
        let LoweredTask {
            mut arena,
            outputs,
            inputs,
            choices,
            uniform,
            ..
        } = lowered;
        let is_small = passes::cost(&arena, &outputs).total() <= LARGEST;
        let relations = is_small.then(|| {
            let of_operand = |input| passes::relations(&mut arena, self.algebra, input);
            inputs.iter().flat_map(of_operand).collect()
        });
        LoweredGraph {
            graph: (arena, outputs),
            choices,
            uniform,
            relations,
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

/// A graph as it was lowered.
struct LoweredGraph {
    graph: passes::Graph,
    choices: Choices,
    /// For each input, whether it stays the same over many calls.
    uniform: Vec<bool>,
    /// Values that are known to be zero; none where the graph is too large for the passes.
    relations: Option<Vec<Value>>,
}

/// A lowered graph whose uniform coefficients are collected.
pub(crate) struct Staged {
    /// The operations of each call, then all operations, before the other passes.
    pub(crate) price: (usize, usize),
    lowered: LoweredGraph,
}

impl Staged {
    /// The kernel that the other passes make of it.
    pub(crate) fn kernel(self) -> Kernel {
        self.lowered.kernel()
    }
}

impl LoweredGraph {
    /// The ways to collect its uniform coefficients, the cheapest first.
    fn staged(&self) -> Vec<Staged> {
        let (arena, outputs) = &self.graph;
        let Some(relations) = &self.relations else {
            return Vec::new();
        };
        let is_broken = self.choices.all.broken == Some(Rule::UniformCoefficients);
        let staged = |mut collected: Collected| {
            if is_broken
                && let Some(output) = collected
                    .graph
                    .1
                    .iter_mut()
                    .find(|v| v.as_constant().is_none())
            {
                *output = -*output;
            }
            Staged {
                price: collected.price,
                lowered: Self {
                    choices: self.choices.clone(),
                    graph: collected.graph,
                    uniform: self.uniform.clone(),
                    relations: Some(collected.relations),
                },
            }
        };
        let found = passes::uniform_coefficients(arena, outputs, relations, &self.uniform);
        found.into_iter().map(staged).collect()
    }

    /// The kernel that the passes make of it.
    fn kernel(self) -> Kernel {
        let limits = match self.relations {
            None => vec![SearchLimit::Operations],
            Some(_) => Vec::new(),
        };
        let (arena, outputs) = match &self.relations {
            None => self.graph,
            Some(relations) => {
                let (arena, outputs) = self.graph;
                let all: Vec<Value> = outputs.iter().chain(relations).copied().collect();
                let (arena, outputs, relations) = match passes::divisor(&arena, &all) {
                    None => (arena, outputs, relations.clone()),
                    Some((arena, mut all)) => {
                        let relations = all.split_off(outputs.len());
                        (arena, all, relations)
                    }
                };
                let graph = passes::optimise(arena, outputs, &self.uniform, &relations);
                finished(passes::reciprocal(&graph.0, &graph.1).unwrap_or(graph))
            }
        };
        Kernel {
            arena,
            outputs,
            choices: self.choices,
            uniform: self.uniform,
            literals: Vec::new(),
            limits,
        }
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

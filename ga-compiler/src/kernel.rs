//! One compiled expression: the path from an expression over typed operands to a graph with chosen
//! rules.

use crate::algebra::{Algebra, Blade, NamedBlade, Ratio};
use crate::define::TypeDefinition;
use crate::emit::stage::Stages;
use crate::expression::Expression;
use crate::ir::{Arena, Node, Prime, Value};
use crate::lower::{self, Choice, Choices, Lowered};
use crate::passes::{self, Cost};
use crate::program::{Program, StepId, Witness};
use crate::search;
use crate::verify;

/// A graph whose inputs are the stored coefficients of the operands, one after the other, and whose
/// outputs are the stored coefficients of the result, all in the order of their declarations.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// The graph.
    pub arena: Arena,
    /// The outputs.
    pub outputs: Vec<Value>,
    /// The rules that won.
    pub choices: Choices,
    /// For each input, whether it stays the same over many calls. What depends on such inputs alone
    /// is the prologue.
    pub uniform: Vec<bool>,
}

/// The number of operations from which a graph is left as it was built: passes take time, and
/// nobody waits gladly for the product of two multivectors of 32 blades.
const LARGEST: usize = 600;

impl Kernel {
    /// Compiles an expression, wanting the stored coefficients of a type, or the scalar.
    #[must_use]
    pub fn compile(
        algebra: &Algebra,
        operands: &[&TypeDefinition],
        expression: &Expression,
        result: Option<&TypeDefinition>,
    ) -> Self {
        Self::of_blades(algebra, operands, expression, &wanted(result))
    }

    /// Compiles an expression, wanting the coefficients of the given blades.
    #[must_use]
    pub fn of_blades(
        algebra: &Algebra,
        operands: &[&TypeDefinition],
        expression: &Expression,
        wanted: &[NamedBlade],
    ) -> Self {
        let (program, result) = Program::of_expression(operands, expression);
        let uniform = vec![false; operands.len()];
        Self::of_program(algebra, &program, &uniform, &[(result, wanted.to_vec())])
    }

    /// Compiles a program, wanting the given blades of some of its steps. `uniform` marks operands
    /// that stay the same over many calls.
    ///
    /// The rules are tried, and the cheapest graph is kept.
    #[must_use]
    pub fn of_program(
        algebra: &Algebra,
        program: &Program<'_>,
        uniform: &[bool],
        wanted: &[(StepId, Vec<NamedBlade>)],
    ) -> Self {
        search::cheapest(&Task {
            algebra,
            program,
            uniform,
            wanted,
        })
    }

    /// Compiles a program with given rules.
    #[must_use]
    pub fn of_program_by_choices(
        algebra: &Algebra,
        program: &Program<'_>,
        uniform: &[bool],
        wanted: &[(StepId, Vec<NamedBlade>)],
        choices: &Choices,
    ) -> Self {
        let task = Task {
            algebra,
            program,
            uniform,
            wanted,
        };
        task.compile(choices).0
    }

    /// Compiles an expression with given rules.
    #[must_use]
    pub fn by_choice(
        algebra: &Algebra,
        operands: &[&TypeDefinition],
        expression: &Expression,
        wanted: &[NamedBlade],
        choice: Choice,
    ) -> Self {
        let (program, result) = Program::of_expression(operands, expression);
        let uniform = vec![false; operands.len()];
        let wanted = [(result, wanted.to_vec())];
        let task = Task {
            algebra,
            program: &program,
            uniform: &uniform,
            wanted: &wanted,
        };
        task.compile(&choice.into()).0
    }

    /// What decides between graphs: the operations of each call, then those of the prologue.
    pub(crate) fn rank(&self) -> (usize, usize) {
        let prologue = self.prologue_cost().total();
        (self.cost().total() - prologue, prologue)
    }

    /// The number of operations on uniform inputs alone, which are done once for many calls.
    #[must_use]
    pub fn prologue_cost(&self) -> Cost {
        if !self.uniform.contains(&true) {
            return Cost::default();
        }
        let handed = Stages::new(self).handed.into_iter().map(|node| Value {
            factor: Ratio::ONE,
            node,
        });
        passes::cost(&self.arena, &handed.collect::<Vec<_>>())
    }

    /// The number of operations.
    #[must_use]
    pub fn cost(&self) -> Cost {
        passes::cost(&self.arena, &self.outputs)
    }

    /// Whether some constant in it is beyond what is worked out exactly.
    #[must_use]
    pub fn is_out_of_range(&self) -> bool {
        let is_beyond = |value: &Value| value.factor.is_out_of_range();
        let in_graph = self.arena.ids().any(|id| match self.arena.node(id) {
            Node::Sum(values) | Node::Function(_, values) => values.iter().any(is_beyond),
            _ => false,
        });
        in_graph || self.outputs.iter().any(is_beyond)
    }

    /// The outputs for given inputs over the prime field.
    #[must_use]
    pub fn evaluate(&self, inputs: &[Prime]) -> Vec<Prime> {
        let values = self.arena.evaluate(inputs);
        self.outputs
            .iter()
            .map(|output| values[output.node.index()] * Prime::from_ratio(output.factor))
            .collect()
    }

    /// Whether the graph agrees with the plain meaning of the expression at a random point of the
    /// operands' types.
    #[must_use]
    pub fn agrees(
        &self,
        algebra: &Algebra,
        operands: &[&TypeDefinition],
        expression: &Expression,
        result: Option<&TypeDefinition>,
        seed: u64,
    ) -> bool {
        let mut sequence = verify::sequence(seed);
        let members: Option<Vec<_>> = operands
            .iter()
            .map(|kind| verify::sample(algebra, kind, &mut sequence))
            .collect();
        let Some(members) = members else { return false };
        let Some(meaning) = verify::evaluate(algebra, operands, expression, &members) else {
            return false;
        };
        let expected = match result {
            None => vec![meaning.get(&Blade::SCALAR).copied().unwrap_or(Prime::ZERO)],
            Some(kind) => verify::stored(kind, &meaning),
        };
        self.evaluate(&inputs_of(operands, &members)) == expected
    }

    /// Whether the graph agrees with the plain meaning of a program at the points of its witness.
    #[must_use]
    pub fn agrees_with(
        &self,
        program: &Program<'_>,
        witness: &Witness,
        wanted: &[(StepId, Vec<NamedBlade>)],
    ) -> bool {
        witness.points().all(|(members, values)| {
            let expected = wanted.iter().flat_map(|(step, blades)| {
                let value = &values[step.index()];
                blades.iter().map(|named| {
                    let found = value.get(&named.blade).copied().unwrap_or(Prime::ZERO);
                    if named.is_negative { -found } else { found }
                })
            });
            let found = self.evaluate(&inputs_of(&program.operands, members));
            found.into_iter().eq(expected)
        })
    }
}

/// A program and what is wanted of it.
pub(crate) struct Task<'a> {
    pub(crate) algebra: &'a Algebra,
    pub(crate) program: &'a Program<'a>,
    pub(crate) uniform: &'a [bool],
    pub(crate) wanted: &'a [(StepId, Vec<NamedBlade>)],
}

impl Task<'_> {
    /// The kernel by given rules, and the steps in which versors act.
    pub(crate) fn compile(&self, choices: &Choices) -> (Kernel, Vec<StepId>) {
        let mut arena = Arena::default();
        let mut uniform = Vec::new();
        let mut inputs = Vec::new();
        for (kind, is_uniform) in self.program.operands.iter().zip(self.uniform) {
            inputs.push(lower::operand(&mut arena, kind, choices.all.held));
            uniform.resize(arena.inputs(), *is_uniform);
        }
        let steps: Vec<StepId> = self.wanted.iter().map(|(step, _)| *step).collect();
        let Lowered { values, acted } = lower::lower(
            &mut arena,
            self.algebra,
            self.program,
            &inputs,
            &steps,
            choices,
        );
        let mut outputs = Vec::new();
        for (value, (_, blades)) in values.iter().zip(self.wanted) {
            for named in blades {
                let found = value.coefficient(named.blade);
                outputs.push(if named.is_negative { -found } else { found });
            }
        }
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
        let kernel = Kernel {
            arena,
            outputs,
            choices: choices.clone(),
            uniform,
        };
        (kernel, acted)
    }
}

/// The graph with its differences the right way round.
fn finished(graph: passes::Graph) -> passes::Graph {
    let rank = |graph: &passes::Graph| passes::cost(&graph.0, &graph.1).rank();
    match passes::orient(&graph.0, &graph.1) {
        Some(turned) if rank(&turned) < rank(&graph) => turned,
        _ => graph,
    }
}

/// The stored coefficients of some members, one after the other.
fn inputs_of(operands: &[&TypeDefinition], members: &[verify::Numbers]) -> Vec<Prime> {
    operands
        .iter()
        .zip(members)
        .flat_map(|(kind, member)| verify::stored(kind, member))
        .collect()
}

/// The stored blades of a type, or the scalar.
#[must_use]
pub fn wanted(result: Option<&TypeDefinition>) -> Vec<NamedBlade> {
    let scalar = NamedBlade {
        blade: Blade::SCALAR,
        is_negative: false,
    };
    let stored = |kind: &TypeDefinition| {
        kind.stored()
            .map(|c| NamedBlade {
                blade: c.blade,
                is_negative: c.is_negative,
            })
            .collect()
    };
    result.map_or_else(|| vec![scalar], stored)
}

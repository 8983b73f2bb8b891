//! One compiled expression: the path from an expression over typed operands to a graph with chosen rules.

use crate::algebra::{Algebra, Blade, NamedBlade, Ratio, Unary};
use crate::define::TypeDefinition;
use crate::emit::stage::Stages;
use crate::expression::Expression;
use crate::ir::{Arena, Prime, Value};
use crate::lower::{self, SandwichRule};
use crate::passes::{self, Cost};
use crate::program::{Program, Step, StepId, Witness};
use crate::verify;

/// A graph whose inputs are the stored coefficients of the operands, one after the other, and whose outputs are the
/// stored coefficients of the result, all in the order of their declarations.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// The graph.
    pub arena: Arena,
    /// The outputs.
    pub outputs: Vec<Value>,
    /// The rule that won.
    pub rule: SandwichRule,
    /// For each input, whether it stays the same over many calls. What depends on such inputs alone is the prologue.
    pub uniform: Vec<bool>,
}

/// The number of operations from which a graph is left as it was built: passes take time, and nobody waits gladly for the product
/// of two multivectors of 32 blades.
const LARGEST: usize = 400;

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

    /// Compiles a program, wanting the given blades of some of its steps. `uniform` marks operands that stay the same over
    /// many calls.
    ///
    /// Each rule for sandwiches is tried, and the cheapest graph is kept; of equals the first.
    #[must_use]
    pub fn of_program(
        algebra: &Algebra,
        program: &Program<'_>,
        uniform: &[bool],
        wanted: &[(StepId, Vec<NamedBlade>)],
    ) -> Self {
        let by_rule = |rule, rederive| {
            Self::of_program_by_rule(algebra, program, uniform, wanted, rule, rederive)
        };
        let mut best = by_rule(SandwichRule::LeftFirst, false);
        let rules: &[_] = if has_sandwich(program) {
            &SandwichRule::ALL
        } else {
            &[SandwichRule::LeftFirst]
        };
        let rederivations: &[_] = if program.has_kinds() {
            &[false, true]
        } else {
            &[false]
        };
        for &rederive in rederivations {
            for &rule in rules {
                if (rule, rederive) == (SandwichRule::LeftFirst, false) {
                    continue;
                }
                let next = by_rule(rule, rederive);
                if next.rank() < best.rank() {
                    best = next;
                }
            }
        }
        best
    }

    /// Compiles an expression with a given rule for sandwiches.
    #[must_use]
    pub fn by_rule(
        algebra: &Algebra,
        operands: &[&TypeDefinition],
        expression: &Expression,
        wanted: &[NamedBlade],
        rule: SandwichRule,
    ) -> Self {
        let (program, result) = Program::of_expression(operands, expression);
        let uniform = vec![false; operands.len()];
        let wanted = [(result, wanted.to_vec())];
        Self::of_program_by_rule(algebra, &program, &uniform, &wanted, rule, false)
    }

    fn of_program_by_rule(
        algebra: &Algebra,
        program: &Program<'_>,
        uniform: &[bool],
        wanted: &[(StepId, Vec<NamedBlade>)],
        rule: SandwichRule,
        rederive: bool,
    ) -> Self {
        let mut arena = Arena::default();
        let mut uniform_inputs = Vec::new();
        let mut inputs = Vec::new();
        for (kind, is_uniform) in program.operands.iter().zip(uniform) {
            inputs.push(lower::operand(&mut arena, kind));
            uniform_inputs.resize(arena.inputs(), *is_uniform);
        }
        let steps: Vec<StepId> = wanted.iter().map(|(step, _)| *step).collect();
        let values = lower::lower(
            &mut arena, algebra, program, &inputs, &steps, rule, rederive,
        );
        let mut outputs = Vec::new();
        for (value, (_, blades)) in values.iter().zip(wanted) {
            for named in blades {
                let found = value.coefficient(named.blade);
                outputs.push(if named.is_negative { -found } else { found });
            }
        }
        if passes::cost(&arena, &outputs).total() > LARGEST {
            return Self {
                arena,
                outputs,
                rule,
                uniform: uniform_inputs,
            };
        }
        let mut relations = Vec::new();
        for input in &inputs {
            relations.extend(passes::relations(&mut arena, algebra, input));
        }
        let graph = passes::optimise(arena, outputs, &uniform_inputs, &relations);
        let (arena, outputs) = passes::reciprocal(&graph.0, &graph.1).unwrap_or(graph);
        Self {
            arena,
            outputs,
            rule,
            uniform: uniform_inputs,
        }
    }

    /// What decides between graphs: the operations of each call, then those of the prologue.
    fn rank(&self) -> (usize, usize) {
        let all = self.cost().total();
        if !self.uniform.contains(&true) {
            return (all, 0);
        }
        let handed = Stages::new(self).handed.into_iter().map(|node| Value {
            factor: Ratio::ONE,
            node,
        });
        let prologue = passes::cost(&self.arena, &handed.collect::<Vec<_>>()).total();
        (all - prologue, prologue)
    }

    /// The number of operations.
    #[must_use]
    pub fn cost(&self) -> Cost {
        passes::cost(&self.arena, &self.outputs)
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

    /// Whether the graph agrees with the plain meaning of the expression at a random point of the operands' types.
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

/// Whether a program has an action of a versor, or a product that may be one.
fn has_sandwich(program: &Program<'_>) -> bool {
    program
        .steps()
        .any(|(_, step)| matches!(step, Step::Sandwich(..) | Step::Unary(Unary::Reverse, _)))
}

//! One compiled expression: the path from an expression over typed operands to a graph with chosen rules.

use std::cmp::Ordering;

use crate::algebra::{Algebra, Blade, NamedBlade, Product, Ratio, Unary};
use crate::define::{Role, TypeDefinition};
use crate::emit::stage::Stages;
use crate::expression::Expression;
use crate::ir::{Arena, Prime, Value};
use crate::lower::{self, Choice, InnerRule, JoinRule, SandwichRule};
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
    /// The rules that won.
    pub choice: Choice,
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
    /// The rules are tried, and the cheapest graph is kept; of equals the first.
    #[must_use]
    pub fn of_program(
        algebra: &Algebra,
        program: &Program<'_>,
        uniform: &[bool],
        wanted: &[(StepId, Vec<NamedBlade>)],
    ) -> Self {
        let by_choice =
            |choice| Self::of_program_by_choice(algebra, program, uniform, wanted, choice);
        let mut best = by_choice(Choice::default());
        // One kind of rule after the other: all combinations would be too many.
        if has_sandwich(program) {
            for sandwich in SandwichRule::ALL {
                best.improve(
                    Choice {
                        sandwich,
                        ..best.choice
                    },
                    &by_choice,
                );
            }
        }
        if has_product(program, &[Product::Wedge]) {
            for join in JoinRule::ALL {
                best.improve(
                    Choice {
                        join,
                        ..best.choice
                    },
                    &by_choice,
                );
            }
        }
        let inner = [
            Product::LeftContraction,
            Product::RightContraction,
            Product::ScalarProduct,
        ];
        if has_product(program, &inner) {
            for inner in InnerRule::ALL {
                best.improve(
                    Choice {
                        inner,
                        ..best.choice
                    },
                    &by_choice,
                );
            }
        }
        if program.has_kinds() {
            let rederived = Choice {
                rederive: true,
                ..best.choice
            };
            best.improve(rederived, &by_choice);
            for sandwich in SandwichRule::ALL {
                let choice = Choice {
                    sandwich,
                    ..rederived
                };
                best.improve(choice, &by_choice);
            }
        }
        let is_derived = |kind: &&TypeDefinition| {
            let mut roles = kind.coefficients.iter().map(|c| &c.role);
            roles.any(|role| matches!(role, Role::Derived(_)))
        };
        if program.operands.iter().any(is_derived) {
            let held = Choice {
                held: true,
                ..best.choice
            };
            best.improve(held, &by_choice);
        }
        best
    }

    /// Takes other rules if they make a cheaper graph. Of equals the one by differences stands, which rounds less.
    fn improve(&mut self, choice: Choice, by_choice: &impl Fn(Choice) -> Self) {
        if choice == self.choice {
            return;
        }
        let next = by_choice(choice);
        let is_exacter = |choice: Choice| {
            choice.inner == InnerRule::Distance || choice.join == JoinRule::Difference
        };
        let is_better = match next.rank().cmp(&self.rank()) {
            Ordering::Less => true,
            Ordering::Equal => is_exacter(choice) && !is_exacter(self.choice),
            Ordering::Greater => false,
        };
        if is_better {
            *self = next;
        }
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
        Self::of_program_by_choice(algebra, &program, &uniform, &wanted, choice)
    }

    /// Compiles a program with given rules.
    #[must_use]
    pub fn of_program_by_choice(
        algebra: &Algebra,
        program: &Program<'_>,
        uniform: &[bool],
        wanted: &[(StepId, Vec<NamedBlade>)],
        choice: Choice,
    ) -> Self {
        let mut arena = Arena::default();
        let mut uniform_inputs = Vec::new();
        let mut inputs = Vec::new();
        for (kind, is_uniform) in program.operands.iter().zip(uniform) {
            inputs.push(lower::operand(&mut arena, kind, choice.held));
            uniform_inputs.resize(arena.inputs(), *is_uniform);
        }
        let steps: Vec<StepId> = wanted.iter().map(|(step, _)| *step).collect();
        let values = lower::lower(&mut arena, algebra, program, &inputs, &steps, choice);
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
                choice,
                uniform: uniform_inputs,
            };
        }
        let mut relations = Vec::new();
        for input in &inputs {
            relations.extend(passes::relations(&mut arena, algebra, input));
        }
        let graph = passes::optimise(arena, outputs, &uniform_inputs, &relations);
        let (arena, outputs) = passes::reciprocal(&graph.0, &graph.1).unwrap_or(graph);
        let (arena, outputs) = match passes::orient(&arena, &outputs) {
            Some(turned)
                if passes::cost(&turned.0, &turned.1).rank()
                    < passes::cost(&arena, &outputs).rank() =>
            {
                turned
            }
            _ => (arena, outputs),
        };
        Self {
            arena,
            outputs,
            choice,
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

/// Whether a program has one of some products.
fn has_product(program: &Program<'_>, products: &[Product]) -> bool {
    program
        .steps()
        .any(|(_, step)| matches!(step, Step::Binary(product, ..) if products.contains(product)))
}

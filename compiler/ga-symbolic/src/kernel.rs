//! One compiled graph: what it computes, what it costs, and whether it agrees with its source.

use crate::algebra::{Algebra, Blade, NamedBlade, Ratio};
use crate::define::TypeDefinition;
use crate::expression::Expression;
use crate::ir::{Arena, Node, Number, Outcomes, Residue, Value};
use crate::limit::SearchLimit;
use crate::lower::Choices;
use crate::passes::{self, Cost, Stages};
use crate::program::{Program, StepId, Witness};
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
    /// For each input, whether it stays the same over many calls. The nodes that depend on such
    /// inputs alone are the prologue.
    pub uniform: Vec<bool>,
    /// Numbers of the source that are inputs of the graph, after those of the operands, since
    /// products of them have too many digits.
    pub literals: Vec<Ratio>,
    /// The limits of the search that were reached, in rising order.
    pub limits: Vec<SearchLimit>,
}

impl Kernel {
    /// The cost by which graphs are compared: the operations of each call, then those of the
    /// prologue.
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
        let handed = self.stages().handed.into_iter().map(Value::of);
        passes::cost(&self.arena, &handed.collect::<Vec<_>>())
    }

    /// What depends on uniform inputs alone, apart from the rest.
    #[must_use]
    pub fn stages(&self) -> Stages {
        Stages::new(&self.arena, &self.outputs, &self.uniform)
    }

    /// The number of operations.
    #[must_use]
    pub fn cost(&self) -> Cost {
        passes::cost(&self.arena, &self.outputs)
    }

    /// Whether some constant in it is out of the range of exact arithmetic.
    #[must_use]
    pub fn is_out_of_range(&self) -> bool {
        let is_beyond = |value: &Value| value.factor.is_out_of_range();
        let in_graph = self.arena.ids().any(|id| match self.arena.node(id) {
            Node::Sum(values) | Node::Function(_, values) => values.iter().any(is_beyond),
            Node::One | Node::Input(_) | Node::Product(..) | Node::Quotient(..) => false,
        });
        in_graph || self.outputs.iter().any(is_beyond)
    }

    /// The outputs for given inputs over the prime field; zero where a root does not exist there.
    #[must_use]
    pub fn evaluate(&self, inputs: &[Residue]) -> Vec<Residue> {
        let inputs: Vec<Number> = inputs.iter().copied().map(Number::from).collect();
        let outputs = self
            .evaluate_with(&inputs, &Outcomes::default())
            .into_iter();
        outputs
            .map(|x| x.residue().unwrap_or(Residue::ZERO))
            .collect()
    }

    fn evaluate_with(&self, inputs: &[Number], outcomes: &Outcomes) -> Vec<Number> {
        let mut inputs = inputs.to_vec();
        inputs.extend(self.literals.iter().copied().map(Number::from_ratio));
        let values = self.arena.evaluate_with(&inputs, outcomes);
        self.outputs
            .iter()
            .map(|output| values[output.node.index()] * Number::from_ratio(output.factor))
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
            None => vec![meaning.get(&Blade::SCALAR).copied().unwrap_or(Number::ZERO)],
            Some(kind) => verify::stored(kind, &meaning),
        };
        self.has_outputs(operands, &members, &Outcomes::default(), expected)
    }

    /// Whether the graph agrees with the plain meaning of a program at the points of its witness.
    #[must_use]
    pub fn agrees_with(
        &self,
        program: &Program<'_>,
        witness: &Witness,
        wanted: &[(StepId, Vec<NamedBlade>)],
    ) -> bool {
        witness.points().all(|(members, values, outcomes)| {
            let expected = wanted.iter().flat_map(|(step, blades)| {
                let value = &values[step.index()];
                blades.iter().map(|named| {
                    let found = value.get(&named.blade).copied().unwrap_or(Number::ZERO);
                    if named.is_negative { -found } else { found }
                })
            });
            self.has_outputs(&program.operands, members, outcomes, expected)
        })
    }

    /// Whether the outputs at some members of the operands' types are those that are expected.
    fn has_outputs(
        &self,
        operands: &[&TypeDefinition],
        members: &[verify::Numbers],
        outcomes: &Outcomes,
        expected: impl IntoIterator<Item = Number>,
    ) -> bool {
        let stored = operands.iter().zip(members);
        let stored = stored.flat_map(|(kind, member)| verify::stored(kind, member));
        let found = self.evaluate_with(&stored.collect::<Vec<_>>(), outcomes);
        let mut both = found.into_iter().zip(expected);
        both.all(|(found, expected)| found.stands_for(expected))
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Metric, Product};
    use crate::ir::Function;
    use crate::program::Step;
    use crate::task::Task;

    /// 89 is not a square among the residues, so that `√(89² x²)` is `−89 |x|` there.
    #[test]
    fn a_wrong_sign_is_refused_where_residues_agree() {
        let algebra = Algebra::new(&["e1".to_owned()], Metric::signature(1, 0, 0));
        let scalar = TypeDefinition::scalar();
        let program_of = |factor: i128, is_root: bool| {
            let mut program = Program::new(&[&scalar]);
            let x = program.push(Step::Operand(0));
            let factor = program.push(Step::Constant(Blade::SCALAR, Ratio::integer(factor)));
            let product = |program: &mut Program<'_>, a, b| {
                program.push(Step::Binary(Product::Geometric, a, b))
            };
            let result = if is_root {
                let square = product(&mut program, x, x);
                let square = product(&mut program, factor, square);
                program.push(Step::Function(Function::SquareRoot, vec![square]))
            } else {
                let size = program.push(Step::Function(Function::Absolute, vec![x]));
                product(&mut program, factor, size)
            };
            (program, vec![(result, wanted(None))])
        };
        let compiled = |program: &Program<'_>, outputs: &[(StepId, Vec<NamedBlade>)]| {
            Task::of_program(&algebra, program, outputs.to_vec()).compile()
        };
        let (program, outputs) = program_of(89 * 89, true);
        let mut witness = Witness::default();
        assert!(witness.extend(&algebra, &program));
        let right = compiled(&program, &outputs);
        assert!(right.agrees_with(&program, &witness, &outputs));
        let (other, other_outputs) = program_of(-89, false);
        let wrong = compiled(&other, &other_outputs);
        for x in [3, 5, 7, 11].map(Residue::new) {
            assert_eq!(wrong.evaluate(&[x]), right.evaluate(&[x]));
        }
        assert!(!wrong.agrees_with(&program, &witness, &outputs));
    }
}

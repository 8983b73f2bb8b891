//! One compiled expression: the path from an expression over typed operands to a graph with chosen rules.

use crate::algebra::{Algebra, Blade, NamedBlade};
use crate::define::TypeDefinition;
use crate::expression::Expression;
use crate::ir::{Arena, Multivector, Prime, Value};
use crate::lower::{self, SandwichRule};
use crate::passes::{self, Cost};
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
    ///
    /// Each rule for sandwiches is tried, and the cheapest graph is kept; of equals the first.
    #[must_use]
    pub fn of_blades(
        algebra: &Algebra,
        operands: &[&TypeDefinition],
        expression: &Expression,
        wanted: &[NamedBlade],
    ) -> Self {
        let by_rule = |rule| Self::by_rule(algebra, operands, expression, wanted, rule);
        let mut best = by_rule(SandwichRule::LeftFirst);
        if has_sandwich(expression) {
            for rule in SandwichRule::ALL {
                let next = by_rule(rule);
                if next.cost().total() < best.cost().total() {
                    best = next;
                }
            }
        }
        best
    }

    /// Compiles with a given rule for sandwiches.
    #[must_use]
    pub fn by_rule(
        algebra: &Algebra,
        operands: &[&TypeDefinition],
        expression: &Expression,
        wanted: &[NamedBlade],
        rule: SandwichRule,
    ) -> Self {
        let mut arena = Arena::default();
        let inputs: Vec<Multivector> = operands
            .iter()
            .map(|kind| lower::operand(&mut arena, kind))
            .collect();
        let value = lower::lower(&mut arena, algebra, expression, &inputs, rule);
        let outputs = wanted
            .iter()
            .map(|named| {
                let found = value.coefficient(named.blade);
                if named.is_negative { -found } else { found }
            })
            .collect();
        Self {
            uniform: vec![false; arena.inputs()],
            arena,
            outputs,
            rule,
        }
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
        let inputs: Vec<Prime> = operands
            .iter()
            .zip(&members)
            .flat_map(|(kind, member)| verify::stored(kind, member))
            .collect();
        let meaning = verify::evaluate(algebra, expression, &members);
        let expected = match result {
            None => vec![meaning.get(&Blade::SCALAR).copied().unwrap_or(Prime::ZERO)],
            Some(kind) => verify::stored(kind, &meaning),
        };
        self.evaluate(&inputs) == expected
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

fn has_sandwich(expression: &Expression) -> bool {
    match expression {
        Expression::Operand(_) | Expression::Constant(_) => false,
        Expression::Sandwich(..) => true,
        Expression::Unary(_, a) | Expression::Negative(a) => has_sandwich(a),
        Expression::Binary(_, a, b) | Expression::Sum(a, b) | Expression::Quotient(a, b) => {
            has_sandwich(a) || has_sandwich(b)
        }
    }
}

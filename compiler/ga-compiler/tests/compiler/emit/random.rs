//! Random graphs, for properties of every graph.

use ga_compiler::algebra::Ratio;
use ga_compiler::function::{CompiledFunction, Operand, Shape};
use ga_compiler::ir::{Arena, Function, Node, Residue, ResidueSequence, Value};
use ga_compiler::kernel::Kernel;
use proptest::prelude::*;

/// The operands of random functions: `x: [Scalar; 3]`, `uniform u: [Scalar; 2]`.
const INPUTS: [usize; 2] = [3, 2];

/// One operation on earlier values.
#[derive(Clone, Debug)]
pub(crate) struct Step {
    kind: u8,
    places: [usize; 3],
    factors: [(i8, i8); 3],
}

/// A function of a few numbers.
#[derive(Clone, Debug)]
pub(crate) struct Recipe {
    steps: Vec<Step>,
    outputs: Vec<(usize, (i8, i8))>,
    /// Whether the second operand is uniform.
    is_staged: bool,
}

/// Any function.
pub(crate) fn functions(is_staged: bool) -> impl Strategy<Value = Recipe> {
    let factor = || (-4_i8..=4, 1_i8..=3);
    let places = [any::<usize>(), any::<usize>(), any::<usize>()];
    let step = (0_u8..13, places, [factor(), factor(), factor()]);
    let step = step.prop_map(|(kind, places, factors)| Step {
        kind,
        places,
        factors,
    });
    let steps = prop::collection::vec(step, 1..24);
    let outputs = prop::collection::vec((any::<usize>(), factor()), 1..4);
    (steps, outputs).prop_map(move |(steps, outputs)| Recipe {
        steps,
        outputs,
        is_staged,
    })
}

/// Inputs for a function, the same for the same seed, at which its roots exist in the prime field.
/// `None` where there are too many roots to find such inputs.
pub(crate) fn inputs(function: &CompiledFunction, seed: u64) -> Option<Vec<Residue>> {
    let mut sequence = ResidueSequence::new(seed);
    let arena = &function.kernel.arena;
    let has_roots = |inputs: &Vec<Residue>| {
        let values = arena.evaluate(inputs);
        arena.ids().all(|id| match arena.node(id) {
            Node::Function(Function::SquareRoot, arguments) => {
                let argument = arguments[0];
                let value = values[argument.node.index()] * Residue::from_ratio(argument.factor);
                value.square_root().is_some_and(Residue::is_real)
            }
            _ => true,
        })
    };
    (0..64)
        .map(|_| {
            (0..arena.inputs())
                .map(|_| sequence.next_residue())
                .collect()
        })
        .find(has_roots)
}

impl Recipe {
    /// The function itself.
    pub(crate) fn build(&self) -> CompiledFunction {
        let Self {
            steps,
            outputs,
            is_staged,
        } = self;
        let is_staged = *is_staged;
        let mut arena = Arena::default();
        let mut values: Vec<Value> = (0..INPUTS.iter().sum()).map(|_| arena.input()).collect();
        for step in steps {
            let [a, b, c] = [0, 1, 2].map(|k| {
                let value = values[step.places[k] % values.len()];
                value.scaled(ratio(step.factors[k]))
            });
            let next = match step.kind {
                0..=2 => arena.product(a, b),
                3..=5 => arena.sum([a, b, c]),
                6 => arena.sum([a, Value::ONE]),
                7 => arena.quotient(a, b).unwrap_or(Value::ONE),
                // Functions of constants are evaluated when they are called, not when they are
                // compiled.
                _ if a.as_constant().is_some() || b.as_constant().is_some() => a,
                8 => arena.function(Function::SquareRoot, &[a]),
                10 => {
                    let is_less = arena.function(Function::Less, &[a, b]);
                    arena.function(Function::Select, &[is_less, c, a])
                }
                11 => {
                    let is_equal = arena.function(Function::Equal, &[a, c]);
                    let is_most = arena.function(Function::LessOrEqual, &[b, c]);
                    let other = arena.function(Function::Not, &[is_most]);
                    let both = arena.function(Function::And, &[is_equal, other]);
                    let either = arena.function(Function::Or, &[both, is_most]);
                    arena.function(Function::Select, &[either, a, b])
                }
                12 => {
                    let least = arena.function(Function::Minimum, &[a, b]);
                    arena.function(Function::Maximum, &[least, c])
                }
                _ => arena.function(Function::ArcTangent, &[a, b]),
            };
            values.push(next);
        }
        let outputs: Vec<Value> = outputs
            .iter()
            .map(|&(place, factor)| {
                values[values.len() - 1 - place % values.len()].scaled(ratio(factor))
            })
            .collect();
        let scalars = |count| Shape::Array(Box::new(Shape::Scalar), count);
        let operand = |name: &str, place: usize| Operand {
            name: quote::format_ident!("{name}"),
            shape: scalars(INPUTS[place]),
            is_uniform: is_staged && place == 1,
        };
        CompiledFunction {
            attributes: Vec::new(),
            visibility: syn::Visibility::Inherited,
            name: Some(quote::format_ident!("f")),
            operands: vec![operand("x", 0), operand("u", 1)],
            warnings: Vec::new(),
            result: scalars(outputs.len()),
            kernel: Kernel {
                uniform: (0..arena.inputs())
                    .map(|input| is_staged && input >= INPUTS[0])
                    .collect(),
                arena,
                literals: Vec::new(),
                limits: Vec::new(),
                outputs,
                choices: ga_compiler::lower::Choices::default(),
            },
        }
    }
}

fn ratio((numerator, denominator): (i8, i8)) -> Ratio {
    Ratio::new(numerator.into(), denominator.into()).expect("a positive denominator")
}

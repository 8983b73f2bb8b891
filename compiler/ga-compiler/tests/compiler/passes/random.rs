//! Random graphs: no pass changes a value, and all passes together do not increase the cost.

use ga_compiler::algebra::Ratio;
use ga_compiler::ir::{Arena, Function, Node, Residue, Value};
use ga_compiler::passes::{
    Graph, cost, factor, flatten, hoist, optimise, reduce, scale, schedule, share, substitute,
};
use proptest::prelude::*;

use super::{evaluate, operands, point, total, varying};

/// One step of building a graph: what to do, with which earlier values and which factors.
type Step = (u8, [prop::sample::Index; 3], [i8; 3]);

const INPUTS: usize = 5;

fn steps() -> impl Strategy<Value = Vec<Step>> {
    let factor = prop::sample::select(vec![-4, -2, -1, -1, 1, 1, 2, 3]);
    let step = (
        0_u8..12,
        any::<[prop::sample::Index; 3]>(),
        [factor.clone(), factor.clone(), factor],
    );
    prop::collection::vec(step, 1..40)
}

/// A graph of sums and products of the inputs, with some quotients, roots and held multiples; the
/// last values are the outputs.
fn build(arena: &mut Arena, inputs: &[Value], steps: &[Step]) -> Vec<Value> {
    let mut values = inputs.to_vec();
    values.push(Value::ONE);
    for (kind, places, factors) in steps {
        let [a, b, c] = [0, 1, 2].map(|n: usize| {
            values[places[n].index(values.len())].scaled(Ratio::integer(factors[n].into()))
        });
        let next = match kind {
            0..=3 => arena.sum([a, b, c]),
            4 => arena.sum([a, b]),
            5 => arena.sum([a.scaled(Ratio::new(1, 2).expect("a half")), b]),
            6 => arena.held(a),
            7 if !b.is_zero() => arena.quotient(a, b).unwrap_or(Value::ZERO),
            8 => arena.function(Function::SquareRoot, &[a]),
            _ => arena.product(a, b),
        };
        values.push(next);
    }
    values.split_off(values.len().saturating_sub(6).max(INPUTS + 1))
}

fn random_graph(steps: &[Step]) -> Graph {
    let mut arena = Arena::default();
    let inputs: Vec<Value> = (0..INPUTS).map(|_| arena.input()).collect();
    let outputs = build(&mut arena, &inputs, steps);
    (arena, outputs)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn every_pass_keeps_the_values(
        steps in steps(),
        uniform in prop::collection::vec(any::<bool>(), 0..=INPUTS),
        seed: u64,
    ) {
        let graph = random_graph(&steps);
        let inputs = point(seed, INPUTS);
        let expected = evaluate(&graph, &inputs);
        let (arena, outputs) = &graph;
        let passes = [
            ("flatten", flatten(arena, outputs)),
            ("factor", factor(arena, outputs, &uniform)),
            ("share", share(arena, outputs)),
            ("substitute", substitute(arena, outputs)),
            ("scale", scale(arena, outputs, &uniform)),
            ("hoist", hoist(arena, outputs, &uniform)),
        ];
        for (name, result) in passes {
            if let Some(result) = result {
                prop_assert_eq!(&evaluate(&result, &inputs), &expected, "{}", name);
            }
        }
        let all = optimise(arena.clone(), outputs.clone(), &uniform, &[]);
        prop_assert_eq!(evaluate(&all, &inputs), expected);
    }

    #[test]
    fn flat_graphs_are_factored_shared_and_scaled_correctly(steps in steps(), seed: u64) {
        let mut graph = random_graph(&steps);
        let inputs = point(seed, INPUTS);
        let expected = evaluate(&graph, &inputs);
        type Pass = fn(&Arena, &[Value]) -> Option<Graph>;
        let passes: [(&str, Pass); 6] = [
            ("flatten", flatten),
            ("factor", |arena, outputs| factor(arena, outputs, &[])),
            ("share", share),
            ("substitute", substitute),
            ("scale", |arena, outputs| scale(arena, outputs, &[])),
            ("flatten again", flatten),
        ];
        for (name, pass) in passes {
            if let Some(next) = pass(&graph.0, &graph.1) {
                graph = next;
                prop_assert_eq!(&evaluate(&graph, &inputs), &expected, "{}", name);
            }
        }
    }

    #[test]
    fn no_graph_becomes_more_expensive(steps in steps()) {
        let (arena, outputs) = random_graph(&steps);
        let before = cost(&arena, &outputs).total();
        let after = optimise(arena, outputs, &[], &[]);
        prop_assert!(total(&after) <= before, "{} from {before}", total(&after));
    }

    #[test]
    fn no_graph_varies_more(
        steps in steps(),
        uniform in prop::collection::vec(any::<bool>(), INPUTS),
    ) {
        let graph = random_graph(&steps);
        let before = varying(&graph, &uniform);
        let after = optimise(graph.0, graph.1, &uniform, &[]);
        let after = varying(&after, &uniform);
        prop_assert!(after <= before, "{after} from {before}");
    }

    /// The last input is computed from the others, so that a relation holds, which the pass knows.
    #[test]
    fn reduction_keeps_the_values_where_the_relations_hold(
        steps in steps(),
        factors in prop::array::uniform3(-2_i8..=2),
        seed: u64,
    ) {
        let mut arena = Arena::default();
        let inputs: Vec<Value> = (0..INPUTS).map(|_| arena.input()).collect();
        let terms: Vec<Value> = (0..3)
            .map(|n| {
                let product = arena.product(inputs[n], inputs[(n + 1) % 3]);
                product.scaled(Ratio::integer(factors[n].into()))
            })
            .chain([-inputs[4]])
            .collect();
        let relation = arena.sum(terms.iter().copied());
        // Sums with the relation in them, so that there is something to reduce.
        let mut starts = inputs.clone();
        starts.push(arena.sum([terms[0], terms[1], terms[2], inputs[3]]));
        starts.push(arena.sum([terms[0], -terms[1], terms[2]]));
        let outputs = build(&mut arena, &starts, &steps);
        let mut point = point(seed, INPUTS);
        let values = arena.evaluate(&point);
        point[4] = terms[..3].iter().fold(Residue::ZERO, |sum, term| {
            sum + values[term.node.index()] * Residue::from_ratio(term.factor)
        });
        let graph = (arena, outputs);
        let expected = evaluate(&graph, &point);
        if let Some(reduced) = reduce(&graph.0, &graph.1, &[relation]) {
            prop_assert_eq!(&evaluate(&reduced, &point), &expected);
        }
        let before = total(&graph);
        let all = optimise(graph.0, graph.1, &[], &[relation]);
        prop_assert_eq!(evaluate(&all, &point), expected);
        prop_assert!(total(&all) <= before);
    }

    #[test]
    fn an_order_computes_before_it_reads(steps in steps()) {
        let (arena, outputs) = random_graph(&steps);
        let found = schedule(&arena, &outputs);
        let place = |id| found.order.iter().position(|other| *other == id);
        for (here, id) in found.order.iter().enumerate() {
            prop_assert_eq!(place(*id), Some(here), "twice");
            for operand in operands(arena.node(*id)) {
                if !matches!(arena.node(operand), Node::One | Node::Input(_)) {
                    prop_assert!(place(operand) < Some(here) && place(operand).is_some());
                }
            }
        }
        prop_assert_eq!(&found.order, &schedule(&arena, &outputs).order);
    }
}

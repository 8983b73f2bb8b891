//! The passes, on random graphs and on graphs whose least cost is known.

mod random;
mod rotors;

use crate::algebras::cga3_tokens;
use ga_compiler::algebra::Ratio;
use ga_compiler::compile_function;
use ga_compiler::ir::{Arena, Node, NodeId, Residue, ResidueSequence, Value};
use ga_compiler::passes::{
    Cost, Graph, cost, factor, flatten, hoist, optimise, reciprocal, reduce, schedule,
};

#[test]
fn what_needs_most_registers_comes_first() {
    // a b + (c d + (a d + (b c + (a c)(b d)))), the deepest part written last: as written, a
    // product waits at each level.
    let nested = graph(|arena, [a, b, c, d]| {
        let pairs = [(a, b), (c, d), (a, d), (b, c)];
        // The products come first in the arena, so that each sum reads its product before the rest.
        let products = pairs.map(|(x, y)| arena.product(x, y));
        let mut whole = arena.product(a, c);
        for product in products.into_iter().rev() {
            let inner = arena.sum([whole, product]);
            whole = arena.product(inner, inner);
        }
        vec![whole]
    });
    let (arena, outputs) = &nested;
    let found = schedule(arena, outputs);
    assert_eq!(found.pressure(arena), 2);
    assert_eq!(found.order.len(), 13);
}

#[test]
fn sums_that_cancel_vanish() {
    let norm = graph(|arena, [x, y, z]| {
        let squares = [x, y, z].map(|v| arena.product(v, v));
        let norm = arena.sum(squares);
        let [a, b, _] = squares;
        // The norm is an output too: it is merged although it is read elsewhere.
        vec![
            norm,
            arena.sum([a, b, squares[2], -norm, x]),
            arena.sum([norm, -a, -b]),
        ]
    });
    let flat = flatten(&norm.0, &norm.1).expect("something cancels");
    assert_eq!(operations(count(&flat)), (3, 2));
}

#[test]
fn a_common_factor_is_taken_out() {
    let products = graph(|arena, [a, b, c, d]| {
        let terms = [b, c, d].map(|v| arena.product(a, v));
        vec![arena.sum(terms)]
    });
    assert_eq!(operations(count(&products)), (3, 2));
    assert_eq!(optimised(&products), (1, 2));
    let constants = graph(|arena, [a, b, c]| vec![arena.sum([a, twice(b), twice(c)])]);
    assert_eq!(operations(count(&constants)), (2, 2));
    assert_eq!(optimised(&constants), (1, 2));
}

#[test]
fn factors_are_found_in_products_of_products() {
    // d (a x) + e (a y) + f (z a) is a (d x + e y + f z), whatever was multiplied first.
    let products = graph(|arena, [a, d, e, f, x, y, z]| {
        let inner = [(a, x, d), (a, y, e), (z, a, f)];
        let terms = inner.map(|(first, second, last)| {
            let inner = arena.product(first, second);
            arena.product(last, inner)
        });
        vec![arena.sum(terms)]
    });
    assert_eq!(operations(count(&products)), (6, 2));
    assert_eq!(optimised(&products), (4, 2));
    // a b x + a b y + c: two factors come out together.
    let products = graph(|arena, [a, b, c, x, y]| {
        let (ax, bx) = (arena.product(a, x), arena.product(b, y));
        let terms = [arena.product(ax, b), arena.product(bx, a), c];
        vec![arena.sum(terms)]
    });
    assert_eq!(operations(count(&products)), (4, 2));
    assert_eq!(optimised(&products), (2, 2));
}

#[test]
fn a_sum_at_hand_decides_which_factor_is_taken_out() {
    // a b + a c + b d contains b + c or a + d; b + c is needed anyway.
    for other in [false, true] {
        let sums = graph(|arena, [a, b, c, d]| {
            let at_hand = if other {
                arena.sum([a, d])
            } else {
                arena.sum([b, c])
            };
            let (ab, ac, bd) = (
                arena.product(a, b),
                arena.product(a, c),
                arena.product(b, d),
            );
            vec![at_hand, arena.sum([ab, ac, bd])]
        });
        let found = factor(&sums.0, &sums.1, &[]).expect("a factor");
        assert_eq!(operations(count(&found)), (2, 2), "{other}");
    }
}

#[test]
fn a_common_part_is_shared_up_to_its_factor() {
    let sums = graph(|arena, [x, y, z, a, b, c]| {
        vec![
            arena.sum([x, -y, z, a]),
            arena.sum([x, -y, z, b]),
            arena.sum([-x, y, -z, c]),
            arena.sum([twice(x), twice(-y), a]),
        ]
    });
    // x − y; with z; three sums with it, and one with twice the first.
    assert_eq!(optimised(&sums), (1, 6));
}

#[test]
fn a_doubling_is_an_addition_where_half_of_it_is_at_hand() {
    let sums = graph(|arena, [x, d]| {
        vec![
            arena.sum([x, d]),
            arena.sum([x, twice(d)]),
            arena.sum([x, d.scaled(Ratio::integer(3))]),
        ]
    });
    assert_eq!(optimised(&sums), (0, 3));
    let sums = graph(|arena, [x, d]| vec![arena.sum([x, d]), arena.sum([x, twice(d)])]);
    assert_eq!(optimised(&sums), (0, 2));
}

#[test]
fn a_doubled_operand_is_doubled_once() {
    let sums = graph(|arena, [b, x, y, z, p, q, r]| {
        [(x, p), (y, q), (z, r)]
            .map(|(place, factor)| {
                let product = arena.product(b, factor);
                arena.sum([place, twice(product)])
            })
            .to_vec()
    });
    assert_eq!(operations(count(&sums)), (6, 3));
    assert_eq!(optimised(&sums), (4, 3));
}

#[test]
fn a_factor_of_a_result_moves_where_it_is_free() {
    // ½ (2 a + b) and a c: half of b is needed anyway.
    let half = |value: Value| value.scaled(Ratio::new(1, 2).expect("a half"));
    let sums = graph(|arena, [a, b]| {
        let held = arena.held(half(b));
        let square = arena.product(held, a);
        vec![arena.sum([a, half(b)]), arena.sum([square, a])]
    });
    assert_eq!(optimised(&sums), (2, 2));
}

#[test]
fn relations_serve_sums_that_were_built_before_them() {
    // a² + b² = d e: the product on the right is not there yet when the sum is built.
    let mut relation = Value::ZERO;
    let sums = graph(|arena, [a, b, c, d, e]| {
        let squares = [arena.product(a, a), arena.product(b, b)];
        let sum = arena.sum([squares[0], squares[1], c]);
        let product = arena.product(d, e);
        relation = arena.sum([squares[0], squares[1], -product]);
        vec![sum]
    });
    let point = [3, 1, 7, 5, 2].map(Residue::new);
    let expected = evaluate(&sums, &point);
    if let Some(reduced) = reduce(&sums.0, &sums.1, &[relation]) {
        assert_eq!(evaluate(&reduced, &point), expected);
    }
    let best = optimise(sums.0, sums.1, &[], &[relation]);
    assert_eq!(evaluate(&best, &point), expected);
    assert_eq!(operations(count(&best)), (1, 1));
}

#[test]
fn a_sum_that_is_part_of_a_relation_is_its_value() {
    // n = a² + b² is 1, and stands in the relation as one node, since others read it.
    let mut relation = Value::ZERO;
    let sums = graph(|arena, [a, b, c]| {
        let squares = [arena.product(a, a), arena.product(b, b)];
        let norm = arena.sum(squares);
        relation = arena.sum([norm, -Value::ONE]);
        vec![norm, arena.product(norm, c), arena.sum([norm, c])]
    });
    let (arena, outputs) = optimise(sums.0, sums.1, &[], &[relation]);
    assert_eq!(outputs[0], Value::ONE);
    assert_eq!(operations(cost(&arena, &outputs)), (0, 1));
}

#[test]
fn held_multiples_outlast_later_passes() {
    let graph = graph(|arena, [b, x, y, z]| {
        let doubled = arena.held(twice(b));
        let quotients = [x, y, z].map(|v| arena.quotient(v, b).expect("no constant"));
        let products = [x, y, z].map(|v| arena.product(doubled, v));
        [quotients, products].concat()
    });
    let (arena, outputs) = reciprocal(&graph.0, &graph.1).expect("three quotients by b");
    let cost = cost(&arena, &outputs);
    assert_eq!((cost.multiplications, cost.divisions), (1 + 3 + 3, 1));
}

#[test]
fn uniform_work_is_separated_from_the_rest() {
    // u v + w v costs one multiplication for each v where u and w are uniform.
    let uniform = [true, true, false, false];
    let sums = graph(|arena, [u, w, v, _]| {
        let terms = [arena.product(u, v), arena.product(w, v)];
        vec![arena.sum(terms)]
    });
    let factored = factor(&sums.0, &sums.1, &uniform).expect("v is common");
    assert_eq!((total(&factored), varying(&factored, &uniform)), (2, 1));
    // Of u v + w v + u x, v is the better factor: u (v + x) + w v has a sum that varies.
    let sums = graph(|arena, [u, w, v, x]| {
        let terms = [(u, v), (w, v), (u, x)].map(|(a, b)| arena.product(a, b));
        vec![arena.sum(terms)]
    });
    let factored = factor(&sums.0, &sums.1, &uniform).expect("u and v are common");
    assert_eq!((total(&factored), varying(&factored, &uniform)), (4, 3));
    // u + v + w one addition, u (v w) one multiplication, 2 u a multiple that is held.
    let sums = graph(|arena, [u, w, v, x]| {
        let product = arena.product(w, v);
        let doubled = arena.sum([x, twice(u)]);
        vec![arena.sum([u, v, w]), arena.product(u, product), doubled]
    });
    assert_eq!(varying(&sums, &uniform), 2 + 2 + 2);
    let hoisted = hoist(&sums.0, &sums.1, &uniform).expect("uniform terms");
    assert_eq!(varying(&hoisted, &uniform), 1 + 1 + 2);
    let best = optimise(sums.0, sums.1, &uniform, &[]);
    assert_eq!(varying(&best, &uniform), 3);
}

#[test]
fn the_square_of_a_point_is_the_constant_zero() {
    let function = "(p: Point) -> Scalar { p * p }".parse().expect("tokens");
    let Ok(compiled) = compile_function(cga3_tokens(), function) else {
        panic!("a product of points compiles")
    };
    let kernel = compiled.kernel;
    let (_, outputs) = optimise(kernel.arena, kernel.outputs, &[], &[]);
    assert_eq!(outputs, [Value::ZERO]);
}

fn evaluate((arena, outputs): &Graph, inputs: &[Residue]) -> Vec<Residue> {
    let values = arena.evaluate(inputs);
    let value = |output: &Value| values[output.node.index()] * Residue::from_ratio(output.factor);
    outputs.iter().map(value).collect()
}

fn point(seed: u64, count: usize) -> Vec<Residue> {
    let mut sequence = ResidueSequence::new(seed);
    (0..count).map(|_| sequence.next_residue()).collect()
}

fn count(graph: &Graph) -> Cost {
    cost(&graph.0, &graph.1)
}

fn total(graph: &Graph) -> usize {
    count(graph).total()
}

/// A graph from named inputs and the outputs computed from them.
fn graph<const N: usize>(make: impl FnOnce(&mut Arena, [Value; N]) -> Vec<Value>) -> Graph {
    let mut arena = Arena::default();
    let inputs = std::array::from_fn(|_| arena.input());
    let outputs = make(&mut arena, inputs);
    (arena, outputs)
}

fn operations(cost: Cost) -> (usize, usize) {
    (cost.multiplications, cost.additions)
}

fn optimised(graph: &Graph) -> (usize, usize) {
    operations(count(&optimise(graph.0.clone(), graph.1.clone(), &[], &[])))
}

fn twice(value: Value) -> Value {
    value.scaled(Ratio::integer(2))
}

/// The operations that do not depend on uniform inputs alone.
fn varying((arena, outputs): &Graph, uniform: &[bool]) -> usize {
    let mut is_uniform: Vec<bool> = Vec::new();
    for id in arena.ids() {
        let next = match arena.node(id) {
            Node::One => true,
            Node::Input(number) => uniform[*number],
            node => operands(node)
                .iter()
                .all(|operand| is_uniform[operand.index()]),
        };
        is_uniform.push(next);
    }
    let live = schedule(arena, outputs).order;
    let done_once: Vec<Value> = live
        .into_iter()
        .filter(|id| is_uniform[id.index()])
        .map(|node| Value { node, ..Value::ONE })
        .collect();
    cost(arena, outputs).total() - cost(arena, &done_once).total()
}

fn operands(node: &Node) -> Vec<NodeId> {
    match node {
        Node::Sum(values) | Node::Function(_, values) => {
            values.iter().map(|value| value.node).collect()
        }
        Node::Product(a, b) | Node::Quotient(a, b) => vec![*a, *b],
        Node::One | Node::Input(_) => vec![],
    }
}

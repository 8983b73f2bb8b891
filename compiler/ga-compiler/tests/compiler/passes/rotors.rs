//! The 3×3 map of a rotor, in as few operations as are known.

use ga_compiler::algebra::Ratio;
use ga_compiler::ir::{Residue, Value};
use ga_compiler::passes::{Graph, optimise};

use super::{count, evaluate, graph, total, twice, varying};

#[test]
fn the_map_of_a_rotor_takes_twenty_three_operations() {
    let (map, _) = rotor_map(false);
    // Three doubled coefficients and nine products; six sums off the diagonal, and five on it,
    // where 1 − 2 z² is used twice.
    let best = optimise(map.0.clone(), map.1.clone(), &[], &[]);
    assert!(
        total(&best) <= 23,
        "{:?} from {:?}",
        count(&best),
        count(&map)
    );
}

#[test]
fn the_norm_of_a_rotor_reduces_its_map() {
    let (map, relation) = rotor_map(true);
    let plain = optimise(map.0.clone(), map.1.clone(), &[], &[]);
    let best = optimise(map.0.clone(), map.1.clone(), &[], &[relation]);
    assert!(total(&best) < total(&plain), "{:?}", count(&plain));
    assert!(total(&best) <= 23, "{:?}", count(&best));
    // On a rotor both maps agree.
    let unit = [
        Ratio::new(1, 3),
        Ratio::new(2, 3),
        Ratio::new(-2, 3),
        Some(Ratio::ZERO),
    ];
    let unit = unit.map(|v| Residue::from_ratio(v.expect("a fraction")));
    assert_eq!(evaluate(&best, &unit), evaluate(&map, &unit));
    assert_eq!(evaluate(&best, &unit), evaluate(&rotor_map(false).0, &unit));
}

/// A uniform rotor is applied as a matrix.
#[test]
fn a_uniform_rotor_is_a_matrix() {
    let (map, _) = rotor_map(false);
    let (mut arena, entries) = map;
    let point: Vec<Value> = (0..3).map(|_| arena.input()).collect();
    // Entries come as the diagonal, the one above and the one below of each axis.
    let place = |row: usize, column: usize| match (3 + column - row) % 3 {
        0 => 3 * row,
        1 => 3 * ((row + 2) % 3) + 2,
        _ => 3 * ((row + 1) % 3) + 1,
    };
    let rows: Vec<Value> = (0..3)
        .map(|row| {
            let terms: Vec<Value> = (0..3)
                .map(|column| arena.product(entries[place(row, column)], point[column]))
                .collect();
            arena.sum(terms)
        })
        .collect();
    let uniform = [true, true, true, true, false, false, false];
    let best = optimise(arena, rows, &uniform, &[]);
    assert_eq!(varying(&best, &uniform), 9 + 6);
    assert!(total(&best) <= 24 + 9 + 6);
}

/// The map of a rotor with coefficients w, x, y, z and `w² + x² + y² + z² = 1`.
fn rotor_map(is_homogeneous: bool) -> (Graph, Value) {
    let mut relation = Value::ZERO;
    let map = graph(|arena, [w, x, y, z]| {
        let squares = [w, x, y, z].map(|v| arena.product(v, v));
        let mut entries = Vec::new();
        let axes = [x, y, z];
        for n in 0..3 {
            let (next, last) = (axes[(n + 1) % 3], axes[(n + 2) % 3]);
            let others = [squares[1 + (n + 1) % 3], squares[1 + (n + 2) % 3]];
            entries.push(if is_homogeneous {
                arena.sum([squares[0], squares[n + 1], -others[0], -others[1]])
            } else {
                let pair = arena.sum(others);
                arena.sum([Value::ONE, twice(-pair)])
            });
            let (product, turned) = (arena.product(next, last), arena.product(w, axes[n]));
            let (sum, difference) = (
                arena.sum([product, turned]),
                arena.difference(product, turned),
            );
            entries.extend([twice(sum), twice(difference)]);
        }
        relation = arena.sum(squares.into_iter().chain([-Value::ONE]));
        entries
    });
    (map, relation)
}

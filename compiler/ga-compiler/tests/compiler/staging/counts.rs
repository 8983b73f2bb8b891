//! What each call costs where some operands are uniform.

use ga_compiler::count::{self, Operations};
use ga_compiler::define::Definition;
use quote::quote;

use crate::algebras::{self, compile};

/// Operands and result, the same types under the names of [`algebras::renamed`], the formula, and
/// the multiplications and additions of each call.
type Row = (&'static str, &'static str, &'static str, [usize; 2]);

const STAGED: &[Row] = &[
    // A chain of actions is one matrix.
    (
        "uniform m: Motor, uniform n: Motor, x: Point -> Point",
        "uniform m: Motion, uniform n: Motion, x: Place -> Place",
        "sandwich(m, sandwich(n, x))",
        [9, 9],
    ),
    (
        "uniform m: Motor, uniform n: Motor, x: Point -> Point",
        "uniform m: Motion, uniform n: Motion, x: Place -> Place",
        "m * (n * x * rev(n)) * rev(m)",
        [9, 9],
    ),
    (
        "uniform m: Motor, uniform n: Motor, uniform o: Motor, x: Point -> Point",
        "uniform m: Motion, uniform n: Motion, uniform o: Motion, x: Place -> Place",
        "sandwich(m, sandwich(n, sandwich(o, x)))",
        [9, 9],
    ),
    (
        "uniform m: Motor, uniform n: Motor, x: Line -> Line",
        "uniform m: Motion, uniform n: Motion, x: Axis -> Axis",
        "sandwich(m, sandwich(n, x))",
        [24, 18],
    ),
    (
        "uniform m: Motor, x: Point -> RoundVector",
        "uniform m: Motion, x: Place -> Weighted",
        "sandwich(m, x)",
        [13, 11],
    ),
    // Near points are subtracted before anything else, not after products with the plane.
    (
        "p: Point, uniform q: Point, uniform n: DualPlane -> Scalar",
        "p: Place, uniform q: Place, uniform n: Normal -> Scalar",
        "(p - q) | n",
        [3, 5],
    ),
    // Mirrors and inversions, written as vectors.
    (
        "uniform m: RoundVector, x: Point -> RoundVector",
        "uniform m: Weighted, x: Place -> Weighted",
        "sandwich(m, x)",
        [16, 11],
    ),
    // The path between two motions: linear in functions of t and their products with it.
    (
        "uniform m: Motor, uniform n: Motor, t: Scalar -> Motor",
        "uniform m: Motion, uniform n: Motion, t: Scalar -> Motion",
        "exp(t * log(n * rev(m))) * m",
        [30, 16],
    ),
    (
        "uniform m: Motor, uniform n: Motor, t: Scalar -> Motor",
        "uniform m: Motion, uniform n: Motion, t: Scalar -> Motion",
        "m * exp(t * log(rev(m) * n))",
        [30, 16],
    ),
    (
        "uniform m: Rotor, uniform n: Rotor, t: Scalar -> Rotor",
        "uniform m: Rotation, uniform n: Rotation, t: Scalar -> Rotation",
        "exp(t * log(n * rev(m))) * m",
        [11, 4],
    ),
    // Distances and projections.
    (
        "uniform l: Plane, x: Point -> FlatPoint",
        "uniform l: Flat, x: Place -> FlatPlace",
        "((x ^ INFINITY) | l) * inverse(l)",
        [6, 6],
    ),
    (
        "uniform a: Point, uniform b: Point, uniform c: Point, x: Point -> Pseudoscalar",
        "uniform a: Place, uniform b: Place, uniform c: Place, x: Place -> Volume",
        "a ^ b ^ c ^ INFINITY ^ x",
        [3, 3],
    ),
];

/// Kernels of types that [`algebras::renamed`] does not declare.
const OTHERS: &[(&str, &str, [usize; 2])] = &[
    (
        "uniform a: DualPlane, uniform b: DualPlane, x: Point -> RoundVector",
        "sandwich(a, sandwich(b, x))",
        [16, 15],
    ),
    (
        "uniform s: Similarity, x: Point -> RoundVector",
        "sandwich(s, x)",
        [16, 15],
    ),
    (
        "uniform s: Similarity, x: Line -> Line",
        "sandwich(s, x)",
        [24, 18],
    ),
    (
        "uniform v: EvenVersor, x: Point -> RoundVector",
        "sandwich(v, x)",
        [23, 22],
    ),
    (
        "uniform v: OddVersor, x: Point -> RoundVector",
        "sandwich(v, x)",
        [23, 22],
    ),
    (
        "uniform n: DualPlane, x: Point -> Scalar",
        "(n | x) / norm(n)",
        [3, 3],
    ),
    (
        "uniform m: Motor, a: Point, b: Point -> Line",
        "sandwich(m, a ^ b ^ ei)",
        [24, 21],
    ),
];

/// The operations of each call.
fn call(definition: &Definition, types: &str, formula: &str) -> Operations {
    let (operands, result) = types.split_once(" -> ").expect("a signature");
    let text = format!("fn kernel({operands}) -> {result} {{ {formula} }}");
    let function = compile(definition, &text);
    match count::function(definition, &quote!(algebra), &function) {
        Ok(count) => count.call,
        Err(error) => panic!("{text}: {error}"),
    }
}

#[track_caller]
fn check(definition: &Definition, rows: impl Iterator<Item = (&'static str, String, [usize; 2])>) {
    let mut missed = String::new();
    for (types, formula, stated) in rows {
        let found = call(definition, types, &formula);
        let [multiplications, additions] = stated;
        let is_stated = (found.multiplications, found.additions) == (multiplications, additions);
        if !is_stated || found.divisions + found.roots > 0 {
            missed += &format!("{types} {{ {formula} }}: {found}; stated {stated:?}\n");
        }
    }
    assert!(missed.is_empty(), "{missed}");
}

#[test]
fn a_call_costs_what_depends_on_it() {
    let named = STAGED
        .iter()
        .map(|(types, _, formula, stated)| (*types, *formula, *stated));
    let all = named.chain(OTHERS.iter().copied());
    check(
        &algebras::cga3(),
        all.map(|(types, formula, stated)| (types, formula.replace("INFINITY", "ei"), stated)),
    );
}

#[test]
fn a_call_costs_the_same_under_other_names() {
    let rows = STAGED.iter().map(|(_, types, formula, stated)| {
        (*types, formula.replace("INFINITY", "infinity"), *stated)
    });
    check(&algebras::renamed(), rows);
}

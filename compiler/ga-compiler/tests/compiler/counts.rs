//! The cost of kernels: the exact operations in the emitted code.
//!
//! This includes the tables of `README.md` and of `docs/engine.md`.

use ga_compiler::count::{self, Operations};
use ga_compiler::define::Definition;
use quote::quote;

use crate::algebras::{self, compile};

/// Operands and result, the same types under the names of [`algebras::renamed`], the formula, and
/// its cost.
pub(crate) type Row = (&'static str, &'static str, &'static str, Operations);

pub(crate) const fn cost(multiplications: usize, additions: usize, others: usize) -> Operations {
    Operations {
        multiplications,
        additions,
        divisions: 0,
        roots: 0,
        others,
    }
}

const KERNELS: [Row; 23] = [
    (
        "m: Motor, x: Point -> Point",
        "m: Motion, x: Place -> Place",
        "m * x * rev(m)",
        cost(21, 18, 0),
    ),
    (
        "m: Motor, x: Point -> RoundVector",
        "m: Motion, x: Place -> Weighted",
        "m * x * rev(m)",
        cost(25, 20, 0),
    ),
    (
        "m: Motor, x: RoundVector -> RoundVector",
        "m: Motion, x: Weighted -> Weighted",
        "sandwich(m, x)",
        cost(37, 28, 0),
    ),
    (
        "m: Motor, x: Plane -> Plane",
        "m: Motion, x: Flat -> Flat",
        "sandwich(m, x)",
        cost(29, 21, 0),
    ),
    (
        "m: Motor, x: Quadvector -> Quadvector",
        "m: Motion, x: Ball -> Ball",
        "sandwich(m, x)",
        cost(37, 28, 0),
    ),
    (
        "m: Motor, x: Line -> Line",
        "m: Motion, x: Axis -> Axis",
        "sandwich(m, x)",
        cost(49, 38, 0),
    ),
    (
        "m: Motor, x: Trivector -> Trivector",
        "m: Motion, x: Ring -> Ring",
        "sandwich(m, x)",
        cost(72, 60, 1),
    ),
    (
        "m: Motor, x: Bivector -> Bivector",
        "m: Motion, x: Pair -> Pair",
        "sandwich(m, x)",
        cost(72, 60, 0),
    ),
    (
        "m: Motor, x: Motor -> Motor",
        "m: Motion, x: Motion -> Motion",
        "m * x",
        cost(48, 40, 0),
    ),
    (
        "m: Motor, n: Motor, x: Point -> Point",
        "m: Motion, n: Motion, x: Place -> Place",
        "m * n * x * rev(n) * rev(m)",
        cost(42, 36, 0),
    ),
    (
        "r: Rotor, s: Rotor -> Rotor",
        "r: Rotation, s: Rotation -> Rotation",
        "r * s",
        cost(16, 12, 0),
    ),
    (
        "s: Translator, t: Translator -> Translator",
        "s: Translation, t: Translation -> Translation",
        "s * t",
        cost(0, 3, 0),
    ),
    (
        "p: Point, q: Point -> Scalar",
        "p: Place, q: Place -> Scalar",
        "p | q",
        cost(4, 5, 0),
    ),
    (
        "p: Point, q: Point -> Bivector",
        "p: Place, q: Place -> Pair",
        "p ^ q",
        cost(20, 14, 1),
    ),
    (
        "p: Point, q: Point, r: Point -> Trivector",
        "p: Place, q: Place, r: Place -> Ring",
        "p ^ q ^ r",
        cost(36, 28, 0),
    ),
    (
        "p: Point, q: Point, r: Point, s: Point -> Quadvector",
        "p: Place, q: Place, r: Place, s: Place -> Ball",
        "p ^ q ^ r ^ s",
        cost(44, 37, 0),
    ),
    (
        "p: Point, q: Point -> Line",
        "p: Place, q: Place -> Axis",
        "p ^ q ^ INFINITY",
        cost(6, 6, 0),
    ),
    (
        "p: Point, q: Point, r: Point -> Plane",
        "p: Place, q: Place, r: Place -> Flat",
        "p ^ q ^ r ^ INFINITY",
        cost(9, 11, 0),
    ),
    (
        "p: Point -> Scalar",
        "p: Place -> Scalar",
        "grade(p * p, 0)",
        cost(0, 0, 0),
    ),
    (
        "p: Point, q: Point -> RoundVector",
        "p: Place, q: Place -> Weighted",
        "p - q",
        cost(7, 8, 0),
    ),
    (
        "p: Point, q: Point -> Scalar",
        "p: Place, q: Place -> Scalar",
        "sqrt(-2 * (p | q))",
        Operations {
            roots: 1,
            ..cost(3, 5, 0)
        },
    ),
    (
        "a: Quadvector, b: Quadvector -> Trivector",
        "a: Ball, b: Ball -> Ring",
        "a & b",
        cost(20, 10, 0),
    ),
    (
        "s: Quadvector, p: Point -> Point",
        "s: Ball, p: Place -> Place",
        "sandwich(s, p) / sandwich(s, p).ORIGIN",
        Operations {
            divisions: 1,
            ..cost(16, 14, 0)
        },
    ),
];

/// A type that a uniform motor moves, the cost of each call, and the cost of its matrix, which is
/// computed once.
const UNIFORM: [(&str, Operations, Operations); 4] = [
    ("Point", cost(9, 9, 0), cost(25, 20, 0)),
    ("Direction", cost(9, 6, 0), cost(12, 11, 0)),
    ("Line", cost(24, 18, 0), cost(25, 20, 0)),
    ("Plane", cost(12, 9, 0), cost(25, 20, 0)),
];

/// Counts the operations in the emitted code of a function: those of each call, and those done
/// once.
fn counted(definition: &Definition, types: &str, formula: &str) -> [Operations; 2] {
    let (operands, result) = types.split_once(" -> ").expect("a signature");
    let text = format!("fn kernel({operands}) -> {result} {{ {formula} }}");
    let function = compile(definition, &text);
    match count::function(definition, &quote!(algebra), &function) {
        Ok(count) => [count.call, count.uniform],
        Err(error) => panic!("{text}: {error}"),
    }
}

/// Kernels of rounds, which are types by parameters: operands and result, the formula, and its
/// multiplications, additions, divisions and negations.
const ROUNDS: [(&str, &str, [usize; 4]); 13] = [
    (
        "m: Motor, x: Sphere -> Sphere",
        "sandwich(m, x)",
        [21, 18, 0, 0],
    ),
    (
        "m: Motor, x: Circle -> Circle",
        "sandwich(m, x)",
        [39, 30, 0, 0],
    ),
    (
        "m: Motor, x: PointPair -> PointPair",
        "sandwich(m, x)",
        [39, 30, 0, 0],
    ),
    (
        "m: Motor, x: DualCircle -> DualCircle",
        "sandwich(m, x)",
        [39, 30, 0, 0],
    ),
    (
        "v: Similarity, x: Sphere -> Sphere",
        "sandwich(v, x)",
        [31, 28, 1, 0],
    ),
    (
        "v: Similarity, x: Circle -> Circle",
        "sandwich(v, x)",
        [57, 44, 1, 0],
    ),
    ("p: Point, q: Point -> PointPair", "p ^ q", [7, 8, 0, 0]),
    (
        "p: Point, q: Point, r: Point -> Circle",
        "p ^ q ^ r",
        [37, 26, 1, 0],
    ),
    (
        "p: Point, q: Point, r: Point, s: Point -> Sphere",
        "p ^ q ^ r ^ s",
        [43, 34, 1, 1],
    ),
    ("a: Sphere, b: Sphere -> Circle", "a & b", [15, 11, 1, 0]),
    ("a: Sphere, b: Plane -> Circle", "a & b", [13, 9, 1, 1]),
    (
        "a: DualSphere, b: DualSphere -> Scalar",
        "a | b",
        [6, 7, 0, 0],
    ),
    (
        "s: Sphere, p: Point -> Point",
        "sandwich(s, p) / sandwich(s, p).eo",
        [9, 8, 1, 0],
    ),
];

#[test]
fn kernels_cost_what_is_stated() {
    check_names(&KERNELS);
}

#[test]
fn kernels_of_rounds_cost_what_is_stated() {
    let cga3 = algebras::cga3();
    let mut missed = String::new();
    for (types, formula, stated) in ROUNDS {
        let [found, _] = counted(&cga3, types, formula);
        let [multiplications, additions, divisions, others] = stated;
        let stated = Operations {
            divisions,
            ..cost(multiplications, additions, others)
        };
        if found != stated {
            missed += &format!("{types} {{ {formula} }}: {found}; stated {stated}\n");
        }
    }
    assert!(missed.is_empty(), "{missed}");
}

/// Rules look at facts and structure, never at names or at the order of the basis. That order
/// decides only the signs of blades, and so how many negations are left.
#[test]
fn names_and_order_do_not_change_the_cost() {
    check_renamed(&KERNELS);
}

/// Counts rows in cga3.
#[track_caller]
pub(crate) fn check_names(rows: &[Row]) {
    let cga3 = algebras::cga3();
    let mut missed = String::new();
    for (types, _, formula, stated) in rows {
        let formula = formula.replace("INFINITY", "ei").replace("ORIGIN", "eo");
        let [found, _] = counted(&cga3, types, &formula);
        if found != *stated {
            missed += &format!("{types} {{ {formula} }}: {found}; stated {stated}\n");
        }
    }
    assert!(missed.is_empty(), "{missed}");
}

/// Counts rows under the other names, without negations.
#[track_caller]
pub(crate) fn check_renamed(rows: &[Row]) {
    let renamed = algebras::renamed();
    let mut missed = String::new();
    for (_, types, formula, stated) in rows {
        let formula = formula
            .replace("INFINITY", "infinity")
            .replace("ORIGIN", "origin");
        let [found, _] = counted(&renamed, types, &formula);
        let others = stated.others;
        if (Operations { others, ..found }) != *stated {
            missed += &format!("{types} {{ {formula} }}: {found}; stated {stated}\n");
        }
    }
    assert!(missed.is_empty(), "{missed}");
}

#[test]
fn uniform_motors_are_linear_maps() {
    let cga3 = algebras::cga3();
    let mut missed = String::new();
    for (name, each, once) in UNIFORM {
        let types = format!("uniform m: Motor, x: {name} -> {name}");
        let found = counted(&cga3, &types, "m * x * rev(m)");
        if found != [each, once] {
            let [call, uniform] = found;
            missed += &format!("{types}: {call}; once {uniform}\n");
        }
    }
    assert!(missed.is_empty(), "{missed}");
}

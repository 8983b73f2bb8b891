//! The cost of actions of versors and of products by rules for special operands.

use ga_compiler::count::Operations;

use crate::counts::{Row, check_names, check_renamed, cost};

const ACTIONS: [Row; 22] = [
    (
        "s: RoundVector, x: RoundVector -> RoundVector",
        "s: Weighted, x: Weighted -> Weighted",
        "sandwich(s, x)",
        cost(21, 12, 0),
    ),
    (
        "s: RoundVector, x: Point -> RoundVector",
        "s: Weighted, x: Place -> Weighted",
        "sandwich(s, x)",
        cost(23, 14, 0),
    ),
    (
        "s: Quadvector, x: Point -> RoundVector",
        "s: Ball, x: Place -> Weighted",
        "sandwich(s, x)",
        cost(23, 14, 0),
    ),
    (
        "s: DualPlane, x: Point -> RoundVector",
        "s: Normal, x: Place -> Weighted",
        "sandwich(s, x)",
        cost(19, 11, 0),
    ),
    (
        "s: Plane, x: Point -> RoundVector",
        "s: Flat, x: Place -> Weighted",
        "sandwich(s, x)",
        cost(19, 11, 0),
    ),
    (
        "s: DualPlane, x: Line -> Line",
        "s: Normal, x: Axis -> Axis",
        "sandwich(s, x)",
        cost(33, 19, 2),
    ),
    (
        "s: Plane, x: Line -> Line",
        "s: Flat, x: Axis -> Axis",
        "sandwich(s, x)",
        cost(33, 19, 0),
    ),
    (
        "s: RoundVector, x: Trivector -> Trivector",
        "s: Weighted, x: Ring -> Ring",
        "sandwich(s, x)",
        cost(59, 38, 3),
    ),
    (
        "s: RoundVector, x: Quadvector -> Quadvector",
        "s: Weighted, x: Ball -> Ball",
        "sandwich(s, x)",
        cost(21, 12, 2),
    ),
    (
        "v: EvenVersor, x: Point -> RoundVector",
        "v: Conformal, x: Place -> Weighted",
        "sandwich(v, x)",
        cost(49, 47, 1),
    ),
    (
        "v: OddVersor, x: Point -> RoundVector",
        "v: Reversing, x: Place -> Weighted",
        "sandwich(v, x)",
        cost(49, 47, 0),
    ),
    (
        "v: Similarity, x: Point -> RoundVector",
        "v: Similar, x: Place -> Weighted",
        "sandwich(v, x)",
        cost(34, 34, 0),
    ),
    (
        "v: Similarity, x: Line -> Line",
        "v: Similar, x: Axis -> Axis",
        "sandwich(v, x)",
        cost(64, 48, 0),
    ),
    (
        "v: Similarity, x: Trivector -> Trivector",
        "v: Similar, x: Ring -> Ring",
        "sandwich(v, x)",
        cost(86, 74, 2),
    ),
    (
        "v: Similarity, x: Quadvector -> Quadvector",
        "v: Similar, x: Ball -> Ball",
        "sandwich(v, x)",
        cost(47, 44, 0),
    ),
    (
        "v: Similarity, x: Point -> Point",
        "v: Similar, x: Place -> Place",
        "sandwich(v, x) / sandwich(v, x).ORIGIN",
        cost(28, 25, 1),
    ),
    (
        "v: Dilator, x: Point -> Point",
        "v: Scaling, x: Place -> Place",
        "sandwich(v, x) / sandwich(v, x).ORIGIN",
        cost(4, 1, 0),
    ),
    (
        "m: Motor, d: Dilator, x: Point -> Point",
        "m: Motion, d: Scaling, x: Place -> Place",
        "let y = sandwich(m, sandwich(d, x)); y / y.ORIGIN",
        cost(25, 19, 0),
    ),
    (
        "m: Motor, p: Point, q: Point -> Bivector",
        "m: Motion, p: Place, q: Place -> Pair",
        "sandwich(m, p ^ q)",
        cost(61, 49, 0),
    ),
    (
        "m: Motor, p: Point, q: Point -> Bivector",
        "m: Motion, p: Place, q: Place -> Pair",
        "sandwich(m, p) ^ sandwich(m, q)",
        cost(61, 49, 0),
    ),
    (
        "m: Motor, p: Point, q: Point, r: Point -> Trivector",
        "m: Motion, p: Place, q: Place, r: Place -> Ring",
        "sandwich(m, p ^ q ^ r)",
        cost(99, 73, 0),
    ),
    (
        "m: Motor, p: Point, q: Point -> Line",
        "m: Motion, p: Place, q: Place -> Axis",
        "sandwich(m, p ^ q ^ INFINITY)",
        cost(45, 36, 0),
    ),
];

#[test]
fn actions_cost_what_is_stated() {
    check_names(&ACTIONS);
}

#[test]
fn names_do_not_change_the_cost_of_actions() {
    check_renamed(&ACTIONS);
}

const PRODUCTS: [Row; 9] = [
    (
        "a: Point, b: Point -> Scalar",
        "a: Place, b: Place -> Scalar",
        "norm_squared(a ^ b)",
        cost(5, 5, 0),
    ),
    (
        "a: Point, b: Point, c: Point -> Scalar",
        "a: Place, b: Place, c: Place -> Scalar",
        "norm_squared(a ^ b ^ c)",
        cost(12, 15, 0),
    ),
    (
        "a: Point, b: Point, c: Point, d: Point -> Scalar",
        "a: Place, b: Place, c: Place, d: Place -> Scalar",
        "scalar_product(a ^ b, c ^ d)",
        cost(21, 22, 0),
    ),
    (
        "a: Point, b: Point, c: Point, d: Point -> Scalar",
        "a: Place, b: Place, c: Place, d: Place -> Scalar",
        "(a ^ b) | (c ^ d)",
        cost(21, 22, 0),
    ),
    (
        "a: Point, b: Point, c: Point -> Scalar",
        "a: Place, b: Place, c: Place -> Scalar",
        "norm_squared(a ^ b ^ c) / norm_squared(a ^ b ^ c ^ INFINITY)",
        Operations {
            divisions: 1,
            ..cost(21, 20, 0)
        },
    ),
    (
        "a: Point, b: Point, c: Point, p: Point, q: Point -> FlatPoint",
        "a: Place, b: Place, c: Place, p: Place, q: Place -> FlatPlace",
        "(a ^ b ^ c ^ INFINITY) & (p ^ q ^ INFINITY)",
        cost(18, 22, 0),
    ),
    (
        "a: Point, b: Point, c: Point, p: Point, q: Point -> FlatPoint",
        "a: Place, b: Place, c: Place, p: Place, q: Place -> FlatPlace",
        "(p ^ q ^ INFINITY) & (a ^ b ^ c ^ INFINITY)",
        cost(18, 22, 0),
    ),
    (
        "a: Point, b: Point, c: Point, p: Point, q: Point -> FlatPoint",
        "a: Place, b: Place, c: Place, p: Place, q: Place -> FlatPlace",
        "dual(a ^ b ^ c ^ INFINITY) | (p ^ q ^ INFINITY)",
        cost(18, 22, 0),
    ),
    (
        "s: Plane, p: Point, q: Point -> FlatPoint",
        "s: Flat, p: Place, q: Place -> FlatPlace",
        "s & (p ^ q ^ INFINITY)",
        cost(12, 11, 0),
    ),
];

#[test]
fn products_cost_what_is_stated() {
    check_names(&PRODUCTS);
}

#[test]
fn names_do_not_change_the_cost_of_products() {
    check_renamed(&PRODUCTS);
}

//! Formulas that cost what somebody who knows the geometry needs for them by hand.

use ga_compiler::define::Definition;

use crate::algebras::{self, compile};

/// Operands and result, the formula, and all operations of it, functions included.
type Row = (&'static str, &'static str, usize);

const CGA3: &[Row] = &[
    ("g: MotorGenerator, t: Scalar -> Motor", "exp(t * g)", 33),
    ("m: Motor, t: Scalar -> Motor", "exp(t * log(m))", 50),
    (
        "m: Motor, n: Motor, t: Scalar -> Motor",
        "m * exp(t * log(rev(m) * n))",
        226,
    ),
    (
        "p: Point, d: Direction, c: Point, r: Scalar -> Scalar",
        "norm_squared((p ^ d) & undual(c - r * r / 2 * ei))",
        23,
    ),
    (
        "c: Point, r: Scalar, p: Point -> Point",
        "point(sandwich(c - r * r / 2 * ei, p))",
        16,
    ),
    (
        "p: Point, a: Point, b: Point -> Point",
        "let l = a ^ b ^ ei; point((p | l) * inverse(l))",
        23,
    ),
    (
        "s: Similarity, t: Similarity, x: Point -> Point",
        "point(sandwich(s * t, x))",
        106,
    ),
    (
        "a: Point, b: Point, c: Point -> Point",
        "point(a ^ b ^ c)",
        56,
    ),
    (
        "p: Point, d: Direction, s: RoundVector -> (Point, Point)",
        "endpoints((p ^ d) & undual(s))",
        54,
    ),
    (
        "a: Motor, b: Motor, c: Motor, d: Motor, k: Scalar, l: Scalar, m: Scalar, n: Scalar, \
         x: Point -> Point",
        "sandwich(normalize(k * a + l * b + m * c + n * d), x)",
        104,
    ),
];

const PGA3: &[Row] = &[
    ("g: Line, t: Scalar -> Motor", "exp(t * g)", 33),
    ("m: Motor, t: Scalar -> Motor", "exp(t * log(m))", 50),
    (
        "m: Motor, n: Motor, t: Scalar -> Motor",
        "m * exp(t * log(rev(m) * n))",
        226,
    ),
];

#[test]
fn formulas_cost_what_they_cost_by_hand() {
    let missed = missed(&algebras::cga3(), CGA3) + &missed(&algebras::pga3(), PGA3);
    assert!(missed.is_empty(), "{missed}");
}

fn missed(definition: &Definition, rows: &[Row]) -> String {
    let mut missed = String::new();
    for (types, formula, stated) in rows {
        let (operands, result) = types.rsplit_once(" -> ").expect("a signature");
        let text = format!("fn kernel({operands}) -> {result} {{ {formula} }}");
        let found = compile(definition, &text).kernel.cost().total();
        if found != *stated {
            missed += &format!("{types} {{ {formula} }}: {found}; stated {stated}\n");
        }
    }
    missed
}

//! The cost of what `ga!` has beyond products: choices, places and ends.

use ga_compiler::count;
use quote::quote;

use crate::algebras::{self, compile};

/// Functions, and their operations in words.
const KERNELS: [(&str, &str); 16] = [
    ("fn f(p: Point) -> Point { point(p) }", "0 mul, 0 add"),
    (
        "fn f(v: RoundVector) -> Point { point(v) }",
        "3 mul, 0 add, 1 div",
    ),
    (
        "fn f(x: FlatPoint) -> Point { point(x) }",
        "3 mul, 0 add, 1 div",
    ),
    (
        "fn f(s: Sphere) -> Point { point(s) }",
        "3 mul, 0 add, 1 div",
    ),
    ("fn f(c: Circle) -> Point { point(c) }", "0 mul, 0 add"),
    ("fn f(x: PointPair) -> Point { point(x) }", "0 mul, 0 add"),
    (
        "fn f(l: Line, e: Plane) -> Point { point(l & e) }",
        "15 mul, 8 add, 1 div",
    ),
    (
        "fn f(x: PointPair) -> (Point, Point) { endpoints(x) }",
        "7 mul, 8 add, 1 div, 1 sqrt",
    ),
    (
        "fn f(l: Line, s: Sphere) -> (Point, Point) { endpoints(l & s) }",
        "39 mul, 28 add, 1 div, 1 sqrt, 1 other",
    ),
    (
        "fn f(uniform s: Sphere, l: Line) -> Point { endpoints(l & s).0 }",
        "31 mul, 18 add, 2 div, 1 sqrt",
    ),
    (
        "fn f(m: Motor, v: RoundVector) -> Point { sandwich(m, point(v)) }",
        "24 mul, 18 add, 1 div",
    ),
    (
        "fn f(a: Point, b: Point, c: Point) -> Point { point(a ^ b ^ c) }",
        "31 mul, 24 add, 1 div",
    ),
    (
        "fn f(o: Point, p: Point, q: Point) -> Point { select((o | p) > (o | q), p, q) }",
        "8 mul, 10 add, 4 other",
    ),
    (
        "fn f(x: Scalar, v: RoundVector) -> RoundVector { select(x < 0, 2 * v, -2 * v) }",
        "5 mul, 0 add, 2 other",
    ),
    (
        "fn f(x: Scalar, y: Scalar, m: Motor, p: Point) -> Point { select(x < y, sandwich(m, p), p) }",
        "21 mul, 18 add, 4 other",
    ),
    (
        "fn f(x: Scalar, y: Scalar) -> (Scalar, Scalar) { (select(x < y, x, y), select(y > x, y, x)) }",
        "0 mul, 0 add, 3 other",
    ),
];

#[test]
fn operations_cost_what_is_stated() {
    let definition = algebras::cga3();
    let path = quote! { ga_runtime::cga3 };
    let mut missed = String::new();
    for (text, stated) in KERNELS {
        let function = compile(&definition, text);
        let found = match count::function(&definition, &path, &function) {
            Ok(count) => count.call.to_string(),
            Err(error) => panic!("{text}: {error}"),
        };
        if found != stated {
            missed += &format!("{text}: {found}; stated {stated}\n");
        }
    }
    assert!(missed.is_empty(), "{missed}");
}

/// The reverse of what is not an outer product of its factors stays, where no other form is tried.
#[test]
fn reverses_in_meets_are_kept() {
    let cga3 = algebras::cga3();
    let operands = "x: Scalar, s: Circle, a: Point, b: Point, c: Point";
    for meet in ["rev(s) & (a ^ b ^ c)", "rev(-s) & rev(a ^ b ^ c)"] {
        let text = format!("fn f({operands}) -> RoundVector {{ ({meet}) * select(x < 0, 1, 2) }}");
        // Panics where the graph does not agree with the steps as they are written.
        let _ = compile(&cga3, &text);
    }
}

/// Many choices are checked quickly: pairs of comparisons are counted once.
#[test]
fn many_choices_are_compiled() {
    let cga3 = algebras::cga3();
    let terms: Vec<String> = (0..120)
        .map(|k| format!("select(x < {k}, y, {k})"))
        .collect();
    let text = format!(
        "fn f(x: Scalar, y: Scalar) -> Scalar {{ {} }}",
        terms.join(" + ")
    );
    let _ = compile(&cga3, &text);
}

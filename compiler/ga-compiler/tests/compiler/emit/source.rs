//! Functions in cga3 from their text.

use ga_compiler::define::Definition;
use ga_compiler::function::CompiledFunction;

use crate::algebras::compile;

/// Functions of every kind, for the tests of emitters.
pub(crate) fn kernels(definition: &Definition) -> Vec<CompiledFunction> {
    [
        "fn moved(m: Motor, p: Point) -> Point { m * p * reverse(m) }",
        "fn moved_line(m: Motor, x: Line) -> Line { sandwich(m, x) }",
        "fn moved_circle(m: Motor, x: Circle) -> Circle { sandwich(m, x) }",
        "fn product(m: Motor, n: Motor) -> Motor { m * n }",
        "fn sphere(p: Point, q: Point, r: Point, s: Point) -> Sphere { p ^ q ^ r ^ s }",
        "fn meet(a: Sphere, b: Sphere) -> Circle { a & b }",
        "fn difference(p: Point, q: Point) -> RoundVector { p - q }",
        "fn distance(p: Point, q: Point) -> Scalar { sqrt(-2 * (p | q)) }",
        "fn both(m: Motor, x: [Point; 2]) -> [Point; 2] { [sandwich(m, x[0]), sandwich(m, x[1])] }",
        "fn two(p: Point, q: Point, t: Scalar) -> (Scalar, RoundVector) { (t * (p | q), p - q) }",
        "fn nearer(o: Point, p: Point, q: Point) -> Point { select((o | p) > (o | q), p, q) }",
        "fn bounded(x: Scalar, y: Scalar) -> Scalar { sign(clamp(x, -y, min(y, 1))) * max(x, y) }",
        "fn limited(uniform a: Scalar, uniform b: Scalar, x: Scalar) -> Scalar {
            select(a < b || x == a, select(a == b, a, 2 * b) * x, select(a <= x && x <= b, x, 0))
        }",
        "fn once(uniform m: Motor, p: Point) -> Point { sandwich(m, p) }",
    ]
    .map(|text| compile(definition, text))
    .into()
}

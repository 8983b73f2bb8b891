//! A call with an operand of another type.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(p: Point, q: Point) -> Scalar { g(p ^ q, p) }
    fn g(a: Circle, p: Point) -> Scalar { norm_squared(a | p) }
}

fn main() {}

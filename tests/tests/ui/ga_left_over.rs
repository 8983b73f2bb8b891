//! A result with blades that its type lacks.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(p: Point, q: Point) -> Line { p ^ q }
    fn g(p: Point, q: Point) -> Scalar { p * q }
}

fn main() {}

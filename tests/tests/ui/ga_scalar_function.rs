//! A function of scalars, of a vector.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(p: Point) -> Scalar { sin(p) }
    fn g(p: Point, q: Point) -> Scalar { atan2(p | q, p) }
}

fn main() {}

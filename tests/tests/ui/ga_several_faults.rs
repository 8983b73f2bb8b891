//! Each function's first fault is reported.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(a: Scalar) -> Scalar { a + b }
    fn g(a: Scalar) -> Scalr { a }
    fn h(p: Point) -> Plane { p ^ ei }
}

fn main() {}

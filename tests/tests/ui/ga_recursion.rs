//! A function that calls itself, by way of another.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(a: Scalar) -> Scalar { g(a - 1) }
    fn g(a: Scalar) -> Scalar { a * f(a) }
}

fn main() {}

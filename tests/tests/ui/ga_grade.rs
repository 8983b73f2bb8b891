//! A grade that is no whole number.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(m: Motor, k: Scalar) -> Motor { grade(m, k) }
    fn g(m: Motor) -> Scalar { grade(m, 0.5) }
}

fn main() {}

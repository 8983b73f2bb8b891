//! Patterns that do not match.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(a: (Scalar, Scalar)) -> Scalar { let (x, y, z) = a; x }
    fn g(a: Scalar) -> Scalar { let [x] = a; x }
}

fn main() {}

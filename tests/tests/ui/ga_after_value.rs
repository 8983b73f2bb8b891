//! A statement after the value.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(a: Scalar) -> Scalar { a; let b = a; b }
}

fn main() {}

//! A body without a value.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(a: Scalar) -> Scalar { let b = a; }
}

fn main() {}

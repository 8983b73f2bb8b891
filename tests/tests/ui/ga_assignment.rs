//! Assignments have no place.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(a: Scalar) -> Scalar { a += 1; a }
}

fn main() {}

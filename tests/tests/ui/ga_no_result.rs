//! A function without the type of its result.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(a: Scalar) { a }
}

fn main() {}

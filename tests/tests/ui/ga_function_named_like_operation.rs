//! A function that bears the name of an operation.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn reverse(a: Scalar) -> Scalar { -a }
    fn f(m: Motor) -> Motor { reverse(m) }
}

fn main() {}

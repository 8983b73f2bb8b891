//! Two operands with the same name.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(a: Scalar, a: Scalar) -> Scalar { a }
}

fn main() {}

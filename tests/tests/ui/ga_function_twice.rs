//! Two functions of one name.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(a: Scalar) -> Scalar { a }
    fn f(a: Scalar) -> Scalar { a + 1 }
}

fn main() {}

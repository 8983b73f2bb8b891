//! Nothing is assigned to.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(a: Scalar) -> Scalar { let mut x = a; x }
}

fn main() {}

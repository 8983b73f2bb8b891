//! An algebra that does not exist.

use ga_runtime::ga;

ga! { ga_runtime::cga4; fn f(a: Scalar) -> Scalar { a } }

fn main() {}

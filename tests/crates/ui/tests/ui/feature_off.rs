//! An algebra whose feature is not enabled; the note names the feature.

use ga_runtime::sta::Vector;

ga_runtime::ga! { ga_runtime::pga2;
    fn squared(x: Scalar) -> Scalar { x * x }
}

fn main() {}

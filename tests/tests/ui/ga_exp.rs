//! The exponential of a vector.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(p: Point) -> Even { exp(p) }
    fn g(b: PointPair) -> Even { exp(b) }
}

fn main() {}

//! A divisor that is no scalar.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(p: Point, q: RoundVector) -> Even { p / q }
}

fn main() {}

//! A divisor that is zero whatever the operands.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(p: Point) -> Scalar { 1 / (p | p) }
    fn g(p: Point) -> Scalar { recip(p | p) }
    fn h(p: Point) -> Point { inverse(p) }
}

fn main() {}

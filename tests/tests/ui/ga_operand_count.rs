//! Too few operands and too many.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(m: Motor, p: Point) -> Point { sandwich(m) }
    fn g(m: Motor, p: Point) -> Point { h(m, p, p) }
    fn h(m: Motor, p: Point) -> Point { m * p * rev(m, m) }
}

fn main() {}

//! A point whose weight is not 1: the division helps.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(s: Sphere, p: Point) -> Point { sandwich(s, p) }
    fn g(x: RoundVector) -> Point { x }
}

fn main() {}

//! A type that the algebra does not have.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(m: Motr, p: Point) -> Point { m * p * rev(m) }
    fn g(p: Point) -> f64 { p | p }
}

fn main() {}

//! A number with a type of its own.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(p: Point) -> RoundVector { 2.0_f64 * p }
}

fn main() {}

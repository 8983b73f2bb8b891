//! Callers of a faulty function add no errors, here or in Rust.

use ga_runtime::cga3::Point;
use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn faulty(p: Point, q: Point) -> Scalar { p | r }
    fn caller(p: Point) -> Scalar { 2 * faulty(p, p) }
    fn moving(uniform m: Motor, p: Point) -> Point { m * p * x }
}

fn rust(p: Point<f64>, m: ga_runtime::cga3::Motor<f64>) -> f64 {
    caller(p) + faulty(p, p) + moving(m).apply(p).e1()
}

fn main() {}

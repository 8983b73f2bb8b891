//! A name that is no operand, no `let` and no blade, and one that is nearly one.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(motor: Motor, p: Point) -> Point { moter * p * rev(motor) }
    fn g(p: Point) -> Scalar { p | e4 }
}

fn main() {}

//! Neither an operation nor a function of the block.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(m: Motor, p: Point) -> Point { m * p * reversed(m) }
    fn g(m: Motor) -> Motor { m.square() }
}

fn main() {}

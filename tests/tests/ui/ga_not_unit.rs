//! A motor only up to its norm.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(m: Motor, n: Motor) -> Motor { m + n }
}

fn main() {}

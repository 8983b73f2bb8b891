//! Products and sums mixed without parentheses.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(p: Point, q: Point, r: Point) -> PointPair { p ^ q - r }
}

fn main() {}

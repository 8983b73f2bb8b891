//! A `let` whose value is not of the type.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(p: Point, q: Point) -> Scalar { let line: Line = p ^ q; norm(line) }
}

fn main() {}

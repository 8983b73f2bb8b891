//! A coefficient that the operand's type does not have.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(m: Motor) -> Scalar { m.e12oi }
    fn g(m: Motor) -> Scalar { m.length }
}

fn main() {}

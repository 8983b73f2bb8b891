//! Arrays of another length than declared, and elements beyond the end.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(a: Scalar) -> [Scalar; 3] { [a, a] }
    fn g(a: [Scalar; 2]) -> Scalar { a[2] }
    fn h(a: Scalar) -> Scalar { a[0] }
    fn i(a: [Scalar; 2]) -> Scalar { a * 2 }
}

fn main() {}

//! A quotient by a norm of either sign is no unit versor, which few random points would not tell.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn a(x: Scalar, y: Scalar) -> Dilator { let e = x + y * eoi; e / norm(e) }
    fn b(x: Scalar, y: Scalar) -> Dilator { let e = y + 2 * x * eoi; e / norm(e) }
    fn c(x: Scalar, y: Scalar) -> Dilator { let e = 3 * x + y * eoi; e / norm(e) }
    fn d(x: Scalar, y: Scalar) -> Dilator { let e = x + 4 * y * eoi; e / norm(e) }
}

fn main() {}

//! Numbers whose product no fraction of 128 bits holds, and one that alone has too many digits.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(x: Scalar) -> Scalar { x * 1000000007 * 1000000009 * 1000000021 * 1000000033 * 1000000087 }
    fn g(x: Scalar) -> Scalar { x * 3.14159265358979 }
}

ga! { ga_runtime::cga3;
    fn h(x: Scalar) -> Scalar { x * 3.14159265358979323846 }
}

fn main() {}

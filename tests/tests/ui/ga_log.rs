//! The logarithm of what is no unit versor.

use ga_runtime::ga;

ga! { ga_runtime::cga3;
    fn f(m: DualQuaternion) -> MotorGenerator { log(m) }
    fn g(p: Plane) -> Plane { sqrt(p) }
}

fn main() {}

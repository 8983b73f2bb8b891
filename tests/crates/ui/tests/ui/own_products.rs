//! Products that an algebra of one's own does not declare; the error shows the line to add.

ga_runtime::algebra! {
    mod plane {
        basis e1, e2;
        signature 2, 0, 0;

        struct Vector { e1, e2 }
        struct Bivector { e12 }
        #[hull(Complex)]
        #[facts(unit_versor)]
        struct Rotor { scalar, e12 }
        struct Complex { scalar, e12 }

        products {
            wedge(Vector, Vector);
            sandwich(Rotor, Vector) -> Self;
        }
    }
}

use plane::{Bivector, Rotor, Vector};

fn products(v: Vector<f64>, b: Bivector<f64>, r: Rotor<f64>) {
    let _ = v * v;
    let _ = r * v;
    let _ = v | v;
    let _ = v ^ b;
    let _ = b & b;
}

fn main() {}

//! A product is declared twice.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }
        struct Multivector { scalar, e1, e2, e3, e12, e13, e23, e123 }

        products {
            wedge(Vector, Vector);
            wedge({Bivector, Vector}, Vector) -> Multivector;
        }
    }
}

fn main() {}

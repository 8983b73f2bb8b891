//! The result of a product does not lie in the type that is stated.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }

        products {
            geometric(Vector, Bivector) -> Vector;
        }
    }
}

fn main() {}

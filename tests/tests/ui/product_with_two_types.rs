//! The result of a product fits two types.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }
        struct Area { e23, e31, e12 }

        products {
            wedge(Vector, Vector);
        }
    }
}

fn main() {}

//! The result of a sandwich does not lie in the type of its operand.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }
        struct Multivector { scalar, e1, e2, e3, e12, e13, e23, e123 }

        products {
            sandwich(Multivector, {Vector, Bivector}) -> Self;
        }
    }
}

fn main() {}

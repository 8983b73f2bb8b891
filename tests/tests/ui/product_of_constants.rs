//! All operands of a product are constants, so that no scalar type is known.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct E1 { e1 = 1 }
        struct E2 { e2 = 1 }
        struct Bivector { e12 }

        products {
            wedge(E1, E2);
        }
    }
}

fn main() {}

//! A basis vector bears the name of the scalar coefficient.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, scalar;
        signature 3, 0, 0;

        struct Vector { e1, e2 }
    }
}

fn main() {}

//! The signature counts another number of basis vectors than are named.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 2, 0, 2;

        struct Vector { e1, e2, e3 }
    }
}

fn main() {}

//! A basis vector is listed twice.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e2;
        signature 3, 0, 0;

        struct Vector { e1, e2 }
    }
}

fn main() {}

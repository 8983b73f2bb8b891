//! A type is declared twice.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Vector { e1, e2 }
    }
}

fn main() {}

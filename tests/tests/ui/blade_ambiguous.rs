//! The name of a blade can be read in two ways.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e12;
        signature 3;

        struct Vector { e1, e2, e12 }
    }
}

fn main() {}

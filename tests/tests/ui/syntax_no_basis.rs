//! There is no basis.

ga_runtime::algebra! {
    mod vga3 {
        signature 2;

        struct Vector { e1, e2 }
    }
}

fn main() {}

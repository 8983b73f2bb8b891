//! A type bears the name of a blade.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct e1 { e1 = 1 }
        struct Vector { e1, e2, e3 }
    }
}

fn main() {}

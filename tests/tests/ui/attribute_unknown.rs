//! An attribute of a type is none that is known.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[derive(Hash)]
        struct Vector { e1, e2, e3 }
    }
}

fn main() {}

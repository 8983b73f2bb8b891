//! A type bears the name of a constant of the module.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct METRIC { e1 = 1 }
    }
}

fn main() {}

//! Something follows the module.

ga_runtime::algebra! {
    mod vga2 {
        basis e1, e2;
        signature 2;
    }
    mod vga3 {}
}

fn main() {}

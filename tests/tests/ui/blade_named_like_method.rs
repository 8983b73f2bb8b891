//! A blade has the name of a method.

ga_runtime::algebra! {
    mod vga3 {
        basis n, e, w;
        signature 3;

        struct Trivector { new }
    }
}

fn main() {}

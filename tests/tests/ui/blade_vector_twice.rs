//! A blade names a vector twice.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Bivector { e12, e33 }
    }
}

fn main() {}

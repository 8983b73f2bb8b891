//! A blade is listed twice, in two orders of its vectors.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Bivector { e12, e23, e21 }
    }
}

fn main() {}

//! A blade names a vector that is not in the basis.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Bivector { e12, e14 }
    }
}

fn main() {}

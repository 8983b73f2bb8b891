//! The metric names a vector that is not in the basis.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2;
        metric e1*e1 = 1, e3*e3 = 1;

        struct Vector { e1, e2 }
    }
}

fn main() {}

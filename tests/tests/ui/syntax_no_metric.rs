//! There is no metric.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2;

        struct Vector { e1, e2 }
    }
}

fn main() {}

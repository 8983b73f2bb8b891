//! An entry of the metric is stated twice.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2;
        metric e1*e1 = 1, e2*e2 = 1, e1*e1 = 1;

        struct Vector { e1, e2 }
    }
}

fn main() {}

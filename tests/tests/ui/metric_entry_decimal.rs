//! An entry of the metric is written as a decimal fraction.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2;
        metric e1*e1 = 0.5, e2*e2 = 1;

        struct Vector { e1, e2 }
    }
}

fn main() {}

//! Two entries of the metric contradict each other.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2;
        metric e1*e1 = 1, e1*e2 = 1, e2*e1 = -1;

        struct Vector { e1, e2 }
    }
}

fn main() {}

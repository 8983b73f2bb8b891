//! A derived blade divides by zero.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Vector { e1, e2, e3 = e1/(2 - 2) }
        struct Sums { e1, e2, e3 }
    }
}

fn main() {}

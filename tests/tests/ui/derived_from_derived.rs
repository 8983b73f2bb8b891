//! A derived blade refers to a derived blade.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Vector { e1, e2 = 2*e1, e3 = e2 }
        struct Sums { e1, e2, e3 }
    }
}

fn main() {}

//! A derived blade refers to something that is no blade of the type.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Vector { e1, e2, e3 = e1*e12 }
        struct Sums { e1, e2, e3 }
    }
}

fn main() {}

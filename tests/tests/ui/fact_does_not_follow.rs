//! A fact does not follow from the blades.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[facts(null)]
        struct Vector { e1, e2, e3 }
        struct Sums { e1, e2, e3 }
    }
}

fn main() {}

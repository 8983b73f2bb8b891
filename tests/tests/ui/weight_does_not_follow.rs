//! The weight is not the constant that it is said to be.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[facts(weight(e3))]
        struct Point { e1, e2, e3 = 2 }
        struct Sums { e1, e2, e3 }
    }
}

fn main() {}

//! A weight names no blade of the algebra.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[facts(weight(eo))]
        struct Point { e1, e2, e3 = 1 }
        struct Sums { e1, e2, e3 }
    }
}

fn main() {}

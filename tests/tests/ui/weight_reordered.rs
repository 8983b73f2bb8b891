//! A weight names a blade in another than the rising order.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[facts(weight(e31))]
        struct Point { e12, e23, e31 = 1 }
        struct Sums { e12, e23, e31 }
    }
}

fn main() {}

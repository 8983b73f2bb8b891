//! A hull lacks blades of the type.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Point { e1, e2, e3 = 1 }
        struct Sums { e1 }
    }
}

fn main() {}

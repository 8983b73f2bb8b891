//! A hull has a constant blade, here the type itself.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Point)]
        struct Point { e1, e2, e3 = 1 }
    }
}

fn main() {}

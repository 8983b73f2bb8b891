//! An item is neither a type nor products.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        enum Vector { e1, e2 }
    }
}

fn main() {}

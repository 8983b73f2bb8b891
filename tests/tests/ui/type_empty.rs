//! A type lists no blade.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Nothing {}
    }
}

fn main() {}

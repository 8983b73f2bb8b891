//! A type with constants names no hull.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Point { e1, e2, e3 = 1 }
    }
}

fn main() {}

//! A type bears the name by which results are said to be scalars.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Scalar { scalar }
    }
}

fn main() {}

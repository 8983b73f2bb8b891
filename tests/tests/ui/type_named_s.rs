//! A type bears the name of the scalar parameter.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct S { e1, e2, e3 }
    }
}

fn main() {}

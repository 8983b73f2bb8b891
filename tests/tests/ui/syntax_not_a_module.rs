//! The declaration is no module.

ga_runtime::algebra! {
    struct Vector { e1, e2 }
}

fn main() {}

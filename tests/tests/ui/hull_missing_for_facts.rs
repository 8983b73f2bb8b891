//! A type with facts names no hull.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[facts(unit_versor)]
        struct Rotor { scalar, e12, e13, e23 }
    }
}

fn main() {}

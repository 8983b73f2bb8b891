//! A fact is none that is known.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Even)]
        #[facts(unit)]
        struct Rotor { scalar, e12, e13, e23 }
        struct Even { scalar, e12, e13, e23 }
    }
}

fn main() {}

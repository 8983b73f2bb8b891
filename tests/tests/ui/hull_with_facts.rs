//! A hull states facts.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Rotor)]
        struct Turn { scalar = 1, e12 }
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Rotor { scalar, e12, e13, e23 }
        struct Even { scalar, e12, e13, e23 }
    }
}

fn main() {}

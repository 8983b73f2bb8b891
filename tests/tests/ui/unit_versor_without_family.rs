//! The blades of a type do not hold the unit versors that its bivectors generate.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[facts(unit_versor)]
        struct Rotor { scalar, e12, e13 }
        struct Sums { scalar, e12, e13 }
    }
}

fn main() {}

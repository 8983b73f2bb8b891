//! All faults are reported in one run, but nothing that only follows from another fault.

ga_runtime::algebra! {
    mod vga3 {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3, e4 }
        struct Bivector { e12, e13, e23, e21 }
        struct Point { e1, e2, e3 = 1 }
        #[hull(Sums)]
        #[facts(unit, null)]
        struct Rotor { scalar, e12, e13 = e12/e23, e23 }
        #[hull(Sums)]
        #[facts(null)]
        struct Null { e1, e2 }
        struct Sums { scalar, e1, e2, e12, e13, e23 }
        struct Trivector { e123 }

        products {
            // Sound, but with a faulty operand: nothing is said.
            wedge(Vector, Bivector);
            geometric(Rotor, Rotor) -> Rotor;
            // Faulty of themselves.
            meet(Vector, Vector);
            dual(Trivector, Sums);
            wedge(Sums, Trivectors);
            geometric(Trivector, Sums) -> Trivector;
        }
    }
}

fn main() {}

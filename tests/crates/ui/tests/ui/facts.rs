//! Facts that are unknown or do not follow from the blades.

// Two planes that meet in one point span no family of blades, and blades have one grade.
ga_runtime::algebra! {
    mod fact_blade_without_family {
        basis e1, e2, e3, e4;
        signature 4, 0, 0;

        #[hull(Sums)]
        #[facts(blade)]
        struct Plane { e12, e34 }
        struct Sums { e12, e34 }

        #[hull(Even)]
        #[facts(blade)]
        struct Mixed { scalar, e12, e13, e23 }
        struct Even { scalar, e12, e13, e23 }
    }
}

// A fact does not follow from the blades.
ga_runtime::algebra! {
    mod fact_does_not_follow {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[facts(null)]
        struct Vector { e1, e2, e3 }
        struct Sums { e1, e2, e3 }
    }
}

// The squares of the signature go to the names in order, so that e0 is not the null vector.
ga_runtime::algebra! {
    mod signature_in_another_order {
        basis e0, e1, e2;
        signature 2, 0, 1;

        #[hull(Sums)]
        #[facts(unit_versor)]
        struct Shift { scalar = 1, e01, e02 }
        struct Sums { scalar, e01, e02 }
        #[hull(Vector)]
        #[facts(null)]
        struct Null { e0 }
        struct Vector { e0 }
    }
}

// A fact is unknown.
ga_runtime::algebra! {
    mod fact_unknown {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Even)]
        #[facts(unit)]
        struct Rotor { scalar, e12, e13, e23 }
        struct Even { scalar, e12, e13, e23 }
    }
}

// A type lacks blades of the unit versors that its bivectors generate.
ga_runtime::algebra! {
    mod unit_versor_without_family {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[facts(unit_versor)]
        struct Rotor { scalar, e12, e13 }
        struct Sums { scalar, e12, e13 }
    }
}

// The weight is not the constant that the fact states.
ga_runtime::algebra! {
    mod weight_does_not_follow {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[facts(weight(e3))]
        struct Point { e1, e2, e3 = 2 }
        struct Sums { e1, e2, e3 }
    }
}

// A weight names the vectors of a blade out of order.
ga_runtime::algebra! {
    mod weight_reordered {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[facts(weight(e31))]
        struct Point { e12, e23, e31 = 1 }
        struct Sums { e12, e23, e31 }
    }
}

// A weight names something that is not a blade of the algebra.
ga_runtime::algebra! {
    mod weight_unknown_blade {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[facts(weight(eo))]
        struct Point { e1, e2, e3 = 1 }
        struct Sums { e1, e2, e3 }
    }
}

// A weight without a blade.
ga_runtime::algebra! {
    mod weight_without_blade {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[facts(weight)]
        struct Point { e1, e2, e3 = 1 }
        struct Sums { e1, e2, e3 }
    }
}

fn main() {}

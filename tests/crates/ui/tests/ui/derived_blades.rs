//! Faults of the polynomials of constant and derived blades.

// A derived blade is not a polynomial.
ga_runtime::algebra! {
    mod derived_by_call {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Vector { e1, e2, e3 = sqrt(e1) }
        struct Sums { e1, e2, e3 }
    }
}

// A derived blade divides by a coefficient.
ga_runtime::algebra! {
    mod derived_by_division {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Vector { e1, e2, e3 = e1/e2 }
        struct Sums { e1, e2, e3 }
    }
}

// A derived blade uses an operator of the algebra.
ga_runtime::algebra! {
    mod derived_by_operator {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Vector { e1, e2, e3 = e1 ^ e2 }
        struct Sums { e1, e2, e3 }
    }
}

// A derived blade divides by zero.
ga_runtime::algebra! {
    mod derived_by_zero {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Vector { e1, e2, e3 = e1/(2 - 2) }
        struct Sums { e1, e2, e3 }
    }
}

// A derived blade refers to a constant blade.
ga_runtime::algebra! {
    mod derived_from_constant {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Vector { e1, e2 = 2, e3 = e1*e2 }
        struct Sums { e1, e2, e3 }
    }
}

// A derived blade refers to a derived blade.
ga_runtime::algebra! {
    mod derived_from_derived {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Vector { e1, e2 = 2*e1, e3 = e2 }
        struct Sums { e1, e2, e3 }
    }
}

// A derived blade refers to something that is not a blade of the type.
ga_runtime::algebra! {
    mod derived_from_no_blade {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Vector { e1, e2, e3 = e1*e12 }
        struct Sums { e1, e2, e3 }
    }
}

// Each factor of a derived blade is small, and their product is too large.
ga_runtime::algebra! {
    mod derived_number_too_large {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Nested { e1, e2, e3 = 1000000*(e1*1000000*(e2*(1000000*e1)*1000000*(e2*1000000))*1000000*1000000) }
        #[hull(Sums)]
        struct Power { e1, e2, e3 = (100*e1 + 100*e2)*(100*e1 - 100*e2)*(100*e1 - 100*e2) }
        #[hull(Sums)]
        struct Fractions { e1, e2, e3 = e1/1009 + e2/1013 }
        #[hull(Sums)]
        struct Exact { e1, e2, e3 = e1/1000000 + 999999*(e2/1000000) }
        struct Sums { e1, e2, e3 }
    }
}

// A number is too large for exact arithmetic.
ga_runtime::algebra! {
    mod number_too_large {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Vector { e1, e2, e3 = 1000000*e1 + 1000*1001*e2 }
        struct Sums { e1, e2, e3 }
    }
}

fn main() {}

//! Warnings of declarations that are probably mistakes; `allow(deprecated)` silences them.
#![deny(deprecated)]

// e2 is null, though other libraries make e0 null.
ga_runtime::algebra! {
    mod null_last {
        basis e0, e1, e2;
        signature 2, 0, 1;

        struct Vector { e0, e1, e2 }
    }
}

// The squares are as they are written.
ga_runtime::algebra! {
    mod null_first {
        basis e0 = 0, e1 = 1, e2 = 1;

        struct Vector { e0, e1, e2 }
    }
}

// A product is always zero; the others are declared.
ga_runtime::algebra! {
    mod always_zero {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }

        products {
            wedge(Bivector, Bivector);
            wedge(Vector, Vector);
        }
    }
}

// In a list some products are zero.
ga_runtime::algebra! {
    mod zero_in_list {
        basis e1, e2;
        signature 2, 0, 0;

        struct Vector { e1, e2 }
        struct Bivector { e12 }

        products {
            wedge({Vector, Bivector}, {Vector, Bivector});
        }
    }
}

ga_runtime::algebra! {
    #[allow(deprecated)]
    mod silent {
        basis e0, e1, e2;
        signature 2, 0, 1;

        struct Vector { e0, e1, e2 }
    }
}

fn main() {
    let v = zero_in_list::Vector::new(1.0, 0.0);
    let _ = v ^ v;
}

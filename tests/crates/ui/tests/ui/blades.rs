//! Faults of the names of blades.

// The name of a blade can be read in two ways.
ga_runtime::algebra! {
    mod blade_ambiguous {
        basis e1, e2, e12;
        signature 3;

        struct Vector { e1, e2, e12 }
    }
}

// A blade, and a basis vector, have the name of a keyword.
ga_runtime::algebra! {
    mod blade_named_like_keyword {
        basis i, f, m;
        signature 3;

        struct Vector { i, f, m }
        struct Bivector { if, mf, im }
    }
}
ga_runtime::algebra! {
    mod vector_named_like_keyword {
        basis x, fn;
        signature 2;

        struct Vector { x, fn }
    }
}

// A blade has the name of a method.
ga_runtime::algebra! {
    mod blade_named_like_method {
        basis n, e, w;
        signature 3;

        struct Trivector { new }
    }
}

// A blade is listed twice.
ga_runtime::algebra! {
    mod blade_twice {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e1 }
    }
}

// A blade is listed twice, in two orders of its vectors.
ga_runtime::algebra! {
    mod blade_twice_reordered {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Bivector { e12, e23, e21 }
    }
}

// A blade names a vector that is not in the basis.
ga_runtime::algebra! {
    mod blade_unknown_vector {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Bivector { e12, e14 }
    }
}

// A blade names a vector twice.
ga_runtime::algebra! {
    mod blade_vector_twice {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Bivector { e12, e33 }
    }
}

fn main() {}

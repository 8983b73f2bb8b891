//! Faults of the names of types, their attributes and their hulls.

// An attribute of a type is unknown.
ga_runtime::algebra! {
    mod attribute_unknown {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[derive(Hash)]
        struct Vector { e1, e2, e3 }
    }
}

// A hull lacks blades of the type.
ga_runtime::algebra! {
    mod hull_lacks_blade {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Point { e1, e2, e3 = 1 }
        struct Sums { e1 }
    }
}

// A type with constants names no hull.
ga_runtime::algebra! {
    mod hull_missing {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Point { e1, e2, e3 = 1 }
    }
}

// A type with facts names no hull.
ga_runtime::algebra! {
    mod hull_missing_for_facts {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[facts(unit_versor)]
        struct Rotor { scalar, e12, e13, e23 }
    }
}

// A type names two hulls.
ga_runtime::algebra! {
    mod hull_twice {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        #[hull(Sums)]
        struct Point { e1, e2, e3 = 1 }
        struct Sums { e1, e2, e3 }
    }
}

// A hull is not declared.
ga_runtime::algebra! {
    mod hull_unknown {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Sums)]
        struct Point { e1, e2, e3 = 1 }
    }
}

// A hull has a constant blade, here the type itself.
ga_runtime::algebra! {
    mod hull_with_constant {
        basis e1, e2, e3;
        signature 3, 0, 0;

        #[hull(Point)]
        struct Point { e1, e2, e3 = 1 }
    }
}

// A hull states facts.
ga_runtime::algebra! {
    mod hull_with_facts {
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

// A type lists no blade.
ga_runtime::algebra! {
    mod type_empty {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Nothing {}
    }
}

// A type has the name of a blade.
ga_runtime::algebra! {
    mod type_named_like_blade {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct e1 { e1 = 1 }
        struct Vector { e1, e2, e3 }
    }
}

// A type has the name of a constant of the module.
ga_runtime::algebra! {
    mod type_named_like_constant {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct METRIC { e1 = 1 }
    }
}

// A type has the name of a keyword.
ga_runtime::algebra! {
    mod type_named_like_keyword {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Self { e1, e2, e3 }
    }
}

// A type has the name of the scalar parameter.
ga_runtime::algebra! {
    mod type_named_s {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct S { e1, e2, e3 }
    }
}

// A type has the name `Scalar`, which stands for results that are scalars.
ga_runtime::algebra! {
    mod type_named_scalar {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Scalar { scalar }
    }
}

// A type is declared twice.
ga_runtime::algebra! {
    mod type_twice {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Vector { e1, e2 }
    }
}

fn main() {}

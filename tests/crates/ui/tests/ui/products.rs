//! Faults of declared products.

// A list of operands is empty.
ga_runtime::algebra! {
    mod product_no_operand {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }

        products {
            wedge({}, Vector);
        }
    }
}

// The result of a product does not have the weight of its type.
ga_runtime::algebra! {
    mod product_not_as_derived {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2 }
        #[hull(Sums)]
        #[facts(weight(e3))]
        struct Point { e1, e2, e3 = 1 }
        struct Sums { e1, e2, e3 }

        products {
            sandwich(Vector, Point) -> Point;
        }
    }
}

// The result of a product is not a scalar.
ga_runtime::algebra! {
    mod product_not_scalar {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }

        products {
            wedge(Vector, Vector) -> Scalar;
        }
    }
}

// All operands of a product are constants, so that no scalar type is known.
ga_runtime::algebra! {
    mod product_of_constants {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct E1 { e1 = 1 }
        struct E2 { e2 = 1 }
        struct Bivector { e12 }

        products {
            wedge(E1, E2);
        }
    }
}

// A dual has two operands.
ga_runtime::algebra! {
    mod product_one_operand {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }

        products {
            dual(Vector, Bivector);
        }
    }
}

// The result of a sandwich does not lie in the type of its operand.
ga_runtime::algebra! {
    mod product_outside_self {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }
        struct Multivector { scalar, e1, e2, e3, e12, e13, e23, e123 }

        products {
            sandwich(Multivector, {Vector, Bivector}) -> Self;
        }
    }
}

// The result of a product does not lie in the type that is stated.
ga_runtime::algebra! {
    mod product_outside_type {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }

        products {
            geometric(Vector, Bivector) -> Vector;
        }
    }
}

// A product has three operands.
ga_runtime::algebra! {
    mod product_three_operands {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }

        products {
            wedge(Vector, Vector, Vector);
        }
    }
}

// A product is declared twice.
ga_runtime::algebra! {
    mod product_twice {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }
        struct Multivector { scalar, e1, e2, e3, e12, e13, e23, e123 }

        products {
            wedge(Vector, Vector);
            wedge({Bivector, Vector}, Vector) -> Multivector;
        }
    }
}

// An operation is unknown.
ga_runtime::algebra! {
    mod product_unknown_operation {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }

        products {
            cross(Vector, Vector);
        }
    }
}

// The stated result is not declared.
ga_runtime::algebra! {
    mod product_unknown_result {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }

        products {
            wedge({Vector, Bivector}, Vector) -> Trivector;
        }
    }
}

// A product names types that are not declared.
ga_runtime::algebra! {
    mod product_unknown_type {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }

        products {
            wedge({Vector, Covector}, Vectors);
        }
    }
}

// The result of a product fits two types.
ga_runtime::algebra! {
    mod product_with_two_types {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }
        struct Area { e23, e31, e12 }

        products {
            wedge(Vector, Vector);
        }
    }
}

// The result of a product has no type.
ga_runtime::algebra! {
    mod product_without_type {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        struct Bivector { e12, e13, e23 }

        products {
            geometric(Vector, Vector);
        }
    }
}

fn main() {}

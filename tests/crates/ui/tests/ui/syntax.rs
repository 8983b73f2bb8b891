//! Declarations that do not follow the grammar.

// Something follows the module.
mod syntax_after_module {
    ga_runtime::algebra! {
        mod vga2 {
            basis e1, e2;
            signature 2;
        }
        mod vga3 {}
    }
}

// An item is neither a type nor products.
ga_runtime::algebra! {
    mod syntax_item {
        basis e1, e2, e3;
        signature 3, 0, 0;

        enum Vector { e1, e2 }
    }
}

// There is no basis.
ga_runtime::algebra! {
    mod syntax_no_basis {
        signature 2;

        struct Vector { e1, e2 }
    }
}

// A comma is missing between blades.
ga_runtime::algebra! {
    mod syntax_no_comma {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1 e2 }
    }
}

// There is no metric.
ga_runtime::algebra! {
    mod syntax_no_metric {
        basis e1, e2;

        struct Vector { e1, e2 }
    }
}

// A semicolon is missing after a product.
ga_runtime::algebra! {
    mod syntax_no_semicolon {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2, e3 }
        products { left_contraction(Vector, Vector) -> Scalar }
    }
}

// The declaration is not a module.
mod syntax_not_a_module {
    ga_runtime::algebra! {
        struct Vector { e1, e2 }
    }
}

// Each item that does not follow the grammar is reported.
ga_runtime::algebra! {
    mod syntax_several {
        basis e1, e2, e3;
        signature 3, 0, 0;

        struct Vector { e1, e2; e3 }
        struct Bivector;
        #[hull]
        struct Trivector { e123 }
        struct Even { scalar, e12, e13, e23 }
        products {
            wedge[Vector, Vector];
            geometric(Even, Even) => Even;
            geometric(Vector, Vector) -> Even;
        }
    }
}

// A type with its visibility.
ga_runtime::algebra! {
    mod visibility_of_type {
        basis e1;
        signature 1, 0, 0;

        pub struct Vector { e1 }
    }
}

fn main() {}

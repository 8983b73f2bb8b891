//! Algebras of every visibility, in modules and functions, imported under other names.

mod declarations {
    ga_runtime::algebra! {
        mod private {
            basis e1, e2;
            signature 2;
            struct Vector { e1, e2 }
            struct Bivector { e12 }
            products { wedge(Vector, Vector); }
        }
    }

    ga_runtime::algebra! {
        pub(super) mod for_the_parent {
            basis e1, e2;
            signature 1, 1;
            struct Vector { e1, e2 }
            struct Bivector { e12 }
            products { wedge(Vector, Vector); }
        }
    }

    ga_runtime::algebra! {
        pub(in crate::places) mod for_a_path {
            basis e1, e2;
            signature 0, 2;
            struct Vector { e1, e2 }
            struct Bivector { e12 }
            products { wedge(Vector, Vector); }
        }
    }

    ga_runtime::algebra! {
        pub(crate) mod for_the_crate {
            crate = ga_runtime;
            basis e1, e2;
            signature 0, 0, 2;
            struct Vector { e1, e2 }
            struct Bivector { e12 }
            products { wedge(Vector, Vector); }
        }
    }

    mod private_tests {
        ga_runtime::testing::product_tests!(super::private);
    }

    /// The oriented area by the private algebra.
    pub(crate) fn area(a: [i64; 2], b: [i64; 2]) -> i64 {
        let [a, b] = [a, b].map(|[x, y]| private::Vector::new(x, y));
        (a ^ b).e12
    }
}

use declarations::for_the_crate as renamed;

mod parent_tests {
    ga_runtime::testing::product_tests!(super::declarations::for_the_parent);
}

mod path_tests {
    use super::declarations::for_a_path;
    ga_runtime::testing::product_tests!(for_a_path);
}

mod renamed_tests {
    ga_runtime::testing::product_tests!(crate::places::renamed);
}

/// Another crate's algebra, re-exported under another name.
mod passed_on {
    pub(super) use nullcone_embedder::sta as spacetime;
}

/// An algebra whose declaration gives the path of ga-runtime, in terms of its own crate.
mod runtime_of_another_crate_tests {
    ga_runtime::testing::product_tests!(nullcone_embedder::with_a_path::complex);
}

mod passed_on_tests {
    use super::passed_on::*;
    ga_runtime::testing::product_tests!(spacetime);
}

#[test]
fn in_functions() {
    fn area(a: [i64; 2], b: [i64; 2]) -> i64 {
        ga_runtime::algebra! {
            mod plane {
                basis e1, e2;
                signature 2;
                struct Vector { e1, e2 }
                struct Bivector { e12 }
                products { wedge(Vector, Vector); }
            }
        }
        use plane::Vector;
        (Vector::new(a[0], a[1]) ^ Vector::new(b[0], b[1])).e12
    }
    fn length_squared(a: [i64; 2]) -> i64 {
        // The same name for something else, in a block of its own.
        {
            ga_runtime::algebra! {
                mod plane {
                    basis x, y;
                    signature 2;
                    struct Vector { x, y }
                    products { left_contraction(Vector, Vector); }
                }
            }
            let vector = plane::Vector::new(a[0], a[1]);
            vector | vector
        }
    }
    struct Triangle([[i64; 2]; 3]);
    impl Triangle {
        fn double_area(&self) -> i64 {
            ga_runtime::algebra! {
                mod projective {
                    basis x, y, w;
                    signature 0, 0, 3;
                    struct Vector { x, y, w }
                    #[hull(Vector)]
                    struct Place { x, y, w = 1 }
                    struct Segment { xy, xw, yw }
                    struct Area { xyw }
                    products {
                        wedge(Place, Place) -> Segment;
                        wedge(Segment, Place) -> Area;
                    }
                }
            }
            let [a, b, c] = self.0.map(|[x, y]| projective::Place::new(x, y));
            (a ^ b ^ c).xyw
        }
    }

    assert_eq!(area([3, 0], [1, 2]), 6);
    assert_eq!(declarations::area([3, 0], [1, 2]), 6);
    assert_eq!(length_squared([3, 4]), 25);
    assert_eq!(Triangle([[1, 1], [4, 1], [2, 3]]).double_area(), 6);
}

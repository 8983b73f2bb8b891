//! Algebras declared in another crate that renames ga-runtime. Their product tests are emitted
//! here, from the declarations there.

use nullcone_embedder::{area, first, moved, second};

mod sta {
    ga_runtime::testing::product_tests!(nullcone_embedder::sta);
}

mod oblique {
    ga_runtime::testing::product_tests!(nullcone_embedder::skew::oblique);
}

mod plane {
    ga_runtime::testing::product_tests!(nullcone_embedder::second::plane);
}

#[test]
fn algebras_of_one_name_are_two() {
    let a = first::plane::Vector::new(3.0, 0.0) ^ first::plane::Vector::new(1.0, 2.0);
    let b = second::plane::Vector::new(3, 0) ^ second::plane::Vector::new(1, 2);
    assert_eq!((a.e12, b.e12), (6.0, 6));
}

#[test]
fn the_runtime_may_be_named() {
    use nullcone_embedder::with_a_path::complex::Complex;
    assert_eq!(Complex::new(0, 1) * Complex::new(0, 1), Complex::new(-1, 0));
}

#[test]
fn functions_of_the_embedder_work() {
    assert_eq!(area([3.0, 0.0], [1.0, 2.0]), 6.0);
    let [x, y, z] = moved([1.0, 0.0, 2.0]);
    assert!((x - 1.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && z == 2.0);
}

/// Functions and types of the other crate, and one of its functions called in `ga!` here.
#[test]
fn compiled_functions_of_the_embedder_work() {
    use nullcone_embedder::functions;
    use nullcone_embedder::{skew::oblique, sta, with_a_path::complex::Complex};

    let rest = sta::Vector::new(1.0, 0.0, 0.0, 2.0);
    let boost = functions::boost(0.5_f64);
    let seen = functions::observed(boost, rest);
    assert!(
        (seen.g0 - 0.5_f64.cosh()).abs() < 1e-15 && (seen.g1.abs() - 0.5_f64.sinh()).abs() < 1e-15
    );
    assert_eq!(functions::observing(boost).apply(rest).g3, seen.g3);

    let corner = |x, y, z| ga_runtime::cga3::Point::new(x, y, z);
    let corners = [
        corner(1.0, 0.0, 0.0),
        corner(0.0, 1.0, 0.0),
        corner(0.0, 0.0, 1.0),
        corner(-1.0, 0.0, 0.0),
    ];
    assert_eq!(functions::power(corner(0.0, -1.0, 0.0), corners), 0.0);
    assert_ne!(functions::power(corner(0.0, -2.0, 0.0), corners), 0.0);

    let vector = |a, b, c| oblique::Vector::new(a, b, c);
    let (x, y, z) = (
        vector(2.0, 1.0, 0.0),
        vector(0.0, 3.0, 0.0),
        vector(0.0, 5.0, 4.0),
    );
    let (volume, half) = functions::volumes(x, y, z);
    assert_eq!((volume.abc, half.abc), (24.0, 12.0));
    assert_eq!(functions::square(Complex::new(2, 1)), Complex::new(3, 4));

    mod here {
        ga_runtime::ga! { nullcone_embedder::sta;
            use nullcone_embedder::functions::observed;
            pub fn twice(r: Rotor, p: Vector) -> Vector { observed(r, observed(r, p)) }
        }
    }
    let twice = here::twice(boost, rest);
    assert!((twice.g0 - 1.0_f64.cosh()).abs() < 1e-14);
}

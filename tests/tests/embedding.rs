//! Algebras of another crate, which knows ga-runtime by another name: their tests are written here, from declarations there.

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

//! Vectors, rotors and complex numbers of vga2.

use std::f64::consts::PI;

use ga_runtime::vga2::{Bivector, Complex, Rotor, Vector};
use nullcone_tests::plain::near_all;
use proptest::prelude::*;

use super::plane::rotated;

fn vector() -> impl Strategy<Value = [f64; 2]> + Clone {
    prop::array::uniform2(-5.0..5.0_f64).prop_filter("no direction", |[x, y]| x.hypot(*y) > 0.1)
}

proptest! {
    #[test]
    fn rotors_agree_with_matrices(x in vector(), angle in -7.0..7.0_f64, more in -7.0..7.0_f64) {
        let rotor = Rotor::from_angle(angle).unwrap();
        near_all(rotor.transform(Vector::from(x)).into(), rotated(x, angle), 1e-14);
        let [a, b] = rotor.to_matrix();
        near_all([a[0] * x[0] + a[1] * x[1], b[0] * x[0] + b[1] * x[1]], rotated(x, angle), 1e-14);
        let product = Rotor::from_angle(more).unwrap() * rotor;
        near_all(product.transform(Vector::from(x)).into(), rotated(x, angle + more), 1e-13);
        // As a complex number, by one product on the right: e1 z rotated is e1 z w.
        let number = Vector::from(x).to_complex() * rotor.to_complex();
        near_all(number.to_vector().into(), rotated(x, angle), 1e-14);
    }

    #[test]
    fn angles_survive_a_round_trip(angle in -2.0 * PI..2.0 * PI) {
        let rotor = Rotor::from_angle(angle).unwrap();
        near_all([rotor.angle()], [angle], 1e-15 * 4.0);
        near_all([rotor.log().e12], [-0.5 * angle], 1e-15 * 2.0);
        let again = rotor.log().exp();
        near_all([again.scalar(), again.e12()], [rotor.scalar(), rotor.e12()], 1e-15);
    }

    #[test]
    fn two_vectors_give_the_rotation_between_them(a in vector(), b in vector()) {
        let angle = (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]);
        let (u, v) = (Vector::from(a), Vector::from(b));
        near_all([u.angle(v).unwrap()], [angle], 1e-14);
        let rotor = Rotor::between(u, v).unwrap();
        near_all([rotor.angle()], [angle], 1e-14);
        let size = b[0].hypot(b[1]) / a[0].hypot(a[1]);
        near_all((rotor.transform(u) * size).into(), b, 1e-13);
        near_all([(u * v).argument().unwrap()], [angle], 1e-14);
        let along = (a[0] * b[0] + a[1] * b[1]) / (b[0] * b[0] + b[1] * b[1]);
        near_all(u.project(v).unwrap().into(), b.map(|x| x * along), 1e-13);
        let reflected = u.reflect(v).unwrap();
        near_all(reflected.into(), [a[0] - 2.0 * along * b[0], a[1] - 2.0 * along * b[1]], 1e-13);
        near_all((u.project(v).unwrap() + u.reject(v).unwrap()).into(), a, 1e-13);
    }

    #[test]
    fn complex_numbers_multiply(a in vector(), b in vector()) {
        let product = Complex::new(a[0], a[1]) * Complex::new(b[0], b[1]);
        let expected = [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
        near_all([product.real(), product.imaginary()], expected, 1e-14);
        let (modulus, argument) = (product.modulus(), product.argument().unwrap());
        let again = Complex::from_polar(modulus, argument).unwrap();
        near_all([again.real(), again.imaginary()], expected, 1e-13);
    }
}

#[test]
fn opposite_vectors_are_180_degrees_apart() {
    let rotor = Rotor::between(Vector::new(1.0, 0.0), Vector::new(-2.0, 0.0)).unwrap();
    assert_eq!(rotor.angle(), PI);
    // For nearly opposite vectors the result is accurate, on either side.
    for tiny in [1e-9, -1e-9, 1e-300] {
        let rotor = Rotor::between(Vector::new(1.0, 0.0), Vector::new(-1.0, tiny)).unwrap();
        let image = rotor.transform(Vector::new(1.0, 0.0));
        near_all(image.into(), [-1.0, tiny], 3e-16);
    }
}

#[test]
fn vectors_without_a_direction_give_none() {
    let x = Vector::new(1.0, 0.0);
    for bad in [[0.0, 0.0], [f64::NAN, 1.0], [0.0, f64::INFINITY]] {
        let v = Vector::from(bad);
        assert_eq!(v.normalized(), None);
        assert_eq!(x.angle(v), None);
        assert_eq!(x.project(v), None);
        assert_eq!(x.reject(v), None);
        assert_eq!(x.reflect(v), None);
        assert_eq!(Rotor::between(x, v), None);
        assert_eq!(Rotor::from_complex(v.to_complex()), None);
        assert_eq!(v.to_complex().argument(), None);
    }
    assert_eq!(Rotor::from_angle(f64::NAN), None);
    assert_eq!(Rotor::from_angle(f32::INFINITY), None);
    assert_eq!(Complex::from_polar(1.0, f64::INFINITY), None);
    assert_eq!(Complex::from_polar(f64::NAN, 1.0), None);
    assert!(Bivector::new(f64::NAN).exp().scalar().is_nan());
}

//! Vectors, bivectors, rotors and quaternions of vga3.

use std::f64::consts::PI;

use ga_runtime::cga3;
use ga_runtime::vga3::{Bivector, Quaternion, Rotor, Vector as V};
use nullcone_tests::plain::{
    Vector, cross, dot, length, minus, near_all, rotated, times, unit, vector,
};
use proptest::prelude::*;

fn coefficients(r: Rotor<f64>) -> [f64; 4] {
    [r.scalar(), r.e12(), r.e13(), r.e23()]
}

/// The product of quaternions `[x, y, z, w]`, from `ij = k` and so on.
fn hamilton(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    let ([ax, ay, az, aw], [bx, by, bz, bw]) = (a, b);
    [
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    ]
}

fn quaternion(rotor: Rotor<f64>) -> [f64; 4] {
    let ([x, y, z], w) = rotor.to_quaternion();
    [x, y, z, w]
}

proptest! {
    #[test]
    fn vectors_split_and_mirror(a in vector(5.0), n in unit(), size in 0.1..9.0_f64) {
        let (v, b) = (V::from(a), V::from(times(n, size)));
        let along = times(n, dot(a, n));
        near_all(v.project(b).unwrap().into(), along, 1e-14);
        near_all(v.reject(b).unwrap().into(), minus(a, along), 1e-14);
        near_all(v.reflect(b).unwrap().into(), minus(a, times(along, 2.0)), 1e-14);
        let within = Bivector::from_normal(times(n, -size)).project(v).unwrap();
        near_all(within.into(), minus(a, along), 1e-14);
        // The same by the products of the algebra, with n⁻¹ = n / n².
        let sandwiched = V::from(n).sandwich(v);
        near_all(sandwiched.into(), minus(a, times(along, 2.0)), 1e-13);
    }

    #[test]
    fn the_cross_product_is_the_dual_of_the_wedge(a in vector(5.0), b in vector(5.0)) {
        let (u, v) = (V::from(a), V::from(b));
        near_all(u.cross(v).into(), cross(a, b), 0.0);
        near_all((u ^ v).dual().into(), cross(a, b), 1e-14);
        near_all((u ^ v).normal(), cross(a, b), 1e-14);
        near_all([(u ^ v).area()], [length(cross(a, b))], 1e-13);
        prop_assert_eq!(Bivector::from_normal((u ^ v).normal()), u ^ v);
    }

    #[test]
    fn rotors_agree_with_the_formula_of_rodrigues(axis in unit(), angle in -7.0..7.0_f64, x in vector(5.0), size in 0.1..9.0_f64) {
        let rotor = Rotor::from_axis_angle(times(axis, size).into(), angle).unwrap();
        let expected = rotated(axis, angle, x);
        near_all(rotor.transform(V::from(x)).into(), expected, 1e-14 * 10.0);
        near_all(rotor.to_matrix().map(|row| dot(row, x)), expected, 1e-13);
        let again = Rotor::from_matrix(rotor.to_matrix()).unwrap();
        near_all(again.transform(V::from(x)).into(), expected, 1e-13);
        let generator = Bivector::from_normal(times(axis, -0.5 * angle));
        near_all(coefficients(generator.exp()), coefficients(rotor), 3e-15);
        prop_assert_eq!(Rotor::from(cga3::Rotor::from(rotor)), rotor);
    }

    #[test]
    fn quaternions_multiply_as_hamilton_says(a in unit(), s in -7.0..7.0_f64, b in unit(), t in -7.0..7.0_f64, v in vector(3.0)) {
        let p = Rotor::from_axis_angle(a.into(), s).unwrap();
        let q = Rotor::from_axis_angle(b.into(), t).unwrap();
        near_all(quaternion(p * q), hamilton(quaternion(p), quaternion(q)), 1e-15);
        let [x, y, z, w] = quaternion(p);
        let turned = hamilton(hamilton([x, y, z, w], [v[0], v[1], v[2], 0.0]), [-x, -y, -z, w]);
        let expected: Vector = p.transform(V::from(v)).into();
        near_all(turned, [expected[0], expected[1], expected[2], 0.0], 1e-14);
        let again = Rotor::from_quaternion([x * 3.0, y * 3.0, z * 3.0], w * 3.0).unwrap();
        near_all(coefficients(again), coefficients(p), 1e-15);
    }

    #[test]
    fn logarithms_survive_a_round_trip(axis in unit(), angle in 0.0..2.0 * PI) {
        let rotor = Rotor::from_axis_angle(axis.into(), angle).unwrap();
        near_all(coefficients(rotor.log().exp()), coefficients(rotor), 1e-15 * 4.0);
        let sine = (0.5 * angle).sin().max(1e-3);
        near_all(rotor.log().normal(), times(axis, -0.5 * angle), 1e-14 / sine);
    }

    #[test]
    fn interpolation_has_constant_speed(axis in unit(), start in unit(), angle in -3.0..3.0_f64, t in -1.0..2.0_f64, x in vector(3.0)) {
        let first = Rotor::between(V::new(0.0, 0.0, 1.0), start.into()).unwrap();
        let other = Rotor::from_axis_angle(axis.into(), angle).unwrap() * first;
        let begun: Vector = first.transform(V::from(x)).into();
        for goal in [other, -other] {
            let between = first.interpolate(goal, t).transform(V::from(x));
            near_all(between.into(), rotated(axis, angle * t, begun), 1e-13);
        }
    }

    #[test]
    fn the_shortest_rotation_joins_two_vectors(a in unit(), b in unit(), s in 0.1..9.0_f64) {
        let rotor = Rotor::between(times(a, s).into(), b.into()).unwrap();
        near_all(rotor.transform(V::from(a)).into(), b, 1e-14);
        let (axis, angle) = rotor.to_axis_angle();
        near_all([angle], [V::from(a).angle(V::from(b)).unwrap()], 1e-14);
        near_all([dot(axis.into(), a)], [0.0], 1e-7);
    }
}

#[test]
fn small_angles_and_large_vectors_keep_their_digits() {
    for angle in [1e-300_f64, 1e-100, 1e-20, 1e-9, 1e-4] {
        let turned = V::new(1.0, 0.0, 0.0).angle(V::new(angle.cos(), angle.sin(), 0.0));
        near_all([turned.unwrap()], [angle], 1e-16 * angle);
        let log = Bivector::new(angle, 0.0, 0.0).exp().log();
        near_all([log.e12], [angle], 2.3e-16 * angle);
    }
    near_all([V::new(3e200, 4e200, 0.0).length()], [5e200], 1e185);
    near_all([V::new(3e-200, 0.0, 4e-200).length()], [5e-200], 1e-215);
    let unit: Vector = V::new(3e200, 4e200, 0.0).normalized().unwrap().into();
    near_all(unit, [0.6, 0.8, 0.0], 1e-15);
}

#[test]
fn rotations_by_180_and_360_degrees_have_logarithms() {
    assert_eq!(Rotor::<f64>::default().log(), Bivector::new(0.0, 0.0, 0.0));
    assert_eq!(
        (-Rotor::<f64>::default()).log(),
        Bivector::new(PI, 0.0, 0.0)
    );
    let half = Rotor::between(V::new(1.0, 2.0, 3.0), V::new(-1.0, -2.0, -3.0)).unwrap();
    near_all([half.log().area()], [0.5 * PI], 1e-15);
    let back: Vector = half.transform(V::new(1.0, 2.0, 3.0)).into();
    near_all(back, [-1.0, -2.0, -3.0], 1e-15 * 8.0);
}

#[test]
fn vectors_without_a_direction_give_none() {
    let x = V::new(1.0, 0.0, 0.0);
    for bad in [
        [0.0; 3],
        [f64::NAN, 0.0, 0.0],
        [0.0, f64::INFINITY, 0.0],
        [0.0, 0.0, f64::NEG_INFINITY],
    ] {
        let v = V::from(bad);
        assert_eq!(v.normalized(), None);
        assert_eq!(x.project(v), None);
        assert_eq!(x.reject(v), None);
        assert_eq!(x.reflect(v), None);
        assert_eq!(x.angle(v), None);
        assert_eq!(Rotor::between(v, x), None);
        assert_eq!(Rotor::from_axis_angle(v, 1.0), None);
        assert_eq!(Bivector::from_normal(bad).normalized(), None);
        assert_eq!(Bivector::from_normal(bad).project(x), None);
        assert_eq!(Rotor::from_quaternion(bad, 0.0), None);
        assert_eq!(
            Quaternion::new(0.0, bad[0], bad[1], bad[2]).normalize(),
            None
        );
        assert_eq!(
            Rotor::from_matrix([bad, [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
            None
        );
    }
    assert_eq!(V::new(f64::NAN, 0.0, 0.0).project(x), None);
    assert_eq!(Rotor::from_axis_angle(x, f64::NAN), None);
    // NaN stays NaN.
    assert!(Bivector::new(f64::NAN, 0.0, 0.0).exp().scalar().is_nan());
    assert!(Bivector::new(f64::NAN, 0.0, 0.0).exp().e13().is_nan());
    assert!(
        Rotor::new_unchecked(1.0, f64::NAN, 0.0, 0.0)
            .log()
            .e12
            .is_nan()
    );
}

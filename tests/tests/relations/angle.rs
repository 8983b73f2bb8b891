//! Angles between primitives against plain formulas, and the normals at their intersections.

use ga_runtime::cga3::RoundVector;
use std::f64::consts::{FRAC_PI_2, PI};

use nullcone_tests::plain::*;
use proptest::prelude::*;

/// Asserts an angle in both orders.
macro_rules! check {
    ($a:expr, $b:expr, $expected:expr, $bound:expr) => {{
        let (a, b, expected, bound) = ($a, $b, $expected, $bound);
        near(a.angle_to(b).expect("an angle"), expected, bound);
        near(b.angle_to(a).expect("an angle"), expected, bound);
    }};
}

macro_rules! check_none {
    ($a:expr, $b:expr) => {{
        let (a, b) = ($a, $b);
        assert_eq!((a.angle_to(b), b.angle_to(a)), (None, None));
    }};
}

/// The angle of two unit vectors by Kahan's formula for the half angle, which is accurate for all
/// angles.
fn between(u: Vector, v: Vector) -> f64 {
    2.0 * length(minus(u, v)).atan2(length(along(u, 1.0, v)))
}

proptest! {
    #[test]
    fn directions(p in vector(5.0), q in vector(5.0), d in unit(), n in unit(), r in 0.1..4.0_f64, s in 0.1..4.0_f64) {
        let angle = between(d, n);
        check!(line(p, d), line(q, n.map(|x| 3.0 * x)), angle, 1e-14);
        check!(plane(p, d), plane(q, n.map(|x| 3.0 * x)), angle, 1e-14);
        check!(circle(p, d, r), plane(q, n), angle, 1e-12);
        check!(line(p, d), plane(q, n), FRAC_PI_2 - angle, 1e-14);
        check!(line(p, d), circle(q, n, s), FRAC_PI_2 - angle, 1e-12);
        near(plane(p, d).inversive_distance_to(plane(q, n)).unwrap(), dot(d, n), 1e-14);
    }

    /// Spheres through a common point: the angle of their normals there, which the algebra gives as
    /// `σ·τ/√(σ² τ²)`.
    #[test]
    fn spheres_that_meet(x in vector(3.0), u in unit(), v in unit(), n in unit(), r in 0.1..4.0_f64, s in 0.1..4.0_f64) {
        let angle = between(u, v);
        // A small angle of nearly equal spheres depends on differences of squares.
        prop_assume!(angle > 0.02 && angle < PI - 0.02);
        let (a, b) = (sphere(along(x, -r, u), r), sphere(along(x, -s, v), s));
        check!(a, b, angle, 1e-9);
        let by_algebra = |a: ga_runtime::cga3::DualSphere<f64>, b: ga_runtime::cga3::DualSphere<f64>| (a | b) / ((a | a) * (b | b)).sqrt();
        near(angle.cos(), by_algebra(a.dual(), b.dual()), 1e-10);
        near(a.inversive_distance_to(b).unwrap(), angle.cos(), 1e-10);
        // The normal of a plane corresponds to the inward normal of a sphere.
        let plane = plane(x, v.map(|x| -x));
        check!(a, plane, angle, 1e-9);
        near(a.inversive_distance_to(plane).unwrap(), angle.cos(), 1e-10);
        near({ let (a, b) = (RoundVector::from(a.dual()), RoundVector::from(plane.dual())); (a | b) / ((a | a) * (b | b)).sqrt() }, angle.cos(), 1e-10);
        // A curve through the point with tangent n, and the tangent plane.
        let rise = dot(n, u).abs().asin();
        prop_assume!(rise > 0.02 && rise < FRAC_PI_2 - 0.02);
        check!(a, line(x, n), rise, 1e-9);
        let across = cross(n, v);
        prop_assume!(length(across) > 0.1);
        let across = unit_of(across);
        check!(a, circle(along(x, s, across), cross(n, across), s), rise, 1e-8);
    }

    /// The inversive distance is invariant under inversion, whether the spheres meet or not.
    #[test]
    fn inversions_keep_it(p in vector(3.0), q in vector(3.0), c in vector(3.0), r in 0.1..4.0_f64, s in 0.1..4.0_f64) {
        use ga_runtime::geometry::relation::RoundOrFlat::Round;
        let (a, b, mirror) = (sphere(p, r), sphere(q, s), sphere(c, 1.0));
        let power = |p: Vector, r: f64| dot(minus(p, c), minus(p, c)) - r * r;
        prop_assume!(power(p, r).abs() > 0.3 && power(q, s).abs() > 0.3);
        let images = (a.invert_in(mirror, tolerance()), b.invert_in(mirror, tolerance()));
        let (Some(Round(i)), Some(Round(j))) = images else {
            panic!("{images:?}");
        };
        let expected = a.inversive_distance_to(b).unwrap();
        // By outward normals: inside and outside are exchanged if the centre of inversion is
        // inside.
        let turned = power(p, r).signum() * power(q, s).signum();
        let found = i.inversive_distance_to(j).unwrap() * turned;
        near(found, expected, 1e-8 * expected.abs().max(1.0));
    }
}

#[test]
fn small_angles_keep_their_digits() {
    for angle in [1e-12_f64, 1e-8, 1e-4] {
        let d = [angle.cos(), angle.sin(), 0.0];
        check!(line(O, X), line(O, d), angle, 1e-15 * angle.max(1e-4));
        check!(line(O, d), plane(O, Y), angle, 1e-15 * angle.max(1e-4));
        check!(line(O, X), line(O, d.map(|x| -x)), PI - angle, 1e-15);
    }
}

#[test]
fn touching_and_orthogonal() {
    // Touching from outside, from inside, and equal.
    check!(sphere(O, 1.0), sphere([3.0, 0.0, 0.0], 2.0), PI, 1e-7);
    check!(sphere(O, 1.0), sphere([1.0, 0.0, 0.0], 2.0), 0.0, 1e-7);
    check!(sphere(O, 1.0), sphere(O, 1.0), 0.0, 0.0);
    check!(sphere(O, 1.0), plane([0.0, 0.0, 1.0], Z), PI, 1e-7);
    check!(
        sphere(O, 1.0),
        plane([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]),
        0.0,
        1e-7
    );
    check!(sphere(O, 1.0), plane(O, Z), FRAC_PI_2, 1e-15);
    check!(sphere(O, 1.0), line(O, Z), FRAC_PI_2, 1e-15);
    check!(sphere(O, 1.0), line([1.0, 0.0, 0.0], Z), 0.0, 1e-7);
    // A circle on the sphere is tangent to it; one through it crosses it at a right angle.
    check!(sphere(O, 5.0), circle([0.0, 0.0, 3.0], Z, 4.0), 0.0, 1e-7);
    check!(
        sphere(O, 3.0),
        circle([5.0, 0.0, 0.0], Z, 4.0),
        FRAC_PI_2,
        1e-7
    );
    near(
        sphere(O, 1.0)
            .inversive_distance_to(sphere([3.0, 0.0, 0.0], 2.0))
            .unwrap(),
        -1.0,
        1e-15,
    );
    near(
        sphere(O, 1.0)
            .inversive_distance_to(sphere([1.0, 0.0, 0.0], 2.0))
            .unwrap(),
        1.0,
        1e-15,
    );
}

#[test]
fn what_does_not_meet_has_no_angle() {
    check_none!(sphere(O, 1.0), sphere([4.0, 0.0, 0.0], 2.0));
    check_none!(sphere(O, 1.0), sphere(O, 2.0));
    check_none!(sphere(O, 1.0), plane([0.0, 0.0, 2.0], Z));
    check_none!(sphere(O, 1.0), line([0.0, 0.0, 2.0], X));
    check_none!(sphere(O, 1.0), circle([0.0, 0.0, 2.0], Z, 1.0));
    check_none!(sphere(O, 1.0), circle(O, Z, 2.0));
    // The plane of the circle cuts the sphere, the circle does not.
    check_none!(sphere(O, 1.0), circle([5.0, 0.0, 0.5], Z, 2.0));
    near(
        sphere(O, 1.0)
            .inversive_distance_to(sphere(O, 2.0))
            .unwrap(),
        1.25,
        0.0,
    );
    near(
        plane([0.0, 0.0, 2.0], Z)
            .inversive_distance_to(sphere(O, 1.0))
            .unwrap(),
        -2.0,
        0.0,
    );
}

#[test]
fn degenerate() {
    // A point has no normal.
    check_none!(sphere(O, 0.0), sphere([1.0, 0.0, 0.0], 1.0));
    check_none!(sphere(O, 0.0), plane(O, Z));
    check_none!(sphere(O, 0.0), line(O, Z));
    check_none!(sphere(O, 1.0), circle([1.0, 0.0, 0.0], Z, 0.0));
    assert_eq!(sphere(O, 0.0).inversive_distance_to(sphere(O, 1.0)), None);
    assert_eq!(sphere(O, 1.0).inversive_distance_to(line(O, Z)), None);
    // Weight zero and imaginary.
    check_none!(line(O, O), line(O, X));
    check_none!(plane(O, O), line(O, X));
    check_none!(sphere_of_square(O, -1.0), plane(O, X));
    check_none!(circle_of_square(O, X, -1.0), plane(O, X));
    check_none!(sphere(O, 1.0) * 0.0, line(O, X));
}

#[test]
fn bad_input() {
    for bad in [f64::NAN, f64::INFINITY] {
        check_none!(line(O, [bad, 0.0, 1.0]), line(O, X));
        check_none!(line([bad, 0.0, 0.0], Y), line(O, X));
        check_none!(plane(O, [bad, 0.0, 1.0]), circle(O, X, 1.0));
        check_none!(sphere(O, bad), sphere(O, 1.0));
        check_none!(sphere([0.0, bad, 0.0], 1.0), plane(O, Z));
        assert_eq!(sphere(O, bad).inversive_distance_to(sphere(O, 1.0)), None);
    }
}

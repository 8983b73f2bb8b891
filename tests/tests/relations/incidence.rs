//! Incidence, parallels and perpendiculars: they hold for elements constructed so, and no longer
//! after a displacement.

use ga_runtime::cga3::Infinity;
use ga_runtime::geometry::relation::Tolerance;
use nullcone_tests::plain::*;
use proptest::prelude::*;

/// Displacements slightly larger and slightly smaller than the tolerance.
const MOVED: [(f64, bool); 2] = [(1.01e-3, false), (0.99e-3, true)];

fn loose() -> Tolerance<f64> {
    Tolerance::new(1e-3, 1e-3)
}

fn turned(u: Vector, v: Vector, angle: f64) -> Vector {
    std::array::from_fn(|k| u[k] * angle.cos() + v[k] * angle.sin())
}

proptest! {
    #[test]
    fn points(c in vector(5.0), n in unit(), r in 0.1..4.0_f64, t in -3.0..3.0_f64, weight in 0.1..9.0_f64) {
        let [u, v] = frame(n);
        for (off, is_on) in MOVED {
            // Points of the line along n, displaced perpendicular to it; points of the plane normal
            // to n, displaced along n.
            prop_assert_eq!(point(along(along(c, t, n), off, u)).is_on(line(c, n) * -weight, loose()), is_on);
            prop_assert_eq!(point(along(along(c, t, u), off, n)).is_on(plane(c, n) * weight, loose()), is_on);
            prop_assert_eq!(point(along(c, r - off, u)).is_on(sphere(c, r) * -weight, loose()), is_on);
            prop_assert_eq!(point(along(c, r + off, u)).is_on(circle(c, n, r) * -weight, loose()), is_on);
            let place = on_circle(c, n, r, t);
            prop_assert_eq!(point(along(place, off, n)).is_on(circle(c, n, r), loose()), is_on);
            let ends = pair(c, along(c, 9.0, u));
            prop_assert_eq!(point(along(c, off, v)).is_on(ends, loose()), is_on);
            prop_assert_eq!((point(along(c, off, v)) ^ Infinity).is_on(point(c), loose()), is_on);
            // A pair lies on every element on which both its points lie.
            let ends = pair(c, along(along(c, r, n), off, u));
            prop_assert_eq!(ends.is_on(line(c, n), loose()), is_on);
            let ends = pair(along(c, r, u), along(c, r + off, v));
            prop_assert_eq!(ends.is_on(sphere(c, r), loose()), is_on);
            prop_assert_eq!(ends.is_on(circle(c, n, r), loose()), is_on);
            prop_assert!(ends.is_on(plane(c, n), loose()));
        }
    }

    #[test]
    fn flats_and_rounds(c in vector(5.0), n in unit(), r in 0.5..4.0_f64, height in -0.9..0.9_f64, t in -3.0..3.0_f64) {
        let [u, v] = frame(n);
        // The tolerance of lines and planes holds at the point nearest to the origin.
        for (off, is_on) in MOVED {
            prop_assert_eq!(line(along(c, off, u), n).is_on(line(c, n), loose()), is_on);
            prop_assert_eq!(line(along(c, off, n), turned(u, v, t)).is_on(plane(c, n), loose()), is_on);
            prop_assert_eq!(plane(along(c, off, n), n).coincides_with(plane(c, n.map(|x| -x)), loose()), is_on);
            // Lines and planes through the origin, rotated about it.
            prop_assert_eq!(line(O, turned(u, n, off)).is_on(plane(O, n), loose()), is_on);
            prop_assert_eq!(line(O, turned(u, n, off)).coincides_with(line(O, u), loose()), is_on);
            prop_assert_eq!(plane(O, turned(u, n, off)).is_on(plane(O, u), loose()), is_on);
            // A circle in a plane, displaced, and rotated about its centre so that its farthest
            // point moves as far.
            prop_assert_eq!(circle(along(c, off, n), n, r).is_on(plane(c, n), loose()), is_on);
            prop_assert_eq!(circle(c, turned(n, u, (off / r).asin()), r).is_on(plane(c, n), loose()), is_on);
            prop_assert_eq!(circle(along(c, off, u), n, r).coincides_with(circle(c, n, r), loose()), is_on);
            prop_assert_eq!(circle(c, n, r + off).coincides_with(circle(c, n, r), loose()), is_on);
            prop_assert_eq!(circle(c, turned(n, u, (off / r).asin()), r).is_on(circle(c, n, r), loose()), is_on);
            prop_assert_eq!(sphere(along(c, off, u), r).coincides_with(sphere(c, r), loose()), is_on);
            prop_assert_eq!(sphere(c, r + off).is_on(sphere(c, r), loose()), is_on);
        }
        // A circle of latitude of the sphere.
        let parallel = circle(along(c, height * r, n), n, r * (1.0 - height * height).sqrt());
        prop_assert!(parallel.is_on(sphere(c, r), loose()));
        prop_assert!(!parallel.is_on(sphere(c, r + 0.002), loose()));
        prop_assert!(!parallel.is_on(sphere(along(c, 0.01, u), r), loose()));
        prop_assert!(!parallel.is_on(sphere(along(c, 0.01, u), r), loose()));
    }

    #[test]
    fn directions(p in vector(5.0), q in vector(5.0), n in unit(), t in -3.0..3.0_f64) {
        let [u, v] = frame(n);
        for (off, holds) in MOVED {
            let near_n = turned(n, turned(u, v, t), off);
            let (l, k) = (line(p, n), line(q, near_n.map(|x| -2.0 * x)));
            let (a, b) = (plane(p, n), plane(q, near_n.map(|x| -2.0 * x)));
            let (c, d) = (circle(p, n, 1.0), circle(q, near_n, 2.0));
            prop_assert_eq!(l.is_parallel_to(k, loose()), holds);
            prop_assert_eq!(a.is_parallel_to(b, loose()), holds);
            prop_assert_eq!(c.is_parallel_to(d, loose()), holds);
            prop_assert_eq!(c.is_parallel_to(b, loose()), holds);
            prop_assert_eq!(l.is_perpendicular_to(b, loose()), holds);
            prop_assert_eq!(b.is_perpendicular_to(l, loose()), holds);
            prop_assert_eq!(d.is_perpendicular_to(l, loose()), holds);
            prop_assert!(!l.is_parallel_to(b, loose()) && !l.is_perpendicular_to(k, loose()));
            // Perpendicular, or nearly so.
            let side = turned(u, n, off);
            prop_assert_eq!(l.is_perpendicular_to(line(q, side), loose()), holds);
            prop_assert_eq!(a.is_perpendicular_to(plane(q, side), loose()), holds);
            prop_assert_eq!(a.is_perpendicular_to(circle(q, side, 2.0), loose()), holds);
            prop_assert_eq!(l.is_parallel_to(plane(q, side), loose()), holds);
            prop_assert_eq!(plane(q, side).is_parallel_to(l, loose()), holds);
        }
    }
}

#[test]
fn what_cannot_be_on_it() {
    let wide = Tolerance::new(0.5, 0.5);
    assert!(!line(O, X).is_on(circle(O, Z, 9.0), wide) && !line(O, X).is_on(sphere(O, 9.0), wide));
    assert!(!plane(O, X).is_on(line(O, Y), wide) && !plane(O, X).is_on(sphere(O, 9.0), wide));
    assert!(!sphere(O, 9.0).is_on(plane(O, Z), wide) && !circle(O, Z, 9.0).is_on(line(O, X), wide));
    assert!(!line(O, X).is_on(point(O), wide));
}

#[test]
fn radii_within_the_tolerance_are_points() {
    let wide = Tolerance::new(0.5, 0.5);
    assert!(sphere(O, 0.4).is_on(plane(O, Z), wide) && circle(O, Z, 0.4).is_on(line(O, X), wide));
    assert!(!sphere([0.0, 0.0, 1.0], 0.4).is_on(plane(O, Z), wide));
    let exact = Tolerance::new(0.0, 0.0);
    assert!(sphere(O, 0.0).is_on(line(O, X), exact) && circle(O, Z, 0.0).is_on(point(O), exact));
    assert!(sphere(O, 0.0).is_on(sphere(X, 1.0), exact) && point(O).is_on(sphere(O, 0.0), exact));
}

#[test]
fn bounds_are_included() {
    let one = Tolerance::new(1.0, 0.0);
    assert!(point([0.0, 0.0, 1.0]).is_on(plane(O, Z), one));
    assert!(!point([0.0, 0.0, 1.0 + f64::EPSILON]).is_on(plane(O, Z), one));
    for bad in [-1.0, f64::NAN] {
        assert!(!point(O).is_on(plane(O, Z), Tolerance::new(bad, 1.0)));
        assert!(!line(O, X).is_parallel_to(line(O, X), Tolerance::new(1.0, bad)));
        assert!(!line(O, X).is_perpendicular_to(line(O, Y), Tolerance::new(1.0, bad)));
    }
    assert_eq!(
        Tolerance::<f32>::default(),
        Tolerance::new(1024.0 * f32::EPSILON, 1024.0 * f32::EPSILON)
    );
    assert_eq!(
        Tolerance::for_size(3.0),
        Tolerance::new(3072.0 * f64::EPSILON, 1024.0 * f64::EPSILON)
    );
}

#[test]
fn elements_that_are_not_figures_lie_on_nothing() {
    let all = Tolerance::new(f64::INFINITY, f64::INFINITY);
    assert!(point(O).is_on(plane([9.0, 0.0, 0.0], X), all));
    for bad in [f64::NAN, f64::INFINITY] {
        let p = point([bad, 0.0, 0.0]);
        assert!(!p.is_on(plane(O, X), all) && !p.coincides_with(p, all));
        assert!(!point(O).is_on(p, all) && !point(O).is_on(line(O, [bad, 0.0, 0.0]), all));
        assert!(!line(O, [bad, 1.0, 0.0]).is_parallel_to(line(O, X), all));
        assert!(!plane(O, X).is_perpendicular_to(plane(O, [bad, 0.0, 0.0]), all));
        assert!(!point(O).is_on(sphere(O, bad), all));
    }
    // Weight zero, and imaginary.
    assert!(!point(O).is_on(line(O, O), all) && !point(O).is_on(plane(O, O), all));
    assert!(
        !plane(O, O).is_parallel_to(plane(O, X), all)
            && !line(O, X).is_perpendicular_to(line(O, O), all)
    );
    assert!(!point(O).is_on(sphere_of_square(O, -1.0), all));
    assert!(!circle_of_square(O, Z, -1.0).is_on(plane(O, Z), all));
    assert!(!(point(O) ^ point(O)).is_on(point(O), all));
}

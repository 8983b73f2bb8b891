//! Joins of two primitives: the result contains both, is the smallest that does, and equals the
//! outer product in the dense algebra.

use ga_runtime::cga3::{Infinity, Point};
use ga_runtime::geometry::relation::{Join, Primitive, Tolerance};
use nullcone_tests::plain::*;
use proptest::prelude::*;

fn join<A: Primitive<f64>>(a: impl Fn(Tolerance<f64>, A) -> Option<Join<f64>>, b: A) -> Join<f64> {
    a(tolerance(), b).expect("a join")
}

/// The join in both orders; `$a` and `$b` are primitives.
macro_rules! joins {
    ($a:expr, $b:expr) => {{
        let (a, b) = ($a, $b);
        [join(|t, b| a.join(b, t), b), join(|t, a| b.join(a, t), a)]
    }};
}

macro_rules! outcome {
    ($found:expr, $case:path) => {
        match $found {
            $case(inner) => inner,
            other => panic!("{other:?}"),
        }
    };
}

/// Asserts that the join is this case in both orders, and a positive multiple of the outer product
/// in that order.
macro_rules! check_product {
    ($a:expr, $b:expr, $case:path, $bound:expr) => {{
        let (a, b) = ($a, $b);
        let [found, back] = joins!(a, b);
        positive_multiple(
            &dense(&outcome!(found, $case)),
            &dense(&a).wedge(&dense(&b)),
            $bound,
        );
        positive_multiple(
            &dense(&outcome!(back, $case)),
            &dense(&b).wedge(&dense(&a)),
            $bound,
        );
    }};
}

macro_rules! check_case {
    ($a:expr, $b:expr, $case:pat) => {{
        let found = joins!($a, $b);
        assert!(matches!(found, [$case, $case]), "{found:?}");
    }};
}

/// Asserts that the join is this case in both orders, and the same set of points as another
/// primitive.
macro_rules! check_is {
    ($a:expr, $b:expr, $case:path, $expected:expr) => {{
        for found in joins!($a, $b) {
            let found = outcome!(found, $case);
            assert!(
                found.coincides_with($expected, Tolerance::new(1e-7, 1e-7)),
                "{found:?} is not {:?}",
                $expected
            );
        }
    }};
}

proptest! {
    #[test]
    fn points(p in vector(3.0), q in vector(3.0), d in unit(), n in unit(), c in vector(3.0), r in 0.2..3.0_f64) {
        prop_assume!(length(minus(p, q)) > 0.1);
        let found = outcome!(join(|t, b| point(p).join(b, t), point(q)), Join::Line);
        positive_multiple(&dense(&found), &dense(&(point(p) ^ point(q) ^ Infinity)), 1e-12);
        near(length(found.direction()), 1.0, 1e-14);
        let found = outcome!(join(|t, b| point(p).join(b, t), point(q) ^ Infinity), Join::Line);
        near_vector(found.direction(), unit_of(minus(q, p)), 1e-12);
        check_is!(point(p), point(p), Join::Point, point(p));
        // A plane with a line, unless on it.
        prop_assume!(length(cross(minus(p, c), d)) > 0.05);
        check_product!(point(p), line(c, d), Join::Plane, 1e-10);
        check_is!(point(along(c, 2.0, d)), line(c, d), Join::Line, line(c, d));
        // A sphere with a circle, a plane inside its own.
        prop_assume!(dot(minus(p, c), n).abs() > 0.1);
        check_product!(point(p), circle(c, n, r), Join::Sphere, 1e-9);
        let inside = on_circle(c, n, 0.7 * r, r);
        check_is!(point(inside), circle(c, n, r), Join::Plane, plane(c, n));
        check_is!(point(on_circle(c, n, r, r)), circle(c, n, r), Join::Circle, circle(c, n, r));
        // Only surfaces that contain it have a join with it.
        check_case!(point(p), plane(c, n), Join::Space);
        check_is!(point(inside), plane(c, n), Join::Plane, plane(c, n));
        check_case!(point(c), sphere(c, r), Join::Space);
        check_is!(point(along(c, r, d)), sphere(c, r), Join::Sphere, sphere(c, r));
    }

    #[test]
    fn pairs(p in vector(3.0), q in vector(3.0), s in vector(3.0), t in vector(3.0), part in 0.2..0.8_f64) {
        let (u, v, w) = (minus(q, p), minus(s, p), minus(t, p));
        prop_assume!(length(u) > 0.3 && length(v) > 0.3 && length(w) > 0.3);
        let volume = dot(cross(u, v), w);
        prop_assume!(length(cross(u, v)) > 0.3 && length(cross(u, w)) > 0.3 && volume.abs() > 0.3);
        check_product!(pair(p, q), point(s), Join::Circle, 1e-9);
        check_product!(pair(p, q), pair(s, t), Join::Sphere, 1e-8);
        let between = along(p, part, u);
        check_is!(pair(p, q), point(between), Join::Line, line(p, u));
        check_is!(pair(p, q), point(q), Join::PointPair, pair(p, q));
        check_is!(pair(p, q), pair(q, p), Join::PointPair, pair(p, q));
        check_is!(pair(p, q), pair(between, along(p, 2.0, u)), Join::Line, line(p, u));
        check_is!(pair(p, q), pair(between, q), Join::Line, line(p, u));
        // Three distinct points, and four of one circle, are concyclic; four of a plane need not
        // be.
        let round = ga_runtime::cga3::Circle::through(point(p), point(q), point(s));
        check_is!(pair(p, q), pair(q, s), Join::Circle, round);
        let (c, n, r) = (round.centre().unwrap().coordinates(), round.unit_normal().unwrap(), round.radius().unwrap());
        prop_assume!(r < 10.0);
        let fourth = on_circle(c, n, r, part * 6.0);
        prop_assume!([p, q, s].iter().all(|&x| length(minus(x, fourth)) > 0.1));
        check_is!(pair(p, q), pair(s, fourth), Join::Circle, round);
        check_is!(pair(p, fourth), pair(q, s), Join::Circle, round);
        check_is!(pair(p, q), pair(s, c), Join::Plane, plane(p, n));
        // With a line.
        check_is!(pair(p, q), line(p, u), Join::Line, line(p, u));
        check_is!(pair(p, q), line(s, u), Join::Plane, plane(p, n));
        check_is!(pair(p, q), line(p, v), Join::Plane, plane(p, n));
        check_case!(pair(p, q), line(s, w), Join::Space);
        // With a circle.
        check_is!(pair(p, s), round, Join::Circle, round);
        check_is!(pair(p, c), round, Join::Plane, plane(p, n));
        let over = ga_runtime::cga3::Sphere::through(point(p), point(q), point(s), point(t));
        prop_assume!(over.radius().unwrap() < 10.0);
        check_is!(pair(p, t), round, Join::Sphere, over);
        check_is!(pair(t, over.centre().map(|z| along(z.coordinates(), over.radius().unwrap(), unit_of(minus(z.coordinates(), t)))).unwrap()), round, Join::Sphere, over);
        check_case!(pair(t, c), round, Join::Space);
        check_case!(pair(t, c), over, Join::Space);
        check_is!(pair(p, t), over, Join::Sphere, over);
    }

    #[test]
    fn lines_and_circles(x in vector(3.0), d in unit(), e in unit(), s in 0.3..3.0_f64, t in -2.0..2.0_f64, r in 0.3..3.0_f64) {
        prop_assume!(length(cross(d, e)) > 0.1);
        let n = unit_of(cross(d, e));
        check_is!(line(x, d), line(along(x, t, d), e), Join::Plane, plane(x, n));
        check_is!(line(x, d), line(along(x, s, e), d), Join::Plane, plane(x, n));
        check_is!(line(x, d), line(along(x, t, d), d), Join::Line, line(x, d));
        check_case!(line(x, d), line(along(x, s, n), e), Join::Space);
        check_is!(line(x, d), circle(along(x, t, e), n, r), Join::Plane, plane(x, n));
        check_case!(line(x, n), circle(along(x, t, e), n, r), Join::Space);
        check_is!(line(x, d), plane(x, n), Join::Plane, plane(x, n));
        check_case!(line(x, n), plane(x, n), Join::Space);
        check_case!(line(x, n), sphere(x, r), Join::Space);
        check_case!(plane(x, n), sphere(x, r), Join::Space);
        check_case!(plane(x, n), plane(x, d), Join::Space);
        check_is!(plane(x, n), plane(along(x, t, d), n), Join::Plane, plane(x, n));
        check_case!(sphere(x, r), sphere(x, 2.0 * r), Join::Space);
        check_is!(sphere(x, r), sphere(x, r), Join::Sphere, sphere(x, r));
        // Circles on one sphere: any two of its sections.
        let ball = sphere(x, r);
        let section = |n: Vector, part: f64| circle(along(x, part * r, n), n, r * (1.0 - part * part).sqrt());
        check_is!(section(d, 0.3), section(e, -0.2), Join::Sphere, ball);
        check_is!(section(d, 0.3), section(d, -0.6), Join::Sphere, ball);
        check_is!(section(d, 0.3), section(d, 0.3), Join::Circle, section(d, 0.3));
        check_is!(section(d, 0.3), ball, Join::Sphere, ball);
        check_case!(section(d, 0.3), section(e, -0.2) .reflect_in(point(along(x, 1.0, n))).unwrap(), Join::Space);
        check_is!(circle(x, n, r), circle(along(x, t, d), n, s), Join::Plane, plane(x, n));
        check_is!(circle(x, n, r), plane(x, n), Join::Plane, plane(x, n));
        check_case!(circle(x, n, r), plane(along(x, s, n), n), Join::Space);
        check_case!(circle(x, n, r), sphere(x, r + s), Join::Space);
    }
}

/// Where one contains the other, the join is the larger one with its orientation and weight 1.
#[test]
fn what_holds_the_other_comes_back() {
    let t = tolerance();
    let (l, e, s) = (
        line(O, [0.0, 0.0, -2.0]),
        plane(O, [0.0, -3.0, 0.0]),
        sphere(O, 2.0),
    );
    assert_eq!(
        point(Z).join(l, t),
        Some(Join::Line(line(O, [0.0, 0.0, -1.0])))
    );
    assert_eq!(l.join(e, t), Some(Join::Plane(plane(O, [0.0, -1.0, 0.0]))));
    assert_eq!(point([0.0, 2.0, 0.0]).join(s, t), Some(Join::Sphere(s)));
    // Of two equal primitives the join is the first.
    let back = line(O, [0.0, 0.0, 5.0]);
    assert_eq!(l.join(back, t), Some(Join::Line(line(O, [0.0, 0.0, -1.0]))));
    assert_eq!(back.join(l, t), Some(Join::Line(line(O, Z))));
}

/// A circle, sphere or pair no larger than the tolerance is treated as its centre.
#[test]
fn figures_within_the_tolerance_are_points() {
    let t = tolerance();
    assert_eq!(
        sphere(X, 0.0).join(sphere(X, 0.0), t),
        Some(Join::Point(point(X)))
    );
    assert_eq!(sphere(X, 0.0).join(point(O), t), point(X).join(point(O), t));
    assert_eq!(
        circle(X, Z, 0.0).join(line(O, Y), t),
        point(X).join(line(O, Y), t)
    );
    assert!(matches!(
        circle(X, Z, 0.0).join(circle(O, Z, 2.0), t),
        Some(Join::Plane(_))
    ));
    assert!(matches!(
        pair(X, [1.0 + 1e-10, 0.0, 0.0]).join(point(O), t),
        Some(Join::Line(_))
    ));
    assert!(matches!(
        circle(X, Z, 0.0).join(plane(O, Z), t),
        Some(Join::Plane(_))
    ));
}

#[test]
fn tolerances() {
    let loose = Tolerance::new(1e-3, 1e-3);
    for (off, is_less) in [(0.9e-3, true), (1.1e-3, false)] {
        let found = point(X).join(point([1.0, off, 0.0]), loose).unwrap();
        assert_eq!(matches!(found, Join::Point(_)), is_less);
        let found = point([3.0, off, 0.0]).join(line(O, X), loose).unwrap();
        assert_eq!(matches!(found, Join::Line(_)), is_less);
        let found = point([3.0, off, 0.0]).join(pair(O, X), loose).unwrap();
        assert_eq!(matches!(found, Join::Line(_)), is_less);
        let found = point([0.5, 0.0, off])
            .join(circle(O, Z, 1.0), loose)
            .unwrap();
        assert_eq!(matches!(found, Join::Plane(_)), is_less);
        let found = line(O, X).join(line([0.0, 0.0, off], Y), loose).unwrap();
        assert_eq!(matches!(found, Join::Plane(_)), is_less);
        let found = circle(O, Z, 1.0)
            .join(circle([0.5, 0.0, off], Z, 1.0), loose)
            .unwrap();
        assert_eq!(matches!(found, Join::Plane(_)), is_less);
        let found = circle(O, Z, 1.0)
            .join(circle([1.12 * off, 0.0, 1.0], Z, 1.0), loose)
            .unwrap();
        assert_eq!(matches!(found, Join::Sphere(_)), is_less);
    }
}

/// The join of lines whose distance is within the tolerance is the plane midway between them.
#[test]
fn lines_that_all_but_cross() {
    let loose = Tolerance::new(0.1, 1e-3);
    let found = line(O, X).join(line([0.0, 0.0, 0.08], Y), loose).unwrap();
    let midway = outcome!(found, Join::Plane);
    assert!(midway.coincides_with(plane([0.0, 0.0, 0.04], Z), tolerance()));
}

#[test]
fn bad_input() {
    let t = tolerance();
    let o = point(O);
    let nothing = |p: Point<f64>| {
        assert_eq!(
            (p.join(o, t), o.join(p, t), p.join(line(O, X), t)),
            (None, None, None)
        );
        assert_eq!(
            (circle(O, X, 1.0).join(p, t), plane(O, X).join(p, t)),
            (None, None)
        );
    };
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        nothing(point([0.0, bad, 0.0]));
        assert_eq!(
            (
                o.join(line(O, [bad, 0.0, 0.0]), t),
                o.join(plane(O, [bad, 0.0, 0.0]), t)
            ),
            (None, None)
        );
        assert_eq!(
            (
                o.join(sphere(O, bad), t),
                sphere(O, bad).join(sphere(O, bad), t)
            ),
            (None, None)
        );
    }
    // Weight zero and imaginary.
    assert_eq!(
        (o.join(line(O, O), t), o.join(plane(O, O), t)),
        (None, None)
    );
    assert_eq!(
        (
            o.join(sphere_of_square(O, -1.0), t),
            o.join(circle_of_square(O, X, -1.0), t)
        ),
        (None, None)
    );
    assert_eq!(o.join(point(X) ^ point(X), t), None);
    // Beyond the range of the scalar.
    assert_eq!(point([1e200, 0.0, 0.0]).join(circle(O, X, 1.0), t), None);
    // With a negative tolerance a point does not even lie on itself.
    let none = Tolerance::new(f64::NAN, f64::NAN);
    assert_eq!(o.join(o, none), None);
    assert!(matches!(o.join(point(X), none), Some(Join::Line(_))));
}

#[test]
fn single_precision() {
    let t = Tolerance::for_size(10.0_f32);
    let [p, q] = [[1.0_f32, 2.0, 3.0], [4.0, 6.0, 3.0]].map(Point::from);
    let Some(Join::Line(line)) = p.join(q, t) else {
        panic!()
    };
    near_vector(line.direction().map(f64::from), [0.6, 0.8, 0.0], 1e-6);
    let Some(Join::Plane(plane)) = line.join(Point::new(0.0_f32, 0.0, 3.0), t) else {
        panic!()
    };
    near_vector(
        plane.unit_normal().unwrap().map(|x| f64::from(x.abs())),
        Z,
        1e-6,
    );
}

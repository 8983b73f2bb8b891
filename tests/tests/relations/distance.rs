//! Distances between primitives against plain formulas and dense sampling.

use ga_runtime::cga3::{Circle, Direction, Line, Plane, Point, RoundVector};
use ga_runtime::geometry::relation::Tolerance;
use nullcone_tests::plain::*;
use proptest::prelude::*;

/// Asserts a distance in both orders.
macro_rules! check {
    ($a:expr, $b:expr, $expected:expr, $bound:expr) => {{
        let (a, b, expected, bound) = ($a, $b, $expected, $bound);
        near(a.distance_to(b).expect("a distance"), expected, bound);
        near(b.distance_to(a).expect("a distance"), expected, bound);
    }};
}

macro_rules! check_signed {
    ($a:expr, $b:expr, $expected:expr, $bound:expr) => {{
        let (a, b, expected, bound) = ($a, $b, $expected, $bound);
        near(
            a.signed_distance_to(b).expect("a distance"),
            expected,
            bound,
        );
        near(
            b.signed_distance_to(a).expect("a distance"),
            expected,
            bound,
        );
    }};
}

fn place(p: Option<Point<f64>>) -> Vector {
    p.expect("a point").coordinates()
}

fn point_line(p: Vector, q: Vector, d: Vector) -> f64 {
    length(cross(minus(p, q), d)) / length(d)
}

fn point_circle(p: Vector, c: Vector, n: Vector, r: f64) -> f64 {
    let from = minus(p, c);
    let height = dot(from, n);
    (length(along(from, -height, n)) - r).hypot(height)
}

proptest! {
    #[test]
    fn points(p in vector(5.0), q in vector(5.0), d in unit(), n in unit(), r in 0.1..4.0_f64, weight in 0.1..9.0_f64) {
        let x = point(p);
        check!(x, point(q), length(minus(p, q)), 1e-14);
        check!(x, x ^ ga_runtime::cga3::Infinity, 0.0, 0.0);
        check!(x, line(q, d.map(|x| x * weight)), point_line(p, q, d), 1e-13);
        let height = dot(minus(p, q), n);
        check!(x, plane(q, n.map(|x| -x * weight)), height.abs(), 1e-13);
        check_signed!(x, plane(q, n.map(|x| x * weight)), height, 1e-13);
        check!(x, sphere(q, r) * -weight, (length(minus(p, q)) - r).abs(), 5e-12);
        check_signed!(x, sphere(q, r) * -weight, length(minus(p, q)) - r, 5e-12);
        check!(x, circle(q, n, r + 0.1), point_circle(p, q, n, r + 0.1), 5e-12);
        let pair = pair(q, along(q, r + 0.1, d));
        let nearer = length(minus(p, q)).min(length(minus(p, along(q, r + 0.1, d))));
        check!(x, pair, nearer, 1e-11);
    }

    #[test]
    fn lines(p in vector(5.0), d in unit(), q in vector(5.0), e in unit(), n in unit(), r in 0.1..4.0_f64) {
        let l = line(p, d);
        // The volume of the parallelepiped divided by its base.
        let normal = cross(d, e);
        prop_assume!(length(normal) > 1e-3);
        check!(l, line(q, e), dot(minus(q, p), normal).abs() / length(normal), 1e-11);
        check!(l, line(q, d.map(|x| -x)), point_line(q, p, d), 1e-13);
        prop_assume!(dot(d, n).abs() > 1e-3 && length(cross(d, n)) > 0.1);
        check!(l, plane(q, n), 0.0, 0.0);
        let flat = cross(d, n);
        check!(line(p, flat), plane(q, n), dot(minus(p, q), n).abs(), 5e-12);
        check_signed!(line(p, unit_of(flat)), plane(q, n), dot(minus(p, q), n), 5e-12);
        let from_centre = point_line(q, p, d);
        check!(l, sphere(q, r), (from_centre - r).max(0.0), 5e-12);
        check_signed!(l, sphere(q, r), from_centre - r, 5e-12);
    }

    #[test]
    fn planes_and_spheres(p in vector(5.0), q in vector(5.0), n in unit(), m in unit(), r in 0.1..4.0_f64, s in 0.1..4.0_f64) {
        let height = dot(minus(q, p), n);
        check!(plane(p, n), plane(q, n.map(|x| -2.0 * x)), height.abs(), 1e-13);
        near(plane(p, n).signed_distance_to(plane(q, n.map(|x| -2.0 * x))).unwrap(), height, 1e-13);
        prop_assume!(length(cross(n, m)) > 1e-3);
        check!(plane(p, n), plane(q, m), 0.0, 0.0);
        check!(plane(p, n), sphere(q, r), (height.abs() - r).max(0.0), 5e-12);
        check_signed!(plane(p, n), sphere(q, r), height.abs() - r, 5e-12);
        // The circle rises above its centre by its radius times the sine of the angle between the
        // planes.
        let reach = s * (1.0 - dot(n, m).powi(2)).sqrt();
        let c = circle(q, m, s + 0.01);
        check!(plane(p, n), c, (height.abs() - reach * (s + 0.01) / s).max(0.0), 1e-11);
        let d = length(minus(p, q));
        let gap = (d - r - s).max((r - s).abs() - d).max(0.0);
        check!(sphere(p, r), sphere(q, s), gap, 5e-12);
        check_signed!(sphere(p, r), sphere(q, s), d - r - s, 5e-12);
        // The distance of every point of the circle from the sphere.
        let sampled = least_by_sampling(200, |t| (length(minus(on_circle(q, m, s + 0.01, t), p)) - r).abs());
        check!(sphere(p, r), c, sampled, 1e-7);
        let signed = least_by_sampling(200, |t| length(minus(on_circle(q, m, s + 0.01, t), p)) - r);
        check_signed!(sphere(p, r), c, signed, 1e-11);
    }

    #[test]
    fn circles_and_lines(p in vector(3.0), d in unit(), c in vector(3.0), n in unit(), r in 0.05..4.0_f64) {
        let sampled = least_by_sampling(720, |t| point_line(on_circle(c, n, r, t), p, d));
        check!(line(p, d), circle(c, n, r), sampled, 2e-11);
    }

    #[test]
    fn circles(c in vector(3.0), n in unit(), r in 0.02..4.0_f64, d in vector(3.0), m in unit(), s in 0.02..4.0_f64) {
        // Sampled along the smaller circle, on which no minimum is missed.
        let sampled = if r < s {
            least_by_sampling(720, |t| point_circle(on_circle(c, n, r, t), d, m, s))
        } else {
            least_by_sampling(720, |t| point_circle(on_circle(d, m, s, t), c, n, r))
        };
        check!(circle(c, n, r), circle(d, m, s), sampled, 2e-11);
    }

    /// Two circles through one point meet there, whether they cross or touch.
    #[test]
    fn circles_that_meet(x in vector(3.0), n in unit(), m in unit(), t in unit(), r in 0.1..4.0_f64, s in 0.1..4.0_f64) {
        let centre = |n: Vector, r: f64| along(x, r, unit_of(cross(n, t)));
        prop_assume!(length(cross(n, t)) > 0.05 && length(cross(m, t)) > 0.05);
        check!(circle(centre(n, r), n, r), circle(centre(m, s), m, s), 0.0, 2e-12);
        check!(line(x, m), circle(centre(n, r), n, r), 0.0, 2e-12);
        // Touching: one tangent for both, or for the line.
        let tangent = cross(n, unit_of(cross(n, t)));
        check!(line(x, tangent), circle(centre(n, r), n, r), 0.0, 2e-12);
        let other = unit_of(cross(tangent, m));
        prop_assume!(length(cross(tangent, m)) > 0.05);
        let touching = circle(along(x, s, other), cross(tangent, other), s);
        check!(circle(centre(n, r), n, r), touching, 0.0, 2e-12);
    }

    /// Circles that almost touch have two minima of nearly equal depth; circles with nearly the
    /// same axis have nearly the same distance everywhere. The smallest minimum is found, and no
    /// smaller value.
    #[test]
    fn circles_that_all_but_touch(n in unit(), m in unit(), t in unit(), s in 0.3..1.5_f64, digits in 0.0..12.0_f64, more in 0.0..12.0_f64) {
        prop_assume!(length(cross(n, t)) > 0.05 && length(cross(m, t)) > 0.05);
        let [tilt, off] = [digits, more].map(|digits| 10.0_f64.powf(-digits));
        let (a, b) = (unit_of(cross(n, t)), unit_of(cross(m, t)));
        let (n, m) = (cross(a, t), cross(b, t));
        let touching = (a, unit_of(n), along(b.map(|x| s * x), off, m), unit_of(m));
        let one_axis = (O, a, b.map(|x| off * x), unit_of(along(a, tilt, b)));
        for (c, n, d, m) in [touching, one_axis] {
            let (first, second) = (circle(c, n, 1.0), circle(d, m, s));
            // The circles as stored.
            let read = |c: Circle<f64>| (place(c.centre()), c.unit_normal().unwrap(), c.radius().unwrap());
            let ((c, n, r), (d, m, s)) = (read(first), read(second));
            let sampled = least_by_sampling(720, |t| point_circle(on_circle(d, m, s, t), c, n, r));
            let found = first.distance_to(second).unwrap();
            prop_assert!(found <= sampled + 4e-15, "{found:e} is above {sampled:e}");
            // Sampling finds one of the two minima, which differ by the fourth power of their
            // distance.
            prop_assert!(found >= sampled - 1e-4 * off.max(1e-12) - 4e-15, "{found:e} is below {sampled:e}");
        }
    }

    #[test]
    fn common_perpendiculars(p in vector(5.0), d in unit(), q in vector(5.0), e in unit()) {
        prop_assume!(length(cross(d, e)) > 1e-2);
        let (l, k) = (line(p, d), line(q, e.map(|x| 3.0 * x)));
        let found = l.common_perpendicular(k, tolerance()).unwrap();
        let [a, b] = found.feet.map(Point::coordinates);
        near(point_line(a, p, d), 0.0, 1e-10);
        near(point_line(b, q, e), 0.0, 1e-10);
        let way = minus(b, a);
        near(dot(way, d), 0.0, 1e-10);
        near(dot(way, e), 0.0, 1e-10);
        near(found.distance, length(way), 1e-10);
        near(found.distance, l.distance_to(k).unwrap(), 1e-11);
        near_vector(found.line.direction(), unit_of(cross(d, e)), 1e-12);
        near(found.line.distance(found.feet[0]).unwrap(), 0.0, 1e-11);
        near(found.line.distance(found.feet[1]).unwrap(), 0.0, 1e-10);
        // The axis of the motor of both dual lines: its direction is that of their commutator.
        let (l, k) = (dense(&l.dual()), dense(&k.dual()));
        let axis = (&(&l * &k) - &(&k * &l)).scale(0.5);
        let turn = cross(d, e);
        // The coefficients of e12, e13 and e23 give the axis of rotation, up to the sign of the
        // dual.
        let found = [axis.coefficient(0b110), -axis.coefficient(0b101), axis.coefficient(0b011)];
        near(length(cross(unit_of(found), unit_of(turn))), 0.0, 1e-12);
    }
}

#[test]
fn pairs_count_as_their_points() {
    let ends = pair([0.0, 0.0, 2.0], [0.0, 0.0, -1.0]);
    check!(ends, pair([3.0, 0.0, 2.0], [0.0, 9.0, 0.0]), 3.0, 1e-14);
    check!(ends, line([0.0, 4.0, 0.0], X), 17.0_f64.sqrt(), 1e-14);
    // The plane passes between the two.
    check!(ends, plane(O, Z), 1.0, 1e-14);
    check_signed!(ends, plane(O, Z), 0.0, 0.0);
    check_signed!(ends, plane([0.0, 0.0, 3.0], Z), -1.0, 1e-14);
    check!(ends, sphere(O, 1.5), 0.5, 1e-14);
    check_signed!(ends, sphere(O, 1.5), -0.5, 1e-14);
    check!(ends, circle(O, Z, 1.0), 2.0_f64.sqrt(), 1e-14);
    // Two equal points are one point; an imaginary pair has no points.
    let p = point(X);
    let tangent = RoundVector::from(p) ^ RoundVector::new(0.0, 1.0, 0.0, 0.0, 0.0);
    check!(tangent, point(O), 1.0, 1e-15);
    let imaginary =
        RoundVector::new(0.0, 0.0, 0.0, 1.0, -0.5) ^ RoundVector::new(1.0, 0.0, 0.0, 0.0, 0.0);
    assert_eq!(imaginary.distance_to(p), None);
}

#[test]
fn zero_radius_is_a_point() {
    let p = [1.0, 2.0, 3.0];
    check!(sphere(p, 0.0), point(O), 14.0_f64.sqrt(), 1e-14);
    check!(sphere(p, 0.0), sphere(p, 0.0), 0.0, 0.0);
    check!(
        sphere(p, 0.0),
        circle(O, Z, 1.0),
        point_circle(p, O, Z, 1.0),
        1e-14
    );
    check!(circle(p, Z, 0.0), point(O), 14.0_f64.sqrt(), 1e-14);
    check!(circle(p, Z, 0.0), circle(p, X, 0.0), 0.0, 1e-15);
    check!(circle(p, Z, 0.0), line(O, X), 13.0_f64.sqrt(), 1e-14);
    check!(
        circle(p, Z, 0.0),
        circle(O, X, 2.0),
        point_circle(p, O, X, 2.0),
        1e-14
    );
}

#[test]
fn zero_weight_is_flat() {
    // Sums of weight zero are flats: a sphere is a plane, a circle a line, a pair its finite point.
    let flat = RoundVector::new(0.0, 0.0, 2.0, 0.0, 6.0).undual();
    check!(flat, point(O), 3.0, 1e-15);
    let [a, b, c] = [0.0, 1.0, 3.0].map(|x| RoundVector::from(point([x, 2.0, 0.0])));
    check!(a ^ b ^ c, point(O), 2.0, 1e-15);
    assert_eq!(Circle::try_from(a ^ b ^ c).ok(), None);
    let end = a ^ RoundVector::new(0.0, 0.0, 0.0, 0.0, 1.0);
    check!(end, point(O), 2.0, 1e-15);
    // Flats of weight zero are not figures.
    let p = point(O);
    assert_eq!(p.distance_to(line(X, O)), None);
    assert_eq!(p.distance_to(plane(X, O)), None);
    assert_eq!(p.distance_to(Plane::new(1.0, 0.0, 0.0, 0.0)), None);
    assert_eq!(p.distance_to(Line::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0)), None);
    assert_eq!(p.distance_to(sphere(O, 1.0) * 0.0), None);
    assert_eq!(line(X, O).signed_distance_to(p), None);
}

#[test]
fn imaginary_rounds_have_no_distance() {
    assert_eq!(point(O).distance_to(sphere_of_square(O, -1.0)), None);
    assert_eq!(
        point(O).signed_distance_to(circle_of_square(O, Z, -1.0)),
        None
    );
}

#[test]
fn lines_that_are_nearly_parallel() {
    // Too close to parallel: the distance is that of a point.
    check!(
        line(O, X),
        line([0.0, 3.0, 4.0], [1.0, 1e-17, 0.0]),
        5.0,
        1e-15
    );
    // Clearly not parallel: far away they approach each other up to the height.
    check!(
        line(O, X),
        line([0.0, 3.0, 4.0], [1.0, 1e-12, 0.0]),
        4.0,
        1e-3
    );
    check!(line(O, X), line(O, X), 0.0, 0.0);
    check!(
        line(O, X),
        line([9.0, 0.0, 0.0], [-4.0, 0.0, 0.0]),
        0.0,
        0.0
    );
}

#[test]
fn common_perpendiculars_that_are_special() {
    let x = line(O, X);
    // Crossing lines: both feet are the intersection.
    let crossing = x
        .common_perpendicular(line([2.0, 0.0, 0.0], Y), tolerance())
        .unwrap();
    assert_eq!(
        (crossing.distance, crossing.feet),
        (0.0, [point([2.0, 0.0, 0.0]); 2])
    );
    assert_eq!(crossing.line.direction(), Z);
    assert!(!crossing.is_parallel);
    // Parallel lines: from the first one's point nearest to the origin.
    let parallel = line([5.0, 1.0, 1.0], X)
        .common_perpendicular(line([7.0, 4.0, 5.0], [-2.0, 0.0, 0.0]), tolerance());
    let parallel = parallel.unwrap();
    assert!(parallel.is_parallel);
    assert_eq!(parallel.distance, 5.0);
    assert_eq!(
        parallel.feet,
        [point([0.0, 1.0, 1.0]), point([0.0, 4.0, 5.0])]
    );
    near_vector(parallel.line.direction(), [0.0, 0.6, 0.8], 1e-15);
    // A line and itself have no unique perpendicular.
    assert_eq!(
        x.common_perpendicular(line(X, [-1.0, 0.0, 0.0]), tolerance()),
        None
    );
    assert_eq!(x.common_perpendicular(line(O, O), tolerance()), None);
    assert_eq!(
        x.common_perpendicular(line([f64::NAN, 0.0, 0.0], Y), tolerance()),
        None
    );
    assert_eq!(
        x.common_perpendicular(line([f64::INFINITY, 0.0, 0.0], Y), tolerance()),
        None
    );
}

/// Circles with the same axis have the same distance everywhere.
#[test]
fn circles_with_one_axis() {
    check!(
        circle(O, Z, 2.0),
        circle([0.0, 0.0, 3.0], Z, 6.0),
        5.0,
        1e-14
    );
    check!(circle(O, Z, 2.0), circle(O, Z, 6.0), 4.0, 1e-14);
    check!(circle(O, Z, 2.0), circle(O, Z, 2.0), 0.0, 1e-15);
    check!(circle(O, Z, 2.0), line(O, Z), 2.0, 1e-14);
    // Linked circles, each crossing the plane of the other.
    check!(
        circle(O, Z, 2.0),
        circle([2.0, 0.0, 0.0], Y, 1.0),
        1.0,
        1e-14
    );
    // Through the axis and back: two minima of the same depth.
    check!(circle(O, Z, 2.0), circle(O, Y, 1.0), 1.0, 1e-14);
    check!(circle(O, Z, 2.0), line([0.0, 0.0, 1.0], X), 1.0, 1e-14);
}

/// Circles of very different size, and circles that are all very large or very small.
#[test]
fn sizes_far_apart() {
    let mut worst = 0.0_f64;
    for k in 0..200 {
        let t = f64::from(k);
        let n = unit_of([(t * 0.7).sin(), (t * 1.3).cos(), 0.3]);
        let centre = on_circle(
            [0.5, 0.0, 0.1],
            unit_of([0.2, 0.1, 1.0]),
            1000.0 + (t * 0.37).sin(),
            t,
        );
        let small = circle(centre, n, 0.01);
        let large = circle([0.5, 0.0, 0.1], unit_of([0.2, 0.1, 1.0]), 1000.0);
        let sampled = least_by_sampling(720, |t| {
            point_circle(
                on_circle(centre, n, 0.01, t),
                [0.5, 0.0, 0.1],
                unit_of([0.2, 0.1, 1.0]),
                1000.0,
            )
        });
        worst = worst.max((small.distance_to(large).unwrap() - sampled).abs());
        worst = worst.max((large.distance_to(small).unwrap() - sampled).abs());
    }
    // The circles keep their radii as differences of squares of about 10⁶.
    assert!(worst < 1e-6, "{worst}");
    for scale in [1e-60, 1e60] {
        let [a, b] = [[0.0, 0.0, 3.0], [4.0, 1.0, 0.0]].map(|v: Vector| v.map(|x| x * scale));
        let sampled = least_by_sampling(720, |t| {
            point_circle(
                on_circle([0.0, 0.0, 3.0], X, 1.0, t),
                [4.0, 1.0, 0.0],
                Z,
                2.0,
            )
        });
        let found = circle(a, X, scale)
            .distance_to(circle(b, Z, 2.0 * scale))
            .unwrap();
        near(found / scale, sampled, 1e-12);
    }
}

#[test]
fn single_precision() {
    let ring =
        Circle::from_centre_normal_radius(Point::new(0.0_f32, 0.0, 0.0), [0.0, 0.0, 1.0], 2.0)
            .unwrap();
    let other =
        Circle::from_centre_normal_radius(Point::new(0.5_f32, 3.0, 1.0), [0.6, 0.0, 0.8], 1.0)
            .unwrap();
    let sampled = least_by_sampling(720, |t| {
        point_circle(
            on_circle([0.5, 3.0, 1.0], [0.6, 0.0, 0.8], 1.0, t),
            O,
            Z,
            2.0,
        )
    });
    near(f64::from(ring.distance_to(other).unwrap()), sampled, 2e-6);
    let line = Line::from_point_direction(Point::new(3.0_f32, 0.0, 1.0), [0.0, 1.0, 0.0]);
    near(
        f64::from(ring.distance_to(line).unwrap()),
        2.0_f64.sqrt(),
        2e-6,
    );
}

#[test]
fn bad_input() {
    let all = |p: Point<f64>| {
        [
            p.distance_to(point(Y)),
            p.distance_to(line(Y, X)),
            p.distance_to(plane(Y, Z)),
            p.distance_to(sphere(Y, 2.0)),
            p.distance_to(circle(Y, Z, 2.0)),
            p.distance_to(pair(Y, X)),
            p.signed_distance_to(plane(Y, Z)),
            p.signed_distance_to(sphere(Y, 2.0)),
        ]
    };
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(all(point([bad, 0.0, 0.0])), [None; 8]);
        let good = point(O);
        assert_eq!(good.distance_to(line([0.0, bad, 0.0], X)), None);
        assert_eq!(good.distance_to(line(O, [1.0, bad, 0.0])), None);
        assert_eq!(good.distance_to(plane(O, [bad, 0.0, 1.0])), None);
        assert_eq!(good.distance_to(sphere([bad, 0.0, 0.0], 1.0)), None);
        assert_eq!(good.distance_to(sphere(O, bad)), None);
        assert_eq!(sphere(O, bad).signed_distance_to(sphere(O, 1.0)), None);
        assert_eq!(
            circle(O, Z, 1.0).distance_to(pair([bad, 0.0, 0.0], X)),
            None
        );
        let circle = Circle::new(Point::ORIGIN, Direction::new(bad, 0.0, 1.0), 1.0);
        assert_eq!(
            (circle.distance_to(circle), good.distance_to(circle)),
            (None, None)
        );
        assert!(!good.is_on(circle, Tolerance::new(1e300, 1.0)));
    }
    // Beyond the range of the scalar.
    let far = point([1e308, 1e308, 1e308]);
    assert_eq!(far.distance_to(point([-1e308, -1e308, -1e308])), None);
}

//! Lines on circles and circles on planes: what is projected, against the projection of points.

use ga_runtime::cga3::{Circle, Line, Plane, Point};
use ga_runtime::geometry::relation::projection::{CircleOnPlane, LineOnCircle};
use nullcone_tests::plain::*;
use proptest::prelude::*;

proptest! {
    #[test]
    fn circles_have_ellipses_as_shadows(
        c in vector(3.0), n in unit(), m in unit(), p in vector(3.0), r in 0.3..3.0_f64, angle in -3.0..3.0_f64,
    ) {
        prop_assume!(length(cross(n, m)) > 1e-3 && dot(n, m).abs() > 1e-3);
        let ground = plane(p, m);
        let Some(CircleOnPlane::Ellipse { centre, major, minor }) = circle(c, n, r).project_onto(ground) else {
            panic!();
        };
        let [u, v] = [major, minor].map(|axis| axis.vector());
        near_vector(centre.coordinates(), minus(c, times(m, dot(minus(c, p), m))), 1e-12);
        near_all([length(u), length(v)], [r, r * dot(n, m).abs()], 1e-11);
        near_all([dot(u, v), dot(u, m), dot(v, m), dot(u, n)], [0.0; 4], 1e-11);
        // The foot of a point of the circle satisfies the equation of the ellipse.
        let x = on_circle(c, n, r, angle);
        let foot = minus(minus(x, times(m, dot(minus(x, p), m))), centre.coordinates());
        let (a, b) = (dot(foot, u) / (r * r), dot(foot, v) / dot(v, v));
        near(a * a + b * b, 1.0, 1e-6);
        near_vector(foot, plus(times(u, a), times(v, b)), 1e-9);
        // It runs as the circle does: the area swept is positive about the normal of the plane
        // where the circle's is.
        let turn = dot(cross(u, v), m);
        near(turn, r * r * dot(n, m), 1e-10);
    }

    #[test]
    fn level_and_upright_circles(c in vector(3.0), n in unit(), p in vector(3.0), r in 0.3..3.0_f64) {
        let above = minus(c, times(n, dot(minus(c, p), n)));
        for sign in [1.0, -1.0] {
            let found = circle(c, times(n, sign), r).project_onto(plane(p, n));
            let Some(CircleOnPlane::Circle(shadow)) = found else { panic!("{found:?}") };
            near_vector(shadow.centre().unwrap().coordinates(), above, 1e-10);
            near(shadow.radius().unwrap(), r, 1e-9);
            near_vector(shadow.unit_normal().unwrap(), times(n, sign), 1e-9);
        }
        let [u, v] = frame(n);
        // Exactly perpendicular only within rounding.
        let found = circle([0.0, 0.0, 1.0], X, r).project_onto(plane(p, Z));
        let Some(CircleOnPlane::Segment(pair)) = found else { panic!("{found:?}") };
        let ends = pair.endpoints().unwrap().map(Point::coordinates);
        near_all([ends[0][0], ends[0][2], ends[1][0], ends[1][2]], [0.0, p[2], 0.0, p[2]], 1e-12);
        near((ends[0][1] - ends[1][1]).abs(), 2.0 * r, 1e-12);
        prop_assert!(dot(u, v).abs() < 1e-12);
    }

    #[test]
    fn the_points_of_a_line_are_nearest_to_half_a_circle(
        p in vector(3.0), d in unit(), c in vector(3.0), n in unit(), r in 0.3..3.0_f64, t in -50.0..50.0_f64,
    ) {
        let (l, ring) = (line(p, d), circle(c, n, r));
        let Some(LineOnCircle::HalfCircle { start, middle, end }) = l.project_onto(ring) else {
            panic!();
        };
        let [start, middle, end] = [start, middle, end].map(|x| minus(x.coordinates(), c));
        near_all([length(start), length(middle), length(end)], [r; 3], 1e-9);
        near_all([dot(start, n), dot(middle, n), dot(middle, end)], [0.0; 3], 1e-7);
        near_vector(start, times(end, -1.0), 1e-9);
        // A point of the line falls on the half of the middle, and far ones near the ends.
        let at = |t: f64| {
            let nearest = point(along(p, t, d)).project_onto(ring).unwrap();
            minus(nearest.coordinates(), c)
        };
        prop_assert!(dot(at(t), middle) > 0.0);
        prop_assume!(length(cross(d, n)) > 0.1);
        near_vector(at(1e9), end, 1e-6);
        near_vector(at(-1e9), start, 1e-6);
        prop_assert!(dot(at(t + 0.1), end) > dot(at(t), end));
        prop_assert_eq!(l.project_onto(ring.dual()), l.project_onto(ring));
        prop_assert_eq!(l.project_onto(plane(c, n).dual()), l.project_onto(plane(c, n)));
    }
}

#[test]
fn lines_that_cross_the_axis_or_are_parallel_to_it() {
    let ring = circle([1.0, 2.0, 3.0], Z, 2.0);
    let on = |x: f64, y: f64, z: f64, d: Vector| line([x, y, z], d).project_onto(ring);
    let Some(LineOnCircle::Points(pair)) = on(1.0, 2.0, 9.0, [3.0, 0.0, 1.0]) else {
        panic!();
    };
    let ends = pair.endpoints().unwrap().map(Point::coordinates);
    near_vector(ends[0], [-1.0, 2.0, 3.0], 1e-14);
    near_vector(ends[1], [3.0, 2.0, 3.0], 1e-14);
    let upright = on(1.0, 7.0, 0.0, Z);
    assert_eq!(
        upright,
        Some(LineOnCircle::Point(Point::new(1.0, 4.0, 3.0)))
    );
    // The axis, a circle of radius zero, and what is not a figure.
    assert_eq!(on(1.0, 2.0, 0.0, Z), None);
    assert_eq!(line(O, X).project_onto(circle(O, Z, 0.0)), None);
    assert_eq!(line(O, X).project_onto(circle_of_square(O, Z, -1.0)), None);
    assert_eq!(Line::<f64>::default().project_onto(ring), None);
    assert_eq!(ring.project_onto(Plane::default()), None);
    assert_eq!(Circle::default().project_onto(plane(O, Z)), None);
    assert_eq!(circle_of_square(O, Z, -1.0).project_onto(plane(O, Z)), None);
}

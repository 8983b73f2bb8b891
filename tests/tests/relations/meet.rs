//! Meets of lines, planes, spheres and circles: each case by plain formulas, its blade and
//! orientation by the vee product of the dense algebra.

use ga_runtime::cga3::{Point, PointPair};
use ga_runtime::geometry::relation::Meet;
use ga_runtime::geometry::relation::meet::{
    CircleAndCircle, LineAndCircle, LineAndLine, LineAndPlane, LineAndSphere, PlaneAndCircle,
    PlaneAndPlane, PlaneAndSphere, SphereAndCircle, SphereAndSphere,
};
use nullcone_tests::oracle;
use nullcone_tests::plain::*;
use proptest::prelude::*;

fn meet<A: Meet<B, Scalar = f64>, B>(a: A, b: B) -> A::Outcome {
    a.meet(b, tolerance()).expect("an outcome")
}

fn place(p: Point<f64>) -> Vector {
    p.coordinates()
}

fn ends(pair: PointPair<f64>) -> [Vector; 2] {
    pair.endpoints().expect("a real pair").map(place)
}

/// Half the chord of a sphere or circle at this distance from its centre.
fn leg(r: f64, distance: f64) -> f64 {
    (r * r - distance * distance).sqrt()
}

macro_rules! outcome {
    ($found:expr, $case:path) => {
        match $found {
            $case(inner) => inner,
            other => panic!("{other:?}"),
        }
    };
}

proptest! {
    #[test]
    fn lines(x in vector(5.0), d in unit(), e in unit(), s in -3.0..3.0_f64, t in -3.0..3.0_f64, gap in 0.01..3.0_f64) {
        prop_assume!(length(cross(d, e)) > 0.05);
        let (l, k) = (line(along(x, s, d), d), line(along(x, t, e), e.map(|x| -2.0 * x)));
        near_vector(place(outcome!(meet(l, k), LineAndLine::Point)), x, 1e-11);
        let normal = unit_of(cross(d, e));
        let skew = outcome!(meet(l, line(along(x, gap, normal), e)), LineAndLine::Skew);
        near(skew.distance, gap, 1e-11);
        near_vector(place(skew.feet[0]), x, 1e-10);
        near_vector(place(skew.feet[1]), along(x, gap, normal), 1e-10);
        match meet(l, line(along(x, gap, normal), d.map(|x| -x))) {
            LineAndLine::Parallel { direction, distance } => {
                near_vector(direction.vector(), d, 1e-15);
                near(distance, gap, 1e-12);
            }
            other => panic!("{other:?}"),
        }
        prop_assert_eq!(meet(l, line(along(x, t, d), d.map(|x| -3.0 * x))), LineAndLine::Coincident(l));
    }

    #[test]
    fn lines_and_planes(x in vector(5.0), d in unit(), n in unit(), t in -3.0..3.0_f64, height in 0.01..3.0_f64) {
        prop_assume!(dot(d, n).abs() > 0.05 && dot(d, n).abs() < 0.99);
        let (l, e) = (line(along(x, t, d), d), plane(x, n.map(|x| 2.0 * x)));
        near_vector(place(outcome!(meet(l, e), LineAndPlane::Point)), x, 1e-11);
        prop_assert_eq!(meet(l, e), meet(e, l));
        let flat = unit_of(cross(d, n));
        match meet(line(along(x, -height, n), flat), e) {
            LineAndPlane::Parallel { direction, distance } => {
                near_vector(direction.vector(), flat, 1e-14);
                near(distance, -height, 1e-12);
            }
            other => panic!("{other:?}"),
        }
        let within = line(along(x, t, flat), flat);
        prop_assert_eq!(meet(within, e), LineAndPlane::Contained(within));
    }

    #[test]
    fn planes(x in vector(5.0), n in unit(), m in unit(), t in -3.0..3.0_f64, height in 0.01..3.0_f64) {
        prop_assume!(length(cross(n, m)) > 0.05);
        let (a, b) = (plane(x, n), plane(x, m.map(|x| 3.0 * x)));
        let found = outcome!(meet(a, b), PlaneAndPlane::Line);
        positive_multiple(&dense(&found), &dense(&a).vee(&dense(&b)), 1e-11);
        near(found.distance(point(x)).unwrap(), 0.0, 1e-11);
        near(length(found.direction()), 1.0, 1e-14);
        let [u, _] = frame(n);
        match meet(a, plane(along(along(x, t, u), height, n), n.map(|x| -x))) {
            PlaneAndPlane::Parallel { attitude, distance } => {
                near_vector(attitude.normal(), n, 1e-15);
                near(distance, height, 1e-12);
            }
            other => panic!("{other:?}"),
        }
        prop_assert_eq!(meet(a, plane(along(x, t, u), n.map(|x| -x))), PlaneAndPlane::Coincident(a));
    }

    #[test]
    fn lines_and_spheres(c in vector(3.0), d in unit(), r in 0.2..4.0_f64, part in 0.02..0.98_f64, t in -3.0..3.0_f64) {
        let [u, _] = frame(d);
        let s = sphere(c, r) * 2.0;
        let at = |part: f64| line(along(along(c, part * r, u), t, d), d);
        let found = outcome!(meet(at(part), s), LineAndSphere::Points);
        let half = leg(r, part * r);
        let [p, q] = ends(found);
        near_vector(p, along(along(c, part * r, u), -half, d), 1e-10);
        near_vector(q, along(along(c, part * r, u), half, d), 1e-10);
        positive_multiple(&dense(&found), &dense(&at(part)).vee(&dense(&s)).scale(-1.0), 1e-10);
        prop_assert_eq!(meet(s, at(part)), LineAndSphere::Points(found));
        match meet(at(1.0), s) {
            LineAndSphere::Tangent { point, direction } => {
                near_vector(place(point), along(c, r, u), 1e-12);
                near_vector(direction, d, 1e-15);
            }
            other => panic!("{other:?}"),
        }
        let off = 1.0 / part;
        let found = outcome!(meet(at(off), s), LineAndSphere::Imaginary);
        near(found.radius_squared().unwrap(), r * r * (1.0 - off * off), 1e-10 * (off * r).powi(2).max(1.0));
        near_vector(place(found.centre().unwrap()), along(c, off * r, u), 1e-11 * off);
        positive_multiple(&dense(&found), &dense(&at(off)).vee(&dense(&s)).scale(-1.0), 1e-9);
        // Every meet with an imaginary sphere is imaginary.
        let found = outcome!(meet(at(part), sphere_of_square(c, -r * r)), LineAndSphere::Imaginary);
        near(found.radius_squared().unwrap(), -r * r * (1.0 + part * part), 1e-10);
    }

    #[test]
    fn planes_and_spheres(c in vector(3.0), n in unit(), r in 0.2..4.0_f64, part in -0.98..0.98_f64) {
        prop_assume!(part.abs() > 0.02);
        let s = sphere(c, r) * 2.0;
        let at = |part: f64| plane(along(c, part * r, n), n.map(|x| 3.0 * x));
        for (found, blade, sign) in [
            (meet(s, at(part)), dense(&s).vee(&dense(&at(part))), 1.0),
            (meet(at(part), s), dense(&at(part)).vee(&dense(&s)), -1.0),
        ] {
            let found = outcome!(found, PlaneAndSphere::Circle);
            near_vector(place(found.centre().unwrap()), along(c, part * r, n), 1e-12);
            near(found.radius().unwrap(), leg(r, part * r), 1e-10);
            near_vector(found.unit_normal().unwrap(), n.map(|x| sign * x), 1e-13);
            positive_multiple(&dense(&found), &blade, 1e-11);
        }
        for side in [-1.0, 1.0] {
            match meet(s, at(side)) {
                PlaneAndSphere::Tangent { point, normal } => {
                    near_vector(place(point), along(c, side * r, n), 1e-12);
                    near_vector(normal, n, 1e-15);
                }
                other => panic!("{other:?}"),
            }
        }
        let off = 1.0 / part;
        let found = outcome!(meet(s, at(off)), PlaneAndSphere::Imaginary);
        near(found.radius_squared().unwrap(), r * r * (1.0 - off * off), 1e-10 * (off * r).powi(2).max(1.0));
        positive_multiple(&dense(&found), &dense(&s).vee(&dense(&at(off))), 1e-9);
        let found = outcome!(meet(at(part), sphere_of_square(c, -r * r)), PlaneAndSphere::Imaginary);
        near(found.radius_squared().unwrap(), -r * r * (1.0 + part * part), 1e-10);
    }

    #[test]
    fn spheres(c in vector(3.0), n in unit(), r in 0.2..4.0_f64, s in 0.2..4.0_f64, part in 0.03..0.97_f64) {
        prop_assume!((r - s).abs() > 0.02);
        // Between touching from inside and from outside.
        let (near_by, far) = ((r - s).abs(), r + s);
        let d = near_by + part * (far - near_by);
        let (a, b) = (sphere(c, r), sphere(along(c, d, n), s) * 2.0);
        let found = outcome!(meet(a, b), SphereAndSphere::Circle);
        positive_multiple(&dense(&found), &dense(&a).vee(&dense(&b)), 1e-10);
        near_vector(found.unit_normal().unwrap(), n, 1e-12);
        // Its points are on both.
        let (centre, normal, radius) = (place(found.centre().unwrap()), found.unit_normal().unwrap(), found.radius().unwrap());
        let x = on_circle(centre, normal, radius, 1.0);
        near(length(minus(x, c)), r, 1e-10);
        near(length(minus(x, along(c, d, n))), s, 1e-10);
        let back = outcome!(meet(b, a), SphereAndSphere::Circle);
        near_vector(back.unit_normal().unwrap(), n.map(|x| -x), 1e-12);
        for (d, at) in [(near_by, if r > s { r } else { -r }), (far, r)] {
            match meet(a, sphere(along(c, d, n), s)) {
                SphereAndSphere::Tangent { point, normal } => {
                    near_vector(place(point), along(c, at, n), 1e-10);
                    near_vector(normal, n, 1e-10);
                }
                other => panic!("{other:?}"),
            }
        }
        for d in [near_by * part, far / part] {
            let b = sphere(along(c, d, n), s);
            let found = outcome!(meet(a, b), SphereAndSphere::Imaginary);
            positive_multiple(&dense(&found), &dense(&a).vee(&dense(&b)), 1e-8);
        }
        prop_assert_eq!(meet(a, sphere(c, s)), SphereAndSphere::Concentric);
        prop_assert_eq!(meet(a, sphere(c, r) * -5.0), SphereAndSphere::Coincident(a));
    }

    #[test]
    fn lines_and_circles(c in vector(3.0), n in unit(), r in 0.2..4.0_f64, part in 0.02..0.98_f64, turn in -3.0..3.0_f64, tilt in 0.2..1.4_f64) {
        let u = minus(on_circle(c, n, 1.0, turn), c);
        let v = cross(n, u);
        let ring = circle(c, n, r);
        let at = |part: f64| line(along(along(c, part * r, u), 0.7, v), v);
        let found = outcome!(meet(at(part), ring), LineAndCircle::Points);
        let half = leg(r, part * r);
        let [p, q] = ends(found);
        near_vector(p, along(along(c, part * r, u), -half, v), 1e-10);
        near_vector(q, along(along(c, part * r, u), half, v), 1e-10);
        prop_assert_eq!(meet(ring, at(part)), LineAndCircle::Points(found));
        match meet(at(1.0), ring) {
            LineAndCircle::Tangent { point, direction } => {
                near_vector(place(point), along(c, r, u), 1e-11);
                near_vector(direction, v, 1e-15);
            }
            other => panic!("{other:?}"),
        }
        let found = outcome!(meet(at(1.0 / part), ring), LineAndCircle::Imaginary);
        near_vector(place(found.centre().unwrap()), along(c, r / part, u), 1e-10 / part);
        // Perpendicular to its plane, through the circle and beside it.
        let across = along(n.map(|x| tilt.sin() * x), tilt.cos(), along(u, 0.5, v));
        let x = along(c, r, u);
        near_vector(place(outcome!(meet(line(along(x, 2.0, across), across), ring), LineAndCircle::Point)), x, 1e-10);
        prop_assert_eq!(meet(line(along(c, part * r, u), across), ring), LineAndCircle::Apart);
        prop_assert_eq!(meet(line(along(x, part, n), v), ring), LineAndCircle::Apart);
    }

    #[test]
    fn planes_and_circles(c in vector(3.0), n in unit(), m in unit(), r in 0.2..4.0_f64, part in 0.02..0.98_f64) {
        let sine = length(cross(n, m));
        prop_assume!(sine > 0.05);
        let (u, ring) = (unit_of(cross(m, n)), circle(c, n, r));
        let v = cross(u, n);
        // The plane that meets the circle's plane at this fraction of the radius.
        let at = |part: f64| plane(along(c, part * r, v), m.map(|x| 2.0 * x));
        let half = leg(r, part * r);
        let found = outcome!(meet(ring, at(part)), PlaneAndCircle::Points);
        let [p, q] = ends(found);
        near_vector(p, along(along(c, part * r, v), -half, u), 1e-9);
        near_vector(q, along(along(c, part * r, v), half, u), 1e-9);
        positive_multiple(&dense(&found), &dense(&ring).vee(&dense(&at(part))), 1e-9);
        prop_assert_eq!(meet(at(part), ring), PlaneAndCircle::Points(found));
        for side in [-1.0, 1.0] {
            match meet(at(side), ring) {
                PlaneAndCircle::Tangent { point, direction } => {
                    near_vector(place(point), along(c, side * r, v), 1e-10);
                    near_vector(direction, u, 1e-11);
                }
                other => panic!("{other:?}"),
            }
        }
        let found = outcome!(meet(at(1.0 / part), ring), PlaneAndCircle::Imaginary);
        positive_multiple(&dense(&found), &dense(&ring).vee(&dense(&at(1.0 / part))), 1e-8);
        prop_assert_eq!(meet(plane(c, n.map(|x| -x)), ring), PlaneAndCircle::Contained(ring));
        match meet(plane(along(c, -part, n), n), ring) {
            PlaneAndCircle::Parallel { distance } => near(distance, part, 1e-11),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn spheres_and_circles(c in vector(3.0), n in unit(), r in 0.2..4.0_f64, part in 0.05..0.95_f64, turn in -3.0..3.0_f64, h in -2.0..2.0_f64, far in 0.3..3.0_f64) {
        let u = minus(on_circle(c, n, 1.0, turn), c);
        let ring = circle(c, n, r);
        let centre = along(along(c, far, u), h, n);
        // The sphere through the point of the circle at this angle, and its mirror image.
        let angle = part * 3.0;
        let w = cross(n, u);
        let x = along(along(c, r * angle.cos(), u), r * angle.sin(), w);
        let y = along(along(c, r * angle.cos(), u), -r * angle.sin(), w);
        let s = sphere(centre, length(minus(x, centre)));
        let found = outcome!(meet(s, ring), SphereAndCircle::Points);
        let [p, q] = ends(found);
        near_vector(p, x, 1e-8);
        near_vector(q, y, 1e-8);
        positive_multiple(&dense(&found), &dense(&s).vee(&dense(&ring)), 1e-9);
        prop_assert_eq!(meet(ring, s), SphereAndCircle::Points(found));
        for side in [-1.0, 1.0] {
            let touched = along(c, side * r, u);
            match meet(sphere(centre, length(minus(touched, centre))), ring) {
                SphereAndCircle::Tangent { point, direction } => {
                    near_vector(place(point), touched, 1e-10);
                    near_vector(direction, w.map(|x| -x), 1e-10);
                }
                other => panic!("{other:?}"),
            }
        }
        let (least, most) = (length(minus(along(c, r, u), centre)), length(minus(along(c, -r, u), centre)));
        for size in [least * part, most / part] {
            let s = sphere(centre, size);
            let found = outcome!(meet(s, ring), SphereAndCircle::Imaginary);
            positive_multiple(&dense(&found), &dense(&s).vee(&dense(&ring)), 1e-8);
        }
        let above = along(c, h, n);
        prop_assert_eq!(meet(sphere(above, r.hypot(h)), ring), SphereAndCircle::Contained(ring));
        prop_assert_eq!(meet(sphere(above, r.hypot(h) + part), ring), SphereAndCircle::Concentric);
    }

    #[test]
    fn circles_of_one_plane(c in vector(3.0), n in unit(), r in 0.2..4.0_f64, s in 0.2..4.0_f64, part in 0.05..0.95_f64, turn in -3.0..3.0_f64) {
        prop_assume!((r - s).abs() > 0.05);
        let u = minus(on_circle(c, n, 1.0, turn), c);
        let w = cross(n, u);
        let a = circle(c, n, r);
        let at = |d: f64| circle(along(c, d, u), n.map(|x| -x), s);
        let (near_by, far) = ((r - s).abs(), r + s);
        let d = near_by + part * (far - near_by);
        let [p, q] = ends(outcome!(meet(a, at(d)), CircleAndCircle::Points));
        for x in [p, q] {
            near(length(minus(x, c)), r, 1e-9);
            near(length(minus(x, along(c, d, u))), s, 1e-9);
        }
        // Along w × n, which is −(n × u).
        near_vector(unit_of(minus(q, p)), w.map(|x| -x), 1e-8);
        for (d, place_at) in [(near_by, if r > s { r } else { -r }), (far, r)] {
            match meet(a, at(d)) {
                CircleAndCircle::Tangent { point, direction } => {
                    near_vector(place(point), along(c, place_at, u), 1e-9);
                    near_vector(direction, w.map(|x| -x), 1e-9);
                }
                other => panic!("{other:?}"),
            }
        }
        for d in [near_by * part, far / part] {
            let found = outcome!(meet(a, at(d)), CircleAndCircle::Imaginary);
            // The power of the centre of the imaginary pair is its radius squared, for both
            // circles.
            let x = place(found.centre().unwrap());
            let squared = found.radius_squared().unwrap();
            near(length(minus(x, c)).powi(2) - r * r, -squared, 1e-8 * (1.0 + squared.abs()));
            near(length(minus(x, along(c, d, u))).powi(2) - s * s, -squared, 1e-8 * (1.0 + squared.abs()));
        }
        prop_assert_eq!(meet(a, at(0.0)), CircleAndCircle::Concentric);
        prop_assert_eq!(meet(a, circle(c, n.map(|x| -x), r)), CircleAndCircle::Coincident(a));
        prop_assert_eq!(meet(a, circle(along(c, part, n), n, r)), CircleAndCircle::Apart);
    }

    #[test]
    fn circles_in_two_planes(x in vector(3.0), n in unit(), m in unit(), r in 0.3..4.0_f64, s in 0.3..4.0_f64, half in 0.05..0.28_f64, swing in 0.3..1.2_f64) {
        prop_assume!(length(cross(n, m)) > 0.1);
        let u = unit_of(cross(m, n));
        // Two points x ± half u in both planes; the centres lie beside their midpoint, each in its
        // plane.
        let centre = |n: Vector, r: f64| along(x, leg(r, half), cross(n, u));
        let (a, b) = (circle(centre(n, r), n, r), circle(centre(m, s), m, s));
        let [p, q] = ends(outcome!(meet(a, b), CircleAndCircle::Points));
        near_vector(p, along(x, -half, u), 1e-8);
        near_vector(q, along(x, half, u), 1e-8);
        // One common point: the second circle is rotated about it.
        let swung = along(cross(m, u).map(|x| x * swing.cos()), swing.sin(), u);
        let b = circle(along(along(x, half, u), s, swung), m, s);
        near_vector(place(outcome!(meet(a, b), CircleAndCircle::Point)), along(x, half, u), 1e-8);
        near_vector(place(outcome!(meet(b, a), CircleAndCircle::Point)), along(x, half, u), 1e-8);
        // One common tangent.
        let (a, b) = (circle(along(x, r, cross(n, u)), n, r), circle(along(x, s, cross(m, u)), m, s));
        match meet(a, b) {
            CircleAndCircle::Tangent { point, direction } => {
                near_vector(place(point), x, 1e-9);
                near_vector(direction, u, 1e-9);
            }
            other => panic!("{other:?}"),
        }
        // The first touches the plane of the second in a point that the second crosses.
        let b = circle(along(x, s, swung), m, s);
        near_vector(place(outcome!(meet(a, b), CircleAndCircle::Point)), x, 1e-9);
        prop_assert_eq!(meet(a, circle(along(x, s + 0.1, swung), m, s)), CircleAndCircle::Apart);
    }
}

/// What other libraries computed: the meet of a sphere with a plane and with a line.
#[test]
fn vectors_of_other_libraries() {
    check_vectors(&oracle::extract("ga/geometry.json"), 12);
    if let Some(all) = oracle::complete() {
        check_vectors(&all["geometry"], 120);
    }
}

/// Checks all records and that there are `count` of them.
fn check_vectors(all: &serde_json::Value, count: usize) {
    let number = |v: &serde_json::Value| v.as_f64().expect("a number");
    let triple = |v: &serde_json::Value| -> Vector { std::array::from_fn(|k| number(&v[k])) };
    let mut cases = 0;
    for record in all["sphere_plane"].as_array().expect("records") {
        let (c, n) = (triple(&record["center"]), triple(&record["normal"]));
        let e = plane(n.map(|x| x * number(&record["offset"])), n);
        match (
            meet(sphere(c, number(&record["radius"])), e),
            record["circle_radius"].as_f64(),
        ) {
            (PlaneAndSphere::Circle(circle), Some(radius)) => {
                near(circle.radius().expect("finite"), radius, 1e-11);
                near_vector(
                    place(circle.centre().expect("finite")),
                    triple(&record["circle_center"]),
                    1e-12,
                );
            }
            (PlaneAndSphere::Imaginary(_), None) => {}
            other => panic!("{other:?}"),
        }
        cases += 1;
    }
    for record in all["sphere_line"].as_array().expect("records") {
        let l = line(triple(&record["through"]), triple(&record["direction"]));
        let s = sphere(triple(&record["center"]), number(&record["radius"]));
        match (meet(l, s), record["hits"].as_array()) {
            (LineAndSphere::Points(pair), Some(hits)) if hits.len() == 2 => {
                let found = ends(pair);
                near_vector(found[0], triple(&hits[0]), 1e-11);
                near_vector(found[1], triple(&hits[1]), 1e-11);
            }
            (LineAndSphere::Imaginary(_), hits) if hits.is_none_or(Vec::is_empty) => {}
            other => panic!("{other:?}"),
        }
        cases += 1;
    }
    assert_eq!(cases, count);
}

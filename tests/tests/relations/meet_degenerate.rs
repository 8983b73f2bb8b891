//! Degenerate meets: of radius zero, imaginary, at the limit of the tolerance, and of elements that
//! are not a figure.

use ga_runtime::cga3::{Circle, Line, Plane, Point, Sphere};
use ga_runtime::geometry::relation::meet::{
    CircleAndCircle, LineAndCircle, LineAndLine, LineAndPlane, LineAndSphere, PlaneAndCircle,
    PlaneAndPlane, PlaneAndSphere, SphereAndCircle, SphereAndSphere,
};
use ga_runtime::geometry::relation::{Meet, Tolerance};
use nullcone_tests::plain::*;

fn meet<A: Meet<B, Scalar = f64>, B>(a: A, b: B) -> A::Outcome {
    a.meet(b, tolerance()).expect("an outcome")
}

fn place(p: Point<f64>) -> Vector {
    p.coordinates()
}

#[test]
fn radius_zero() {
    let (p, o) = (sphere(X, 0.0), sphere(O, 1.0));
    assert!(
        matches!(meet(p, plane(X, X)), PlaneAndSphere::Tangent { point, .. } if place(point) == X)
    );
    assert!(matches!(meet(p, plane(O, X)), PlaneAndSphere::Imaginary(_)));
    assert!(
        matches!(meet(p, line(X, Y)), LineAndSphere::Tangent { point, .. } if place(point) == X)
    );
    assert!(matches!(meet(p, line(O, Y)), LineAndSphere::Imaginary(_)));
    assert!(matches!(meet(p, o), SphereAndSphere::Tangent { point, .. } if place(point) == X));
    assert!(matches!(
        meet(p, sphere(O, 2.0)),
        SphereAndSphere::Imaginary(_)
    ));
    assert!(matches!(
        meet(p, sphere(X, 0.0)),
        SphereAndSphere::Coincident(_)
    ));
    assert!(matches!(
        meet(p, sphere(X, 1.0)),
        SphereAndSphere::Concentric
    ));
    let ring = circle(O, Z, 1.0);
    assert!(matches!(meet(p, ring), SphereAndCircle::Tangent { point, .. } if place(point) == X));
    let dot = circle(X, Y, 0.0);
    assert!(matches!(meet(o, dot), SphereAndCircle::Contained(_)));
    assert!(matches!(
        meet(sphere(O, 2.0), dot),
        SphereAndCircle::Imaginary(_)
    ));
    assert!(matches!(
        meet(plane(O, Y), dot),
        PlaneAndCircle::Contained(_)
    ));
    assert!(matches!(
        meet(plane(X, X), dot),
        PlaneAndCircle::Contained(_)
    ));
    assert!(matches!(
        meet(plane(O, X), dot),
        PlaneAndCircle::Imaginary(_)
    ));
    assert!(
        matches!(meet(line(X, Z), dot), LineAndCircle::Tangent { point, .. } if place(point) == X)
    );
    assert!(matches!(meet(line(X, Y), dot), LineAndCircle::Point(point) if place(point) == X));
    assert!(matches!(meet(line(O, Z), dot), LineAndCircle::Imaginary(_)));
    assert!(matches!(meet(ring, dot), CircleAndCircle::Point(point) if place(point) == X));
    assert!(matches!(meet(dot, ring), CircleAndCircle::Point(point) if place(point) == X));
    assert!(matches!(
        meet(dot, circle(X, Y, 0.0)),
        CircleAndCircle::Coincident(_)
    ));
    assert!(matches!(
        meet(dot, circle(O, Z, 2.0)),
        CircleAndCircle::Apart
    ));
}

#[test]
fn imaginary_rounds() {
    let (s, ring) = (sphere_of_square(O, -1.0), circle_of_square(O, Z, -1.0));
    assert!(matches!(
        meet(s, sphere(X, 1.0)),
        SphereAndSphere::Imaginary(_)
    ));
    assert!(matches!(
        meet(s, sphere_of_square(O, -1.0)),
        SphereAndSphere::Coincident(_)
    ));
    assert!(matches!(
        meet(s, sphere_of_square(O, -2.0)),
        SphereAndSphere::Concentric
    ));
    assert!(matches!(
        meet(s, sphere(O, 1.0)),
        SphereAndSphere::Concentric
    ));
    assert!(matches!(
        meet(s, circle(X, Z, 3.0)),
        SphereAndCircle::Imaginary(_)
    ));
    assert!(matches!(
        meet(sphere(X, 3.0), ring),
        SphereAndCircle::Imaginary(_)
    ));
    assert!(matches!(
        meet(plane(O, X), ring),
        PlaneAndCircle::Imaginary(_)
    ));
    assert!(matches!(
        meet(plane(O, Z), ring),
        PlaneAndCircle::Contained(_)
    ));
    assert!(matches!(
        meet(line(O, X), ring),
        LineAndCircle::Imaginary(_)
    ));
    assert!(matches!(meet(line(O, Z), ring), LineAndCircle::Apart));
    assert!(matches!(
        meet(ring, circle(X, Z, 1.0)),
        CircleAndCircle::Imaginary(_)
    ));
    assert!(matches!(
        meet(ring, circle(O, X, 1.0)),
        CircleAndCircle::Apart
    ));
    assert!(matches!(
        meet(circle(O, X, 1.0), ring),
        CircleAndCircle::Apart
    ));
    assert!(matches!(meet(ring, ring), CircleAndCircle::Coincident(_)));
}

/// A negative squared radius smaller than the square of the tolerance is that of a point.
#[test]
fn radius_zero_but_for_rounding() {
    let (point_like, imaginary) = (sphere_of_square(O, -0.9e-18), sphere_of_square(O, -1.1e-18));
    assert!(matches!(
        meet(plane(O, X), point_like),
        PlaneAndSphere::Tangent { .. }
    ));
    assert!(matches!(
        meet(plane(O, X), imaginary),
        PlaneAndSphere::Imaginary(_)
    ));
    let none = Tolerance::new(-1e-9, 0.0);
    assert!(matches!(
        plane(O, X).meet(point_like, none),
        Some(PlaneAndSphere::Imaginary(_))
    ));
}

/// The tolerance is a distance: figures touch if their gap or overlap is no larger.
#[test]
fn tolerances() {
    let loose = Tolerance::new(1e-3, 1e-3);
    let s = sphere(O, 1.0);
    for (off, touches) in [(0.9e-3, true), (1.1e-3, false)] {
        for x in [1.0 - off, 1.0 + off] {
            let found = plane([x, 0.0, 0.0], X).meet(s, loose).unwrap();
            assert_eq!(matches!(found, PlaneAndSphere::Tangent { .. }), touches);
            let found = line([x, 0.0, 0.0], Y).meet(s, loose).unwrap();
            assert_eq!(matches!(found, LineAndSphere::Tangent { .. }), touches);
            let found = s.meet(sphere([x + 2.0, 0.0, 0.0], 2.0), loose).unwrap();
            assert_eq!(matches!(found, SphereAndSphere::Tangent { .. }), touches);
            let found = plane([x, 0.0, 0.0], X)
                .meet(circle(O, Z, 1.0), loose)
                .unwrap();
            assert_eq!(matches!(found, PlaneAndCircle::Tangent { .. }), touches);
            let found = circle(O, Z, 1.0)
                .meet(circle([x + 2.0, 0.0, 0.0], Z, 2.0), loose)
                .unwrap();
            assert_eq!(matches!(found, CircleAndCircle::Tangent { .. }), touches);
        }
        let tilted = [off.cos(), off.sin(), 0.0];
        let found = line([0.0, 0.0, 1.0], X)
            .meet(line(O, tilted), loose)
            .unwrap();
        assert_eq!(matches!(found, LineAndLine::Parallel { .. }), touches);
        let found = line(O, X).meet(line([0.0, 0.0, off], Y), loose).unwrap();
        assert_eq!(matches!(found, LineAndLine::Point(_)), touches);
        let found = line([0.0, 1.0, 0.0], tilted)
            .meet(plane(O, Y), loose)
            .unwrap();
        assert_eq!(matches!(found, LineAndPlane::Parallel { .. }), touches);
        let found = plane(X, X).meet(plane(O, tilted), loose).unwrap();
        assert_eq!(matches!(found, PlaneAndPlane::Parallel { .. }), touches);
        // A point of the circle beside the line, perpendicular to the plane.
        let found = line([1.0 + off, 0.0, 0.0], Z)
            .meet(circle(O, Z, 1.0), loose)
            .unwrap();
        assert_eq!(matches!(found, LineAndCircle::Point(_)), touches);
        // A circle beside a sphere, and one almost on it.
        let found = s
            .meet(circle([2.0 + off, 0.0, 0.0], Z, 1.0), loose)
            .unwrap();
        assert_eq!(matches!(found, SphereAndCircle::Tangent { .. }), touches);
        let found = s.meet(circle(O, Z, 1.0 + off), loose).unwrap();
        assert_eq!(matches!(found, SphereAndCircle::Contained(_)), touches);
    }
}

#[test]
fn bad_input() {
    let t = tolerance();
    let (l, e, s, c) = (line(O, X), plane(O, X), sphere(O, 1.0), circle(O, Z, 1.0));
    // Of weight zero, none of these is a figure.
    let flat_sphere = sphere(O, 1.0) * 0.0;
    let flat_circle = Circle::through(point(O), point(X), point([2.0, 0.0, 0.0]));
    let nothing = |l2: Line<f64>, e2: Plane<f64>, s2: Sphere<f64>, c2: Circle<f64>| {
        assert!(
            l.meet(l2, t).is_none()
                && e.meet(l2, t).is_none()
                && s.meet(l2, t).is_none()
                && c.meet(l2, t).is_none()
        );
        assert!(
            l.meet(e2, t).is_none()
                && e.meet(e2, t).is_none()
                && s.meet(e2, t).is_none()
                && c.meet(e2, t).is_none()
        );
        assert!(
            l.meet(s2, t).is_none()
                && e.meet(s2, t).is_none()
                && s.meet(s2, t).is_none()
                && c.meet(s2, t).is_none()
        );
        assert!(
            l.meet(c2, t).is_none()
                && e.meet(c2, t).is_none()
                && s.meet(c2, t).is_none()
                && c.meet(c2, t).is_none()
        );
        assert!(
            l2.meet(l, t).is_none()
                && e2.meet(e, t).is_none()
                && s2.meet(s, t).is_none()
                && c2.meet(c, t).is_none()
        );
    };
    nothing(line(O, O), plane(O, O), flat_sphere, flat_circle);
    for bad in [f64::NAN, f64::INFINITY] {
        let broken = Circle::new(
            point(O),
            ga_runtime::cga3::Direction::new(bad, 0.0, 1.0),
            1.0,
        );
        nothing(
            line([0.0, bad, 0.0], X),
            plane([bad, 0.0, 0.0], X),
            sphere(O, bad),
            broken,
        );
        nothing(
            line(O, [bad, 1.0, 0.0]),
            plane(O, [bad, 0.0, 1.0]),
            sphere([0.0, bad, 0.0], 1.0),
            broken,
        );
    }
    // A negative tolerance or NaN causes neither an endless loop nor NaN.
    for bad in [f64::NAN, -1.0] {
        let none = Tolerance::new(bad, bad);
        assert!(matches!(s.meet(s, none), Some(SphereAndSphere::Concentric)));
        assert!(l.meet(plane(O, Z), none).is_none());
        assert!(e.meet(e, none).is_none());
        assert!(c.meet(c, none).is_none());
    }
}

#[test]
fn single_precision() {
    let t = Tolerance::for_size(10.0_f32);
    let sphere = Sphere::from_centre_radius(Point::new(3.0_f32, 4.0, 0.0), 5.0);
    let line = Line::from_point_direction(Point::new(0.0_f32, 0.0, 3.0), [0.6, 0.8, 0.0]);
    let Some(LineAndSphere::Points(pair)) = line.meet(sphere, t) else {
        panic!()
    };
    let [p, q] = pair
        .endpoints()
        .unwrap()
        .map(|p| p.coordinates().map(f64::from));
    near_vector(p, [0.6, 0.8, 3.0], 1e-5);
    near_vector(q, [5.4, 7.2, 3.0], 1e-5);
    let touching = Plane::from_point_normal(Point::new(3.0_f32, 4.0, 5.0), [0.0, 0.0, 1.0]);
    assert!(matches!(
        sphere.meet(touching, t),
        Some(PlaneAndSphere::Tangent { .. })
    ));
}

//! Tangent planes of spheres and tangent lines of circles.

use ga_runtime::cga3::{Circle, DualSphere, Infinity, Plane, Point, Sphere};
use ga_runtime::geometry::relation::Tolerance;
use nullcone_tests::plain::{
    along, cross, dense, dot, frame, near, near_all, plus, positive_multiple, times, tolerance,
    unit, vector,
};
use proptest::prelude::*;

proptest! {
    #[test]
    fn a_tangent_plane_touches_its_sphere(c in vector(9.0), out in unit(), radius in 0.1..9.0_f64, off in -1e-10..1e-10_f64) {
        let sphere = Sphere::from_centre_radius(Point::from(c), radius);
        let point = Point::from(along(c, radius + off, out));
        let plane = sphere.tangent_plane_at(point, tolerance()).unwrap();
        near_all(plane.normal(), out, 1e-9);
        // At a distance of the radius from the centre, whether or not the point is on the sphere.
        near(plane.signed_distance(Point::from(c)).unwrap(), -radius, 1e-10);
        let dual = DualSphere::from_centre_radius(Point::from(c), radius);
        let same = dual.tangent_plane_at(point, tolerance()).unwrap();
        near_all(same.normal(), out, 1e-9);
        near(same.ei, dot(out, c) + radius, 1e-9);
        // In blades: the contraction by the point, and infinity.
        let on = Point::from(along(c, radius, out));
        let by_blades: Plane<f64> = -((on | sphere) ^ Infinity);
        positive_multiple(&dense(&sphere.tangent_plane_at(on, tolerance()).unwrap()), &dense(&by_blades), 1e-9);
    }

    #[test]
    fn a_tangent_line_touches_its_circle(c in vector(9.0), normal in unit(), radius in 0.1..9.0_f64, angle in -3.0..3.0_f64) {
        let [u, v] = frame(normal);
        let (sine, cosine) = angle.sin_cos();
        let out = plus(times(u, cosine), times(v, sine));
        let circle = Circle::from_centre_normal_radius(Point::from(c), normal, radius).unwrap();
        let point = Point::from(along(c, radius, out));
        let line = circle.tangent_line_at(point, tolerance()).unwrap();
        // The derivative of c + r (cos φ u + sin φ v).
        near_all(line.direction(), plus(times(u, -sine), times(v, cosine)), 1e-9);
        near_all(line.moment(), cross(point.coordinates(), line.direction()), 1e-8);
    }
}

#[test]
fn points_elsewhere_have_no_tangents() {
    let at = |x: f64, y: f64, z: f64| Point::new(x, y, z);
    let sphere = Sphere::from_centre_radius(at(1.0, 0.0, 0.0), 2.0);
    let tangent = |sphere: Sphere<f64>, p| sphere.tangent_plane_at(p, Tolerance::default());
    assert!(tangent(sphere, at(3.0, 0.0, 0.0)).is_some());
    for p in [
        at(1.0, 0.0, 0.0),
        at(3.1, 0.0, 0.0),
        at(2.9, 0.0, 0.0),
        at(f64::NAN, 0.0, 0.0),
    ] {
        assert_eq!(tangent(sphere, p), None);
    }
    let loose = Tolerance::new(0.2, 0.0);
    assert!(sphere.tangent_plane_at(at(3.1, 0.0, 0.0), loose).is_some());
    // A point, an imaginary sphere, one of weight zero.
    let point = Sphere::from_centre_radius(at(1.0, 0.0, 0.0), 0.0);
    assert_eq!(tangent(point, at(1.0, 0.0, 0.0)), None);
    let imaginary = Sphere::from_centre_radius_squared(at(0.0, 0.0, 0.0), -1.0);
    assert_eq!(tangent(imaginary, at(1.0, 0.0, 0.0)), None);
    let nothing = Sphere::from_centre_radius(at(0.0, 0.0, 0.0), 1.0) * 0.0;
    assert_eq!(tangent(nothing, at(1.0, 0.0, 0.0)), None);

    let circle = Circle::from_centre_normal_radius(Point::default(), [0.0, 0.0, 1.0], 2.0).unwrap();
    let tangent = |circle: Circle<f64>, p| circle.tangent_line_at(p, Tolerance::default());
    assert!(tangent(circle, at(0.0, -2.0, 0.0)).is_some());
    for p in [
        at(0.0, 0.0, 0.0),
        at(0.0, 0.0, 2.0),
        at(2.0, 0.0, 0.1),
        at(2.1, 0.0, 0.0),
    ] {
        assert_eq!(tangent(circle, p), None);
    }
    assert_eq!(tangent(circle * 0.0, at(0.0, -2.0, 0.0)), None);
}

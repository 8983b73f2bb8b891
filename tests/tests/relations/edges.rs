//! Edge cases of relations: figures that touch far from the origin, dual forms, numbers that are
//! not finite.

use ga_runtime::cga3::{Circle, Line, Multivector, Plane, Point, PointPair, RoundVector, Sphere};
use ga_runtime::geometry::relation::Tolerance;
use ga_runtime::testing::assert_close;
use proptest::prelude::*;

fn place(size: f64) -> impl Strategy<Value = [f64; 3]> + Clone {
    prop::array::uniform3(-size..size)
}

fn unit() -> impl Strategy<Value = [f64; 3]> + Clone {
    place(1.0).prop_filter_map("a direction", |v| {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        (length > 0.1).then(|| v.map(|x| x / length))
    })
}

fn along(a: [f64; 3], t: f64, b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] + t * b[k])
}

fn across(n: [f64; 3]) -> [f64; 3] {
    let k = (0..3)
        .min_by(|&a, &b| n[a].abs().total_cmp(&n[b].abs()))
        .expect("three");
    let mut e = [0.0; 3];
    e[k] = 1.0;
    let v = along(e, -n[k], n);
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

proptest! {
    #[test]
    fn what_touches_has_an_angle(c in place(1000.0), n in unit(), r in 0.5..5.0_f64) {
        let sphere = Sphere::from_centre_radius(Point::from(c), r);
        let foot = Point::from(along(c, r, n));
        let plane = sphere.angle_to(Plane::from_point_normal(foot, n));
        // The centre is behind the plane: the inward normal is opposite to the plane's.
        prop_assert!((plane.expect("they touch") - std::f64::consts::PI).abs() < 1e-2);
        let line = sphere.angle_to(Line::from_point_direction(foot, across(n)));
        prop_assert!(line.expect("they touch").abs() < 1e-2);
        let other = Sphere::from_centre_radius(Point::from(along(c, 3.0 * r, n)), 2.0 * r);
        prop_assert!((sphere.angle_to(other).expect("they touch") - std::f64::consts::PI).abs() < 1e-2);
        // Figures that are clearly apart have none.
        let apart = Sphere::from_centre_radius(Point::from(along(c, 3.1 * r, n)), 2.0 * r);
        prop_assert_eq!(sphere.angle_to(apart), None);
        prop_assert_eq!(sphere.angle_to(Plane::from_point_normal(Point::from(along(c, 1.1 * r, n)), n)), None);
    }

    #[test]
    fn dual_forms_relate_as_what_they_stand_for(c in place(3.0), n in unit(), r in 0.5..2.0_f64, p in place(5.0)) {
        let tolerance = Tolerance::for_size(100.0);
        let (centre, p) = (Point::from(c), Point::from(p));
        let circle = Circle::from_centre_normal_radius(centre, n, r).expect("a circle");
        let (sphere, plane) = (Sphere::from_centre_radius(centre, r), Plane::from_point_normal(centre, n));
        let line = Line::from_point_direction(centre, n);
        let pair = PointPair::from_centre_axis_radius_squared(centre, n, r * r).expect("a pair");
        let same = |a: Option<f64>, b: Option<f64>| assert_close!(a.expect("a number"), b.expect("a number"), 1e-11, 10.0);
        same(p.distance_to(circle.dual()), p.distance_to(circle));
        same(sphere.dual().distance_to(p), sphere.distance_to(p));
        same(p.signed_distance_to(plane.dual()), p.signed_distance_to(plane));
        same(line.dual().distance_to(p), line.distance_to(p));
        same(p.distance_to(pair.dual()), p.distance_to(pair));
        same(line.dual().angle_to(plane.dual()), Some(std::f64::consts::FRAC_PI_2));
        prop_assert!(circle.dual().is_on(sphere.dual(), tolerance));
        prop_assert!(circle.dual().is_on(plane, tolerance));
        prop_assert!(pair.dual().is_on(line.dual(), tolerance));
        prop_assert!(line.dual().is_perpendicular_to(circle.dual(), tolerance));
    }

    #[test]
    fn reflections_of_dual_forms_are_versor_actions(c in place(3.0), n in unit(), m in unit(), r in 0.5..2.0_f64) {
        let mirror = Plane::from_point_normal(Point::from(c), m);
        let versor = Multivector::from(RoundVector::from(mirror.dual()));
        let centre = Point::from(along(c, 1.0, n));
        let circle = Circle::from_centre_normal_radius(centre, n, r).expect("a circle");
        let sphere = Sphere::from_centre_radius(centre, r);
        let check = |x: Multivector<f64>, image: Multivector<f64>| {
            let difference = versor * x.involute() * versor - image;
            assert!(difference.scalar_product(difference.reverse()).abs() < 1e-10);
            for value in [difference.e1, difference.e12i, difference.e12, difference.e123, difference.e1o, difference.ei] {
                assert!(value.abs() < 1e-10);
            }
        };
        check(sphere.dual().into(), sphere.dual().reflect_in(mirror).expect("finite").into());
        check(circle.dual().into(), circle.dual().reflect_in(mirror.dual()).expect("finite").into());
        check(circle.into(), circle.reflect_in(mirror).expect("finite").into());
        // The dual of the image is minus the image of the dual.
        let both = sphere.reflect_in(mirror).expect("finite").dual() + sphere.dual().reflect_in(mirror).expect("finite");
        assert_close!([both.e1, both.e2, both.e3, both.eo, both.ei], [0.0; 5], 1e-11, 10.0);
        // Reflected figures are at the reflected positions.
        let image = circle.dual().reflect_in(mirror).expect("finite");
        assert_close!(
            image.centre().expect("a circle").coordinates(),
            centre.reflect_in(mirror).expect("finite").coordinates(),
            1e-11,
            10.0
        );
    }

    #[test]
    fn the_cosine_is_minus_the_scalar_product(p in place(3.0), m in unit(), n in unit()) {
        let p = Point::from(p);
        let (k, l) = (Line::from_point_direction(p, m), Line::from_point_direction(Point::default(), n));
        assert_close!(-k.scalar_product(l.reverse()), k.angle_to(l).expect("lines").cos(), 1e-12, 1.0);
        let (a, b) = (Plane::from_point_normal(p, m), Plane::from_point_normal(Point::default(), n));
        assert_close!(-a.scalar_product(b.reverse()), a.angle_to(b).expect("planes").cos(), 1e-12, 1.0);
    }
}

#[test]
fn images_that_are_not_finite_are_none() {
    let wall = Plane::from_point_normal(Point::default(), [0.6, 0.8, 0.0]);
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(Point::new(bad, 0.0, 0.0).reflect_in(Point::default()), None);
        assert_eq!(
            Line::from_point_direction(Point::default(), [bad, 1.0, 0.0]).reflect_in(wall),
            None
        );
        assert_eq!(
            Line::from_point_direction(Point::default(), [1.0, 0.0, 0.0])
                .distance(Point::new(0.0, bad, 0.0)),
            None
        );
    }
    let long = Line::new(1e308, 1e308, 1e308, -2.0, 1e308, 1e308);
    let image = long.reflect_in(wall);
    assert!(image.is_none_or(|line| {
        line.direction()
            .iter()
            .chain(&line.moment())
            .all(|x| x.is_finite())
    }));
    let axis = Line::from_point_direction(Point::default(), [1.0, 0.0, 0.0]);
    assert_eq!(axis.distance(Point::new(0.0, 1.5e308, 1.5e308)), None);
}

#[test]
fn an_inside_out_sphere_counts_as_the_sphere() {
    let a = Sphere::from_centre_radius(Point::default(), 1.0);
    let b = Sphere::from_centre_radius(Point::new(4.0, 0.0, 0.0), 2.0);
    assert_eq!((-a).inversive_distance_to(b), a.inversive_distance_to(b));
    assert_eq!(a.dual().inversive_distance_to(b.dual()), Some(-2.75));
}

#[test]
fn distances_from_lines_of_any_weight_are_within_the_range() {
    for (distance, weight) in [(1e20_f32, 1e-11), (1e-22, 1e11), (3.0, 1e-11), (3.0, 1e11)] {
        let line = Line::from_point_direction(Point::default(), [0.0, 0.0, weight]);
        let found = line
            .distance(Point::new(0.0, distance, 5.0))
            .expect("a distance");
        assert!(
            (found / distance - 1.0).abs() < 1e-6,
            "{found} at {distance}"
        );
    }
}

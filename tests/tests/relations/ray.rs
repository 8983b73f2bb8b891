//! Rays against closed forms in plain arithmetic: each surface is built about a point that the ray
//! is known to hit or to miss.

use ga_runtime::cga3::{
    Circle, Direction, Line, Motor, Plane, Point, Rotor, Similarity, Sphere, Translator,
};
use ga_runtime::geometry::ray::{Hit, Ray, Side};
use ga_runtime::geometry::relation::Primitive;
use ga_runtime::scalar::Lanes;
use nullcone_tests::plain::{
    Vector, along, cross, dot, length, minus, near, near_vector, on_circle, plane, plus, point,
    rotated, sphere, times, unit, unit_of, vector,
};
use nullcone_tests::random::SplitMix64;
use proptest::prelude::*;

/// A weight of either sign.
fn weight() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![0.01..100.0, -100.0..-0.01]
}

/// A ray with a direction that is not normalised, and that direction.
fn ray(origin: Vector, direction: Vector) -> Ray<f64> {
    Ray::new(point(origin), times(direction, 3.7)).expect("a direction")
}

/// Asserts that a hit is at a distance along a direction from an origin, with this normal or its
/// opposite, whichever faces the ray.
#[track_caller]
fn check(hit: Option<Hit<f64>>, origin: Vector, direction: Vector, distance: f64, normal: Vector) {
    let hit = hit.expect("a hit");
    let slope = dot(normal, direction);
    let faces = times(normal, -slope.signum());
    let bound = 1e-10 / slope.abs();
    near(hit.distance, distance, bound);
    near_vector(
        hit.point.coordinates(),
        along(origin, distance, direction),
        bound,
    );
    near_vector(hit.normal.vector(), faces, bound);
    near(length(hit.normal.vector()), 1.0, 1e-14);
    let side = if slope < 0.0 { Side::Front } else { Side::Back };
    assert_eq!(hit.side(), side);
}

/// Ends of the crossing of a line with a sphere, by the quadratic formula.
fn ends_by_formula(o: Vector, d: Vector, c: Vector, r: f64) -> Option<[f64; 2]> {
    let f = minus(o, c);
    let (half, last) = (dot(f, d), dot(f, f) - r * r);
    let root = half * half - last;
    (root >= 0.0).then(|| [-half - root.sqrt(), -half + root.sqrt()])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_sphere_is_hit_where_the_quadratic_formula_says(
        o in vector(5.0), d in unit(), c in vector(5.0), r in 0.1..4.0_f64, w in weight()
    ) {
        let ends = ends_by_formula(o, d, c, r);
        // Grazing rays are decided by rounding.
        let foot = along(o, dot(minus(c, o), d), d);
        prop_assume!((length(minus(foot, c)) - r).abs() > 1e-3);
        let expected = ends.and_then(|ends| ends.into_iter().find(|t| *t > 0.0));
        let ball = sphere(c, r) * w;
        for found in [ray(o, d).first_hit(ball), ray(o, d).first_hit(ball.dual()), ray(o, d).first_hit(ball.figure().unwrap())] {
            match expected {
                None => prop_assert_eq!(found, None),
                Some(t) => check(found, o, d, t, times(minus(along(o, t, d), c), 1.0 / r)),
            }
        }
        let both = ray(o, d).entry_and_exit(ball);
        prop_assert_eq!(both.is_some(), ends.is_some());
        if let (Some(both), Some(ends)) = (both, ends) {
            for k in 0..2 {
                near(both[k].distance, ends[k], 1e-10);
            }
            prop_assert_eq!(both.map(|hit| hit.side()), [Side::Front, Side::Back]);
            // The same points in the same order, from the product.
            let line = Line::from_point_direction(point(o), d);
            let pair = (sphere(c, r) & line) * -1.0;
            let pair = pair.endpoints().expect("a real pair");
            for k in 0..2 {
                near_vector(both[k].point.coordinates(), pair[k].coordinates(), 1e-7);
            }
        }
    }

    #[test]
    fn a_plane_is_hit_from_both_sides(
        o in vector(5.0), d in unit(), n in unit(), t in 0.01..20.0_f64, w in weight()
    ) {
        prop_assume!(dot(n, d).abs() > 1e-3);
        let through = along(o, t, d);
        let oriented = times(n, w.signum());
        let wall = plane(through, times(n, w));
        for found in [ray(o, d).first_hit(wall), ray(o, d).first_hit(wall.dual()), ray(o, d).first_hit(wall.figure().unwrap())] {
            check(found, o, d, t, oriented);
        }
        // Behind the ray there is nothing.
        prop_assert_eq!(ray(o, times(d, -1.0)).first_hit(wall), None);
        // A sphere without weight is not hit.
        prop_assert_eq!(ray(o, d).first_hit(sphere(through, 1.0) * 0.0), None);
    }

    #[test]
    fn a_disc_is_hit_within_its_circle(
        o in vector(5.0), d in unit(), n in unit(), t in 0.01..20.0_f64,
        r in 0.1..5.0_f64, share in 0.0..2.0_f64, turn in 0.0..6.3_f64, w in weight(),
    ) {
        prop_assume!(dot(n, d).abs() > 1e-2 && (share - 1.0).abs() > 1e-3);
        let through = along(o, t, d);
        let c = on_circle(through, n, r * share, turn);
        let circle = Circle::from_centre_normal_radius(point(c), n, r).expect("a circle") * w;
        let rim = |angle| point(on_circle(c, times(n, w.signum()), r, angle));
        let by_points = Circle::through(rim(0.0), rim(2.0), rim(4.0));
        let discs = [
            ray(o, d).first_hit(circle),
            ray(o, d).first_hit(circle.dual()),
            ray(o, d).first_hit(by_points),
            ray(o, d).first_hit(circle.figure().unwrap()),
        ];
        for found in discs {
            if share < 1.0 {
                check(found, o, d, t, times(n, w.signum()));
            } else {
                prop_assert_eq!(found, None);
            }
        }
        prop_assert_eq!(ray(o, times(d, -1.0)).first_hit(circle), None);
    }

    #[test]
    fn a_triangle_is_hit_between_its_corners(
        o in vector(5.0), d in unit(), t in 0.01..20.0_f64,
        p in vector(4.0), q in vector(4.0), shares in (-0.6..1.3_f64, -0.6..1.3_f64),
    ) {
        let (u, v) = shares;
        let least = u.min(v).min(1.0 - u - v);
        prop_assume!(least.abs() > 1e-3);
        // The corners 0, p, q, displaced so that the ray passes through u p + v q.
        let through = along(o, t, d);
        let base = minus(minus(through, times(p, u)), times(q, v));
        let corners = [base, plus(base, p), plus(base, q)];
        let normal = cross(p, q);
        prop_assume!(length(normal) > 0.1 && dot(unit_of(normal), d).abs() > 0.01);
        let found = ray(o, d).first_hit(corners.map(point));
        if least > 0.0 {
            check(found, o, d, t, unit_of(normal));
        } else {
            prop_assert_eq!(found, None);
        }
        let reversed = [corners[0], corners[2], corners[1]].map(point);
        prop_assert_eq!(ray(o, d).first_hit(reversed).map(|hit| hit.side() == Side::Back), found.map(|hit| hit.side() == Side::Front));
        prop_assert_eq!(ray(o, times(d, -1.0)).first_hit(corners.map(point)), None);
    }

    #[test]
    fn rays_through_the_edges_and_corners_of_a_mesh_hit_it(
        o in vector(1.0), middle in vector(0.3), heights in prop::array::uniform6(-0.5..0.5_f64), share in 0.0..1.0_f64
    ) {
        // A fan of six triangles, seen from above; rays through its spokes and its centre.
        let origin = plus(o, [0.0, 0.0, 8.0]);
        let rim: Vec<Vector> = (0..6)
            .map(|k| {
                let angle = k as f64 * std::f64::consts::FRAC_PI_3;
                [2.0 * angle.cos(), 2.0 * angle.sin(), heights[k]]
            })
            .collect();
        for k in 0..6 {
            for share in [0.0, share] {
                let target = plus(times(middle, 1.0 - share), times(rim[k], share));
                let ray = Ray::through(point(origin), point(target)).expect("apart");
                let hits = (0..6).filter(|&i| {
                    let corners = [middle, rim[i], rim[(i + 1) % 6]].map(point);
                    ray.first_hit(corners).is_some()
                });
                prop_assert!(hits.count() >= 1, "through the gap at {target:?}");
            }
        }
    }

    #[test]
    fn a_mirror_and_glass_send_rays_on_by_the_laws_of_optics(
        o in vector(5.0), d in unit(), n in unit(), t in 0.1..10.0_f64, ratio in 0.3..3.0_f64
    ) {
        prop_assume!(dot(n, d).abs() > 1e-3);
        let incoming = ray(o, d);
        let hit = incoming.first_hit(plane(along(o, t, d), n)).expect("a hit");
        let facing = times(n, -dot(n, d).signum());
        let reflected = incoming.reflect(&hit);
        prop_assert_eq!(reflected.origin(), hit.point);
        near_vector(reflected.direction().vector(), along(d, -2.0 * dot(d, n), n), 1e-14);
        // The sines are those of Snell's law, and all three directions lie in one plane.
        let sine = length(cross(d, n));
        match incoming.refract(&hit, ratio) {
            None => prop_assert!(ratio * sine > 1.0 - 1e-12),
            Some(refracted) => {
                let e = refracted.direction().vector();
                near(length(e), 1.0, 1e-14);
                near(length(cross(e, n)), ratio * sine, 1e-7);
                near(dot(e, cross(d, n)), 0.0, 1e-13);
                prop_assert!(dot(e, facing) <= 0.0 && dot(cross(e, n), cross(d, n)) >= 0.0);
            }
        }
    }

    #[test]
    fn a_moved_ray_hits_the_moved_surface(
        o in vector(3.0), d in unit(), c in vector(3.0), r in 0.5..3.0_f64,
        axis in unit(), angle in -3.0..3.0_f64, t in vector(4.0), factor in 0.2..5.0_f64, n in unit(),
    ) {
        let foot = along(o, dot(minus(c, o), d), d);
        prop_assume!((length(minus(foot, c)) - r).abs() > 1e-2);
        let rotor = Rotor::from_axis_angle(axis, angle).expect("an axis");
        let motor: Motor<f64> = Translator::from_displacement(t) * rotor;
        let similarity = Similarity::from_parts(t, rotor, factor).expect("a similarity");
        let (ball, beam) = (sphere(c, r), ray(o, d));
        let moved = motor.transform(beam);
        near_vector(moved.origin().coordinates(), plus(rotated(axis, angle, o), t), 1e-13);
        near_vector(moved.direction().vector(), rotated(axis, angle, d), 1e-14);
        let scaled = similarity.transform(beam);
        near_vector(scaled.origin().coordinates(), plus(times(rotated(axis, angle, o), factor), t), 1e-12);
        near_vector(scaled.direction().vector(), rotated(axis, angle, d), 1e-14);
        prop_assert_eq!(rotor.transform(beam).direction(), moved.direction());

        let expected = beam.first_hit(ball);
        let (rigid, larger) = (moved.first_hit(motor.transform(ball)), scaled.first_hit(similarity.transform(ball)));
        prop_assert_eq!(rigid.is_some(), expected.is_some());
        prop_assert_eq!(larger.is_some(), expected.is_some());
        if let (Some(hit), Some(rigid), Some(larger)) = (expected, rigid, larger) {
            near(rigid.distance, hit.distance, 1e-10);
            near(larger.distance, hit.distance * factor, 1e-9);
        }
        // Mirror image of ray and sphere.
        let mirror = plane(t, n);
        let image = beam.reflect_in(mirror).expect("an image");
        near_vector(image.direction().vector(), along(d, -2.0 * dot(d, n), n), 1e-13);
        let seen = image.first_hit(ball.reflect_in(mirror).expect("an image"));
        prop_assert_eq!(seen.is_some(), expected.is_some());
        if let (Some(hit), Some(seen)) = (expected, seen) {
            near(seen.distance, hit.distance, 1e-9);
            prop_assert_eq!(seen.side(), hit.side());
        }
    }

    #[test]
    fn a_ray_is_a_line_and_where_it_begins(o in vector(5.0), q in vector(5.0), t in -9.0..9.0_f64, p in vector(5.0)) {
        prop_assume!(length(minus(q, o)) > 0.1);
        let ray = Ray::through(point(o), point(q)).expect("apart");
        let d = unit_of(minus(q, o));
        near_vector(ray.direction().vector(), d, 1e-15);
        near_vector(ray.at(t).coordinates(), along(o, t, d), 1e-14);
        near(ray.line().distance(point(q)).expect("a line"), 0.0, 1e-13);
        near_vector(ray.line().direction(), d, 1e-15);
        near(ray.depth(point(p)), dot(minus(p, o), d), 1e-13);
        prop_assert_eq!(ray.advance(t), Ray::new_unchecked(ray.at(t), ray.direction()));
        prop_assert_eq!(ray.origin(), point(o));
        // By array, vector or direction.
        prop_assert_eq!(Ray::new(point(o), Direction::from_vector(d)), Ray::new(point(o), d));
    }
}

#[test]
fn rays_in_lanes_go_as_each_of_them_does() {
    let mut random = SplitMix64(21);
    let mut hits = 0;
    for _ in 0..2_000 {
        let single: [_; 4] = std::array::from_fn(|_| {
            let (o, d) = (random.vector(4.0), random.axis());
            let (c, r) = (random.vector(3.0), 2.0 * random.unit());
            let wall = plane(random.vector(3.0), random.axis());
            (ray(o, d), sphere(c, r) * -2.0, wall)
        });
        let of =
            |read: &dyn Fn(usize) -> f64| Lanes::<f64, 4>::from_array(std::array::from_fn(read));
        let vector = |read: &dyn Fn(usize) -> Vector| [0, 1, 2].map(|k| of(&|lane| read(lane)[k]));
        let rays = Ray::new_unchecked(
            Point::from(vector(&|lane| single[lane].0.origin().coordinates())),
            Direction::from_vector(vector(&|lane| single[lane].0.direction().vector())),
        );
        let ball = Sphere::new(
            of(&|lane| single[lane].1.weight),
            Point::from(vector(&|lane| single[lane].1.centre.coordinates())),
            of(&|lane| single[lane].1.radius_squared),
        );
        let wall = Plane::new(
            of(&|lane| single[lane].2.e123i),
            of(&|lane| single[lane].2.e12oi),
            of(&|lane| single[lane].2.e13oi),
            of(&|lane| single[lane].2.e23oi),
        );
        let (is_hit, ends) = rays.sphere_distances(ball);
        let (crosses, distance) = rays.plane_distance(wall);
        for (lane, (ray, ball, wall)) in single.into_iter().enumerate() {
            let both = ray.entry_and_exit(ball);
            assert_eq!(is_hit.to_array()[lane], both.is_some());
            let expected = both.map_or([0.0; 2], |both| both.map(|hit| hit.distance));
            for k in 0..2 {
                near(ends[k].to_array()[lane], expected[k], 1e-6);
            }
            hits += usize::from(both.is_some());
            assert!(crosses.to_array()[lane]);
            let found = distance.to_array()[lane];
            match ray.first_hit(wall) {
                Some(hit) => near(found / hit.distance, 1.0, 1e-13),
                None => assert!(found <= 0.0),
            }
        }
    }
    assert!(hits > 500, "{hits}");
}

#[test]
fn surfaces_may_be_of_one_list() {
    use ga_runtime::geometry::ray::Surface;
    let ball = Sphere::from_centre_radius(Point::new(0.0, 0.0, 4.0), 1.0);
    let floor = Plane::from_point_normal(Point::new(0.0, 0.0, 9.0), [0.0, 0.0, 1.0]);
    let triangle = [[-9.0, -9.0, 2.0], [9.0, -9.0, 2.0], [0.0, 9.0, 2.0]].map(Point::from);
    let surfaces: [&dyn Surface<f64>; 3] = [&ball, &floor, &triangle];
    let ray = Ray::new(Point::default(), [0.0, 0.0, 1.0]).expect("a direction");
    let distances = surfaces.map(|surface| ray.first_hit(surface).map(|hit| hit.distance));
    assert_eq!(distances, [Some(3.0), Some(9.0), Some(2.0)]);
}

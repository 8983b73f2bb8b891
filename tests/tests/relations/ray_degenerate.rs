//! Rays where there is no hit, almost none, or no sensible input, and rays far from the origin.

use ga_runtime::cga3::{Circle, DualSphere, Plane, Point, Rotor, Sphere, Translator};
use ga_runtime::geometry::ray::{Hit, Ray, Side};
use ga_runtime::geometry::relation::Figure;
use ga_runtime::vga3::Vector;
use nullcone_tests::random::SplitMix64;
use proptest::prelude::*;

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray<f64> {
    Ray::new(Point::from(origin), direction).expect("a direction")
}

#[test]
fn rays_without_a_direction_do_not_exist() {
    let p = Point::new(1.0, 2.0, 3.0);
    assert_eq!(Ray::through(p, p), None);
    assert_eq!(Ray::new(p, [0.0; 3]), None);
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(Ray::new(p, [1.0, bad, 0.0]), None);
        assert_eq!(Ray::new(Point::new(0.0, bad, 0.0), [1.0, 0.0, 0.0]), None);
    }
    // Directions of any size are directions.
    for size in [5e-324, 1e-300, 1e300] {
        let ray = Ray::new(p, [0.0, size, 0.0]).expect("a direction");
        assert_eq!(ray.direction().vector(), [0.0, 1.0, 0.0]);
    }
}

#[test]
fn a_ray_that_touches_a_sphere_hits_it() {
    let ball = Sphere::from_centre_radius(Point::new(4.0, 0.0, 0.0), 1.0);
    let touching = ray([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]);
    let hit = touching.first_hit(ball).expect("a hit");
    assert_eq!((hit.distance, hit.side()), (4.0, Side::Front));
    assert_eq!(hit.normal.vector(), [0.0, 1.0, 0.0]);
    assert_eq!(touching.entry_and_exit(ball), Some([hit, hit]));
    let beside = ray([0.0, 1.0 + 1e-15, 0.0], [1.0, 0.0, 0.0]);
    assert_eq!(beside.first_hit(ball), None);
}

#[test]
fn a_ray_hits_nothing_where_it_begins() {
    let ball = Sphere::from_centre_radius(Point::default(), 1.0);
    let (outwards, inwards) = (
        ray([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ray([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]),
    );
    assert_eq!(outwards.first_hit(ball), None);
    let through = inwards.first_hit(ball).expect("the other side");
    assert_eq!((through.distance, through.side()), (2.0, Side::Back));
    let [enters, leaves] = ray([3.0, 0.0, 0.0], [1.0, 0.0, 0.0])
        .entry_and_exit(ball)
        .expect("the line crosses the sphere");
    assert_eq!((enters.distance, leaves.distance), (-4.0, -2.0));

    let wall = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
    assert_eq!(ray([5.0, 0.0, 0.0], [0.0, 0.6, 0.8]).first_hit(wall), None);
    // Parallel to the plane, above it and within it.
    assert_eq!(ray([0.0, 0.0, 2.0], [1.0, 0.0, 0.0]).first_hit(wall), None);
    assert_eq!(ray([0.0, 0.0, 0.0], [1.0, 0.0, 0.0]).first_hit(wall), None);
}

#[test]
fn a_disc_contains_its_rim() {
    let disc = Circle::from_centre_normal_radius(Point::default(), [0.0, 0.0, 1.0], 2.0)
        .expect("a circle");
    let down = |x: f64| ray([x, 0.0, 1.0], [0.0, 0.0, -1.0]).first_hit(disc);
    assert!(down(2.0).is_some() && down(2.0 + 1e-15).is_none() && down(0.0).is_some());
    // Any weight: circles through points very close together, or very far apart.
    for size in [1e-40, 1e-9, 1e9, 1e40] {
        let rim = [[size, 0.0, 0.0], [0.0, size, 0.0], [-size, 0.0, 0.0]].map(Point::from);
        let disc = Circle::through(rim[0], rim[1], rim[2]);
        let down = |x: f64| ray([x * size, 0.0, size], [0.0, 0.0, -1.0]).first_hit(disc);
        let hit = down(0.9).unwrap_or_else(|| panic!("no hit at size {size:e}"));
        assert_eq!((hit.distance, hit.side()), (size, Side::Front));
        assert_eq!(hit.normal.vector(), [0.0, 0.0, 1.0]);
        assert_eq!(down(1.1), None);
    }
}

#[test]
fn weight_and_size_do_not_matter() {
    let beam = |size: f64| ray([0.0, 0.0, -5.0 * size], [0.0, 0.0, 1.0]);
    let scaled = |size: f64| Sphere::from_centre_radius(Point::default(), size);
    let wall = Plane::from_point_normal(Point::new(0.0, 0.0, -1.0), [0.0, 0.0, 1.0]);
    let check = |hit: Option<Hit<f64>>, size: f64, text: String| {
        let hit = hit.unwrap_or_else(|| panic!("no hit, {text}"));
        assert!((hit.distance / size - 4.0).abs() < 1e-15, "{text}: {hit:?}");
        let [x, y, z] = hit.normal.vector();
        assert!(
            x == 0.0 && y == 0.0 && (z + 1.0).abs() < 1e-15,
            "{text}: {hit:?}"
        );
    };
    for weight in [1e-300, 1e-200, 1e-12, 1e-9, 1e9, 1e12, 1e200, 1e300] {
        for weight in [weight, -weight] {
            let text = format!("weight {weight:e}");
            check(beam(1.0).first_hit(scaled(1.0) * weight), 1.0, text.clone());
            check(beam(1.0).first_hit(wall * weight), 1.0, text);
        }
    }
    for size in [1e-150, 1e-12, 1e-9, 1e9, 1e12, 1e150] {
        check(
            beam(size).first_hit(scaled(size)),
            size,
            format!("size {size:e}"),
        );
    }
}

#[test]
fn figures_without_a_surface_are_missed() {
    let beam = ray([0.0, 0.0, -5.0], [0.0, 0.0, 1.0]);
    let centre = Point::default();
    assert_eq!(
        beam.first_hit(Sphere::from_centre_radius(centre, 0.0)),
        None
    );
    let imaginary = Sphere::from_centre_radius_squared(centre, -1.0);
    assert_eq!(beam.first_hit(imaginary), None);
    assert_eq!(beam.entry_and_exit(imaginary), None);
    let normal = [0.0, 0.0, 1.0];
    let imaginary = Circle::from_centre_normal_radius_squared(centre, normal, -1.0);
    assert_eq!(beam.first_hit(imaginary.expect("a circle")), None);
    // Collinear points: as triangle, as circle and as plane.
    let [p, q, r] = [[0.0, -1.0, 0.0], [0.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(Point::from);
    assert_eq!(beam.first_hit([p, q, r]), None);
    assert_eq!(beam.first_hit([q, q, r]), None);
    assert_eq!(beam.first_hit(Circle::through(p, q, r)), None);
    assert_eq!(beam.first_hit(Plane::through(p, q, r)), None);
    assert_eq!(beam.first_hit(Sphere::default()), None);
    assert_eq!(beam.entry_and_exit(Sphere::default()), None);
    // A triangle seen from its edge.
    let edgewise = [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.0]].map(Point::from);
    assert_eq!(beam.first_hit(edgewise), None);
    let zero = Vector::default();
    let figures = [
        Figure::Point(zero),
        Figure::PointPair([zero, zero]),
        Figure::Line {
            point: zero,
            direction: Vector::new(0.0, 0.0, 1.0),
        },
    ];
    for figure in figures {
        assert_eq!(beam.first_hit(figure), None);
    }
}

#[test]
fn total_reflection_and_ratios_that_are_not_positive_give_no_ray() {
    let wall = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
    let beam = ray([-3.0, 0.0, 4.0], [0.6, 0.0, -0.8]);
    let hit = beam.first_hit(wall).expect("a hit");
    for ratio in [2.0, 0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(beam.refract(&hit, ratio), None, "{ratio}");
    }
    // Without a change of medium the ray goes straight on.
    let through = beam.refract(&hit, 1.0).expect("a ray");
    let change = Vector::from(through.direction()) - Vector::from(beam.direction());
    assert!(change.length() < 1e-15);
}

/// Whether all numbers of a hit are finite, its distance positive and its normal of length 1.
fn is_sound<S: Into<f64> + ga_runtime::scalar::Real<Mask = bool>>(hit: Hit<S>) -> bool {
    let numbers = [hit.point.coordinates(), hit.normal.vector()].map(|v| v.map(Into::into));
    let [_, normal] = numbers;
    let length: f64 = normal.iter().map(|x: &f64| x * x).sum::<f64>().sqrt();
    numbers.as_flattened().iter().all(|x| x.is_finite())
        && hit.distance.into() > 0.0
        && (length - 1.0).abs() < 1e-6
}

/// Numbers of every kind: ordinary ones, very large and very small ones, zero, infinity and NaN.
fn wild(random: &mut SplitMix64) -> f64 {
    match random.bits() % 8 {
        0 => 0.0,
        1 => [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, 5e-324]
            [random.bits() as usize % 5],
        2 => random.finite(),
        3 => random.within(1.0) * 1e150,
        _ => random.within(3.0),
    }
}

#[test]
fn hits_are_sound_whatever_the_numbers() {
    let mut random = SplitMix64(10);
    let (mut rays, mut hits) = (0, 0);
    while rays < 200_000 {
        let mut vector = || -> [f64; 3] { std::array::from_fn(|_| wild(&mut random)) };
        let (origin, direction) = (Point::from(vector()), vector());
        let [a, b, c] = [(); 3].map(|()| Point::from(vector()));
        let [normal, [r, w, ..]] = [(); 2].map(|()| vector());
        let Some(ray) = Ray::new(origin, direction) else {
            continue;
        };
        rays += 1;
        let sphere = Sphere::from_centre_radius(a, r) * w;
        let found = [
            ray.first_hit(sphere),
            ray.first_hit(DualSphere::new(w, Point::new(a.e1(), b.e1(), c.e1()), r)),
            ray.first_hit(Plane::from_point_normal(a, normal)),
            ray.first_hit(Circle::through(a, b, c)),
            ray.first_hit([a, b, c]),
        ];
        for hit in found.into_iter().flatten() {
            assert!(is_sound(hit), "{ray:?} gives {hit:?}");
            hits += 1;
            for next in [Some(ray.reflect(&hit)), ray.refract(&hit, w)]
                .into_iter()
                .flatten()
            {
                let d = Vector::from(next.direction());
                assert!((d.length() - 1.0).abs() < 1e-6, "{next:?}");
            }
        }
        for end in ray.entry_and_exit(sphere).into_iter().flatten() {
            assert!(end.distance.is_finite() && Vector::from(end.point).is_finite());
            assert!(
                (Vector::from(end.normal).length() - 1.0).abs() < 1e-6,
                "{end:?}"
            );
        }
    }
    assert!(hits > 10_000, "only {hits} hits");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// In single precision, at 10⁴ from the origin, a ray that begins nearby is as accurate as the
    /// coordinates of the surface allow.
    #[test]
    fn far_from_the_origin_nothing_is_lost(
        place in prop::array::uniform3(-1e4..1e4_f32), d in prop::array::uniform3(-1.0..1.0_f32),
        t in 0.5..5.0_f32, u in prop::array::uniform3(-1.0..1.0_f32), r in 0.5..2.0_f32,
    ) {
        let (Some(d), Some(u)) = (Vector::from(d).normalized(), Vector::from(u).normalized()) else {
            return Ok(());
        };
        prop_assume!(d.dot(u).abs() > 0.1);
        let origin = Vector::from(place);
        let ray = Ray::new(origin.into(), d).expect("a direction");
        let spacing = 1e4 * f32::EPSILON;

        // A triangle about the point at distance t, perpendicular to u.
        let through = origin + d * t;
        let side = u.cross(Vector::new(-u.e2, u.e3, u.e1));
        prop_assume!(side.length() > 0.1);
        let side = side.normalized().expect("a direction");
        let corners = [side * 2.0, u.cross(side) * 2.0 - side, u.cross(side) * -2.0 - side].map(|v| through + v);
        let hit = ray.first_hit(corners.map(Point::from)).expect("a hit");
        prop_assert!((hit.distance - t).abs() < 40.0 * spacing, "{} is not {t}", hit.distance);

        // A sphere by its radius; as a blade it does not determine that radius here.
        let u = if d.dot(u) < 0.0 { u } else { -u };
        let figure = Figure::Sphere { centre: through - u * r, radius: r };
        let hit = ray.first_hit(figure).expect("a hit");
        prop_assert!((hit.distance - t).abs() < 40.0 * spacing, "{} is not {t}", hit.distance);
        prop_assert!((Vector::from(hit.normal) - u).length() < 40.0 * spacing / r);
        prop_assert!((Vector::from(hit.normal).length() - 1.0).abs() < 4.0 * f32::EPSILON);
    }

    /// A small sphere seen from far away: its radius is not lost beside the distance.
    #[test]
    fn small_spheres_far_away_are_hit(d in prop::array::uniform3(-1.0..1.0_f32), share in 0.0..2.0_f32) {
        let Some(d) = Vector::from(d).normalized() else { return Ok(()) };
        prop_assume!((share - 1.0).abs() > 0.1);
        let centre = Point::default();
        let ball = Sphere::from_centre_radius(centre, 0.05_f32);
        let side = d.cross(Vector::new(-d.e2, d.e3, d.e1));
        prop_assume!(side.length() > 0.1);
        let beside = side.normalized().expect("a direction") * (0.05 * share);
        // From 1000 away, aiming at a point beside the centre.
        let ray = Ray::new(Point::from(beside - d * 1000.0), d).expect("a direction");
        // The coordinates of the origin are rounded to 6·10⁻⁵ there, far less than the radius.
        prop_assert_eq!(ray.first_hit(ball).is_some(), share < 1.0, "{}", share);
        if let Some(hit) = ray.first_hit(ball) {
            prop_assert!((hit.distance - 1000.0).abs() < 0.051);
            prop_assert!((Vector::from(hit.normal).length() - 1.0).abs() < 4.0 * f32::EPSILON);
        }
    }
}

#[test]
fn f32_and_f64_give_the_same_hits() {
    let mut random = SplitMix64(3);
    for _ in 0..10_000 {
        let origin = random.vector(4.0);
        let (direction, centre) = (random.axis(), random.vector(2.0));
        let single = |v: [f64; 3]| v.map(|x| x as f32);
        let double = |v: [f32; 3]| v.map(f64::from);
        let (origin, direction, centre) = (single(origin), single(direction), single(centre));
        let low = Ray::new(Point::from(origin), direction).expect("a direction");
        let high = Ray::new(Point::from(double(origin)), double(direction)).expect("a direction");
        let [low, high] = [
            low.first_hit(Sphere::from_centre_radius(Point::from(centre), 1.5))
                .map(|hit| f64::from(hit.distance)),
            high.first_hit(Sphere::from_centre_radius(Point::from(double(centre)), 1.5))
                .map(|hit| hit.distance),
        ];
        if let (Some(low), Some(high)) = (low, high) {
            assert!(
                (low - high).abs() < 2e-3 || high < 1e-5,
                "{low} is not {high}"
            );
        }
    }
}

#[test]
fn spheres_of_radius_zero_are_not_hit() {
    let motor = Rotor::from_axis_angle([1.0, 2.0, -3.0], 0.7).expect("an axis")
        * Translator::from_displacement([0.3, -0.7, 0.9]);
    for centre in [[0.1, 0.2, 0.3], [-7.3, 0.9, 1e3], [1e-4, 3e-5, 0.7]] {
        let point = Sphere::from_centre_radius(Point::from(centre), 0.0);
        let small = Sphere::from_centre_radius(Point::from(centre), 1e-4 * (1.0 + centre[2]));
        let images = [
            (point, small, Point::from(centre)),
            (
                motor.transform(point),
                motor.transform(small),
                motor.transform(Point::from(centre)),
            ),
        ];
        for (point, small, centre) in images {
            for weight in [1.0, -3.0, 1e-20, 1e20] {
                let (point, small) = (point * weight, small * weight);
                for direction in [[1.0, 0.0, 0.0], [0.3, -0.5, 0.2], [0.0, 1.0, 1.0]] {
                    let ray = ray(centre.coordinates(), direction).advance(-2.0);
                    assert_eq!(ray.first_hit(point), None);
                    assert_eq!(ray.first_hit(point.dual()), None);
                    assert_eq!(ray.entry_and_exit(point), None);
                    assert_eq!(ray.sphere_distances(point), (false, [0.0; 2]));
                    // A sphere whose radius is above the rounding is.
                    assert!(ray.first_hit(small).is_some() && ray.entry_and_exit(small).is_some());
                }
            }
        }
    }
}

//! Nearest points, reflections and inversions against plain formulas and the dense algebra.

use ga_runtime::cga3::{Direction, DualPlane, Infinity, Point, RoundVector};
use ga_runtime::geometry::relation::RoundOrFlat::{Flat, Round};
use nullcone_tests::plain::*;
use proptest::prelude::*;

/// The projection of a point onto a flat is a round vector; this is its centre.
fn centre_of_part(p: Vector, flat: &ga_runtime::dense::Multivector<f64>) -> Vector {
    let x = dense(&point(p));
    let part = &(&x | flat) * &flat.inverse().expect("not null");
    let weight = part.coefficient(0b1000);
    [1, 2, 4].map(|blade| part.coefficient(blade) / weight)
}

fn place(p: Option<Point<f64>>) -> Vector {
    p.expect("a point").coordinates()
}

proptest! {
    #[test]
    fn points(p in vector(5.0), q in vector(5.0), n in unit(), r in 0.1..4.0_f64, weight in 0.1..9.0_f64) {
        let x = point(p);
        let from = minus(p, q);
        let (l, e) = (line(q, n.map(|x| x * weight)), plane(q, n.map(|x| -x * weight)));
        let foot = along(q, dot(from, n), n);
        near_vector(place(x.project_onto(l)), foot, 1e-13);
        near_vector(centre_of_part(p, &dense(&l)), foot, 1e-11);
        near_vector(x.reject_from(l).unwrap().vector(), minus(p, foot), 1e-13);
        let foot = along(p, -dot(from, n), n);
        near_vector(place(x.project_onto(e)), foot, 1e-13);
        near_vector(centre_of_part(p, &dense(&e)), foot, 1e-11);
        near_vector(x.reject_from(e).unwrap().vector(), minus(p, foot), 1e-13);
        prop_assume!(length(from) > 1e-2);
        let foot = along(q, r / length(from), from);
        near_vector(place(x.project_onto(sphere(q, r))), foot, 1e-12);
        near_vector(place((x ^ Infinity).project_onto(sphere(q, r))), foot, 1e-11);
        // An end of the point pair in which the line through the centre meets the sphere.
        let ends = dense(&(point(q) ^ x ^ Infinity)).vee(&dense(&sphere(q, r)));
        let on = ends.wedge(&dense(&point(foot)));
        prop_assert!(on.coefficients().iter().all(|c| c.abs() < 1e-8));
        let flat = along(from, -dot(from, n), n);
        prop_assume!(length(flat) > 1e-2);
        let foot = along(q, r / length(flat), flat);
        near_vector(place(x.project_onto(circle(q, n, r))), foot, 1e-11);
        near_vector(x.reject_from(circle(q, n, r)).unwrap().vector(), minus(p, foot), 1e-11);
        // The projection is the nearest point.
        near(length(minus(p, foot)), x.distance_to(circle(q, n, r)).unwrap(), 1e-12);
    }

    #[test]
    fn directions(v in vector(5.0), q in vector(5.0), n in unit()) {
        let d = Direction::from_vector(v);
        let part = n.map(|x| x * dot(v, n));
        near_vector(d.project_onto(line(q, n)).unwrap().vector(), part, 1e-14);
        near_vector(d.reject_from(line(q, n)).unwrap().vector(), minus(v, part), 1e-14);
        near_vector(d.project_onto(plane(q, n)).unwrap().vector(), minus(v, part), 1e-14);
        near_vector(d.reject_from(plane(q, n)).unwrap().vector(), part, 1e-14);
        near_vector(d.project_onto(circle(q, n, 2.0)).unwrap().vector(), minus(v, part), 1e-12);
    }

    #[test]
    fn lines(p in vector(5.0), d in unit(), q in vector(5.0), n in unit(), r in 0.1..4.0_f64) {
        let slope = dot(d, n);
        prop_assume!(slope.abs() > 0.05 && slope.abs() < 0.99);
        let (l, e) = (line(p, d), plane(q, n));
        let image = l.project_onto(e).unwrap();
        let foot = |t: f64| place(point(along(p, t, d)).project_onto(e));
        near_vector(image.direction(), unit_of(minus(foot(1.0), foot(0.0))), 1e-12);
        near(image.distance(point(foot(0.0))).unwrap(), 0.0, 1e-12);
        let rest = l.reject_from(e).unwrap();
        near_vector(rest.direction(), n.map(|x| x * slope.signum()), 1e-13);
        // The algebra splits the line into the same two parts.
        let (x, flat) = (dense(&l), dense(&e));
        let part = &(&x | &flat) * &flat.inverse().unwrap();
        positive_multiple(&dense(&image), &part, 1e-11);
        positive_multiple(&dense(&rest), &(&x - &part), 1e-11);
        // A great circle: its plane contains the line and the centre, and its direction is that of
        // the line.
        let below = l.great_circle_on(sphere(q, r));
        let arm = minus(p, q);
        prop_assume!(length(cross(arm, d)) > 0.1);
        let below = below.unwrap();
        near_vector(below.centre().unwrap().coordinates(), q, 1e-11);
        near(below.radius().unwrap(), r, 1e-9);
        near_vector(below.unit_normal().unwrap(), unit_of(cross(arm, d)), 1e-11);
        let by_algebra = dense(&sphere(q, r)).vee(&dense(&point(q)).wedge(&x));
        positive_multiple(&dense(&below), &by_algebra, 1e-9);
    }

    /// Reflections of every element in a plane, line and point, against the odd and even versors of
    /// the dense algebra.
    #[test]
    fn reflections(p in vector(3.0), q in vector(3.0), s in vector(3.0), d in unit(), n in unit(), c in vector(3.0), r in 0.1..3.0_f64) {
        let (e, l, o) = (plane(c, n.map(|x| -2.0 * x)), line(c, n.map(|x| 3.0 * x)), point(c));
        // By coordinates.
        let from = minus(p, c);
        let in_plane = along(p, -2.0 * dot(from, n), n);
        let in_line = along(c, 1.0, minus(n.map(|x| 2.0 * dot(from, n) * x), from));
        near_vector(place(point(p).reflect_in(e)), in_plane, 1e-13);
        near_vector(place(point(p).reflect_in(l)), in_line, 1e-13);
        near_vector(place(point(p).reflect_in(o)), along(c, -1.0, from), 1e-13);
        near_vector(place(point(p).reflect_in(o ^ Infinity)), along(c, -1.0, from), 1e-13);
        // By versors, with weights and orientations.
        let unit = |m: ga_runtime::dense::Multivector<f64>| { let size = m.norm_squared().abs().sqrt(); m.scale(1.0 / size) };
        let versors = [unit(dense(&e).dual()), unit(dense(&l).dual()), unit(dense(&(o ^ Infinity)).dual())];
        macro_rules! check {
            ($($element:expr),*) => {$({
                let element = $element;
                let images = [element.reflect_in(e), element.reflect_in(l), element.reflect_in(o)];
                for (image, versor) in images.into_iter().zip(&versors) {
                    let expected = versor.transform(&dense(&element)).unwrap();
                    near_dense(&dense(&image.unwrap()), &expected, 1e-11);
                }
                let again = element.reflect_in(e).unwrap().reflect_in(e).unwrap();
                near_dense(&dense(&again), &dense(&element), 1e-11);
            })*};
        }
        check!(
            point(p), point(p) ^ Infinity, pair(p, q), Direction::from_vector(p), line(p, d), plane(p, d), circle(p, d, r), sphere(p, r),
            RoundVector::dual_sphere(point(p), r), DualPlane::from_normal_distance(d, r),
            point(p) ^ point(q) ^ point(s)
        );
        // The plane through three of its points, moved.
        let three = [p, q, s].map(point);
        let moved = three.map(|x| x.reflect_in(e).unwrap());
        let image = (three[0] ^ three[1] ^ three[2] ^ Infinity).reflect_in(e).unwrap();
        near_dense(&dense(&image), &dense(&(moved[0] ^ moved[1] ^ moved[2] ^ Infinity)), 1e-11);
    }

    #[test]
    fn inversions(p in vector(3.0), q in vector(3.0), s in vector(3.0), d in unit(), c in vector(3.0), r in 0.5..3.0_f64, size in 0.1..3.0_f64) {
        let (mirror, t) = (sphere(c, r) * -2.0, tolerance());
        prop_assume!(length(minus(p, c)) > 0.3 && length(minus(q, c)) > 0.3);
        let from = minus(p, c);
        let image = along(c, r * r / dot(from, from), from);
        near_vector(place(point(p).invert_in(mirror, t)), image, 1e-11);
        let dual = dense(&mirror).dual();
        macro_rules! check {
            ($($element:expr),*) => {$({
                let element = $element;
                let image = element.invert_in(mirror, t);
                let Some(Round(image)) = image else { panic!("{image:?}") };
                near_dense(&dense(&image), &dual.transform(&dense(&element)).unwrap(), 1e-9);
            })*};
        }
        check!(point(p) ^ Infinity, pair(p, q));
        // Far enough from the centre that the images are not nearly flat.
        let away = |x: f64| x > 0.1;
        prop_assume!(away(point(c).distance_to(line(p, d)).unwrap()) && away(point(c).distance_to(plane(p, d)).unwrap()));
        prop_assume!(away(point(c).distance_to(circle(p, d, size)).unwrap()) && away(point(c).distance_to(sphere(p, size)).unwrap()));
        check!(line(p, d), plane(p, d), circle(p, d, size), sphere(p, size));

        // Elements through the centre become flats, which are spanned by the images of their
        // points.
        let arm = unit_of(cross(d, s));
        prop_assume!(length(cross(d, s)) > 0.1);
        let image_of = |x: Vector| point(x).invert_in(mirror, t).unwrap();
        let through = sphere(along(c, size, d), size);
        let Some(Flat(flat)) = through.invert_in(mirror, t) else { panic!("not flat") };
        for u in [d, arm, cross(d, arm)] {
            let x = along(along(c, size, d), size, u);
            prop_assert!(image_of(x).distance_to(flat).unwrap() < 1e-9);
        }
        let ring = circle(along(c, size, d), arm, size);
        let Some(Flat(flat)) = ring.invert_in(mirror, t) else { panic!("not flat") };
        prop_assert!(image_of(along(c, 2.0 * size, d)).distance_to(flat).unwrap() < 1e-9);
        prop_assert!(image_of(along(along(c, size, d), size, cross(d, arm))).distance_to(flat).unwrap() < 1e-9);
        let Some(Flat(flat)) = pair(c, p).invert_in(mirror, t) else { panic!("not flat") };
        near_vector(place(flat.to_point()), image, 1e-9);
        // Flats through the centre stay.
        let Some(Flat(same)) = line(c, d).invert_in(mirror, t) else { panic!("not flat") };
        prop_assert!(same.coincides_with(line(c, d), t));
        let Some(Flat(same)) = plane(c, d).invert_in(mirror, t) else { panic!("not flat") };
        prop_assert!(same.coincides_with(plane(c, d), t));
    }
}

#[test]
fn where_no_point_is_nearest() {
    let o = point(O);
    assert_eq!(o.project_onto(sphere(O, 1.0)), None);
    assert_eq!(o.reject_from(sphere(O, 1.0)), None);
    assert_eq!(o.project_onto(circle(O, Z, 1.0)), None);
    assert_eq!(point([0.0, 0.0, 7.0]).project_onto(circle(O, Z, 1.0)), None);
    // A point that differs from the axis only by rounding counts as lying on it.
    assert_eq!(
        point([1e-17, 0.0, 7.0]).project_onto(circle(O, Z, 1.0)),
        None
    );
    assert_eq!(
        o.project_onto(pair([0.0, 1.0, 0.0], [0.0, -1.0, 0.0])),
        None
    );
    assert_eq!(
        o.project_onto(pair([0.0, 1.0, 0.0], [0.0, -3.0, 0.0]))
            .map(Point::coordinates),
        Some(Y)
    );
    assert_eq!(line(O, Z).project_onto(plane(O, Z)), None);
    assert_eq!(line(O, X).reject_from(plane(O, Z)), None);
    assert_eq!(
        line(O, X).great_circle_on(sphere([4.0, 0.0, 0.0], 1.0)),
        None
    );
    // A sphere or circle of radius zero has one point.
    assert_eq!(o.project_onto(sphere(O, 0.0)), Some(o));
    assert_eq!(point(X).project_onto(circle(O, Z, 0.0)), Some(o));
    // A line in the plane is its own projection.
    let within = line([0.0, 2.0, 0.0], X);
    assert_eq!(within.project_onto(plane(O, Z)), Some(within));
}

#[test]
fn where_nothing_can_be_inverted() {
    let t = tolerance();
    let p = point(X);
    assert_eq!(p.invert_in(sphere(X, 1.0), t), None);
    assert_eq!(p.invert_in(sphere([1.0 + 1e-10, 0.0, 0.0], 1.0), t), None);
    assert_eq!(p.invert_in(sphere(O, 0.0), t), None);
    assert_eq!(p.invert_in(sphere_of_square(O, -1.0), t), None);
    assert_eq!(line(X, Y).invert_in(sphere(O, 0.0), t), None);
    assert_eq!(line(X, O).invert_in(sphere(O, 1.0), t), None);
    assert_eq!(sphere_of_square(X, -1.0).invert_in(sphere(O, 1.0), t), None);
    // A sphere of weight zero has no centre.
    assert_eq!(p.invert_in(sphere(O, 1.0) * 0.0, t), None);
    // A sphere about the centre is mapped to a sphere about it.
    match sphere(O, 2.0).invert_in(sphere(O, 1.0), t) {
        Some(Round(image)) => assert_eq!(image.radius(), Some(0.5)),
        other => panic!("{other:?}"),
    }
}

#[test]
fn bad_input() {
    let t = tolerance();
    for bad in [f64::NAN, f64::INFINITY] {
        let (p, q) = (point([bad, 0.0, 0.0]), point(Y));
        assert_eq!(
            (
                p.project_onto(plane(O, Z)),
                q.project_onto(plane([bad, 0.0, 0.0], Z))
            ),
            (None, None)
        );
        assert_eq!(
            (
                p.project_onto(sphere(O, 1.0)),
                q.project_onto(sphere(O, bad))
            ),
            (None, None)
        );
        assert_eq!(
            (p.project_onto(q), q.project_onto(p), p.reject_from(q)),
            (None, None, None)
        );
        assert_eq!(
            Direction::from_vector([bad, 0.0, 0.0]).project_onto(line(O, X)),
            None
        );
        assert_eq!(
            Direction::from_vector(X).reject_from(line(O, [bad, 0.0, 0.0])),
            None
        );
        assert_eq!(line([bad, 0.0, 0.0], Y).project_onto(plane(O, Z)), None);
        assert_eq!(
            line([0.0, 1.0, 0.0], X).great_circle_on(sphere(O, bad)),
            None
        );
        assert_eq!(q.reflect_in(p), None);
        assert_eq!(q.reflect_in(line(O, [bad, 0.0, 0.0])), None);
        assert_eq!(q.reflect_in(plane(O, [0.0, bad, 0.0])), None);
        assert_eq!(
            (
                p.invert_in(sphere(O, 1.0), t),
                q.invert_in(sphere(O, bad), t)
            ),
            (None, None)
        );
        assert_eq!(plane([bad, 0.0, 0.0], X).invert_in(sphere(O, 1.0), t), None);
    }
    // Mirrors without weight.
    let q = point(Y);
    assert_eq!(
        (q.reflect_in(line(O, O)), q.reflect_in(plane(O, O))),
        (None, None)
    );
}

/// Far from the origin, errors in single precision are of the order of the spacing of the numbers
/// there.
#[test]
fn single_precision_far_from_the_origin() {
    let spacing = f32::EPSILON * 1e4;
    let place = [10_000.0_f32, -9_000.0, 8_000.0];
    let shifted = |x: f32, y: f32, z: f32| Point::new(place[0] + x, place[1] + y, place[2] + z);
    let ground =
        ga_runtime::cga3::Plane::from_point_normal(shifted(0.0, 0.0, 0.0), [0.0, 0.6, 0.8]);
    let p = shifted(1.0, 2.0, 3.0);
    let height = 0.6 * 2.0 + 0.8 * 3.0;
    assert!((p.signed_distance_to(ground).unwrap() - height).abs() < 4.0 * spacing);
    let image = p.reflect_in(ground).unwrap();
    assert!(image.distance(shifted(1.0, 2.0 - 1.2 * height, 3.0 - 1.6 * height)) < 16.0 * spacing);
    let foot = p.project_onto(ground).unwrap();
    assert!(foot.distance(shifted(1.0, 2.0 - 0.6 * height, 3.0 - 0.8 * height)) < 8.0 * spacing);
}

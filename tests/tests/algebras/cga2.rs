//! Circles, lines, point pairs and versors of cga2.

use std::f64::consts::PI;

use ga_runtime::cga2::{
    Circle, Dilator, Direction, DualLine, Infinity, Line, Motor, MotorGenerator, Point, PointPair,
    Rotor, RoundVector, Translator,
};
use nullcone_tests::plain::near_all;
use proptest::prelude::*;

use super::plane::{length, minus, plus, rotated, times, vector};

fn coefficients(m: Motor<f64>) -> [f64; 4] {
    [m.scalar(), m.e12(), m.e1i(), m.e2i()]
}

proptest! {
    #[test]
    fn directions_displace_points(a in vector(5.0), b in vector(5.0), t in -1.0..2.0_f64) {
        let (p, v) = (Point::from(a), Direction::from(b));
        prop_assert_eq!(<[f64; 2]>::from(p + v), plus(a, b));
        prop_assert_eq!(<[f64; 2]>::from(p - v), minus(a, b));
        let mut moved = p;
        moved += v;
        prop_assert_eq!(moved, p + v);
        moved -= v;
        near_all(moved.coordinates(), a, 1e-14);
        let translated = Translator::from_displacement(b).transform(p);
        near_all((p + v).coordinates(), translated.coordinates(), 1e-14);
        let q = Point::from(b);
        prop_assert_eq!(<[f64; 2]>::from(p.to(q)), minus(b, a));
        near_all(p.lerp(q, t).coordinates(), plus(a, times(minus(b, a), t)), 1e-13);
        near_all(p.midpoint(q).coordinates(), times(plus(a, b), 0.5), 1e-14);
        prop_assert_eq!((p.lerp(q, 0.0), p.lerp(q, 1.0)), (p, q));
        prop_assert_eq!([p.x(), p.y(), v.x(), v.y()], [a[0], a[1], b[0], b[1]]);
        let w = Direction::from(a);
        prop_assert_eq!(v.dot(w), b[0] * a[0] + b[1] * a[1]);
        prop_assert_eq!(v.cross(w), b[0] * a[1] - b[1] * a[0]);
        near_all([v.length(), v.norm()], [length(b); 2], 1e-14);
        near_all(v.normalized().unwrap().vector(), times(b, 1.0 / length(b)), 1e-15);
        prop_assert_eq!((v - v).normalized(), None);
    }

    #[test]
    fn three_points_lie_on_their_circle(
        centre in vector(5.0), radius in 0.5..4.0_f64, start in -PI..PI, b in 0.5..2.5_f64, c in 0.5..2.5_f64,
    ) {
        let on = |angle: f64| Point::from(plus(centre, rotated([radius, 0.0], angle)));
        let (p, q, r) = (on(start), on(start + b), on(start + b + c));
        let circle = Circle::through(p, q, r);
        near_all(circle.centre().unwrap().coordinates(), centre, 1e-11);
        near_all([circle.radius().unwrap()], [radius], 1e-11);
        // Counterclockwise points give a positive weight, twice the area of their triangle.
        let (u, v) = (minus(q.coordinates(), p.coordinates()), minus(r.coordinates(), p.coordinates()));
        near_all([circle.e12o], [u[0] * v[1] - u[1] * v[0]], 1e-12);
        let made = Circle::from_centre_radius(Point::from(centre), radius);
        near_all(
            [made.e12o, made.e12i, made.e1oi, made.e2oi],
            [circle.e12o, circle.e12i, circle.e1oi, circle.e2oi].map(|x| x / circle.e12o),
            1e-10,
        );
        // A fourth point of the circle, and one that is not.
        near_all([(made ^ on(start - 1.0)).e12oi], [0.0], 1e-12);
        let outside = Point::from(plus(centre, [radius + 1.0, 0.0]));
        near_all([(made ^ outside).e12oi.abs()], [0.5 * (2.0 * radius + 1.0)], 1e-11);
        prop_assert_eq!(Circle::through(p, q, r), p ^ q ^ r);
        near_all([made.dual().centre().unwrap().e1(), made.dual().radius_squared().unwrap()], [centre[0], radius * radius], 1e-12);
    }

    #[test]
    fn circles_meet_in_points_of_both(
        a in vector(5.0), angle in -PI..PI, distance in 1.0..4.0_f64, share in 0.1..0.9_f64, r in 1.0..3.0_f64,
    ) {
        // The other radius is chosen so that the circles intersect.
        let b = plus(a, rotated([distance, 0.0], angle));
        let s = (distance - r).abs() + share * (distance + r - (distance - r).abs());
        let (first, second) = (
            Circle::from_centre_radius(Point::from(a), r),
            Circle::from_centre_radius(Point::from(b), s),
        );
        let [p, q] = (first & second).endpoints().unwrap().map(Point::coordinates);
        for x in [p, q] {
            near_all([length(minus(x, a)), length(minus(x, b))], [r, s], 1e-9);
        }
        // Their midpoint is the intersection of the radical axis with the line of centres.
        let along = (distance * distance + r * r - s * s) / (2.0 * distance);
        let middle = plus(a, rotated([along, 0.0], angle));
        near_all(times(plus(p, q), 0.5), middle, 1e-11);
        near_all([length(minus(p, q))], [2.0 * (r * r - along * along).sqrt()], 1e-8);
        // Disjoint ones meet in an imaginary pair.
        let far = Circle::from_centre_radius(Point::from(plus(a, rotated([distance + 10.0, 0.0], angle))), s);
        let pair = first & far;
        prop_assert_eq!(pair.endpoints(), None);
        prop_assert!(pair.radius_squared().unwrap() < 0.0);
    }

    #[test]
    fn pairs_give_back_their_points(p in vector(5.0), q in vector(5.0), weight in 0.1..9.0_f64) {
        prop_assume!(length(minus(p, q)) > 0.1);
        let pair = (Point::from(p) ^ Point::from(q)) * weight;
        let [a, b] = pair.endpoints().unwrap().map(Point::coordinates);
        near_all([a[0], a[1], b[0], b[1]], [p[0], p[1], q[0], q[1]], 1e-10);
        near_all(pair.direction(), times(minus(q, p), weight), 1e-12);
        near_all(pair.centre().unwrap().coordinates(), times(plus(p, q), 0.5), 1e-11);
        let expected = 0.25 * length(minus(p, q)).powi(2);
        near_all([pair.radius_squared().unwrap()], [expected], 1e-10);
    }

    #[test]
    fn lines_measure_and_meet(p in vector(5.0), d in vector(5.0), q in vector(5.0), angle in 0.2..2.9_f64) {
        prop_assume!(length(d) > 0.1);
        let line = Line::from_point_direction(Point::from(p), d);
        let unit = times(d, 1.0 / length(d));
        let left = rotated(unit, 0.5 * PI);
        let offset = minus(q, p);
        let height = offset[0] * left[0] + offset[1] * left[1];
        near_all([line.signed_distance(Point::from(q)).unwrap()], [height], 1e-13);
        near_all(line.foot(Point::from(q)).unwrap().coordinates(), minus(q, times(left, height)), 1e-12);
        let through = Line::through(Point::from(p), Point::from(plus(p, d)));
        near_all([through.e12i, through.e1oi, through.e2oi], [line.e12i, line.e1oi, line.e2oi], 1e-13);
        let meet = line & Line::from_point_direction(Point::from(p), rotated(d, angle));
        near_all(meet.to_point().unwrap().coordinates(), p, 1e-12);
        // The dual line has the normal of the line.
        let dual = DualLine::from_normal_distance(left, left[0] * p[0] + left[1] * p[1]).undual();
        near_all(dual.direction(), unit, 1e-13);
        near_all([dual.moment()], [p[0] * unit[1] - p[1] * unit[0]], 1e-13);
        near_all([(Infinity | line).e1i.abs(), (Infinity | line).e2i.abs()], d.map(f64::abs), 0.0);
        let normalized = line.normalized().unwrap();
        near_all(normalized.direction(), unit, 1e-14);
    }

    #[test]
    fn motors_move_as_matrices_do(angle in -6.2..6.2_f64, t in vector(5.0), x in vector(5.0), v in vector(5.0)) {
        let motor: Motor<f64> = Translator::from_displacement(t) * Rotor::from_angle(angle).unwrap();
        let image = motor.transform(Point::from(x)).coordinates();
        near_all(image, plus(rotated(x, angle), t), 1e-13);
        near_all(motor.transform(Direction::from_vector(v)).vector(), rotated(v, angle), 1e-13);
        near_all(motor.translator().displacement(), t, 1e-13);
        near_all([motor.rotor().angle()], [angle], 1e-15 * 4.0);
        let log = motor.log().unwrap();
        let conditioning = if angle.abs() > PI { 1.0 / (0.5 * angle).sin().abs() } else { 1.0 };
        near_all(coefficients(log.exp()), coefficients(motor), 1e-14 * conditioning);
        let about = Motor::about(Point::from(t), Rotor::from_angle(angle).unwrap());
        let expected = plus(t, rotated(minus(x, t), angle));
        near_all(about.transform(Point::from(x)).coordinates(), expected, 1e-13);
        if angle.abs() > 0.1 {
            let sine = (0.5 * angle).sin().abs();
            near_all(about.centre().unwrap().coordinates(), t, 1e-13 / sine);
        }
    }

    #[test]
    fn similarities_scale(angle in -3.0..3.0_f64, t in vector(5.0), factor in 0.1..10.0_f64, x in vector(5.0), r in 0.1..3.0_f64) {
        let motor = Translator::from_displacement(t) * Rotor::from_angle(angle).unwrap();
        let dilator = Dilator::from_factor(factor).unwrap();
        let similarity = motor * dilator;
        let expected = plus(rotated(times(x, factor), angle), t);
        let size = 1.0 + factor;
        let image = similarity.transform(Point::from(x));
        near_all(image.centre().unwrap().coordinates(), expected, 1e-11 * size);
        let circle = similarity.transform(Circle::from_centre_radius(Point::from(x), r));
        near_all(circle.centre().unwrap().coordinates(), expected, 1e-11 * size);
        near_all([circle.radius_squared().unwrap() / (factor * factor)], [r * r], 1e-8 * (1.0 + 1.0 / (factor * factor)));
        near_all([dilator.factor() / factor, similarity.factor() / factor], [1.0, 1.0], 1e-14);
    }

    #[test]
    fn inversion_keeps_the_product_of_distances(centre in vector(5.0), radius in 0.5..3.0_f64, x in vector(5.0)) {
        let offset = minus(x, centre);
        prop_assume!(length(offset) > 0.1);
        let mirror = RoundVector::dual_circle(Point::from(centre), radius * radius);
        let image = mirror.sandwich(Point::from(x)).centre().unwrap().coordinates();
        let expected = plus(centre, times(offset, radius * radius / length(offset).powi(2)));
        near_all(image, expected, 1e-9);
    }
}

#[test]
fn a_line_passes_for_a_circle_without_centre() {
    let [p, q, r] = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]].map(Point::from);
    let flat = Circle::through(p, q, r);
    assert_eq!(flat.centre(), None);
    assert_eq!(flat.radius(), None);
    assert_eq!(flat.radius_squared(), None);
    let imaginary = Circle::from_centre_radius_squared(Point::new(1.0, 2.0), -4.0);
    assert_eq!(imaginary.radius_squared(), Some(-4.0));
    assert_eq!(imaginary.radius(), None);
    assert_eq!(imaginary.centre(), Some(Point::new(1.0, 2.0)));
}

#[test]
fn a_tangent_touches_in_a_point_twice() {
    let circle = Circle::from_centre_radius(Point::new(0.0, 0.0), 2.0);
    let tangent = Line::from_point_direction(Point::new(0.0, 2.0), [1.0, 0.0]);
    let pair = tangent & circle;
    assert_eq!(pair.radius_squared(), Some(0.0));
    let [p, q] = pair.endpoints().unwrap();
    assert_eq!((p, q), (Point::new(0.0, 2.0), Point::new(0.0, 2.0)));
    let passing = Line::from_point_direction(Point::new(0.0, 3.0), [1.0, 0.0]);
    assert_eq!((passing & circle).endpoints(), None);
    // Circles about one centre share no pair of points.
    let inner = Circle::from_centre_radius(Point::new(0.0, 0.0), 1.0);
    assert_eq!((circle & inner).endpoints(), None);
    assert_eq!((circle & circle).centre(), None);
}

#[test]
fn translations_and_full_rotations_have_logarithms() {
    let shift: Motor<f64> = Translator::from_displacement([2.0, -4.0]).into();
    assert_eq!(shift.log(), Some(MotorGenerator::new(0.0, -1.0, 2.0)));
    assert_eq!(shift.centre(), None);
    assert_eq!((-shift).log(), None);
    assert_eq!((-Motor::<f64>::default()).log().unwrap().e12, PI);
}

#[test]
fn numbers_that_are_not_finite_give_none() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(Rotor::from_angle(bad), None);
        assert_eq!(Dilator::from_factor(bad), None);
        let circle = Circle::from_centre_radius(Point::new(bad, 0.0), 1.0);
        assert_eq!(circle.centre(), None);
        assert_eq!(circle.radius(), None);
        assert_eq!(
            Circle::from_centre_radius(Point::new(0.0, 0.0), bad).radius(),
            None
        );
        let line = Line::from_point_direction(Point::new(0.0, bad), [1.0, 1.0]);
        assert_eq!(line.normalized(), None);
        assert_eq!(line.signed_distance(Point::new(0.0, 0.0)), None);
        assert_eq!(line.foot(Point::new(0.0, 0.0)), None);
        let pair = PointPair::new(bad, 1.0, 0.0, 0.0, 0.0, 0.0);
        assert_eq!(pair.centre(), None);
        assert_eq!(pair.endpoints(), None);
        assert_eq!(
            PointPair::new(0.0, bad, 0.0, 0.0, 0.0, 0.0).endpoints(),
            None
        );
        assert_eq!(Motor::new_unchecked(1.0, 0.0, bad, 0.0).log(), None);
        assert_eq!(Motor::new_unchecked(1.0, bad, 0.0, 0.0).log(), None);
        assert_eq!(Motor::new_unchecked(bad, 0.0, 0.0, 0.0).log(), None);
        assert_eq!(RoundVector::new(bad, 0.0, 1.0, 0.0).centre(), None);
        assert_eq!(RoundVector::new(0.0, 0.0, 1.0, bad).radius_squared(), None);
    }
    for bad in [0.0, -1.0] {
        assert_eq!(Dilator::<f64>::from_factor(bad), None);
    }
    let nowhere = Line::through(Point::new(1.0, 1.0), Point::new(1.0, 1.0));
    assert_eq!(nowhere.normalized(), None);
    assert_eq!(nowhere.signed_distance(Point::new(0.0, 0.0)), None);
}

//! Lines, points and motors of pga2.

use std::f64::consts::PI;

use ga_runtime::pga2::{Line, Motor, MotorSum, Point, Rotor, Translator};
use nullcone_tests::plain::near_all;
use proptest::prelude::*;

use super::plane::{area, minus, plus, rotated, vector};

fn place(point: Point<f64>) -> [f64; 2] {
    point.coordinates().expect("a finite point")
}

fn coefficients(m: Motor<f64>) -> [f64; 4] {
    [m.scalar(), m.e12(), m.e20(), m.e01()]
}

proptest! {
    #[test]
    fn lines_meet_and_points_join(p in vector(5.0), q in vector(5.0), r in vector(5.0), weight in 0.1..9.0_f64) {
        prop_assume!(area(minus(q, p), minus(r, p)).abs() > 0.1);
        let [a, b, c] = [p, q, r].map(|x| Point::from_homogeneous(x.map(|x| x * weight), weight));
        let line = Line::through(a, b);
        near_all(line.direction().map(|x| x / (weight * weight)), minus(q, p), 1e-13);
        // Twice the area of a triangle is a side times the height over it.
        let side = minus(q, p)[0].hypot(minus(q, p)[1]);
        let height = area(minus(q, p), minus(r, p)) / side;
        near_all([line.signed_distance(c).unwrap()], [height], 1e-12 / side.min(1.0));
        let meet = place(line ^ Line::through(a, c));
        near_all(meet, p, 1e-9);
        let foot = place(line.foot(c).unwrap());
        let unit = minus(q, p).map(|x| x / side);
        let along = (r[0] - p[0]) * unit[0] + (r[1] - p[1]) * unit[1];
        near_all(foot, plus(p, unit.map(|x| x * along)), 1e-11 / side.min(1.0));
        near_all([a.distance(b).unwrap()], [side], 1e-13);
        let other = Line::from_point_direction(r, rotated(minus(q, p), 1.25));
        near_all([line.angle(other).unwrap()], [1.25], 1e-13);
        near_all([other.signed_distance(c).unwrap()], [0.0], 1e-12 / side.min(1.0));
        let normal = [-unit[1], unit[0]];
        let again = Line::from_normal_distance(normal, normal[0] * p[0] + normal[1] * p[1]);
        near_all([again.signed_distance(c).unwrap()], [height], 1e-12 / side.min(1.0));
    }

    #[test]
    fn motors_move_as_matrices_do(angle in -7.0..7.0_f64, t in vector(5.0), x in vector(5.0), d in vector(5.0)) {
        prop_assume!(d[0].hypot(d[1]) > 0.1);
        let motor: Motor<f64> =
            Translator::from_displacement(t) * Rotor::from_angle(angle).unwrap();
        let expected = plus(rotated(x, angle), t);
        near_all(place(motor.transform(Point::from(x))), expected, 1e-13);
        let [a, b] = motor.to_matrix();
        near_all([a, b].map(|row| row[0] * x[0] + row[1] * x[1] + row[2]), expected, 1e-13);
        let again = Motor::from_matrix([a, b]).unwrap();
        near_all(place(again.transform(Point::from(x))), expected, 1e-13);
        near_all(motor.translator().displacement(), t, 1e-13);
        let line = motor.transform(Line::from_point_direction(x, d));
        near_all(line.direction(), rotated(d, angle), 1e-13);
        near_all([line.signed_distance(Point::from(expected)).unwrap()], [0.0], 1e-12);
    }

    #[test]
    fn rotations_keep_their_centre(centre in vector(5.0), angle in -6.0..6.0_f64, x in vector(5.0)) {
        prop_assume!(angle.abs() > 0.01);
        let motor = Motor::about(centre, Rotor::from_angle(angle).unwrap());
        let expected = plus(centre, rotated(minus(x, centre), angle));
        near_all(place(motor.transform(Point::from(x))), expected, 1e-13);
        near_all(place(motor.centre().unwrap()), centre, 1e-13 / (0.5 * angle).sin().abs());
        let exponential = (Point::from(centre) * (-0.5 * angle)).exp();
        near_all(coefficients(exponential), coefficients(motor), 1e-13);
        // Half the interpolation is half the angle, the short way round.
        let angle = angle - if angle.abs() > PI { (2.0 * PI).copysign(angle) } else { 0.0 };
        let half = Motor::default().interpolate(motor, 0.5);
        let expected = plus(centre, rotated(minus(x, centre), 0.5 * angle));
        prop_assume!(angle.abs() < 3.0);
        near_all(place(half.transform(Point::from(x))), expected, 1e-12);
    }

    #[test]
    fn logarithms_survive_a_round_trip(angle in -6.2..6.2_f64, t in vector(5.0)) {
        let motor: Motor<f64> = Translator::from_displacement(t) * Rotor::from_angle(angle).unwrap();
        let log = motor.log().unwrap();
        near_all([log.e12], [-0.5 * angle], 1e-15 * 4.0);
        // Near a full rotation the centre is determined by small numbers.
        let is_near_whole = angle.abs() > PI;
        let conditioning = if is_near_whole { 1.0 / (0.5 * angle).sin().abs() } else { 1.0 };
        near_all(coefficients(log.exp()), coefficients(motor), 1e-14 * conditioning);
    }
}

#[test]
fn tiny_angles_and_translations_keep_their_digits() {
    for angle in [1e-300_f64, 1e-100, 1e-20, 1e-9] {
        let motor = (Point::from([3.0, -4.0]) * (-0.5 * angle)).exp();
        // p − R p, to first order.
        near_all(
            motor.translator().displacement(),
            [-4.0 * angle, -3.0 * angle],
            1e-8 * angle,
        );
        let log = motor.log().unwrap();
        near_all(
            [log.e12, log.e20, log.e01],
            [-0.5 * angle, -1.5 * angle, 2.0 * angle],
            1e-15 * angle,
        );
    }
    for size in [1e-300, 1.0, 1e300] {
        let motor: Motor<f64> = Translator::from_displacement([size, -size]).into();
        let log = motor.log().unwrap();
        assert_eq!(log, Point::new(0.0, -0.5 * size, -0.5 * size));
        assert_eq!(log.exp(), motor);
    }
}

#[test]
fn minus_one_has_a_logarithm_and_the_negative_of_a_translation_has_none() {
    let still = (-Motor::<f64>::default()).log().unwrap();
    assert_eq!(still.e12, PI);
    near_all(coefficients(still.exp()), [-1.0, 0.0, 0.0, 0.0], 2e-16);
    let shift: Motor<f64> = Translator::from_displacement([1.0, 0.0]).into();
    assert_eq!((-shift).log(), None);
    assert_eq!(shift.centre(), None);
    // The short way to the negative of a translator is the translation.
    let half = Motor::default().interpolate(-shift, 0.5);
    assert_eq!(half.translator().displacement(), [0.5, 0.0]);
}

#[test]
fn ideal_and_not_finite_elements_give_none() {
    let (point, line) = (
        Point::from([1.0, 2.0]),
        Line::from_normal_distance([0.0, 1.0], 1.0),
    );
    let parallel = line ^ Line::from_normal_distance([0.0, 1.0], 2.0);
    assert_eq!(parallel.coordinates(), None);
    assert_eq!(point.distance(parallel), None);
    assert_eq!(line.signed_distance(parallel), None);
    assert_eq!(line.foot(parallel), None);
    for bad in [
        Line::new(0.0, 0.0, 1.0),
        Line::new(f64::NAN, 1.0, 0.0),
        Line::new(1.0, 0.0, f64::INFINITY),
    ] {
        assert_eq!(bad.normalized(), None);
        assert_eq!(bad.signed_distance(point), None);
        assert_eq!(bad.foot(point), None);
    }
    assert_eq!(line.angle(Line::new(0.0, 0.0, 1.0)), None);
    assert_eq!(line.angle(Line::new(f64::NAN, 0.0, 1.0)), None);
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(Point::from([bad, 0.0]).coordinates(), None);
        assert_eq!(Rotor::from_angle(bad), None);
        assert_eq!(Motor::new_unchecked(bad, 0.0, 0.0, 0.0).log(), None);
        assert_eq!(Motor::new_unchecked(-bad, 0.0, 0.0, 0.0).log(), None);
        assert_eq!(Motor::new_unchecked(1.0, bad, 0.0, 0.0).log(), None);
        assert_eq!(Motor::new_unchecked(1.0, 0.0, bad, 0.0).log(), None);
        assert_eq!(Motor::from_matrix([[1.0, 0.0, bad], [0.0, 1.0, 0.0]]), None);
        assert_eq!(Motor::from_matrix([[1.0, bad, 0.0], [0.0, 1.0, 0.0]]), None);
    }
    // A reflection is not a motion.
    assert_eq!(
        Motor::from_matrix([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]),
        None
    );
    assert_eq!(MotorSum::new(0.0, 0.0, 1.0, 0.0).normalize(), None);
    assert!((Point::new(f64::NAN, 1.0, 1.0)).exp().e20().is_nan());
}

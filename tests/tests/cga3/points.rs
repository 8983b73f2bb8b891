//! Points displaced by directions, and what directions measure.

use std::ops::{Add, Sub};

use ga_runtime::cga3::{Direction, Line, Motor, Point, Rotor, Translator};
use ga_runtime::scalar::{Lanes, Prime61, Ring};
use ga_runtime::vga3;
use nullcone_tests::plain::{cross, dot, length, minus, near, near_all, plus, times, unit, vector};
use proptest::prelude::*;

proptest! {
    #[test]
    fn directions_and_vectors_displace_points(a in vector(9.0), b in vector(9.0)) {
        let (p, q, v) = (Point::from(a), Point::from(b), Direction::from(b));
        let w = vga3::Vector::from(b);
        for sum in [p + v, p + w, p.add(&v), p.add(&w), (&p).add(v), (&p).add(&w)] {
            prop_assert_eq!(<[f64; 3]>::from(sum), plus(a, b));
        }
        for difference in [p - v, p - w, p.sub(&v), p.sub(&w), (&p).sub(v), (&p).sub(&w)] {
            prop_assert_eq!(<[f64; 3]>::from(difference), minus(a, b));
        }
        let mut moved = p;
        moved += v;
        moved += w;
        prop_assert_eq!(moved.coordinates(), plus(plus(a, b), b));
        moved -= v;
        moved -= w;
        prop_assert_eq!(moved.coordinates(), minus(minus(plus(plus(a, b), b), b), b));
        prop_assert_eq!(<[f64; 3]>::from(p.to(q)), minus(b, a));
        near_all((p + p.to(q)).coordinates(), b, 1e-14);
        // The algebraic difference has the coefficient ½(q² − p²) of ei, and none of eo.
        let algebraic = q - p;
        near_all(
            [algebraic.e1, algebraic.e2, algebraic.e3, algebraic.eo, algebraic.ei],
            [b[0] - a[0], b[1] - a[1], b[2] - a[2], 0.0, 0.5 * (dot(b, b) - dot(a, a))],
            1e-13,
        );
        prop_assert_eq!([p.x(), p.y(), p.z()], a);
        prop_assert_eq!([v.x(), v.y(), v.z()], b);
        prop_assert_eq!([w.x(), w.y(), w.z()], b);
    }

    #[test]
    fn a_displaced_point_is_a_translated_one(a in vector(9.0), t in vector(9.0)) {
        let translated = Translator::from_displacement(t).transform(Point::from(a));
        near_all((Point::from(a) + Direction::from(t)).coordinates(), translated.coordinates(), 1e-14);
    }

    #[test]
    fn motions_map_sums_to_sums(a in vector(5.0), b in vector(5.0), axis in unit(), angle in -3.0..3.0_f64, t in vector(5.0)) {
        let motor = Translator::from_displacement(t) * Rotor::from_axis_angle(axis, angle).unwrap();
        let (p, v) = (Point::from(a), Direction::from(b));
        let images: Point<f64> = motor.transform(p) + motor.transform(v);
        near_all(motor.transform(p + v).coordinates(), images.coordinates(), 1e-13);
    }

    #[test]
    fn interpolated_points_divide_the_segment(a in vector(9.0), b in vector(9.0), t in -2.0..3.0_f64) {
        let (p, q) = (Point::from(a), Point::from(b));
        near_all(p.lerp(q, t).coordinates(), plus(a, times(minus(b, a), t)), 1e-13);
        prop_assert_eq!((p.lerp(q, 0.0), p.lerp(q, 1.0)), (p, q));
        let middle = p.midpoint(q);
        near_all(middle.coordinates(), plus(a, b).map(|x| 0.5 * x), 1e-14);
        near(middle.distance(p), 0.5 * length(minus(b, a)), 1e-14);
        prop_assert_eq!(q.midpoint(p), middle);
        let (v, w) = (Direction::from(a), Direction::from(b));
        near_all(v.lerp(w, t).vector(), plus(a, times(minus(b, a), t)), 1e-13);
    }

    #[test]
    fn directions_measure_as_vectors_do(a in vector(9.0), b in vector(9.0)) {
        let (v, w) = (Direction::from(a), Direction::from(b));
        prop_assert_eq!(v.dot(w), dot(a, b));
        prop_assert_eq!(v.cross(w).vector(), cross(a, b));
        near(v.length(), length(a), 1e-14);
        prop_assert_eq!(v.norm(), v.length());
        near(v.length_squared(), dot(a, a), 1e-13);
        let unit = v.normalized().unwrap();
        near_all(unit.coordinates(), a.map(|x| x / length(a)), 1e-15);
        let cosine = dot(a, b) / (length(a) * length(b));
        near(v.angle(w).unwrap().cos(), cosine, 1e-14);
        // The blade is null.
        prop_assert_eq!(v.norm_squared(), 0.0);
    }
}

#[test]
fn midpoints_do_not_overflow() {
    let far = f64::MAX;
    let middle = Point::new(far, 0.0, -far).midpoint(Point::new(far, 0.0, -far));
    assert_eq!(middle, Point::new(far, 0.0, -far));
}

#[test]
fn zero_and_infinity_have_no_direction() {
    let unit = |x: f64| Direction::new(x, 0.0, 0.0).normalized();
    assert_eq!([unit(0.0), unit(f64::INFINITY), unit(f64::NAN)], [None; 3]);
    assert_eq!(unit(-1e-320), Some(Direction::new(-1.0, 0.0, 0.0)));
    assert_eq!(
        Direction::new(0.0, 1.0, 0.0).angle(Direction::default()),
        None
    );
    near(
        Direction::new(3e200, 4e200, 0.0).length() / 5e200,
        1.0,
        1e-15,
    );
}

#[test]
fn rings_and_lanes_have_points_too() {
    let p = Point::from([1, 2, 3].map(Prime61::from_integer));
    let v = Direction::from([1, 1, 1].map(Prime61::from_integer));
    assert_eq!(p + v, Point::from([2, 3, 4].map(Prime61::from_integer)));
    assert_eq!((p + v).to(p), -v);
    let lanes = |x: f64| Lanes::from_array([x, 2.0 * x]);
    let q = Point::new(lanes(1.0), lanes(2.0), lanes(2.0));
    assert_eq!(Point::default().to(q).length(), lanes(3.0));
    assert_eq!(Point::default().midpoint(q).z(), lanes(1.0));
}

#[test]
fn a_point_and_the_direction_to_another_span_their_line() {
    let (p, q) = (Point::new(1.0, 2.0, 3.0), Point::new(-1.0, 5.0, 3.5));
    let line: Line<f64> = p ^ p.to(q);
    assert_eq!(line, Line::through(p, q));
    let fixed = Motor::default().transform(p.to(q));
    assert_eq!(fixed, p.to(q));
}

//! Planes, lines, points and motors of pga3.

use std::f64::consts::PI;

use ga_runtime::cga3;
use ga_runtime::pga3::{Direction, Line, Motor, Plane, Point, Rotor, Translator};
use nullcone_tests::plain::{
    Vector, cross, dot, frame, length, minus, near_all, plus, rotated, times, unit, vector,
};
use proptest::prelude::*;

fn motors() -> impl Strategy<Value = Motor<f64>> + Clone {
    (unit(), -2.0 * PI..2.0 * PI, vector(10.0)).prop_map(|(axis, angle, t)| {
        Translator::from_displacement(t) * Rotor::from_axis_angle(axis, angle).expect("an axis")
    })
}

fn coefficients(m: Motor<f64>) -> [f64; 8] {
    [
        m.scalar(),
        m.e12(),
        m.e13(),
        m.e23(),
        m.e10(),
        m.e20(),
        m.e30(),
        m.e1230(),
    ]
}

fn place(point: Point<f64>) -> Vector {
    point.coordinates().expect("a finite point")
}

proptest! {
    #[test]
    fn planes_meet_where_all_equations_hold(
        p in vector(5.0), a in unit(), b in unit(), c in unit(), weight in 0.5..3.0_f64,
    ) {
        let volume = dot(cross(a, b), c);
        prop_assume!(volume.abs() > 0.05);
        let [x, y, z] = [a, b, c].map(|n| Plane::from_point_normal(p, times(n, weight)));
        near_all(place(x ^ y ^ z), p, 1e-12 / volume.abs());
        // The meet of two planes has the direction of the cross product of their normals, and goes
        // through the point.
        let line = x ^ y;
        near_all(line.direction(), times(cross(a, b), weight * weight), 1e-13);
        near_all(line.moment(), cross(p, line.direction()), 1e-12);
    }

    #[test]
    fn directions_lead_from_point_to_point(p in vector(5.0), q in vector(5.0), w in 0.1..9.0_f64) {
        let (a, b) = (Point::from(p), Point::from_homogeneous(times(q, w), w));
        let way = a.to(b).unwrap();
        near_all(way.vector(), minus(q, p), 1e-14);
        near_all(a.midpoint(b).unwrap().coordinates().unwrap(), times(plus(p, q), 0.5), 1e-14);
        near_all([way.length()], [length(minus(q, p))], 1e-14);
        near_all(way.normalized().unwrap().into(), times(minus(q, p), 1.0 / length(minus(q, p))), 1e-14);
        let (u, v) = (Direction::from(p), Direction::from(q));
        prop_assert_eq!((u.dot(v), u.cross(v).vector()), (dot(p, q), cross(p, q)));
        prop_assert_eq!((u - u).normalized(), None);
        prop_assert_eq!((a.to(Point::from(u)), Point::from(u).midpoint(a)), (None, None));
    }

    #[test]
    fn points_join(p in vector(5.0), q in vector(5.0), r in vector(5.0)) {
        let [a, b, c] = [p, q, r].map(Point::from_coordinates);
        let line = Line::through(a, b);
        near_all(line.direction(), minus(q, p), 1e-13);
        near_all(line.moment(), cross(p, q), 1e-12);
        let along = Line::through(a, Direction::from_vector(minus(q, p)).into());
        near_all(along.moment(), line.moment(), 1e-12);
        let plane = Plane::through(a, b, c);
        let normal = cross(minus(q, p), minus(r, p));
        near_all(plane.normal(), normal, 1e-12);
        near_all([plane.e0], [-dot(normal, p)], 1e-11);
        near_all((a & Direction::from_vector(r)).direction(), times(r, -1.0), 0.0);
        near_all((a & Direction::from_vector(r)).moment(), cross(r, p), 1e-12);
    }

    #[test]
    fn distances_and_feet_are_euclidean(
        n in unit(), d in -5.0..5.0_f64, p in vector(5.0), q in vector(5.0), weight in 0.1..9.0_f64,
    ) {
        let point = Point::from_homogeneous(times(p, weight), weight);
        let plane = Plane::from_normal_distance(times(n, weight), d * weight);
        let height = dot(n, p) - d;
        near_all([plane.signed_distance(point).unwrap()], [height], 1e-13);
        near_all(place(plane.foot(point).unwrap()), minus(p, times(n, height)), 1e-13);
        prop_assert!((point.distance(Point::from(q)).unwrap() - length(minus(p, q))).abs() < 1e-13);

        let line = Line::from_point_direction(q, times(n, weight));
        let foot = plus(q, times(n, dot(minus(p, q), n)));
        near_all(place(line.foot(point).unwrap()), foot, 1e-12);
        near_all([line.distance(point).unwrap()], [length(minus(p, foot))], 1e-12);
        let support = place(line.support().unwrap());
        near_all([dot(support, n)], [0.0], 1e-12);
    }

    #[test]
    fn lines_lie_apart_as_their_common_perpendicular_is_long(
        foot in vector(5.0), direction in unit(), angle in 0.1..3.0_f64, gap in 0.0..4.0_f64,
        s in -3.0..3.0_f64, t in -3.0..3.0_f64,
    ) {
        let perpendicular = frame(direction)[0];
        let other = rotated(perpendicular, angle, direction);
        let a = Line::from_point_direction(plus(foot, times(direction, s)), times(direction, 2.0));
        let start = plus(plus(foot, times(perpendicular, gap)), times(other, t));
        let b = Line::from_point_direction(start, other);
        near_all([a.distance_to_line(b).unwrap()], [gap], 1e-11);
        near_all([a.angle(b).unwrap()], [angle], 1e-13);
        let parallel = Line::from_point_direction(start, times(direction, -3.0));
        let between = minus(start, foot);
        let apart = length(cross(between, direction));
        near_all([a.distance_to_line(parallel).unwrap()], [apart], 1e-12);
    }

    #[test]
    fn angles_are_those_of_normals_and_directions(n in unit(), angle in -1.5..1.5_f64, d in -2.0..2.0_f64) {
        let tilted = rotated(frame(n)[0], angle, n);
        let (a, b) = (Plane::from_normal_distance(n, d), Plane::from_normal_distance(times(tilted, 3.0), 1.0));
        near_all([a.angle(b).unwrap()], [angle.abs()], 1e-13);
        let line = Line::from_point_direction([1.0, 2.0, 3.0], rotated(frame(n)[0], angle, cross(frame(n)[0], n)));
        let sine = dot(line.unit_direction().unwrap(), n);
        near_all([line.angle_to_plane(a).unwrap().sin()], [sine], 1e-13);
        // The projection lies in the plane, below the line.
        if sine.abs() < 0.95 {
            let below = a.project(line).unwrap();
            near_all([dot(below.direction(), n)], [0.0], 1e-13);
            let foot = place(a.foot(Point::from([1.0, 2.0, 3.0])).unwrap());
            near_all([below.distance(Point::from(foot)).unwrap()], [0.0], 1e-12);
            near_all([length(below.direction())], [(1.0 - sine * sine).sqrt()], 1e-13);
        }
    }

    #[test]
    fn motors_move_as_matrices_do(axis in unit(), angle in -7.0..7.0_f64, t in vector(5.0), x in vector(5.0)) {
        let motor: Motor<f64> =
            Translator::from_displacement(t) * Rotor::from_axis_angle(axis, angle).unwrap();
        let expected = plus(rotated(axis, angle, x), t);
        near_all(place(motor.transform(Point::from(x))), expected, 1e-13);
        let matrix = motor.to_matrix();
        near_all(matrix.map(|[a, b, c, d]| dot([a, b, c], x) + d), expected, 1e-13);
        let again = Motor::from_matrix(matrix).unwrap();
        near_all(place(again.transform(Point::from(x))), expected, 1e-13);
        near_all(motor.translator().displacement(), t, 1e-13);
        // Free vectors are only rotated, and a line moves with its points.
        let turned = motor.transform(Direction::from_vector(x)).vector();
        near_all(turned, rotated(axis, angle, x), 1e-13);
        let line = motor.transform(Line::from_point_direction(x, axis));
        near_all(line.direction(), axis, 1e-13);
        near_all([line.distance(Point::from(expected)).unwrap()], [0.0], 1e-12);
    }

    #[test]
    fn screws_rotate_right_handed_about_their_line(
        foot in vector(5.0), axis in unit(), angle in -7.0..7.0_f64, shift in -5.0..5.0_f64, x in vector(5.0),
    ) {
        let line = Line::from_point_direction(foot, times(axis, 4.0));
        let screw = Motor::from_screw(line, angle, shift).unwrap();
        let turned = plus(foot, rotated(axis, angle, minus(x, foot)));
        near_all(place(screw.transform(Point::from(x))), plus(turned, times(axis, shift)), 1e-12);
    }

    #[test]
    fn logarithms_survive_a_round_trip(motor in motors(), t in 0.0..1.0_f64) {
        // Near a full rotation the axis is determined by small numbers.
        let sine = (1.0 - motor.scalar() * motor.scalar()).sqrt();
        let conditioning = if motor.scalar() < 0.0 { 1.0 / sine } else { 1.0 };
        near_all(coefficients(motor.log().exp()), coefficients(motor), 1e-13 * conditioning);
        let whole = Motor::default().interpolate(motor, 1.0);
        let x = Point::from([1.0, -2.0, 3.0]);
        near_all(place(whole.transform(x)), place(motor.transform(x)), 1e-11);
        // The speed is constant: two equal steps are one of twice the length.
        let step = Motor::default().interpolate(motor, 0.5 * t);
        let twice = Motor::default().interpolate(motor, t);
        near_all(place((step * step).transform(x)), place(twice.transform(x)), 1e-11);
    }

    #[test]
    fn cga3_is_met_exactly(motor in motors(), p in vector(5.0), q in vector(5.0), n in unit()) {
        let conformal = cga3::Motor::from(motor);
        prop_assert_eq!(Motor::from(conformal), motor);
        let (line, plane) = (
            Line::from_point_direction(p, q),
            Plane::from_point_normal(p, n),
        );
        prop_assert_eq!(cga3::Line::from(line), cga3::Line::from_point_direction(p.into(), q));
        prop_assert_eq!(Line::from(cga3::Line::from(line)), line);
        prop_assert_eq!(Line::from(cga3::MotorGenerator::from(line)), line);
        prop_assert_eq!(Plane::from(cga3::DualPlane::from(plane)), plane);
        prop_assert_eq!(Plane::from(cga3::Plane::from(plane)), plane);
        prop_assert_eq!(cga3::Plane::from(plane).normal(), n);
        let point = Point::from(cga3::Point::from(p));
        prop_assert_eq!(point, Point::from(p));
        prop_assert_eq!(point.to_conformal().unwrap().coordinates(), p);
        prop_assert_eq!(Point::from(cga3::FlatPoint::from(point)), point);
        // Moving and converting commute.
        let moved = motor.transform(point).to_conformal().unwrap().coordinates();
        near_all(moved, conformal.transform(cga3::Point::from(p)).coordinates(), 1e-13);
        let (a, b) = (
            cga3::Line::from(motor.transform(line)),
            conformal.transform(cga3::Line::from(line)),
        );
        near_all(a.direction(), b.direction(), 1e-12);
        near_all(a.moment(), b.moment(), 1e-11);
        let (a, b) = (
            cga3::Plane::from(motor.transform(plane)),
            conformal.transform(cga3::Plane::from(plane)),
        );
        near_all([a.e12oi, a.e13oi, a.e23oi, a.e123i], [b.e12oi, b.e13oi, b.e23oi, b.e123i], 1e-12);
        let signed = plane.signed_distance(Point::from(q)).unwrap();
        near_all([signed], [cga3::Plane::from(plane).signed_distance(q.into()).unwrap()], 1e-12);
    }
}

#[test]
fn tiny_angles_keep_all_digits() {
    for angle in [0.0_f64, 1e-300, 1e-200, 1e-100, 1e-20, 1e-12, 1e-8, 1e-4] {
        let axis = Line::from_point_direction([1.0, 2.0, 0.0], [0.0, 0.0, 1.0]);
        let motor = (axis * (-0.5 * angle)).exp();
        // (p − R p) for a rotation about p, to first order for tiny angles.
        let shift = motor.translator().displacement();
        let (sine, versine) = (angle.sin(), 2.0 * (0.5 * angle).sin().powi(2));
        let expected = [versine + 2.0 * sine, 2.0 * versine - sine, 0.0];
        near_all(shift, expected, 1e-15 * angle);
        let log = motor.log();
        near_all([log.e12], [-0.5 * angle], 1e-16 * angle);
        near_all(
            [log.e10, log.e20],
            [axis.e10 * -0.5 * angle, axis.e20 * -0.5 * angle],
            2e-16 * angle,
        );
    }
}

#[test]
fn pure_translations_have_logarithms() {
    for size in [1e-300, 1e-12, 1.0, 1e12, 1e300] {
        let motor: Motor<f64> = Translator::from_displacement([size, -2.0 * size, 0.0]).into();
        let log = motor.log();
        assert_eq!(log, Line::new(0.0, 0.0, 0.0, 0.5 * size, -size, 0.0));
        assert_eq!(log.exp(), motor);
    }
}

#[test]
fn ideal_elements_have_no_coordinates() {
    let ideal_line = Line::from_direction_moment([0.0; 3], [1.0, 2.0, 3.0]);
    let ideal_plane = Plane::new(0.0, 0.0, 0.0, 1.0);
    let ideal_point: Point<f64> = Direction::from_vector([1.0, 0.0, 0.0]).into();
    let (line, plane, point) = (
        Line::from_point_direction([0.0; 3], [0.0, 0.0, 1.0]),
        Plane::from_normal_distance([0.0, 0.0, 1.0], 1.0),
        Point::from([1.0, 2.0, 3.0]),
    );
    assert_eq!(ideal_line.normalized(), None);
    assert_eq!(ideal_line.support(), None);
    assert_eq!(ideal_line.angle(line), None);
    assert_eq!(line.distance_to_line(ideal_line), None);
    assert_eq!(Motor::from_screw(ideal_line, 1.0, 1.0), None);
    assert_eq!(ideal_plane.normalized(), None);
    assert_eq!(ideal_plane.signed_distance(point), None);
    assert_eq!(plane.angle(ideal_plane), None);
    assert_eq!(line.angle_to_plane(ideal_plane), None);
    assert_eq!(ideal_point.coordinates(), None);
    assert_eq!(ideal_point.to_conformal(), None);
    assert_eq!(plane.signed_distance(ideal_point), None);
    assert_eq!(plane.foot(ideal_point), None);
    assert_eq!(line.foot(ideal_point), None);
    assert_eq!(point.distance(ideal_point), None);
    // A line perpendicular to the plane has no projection.
    assert_eq!(plane.project(line), None);
    // Parallel planes meet in an ideal line, parallel lines in an ideal point.
    let meet = plane ^ Plane::from_normal_distance([0.0, 0.0, 1.0], 3.0);
    assert_eq!(meet.unit_direction(), None);
    assert_eq!((Plane::new(1.0, 0.0, 0.0, -1.0) ^ line).coordinates(), None);
}

#[test]
fn numbers_that_are_not_finite_give_none() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let point = Point::from([bad, 0.0, 0.0]);
        assert_eq!(point.coordinates(), None);
        assert_eq!(point.distance(Point::from([0.0; 3])), None);
        let plane = Plane::from_normal_distance([0.0, 1.0, 0.0], bad);
        assert_eq!(plane.normalized(), None);
        assert_eq!(plane.signed_distance(Point::from([0.0; 3])), None);
        assert_eq!(
            Plane::from_normal_distance([bad, 1.0, 0.0], 1.0).unit_normal(),
            None
        );
        let line = Line::from_direction_moment([1.0, 0.0, 0.0], [0.0, bad, 0.0]);
        assert_eq!(line.normalized(), None);
        assert_eq!(line.support(), None);
        assert_eq!(line.foot(Point::from([0.0; 3])), None);
        let axis = Line::from_point_direction([0.0; 3], [1.0, 0.0, 0.0]);
        assert_eq!(Motor::from_screw(axis, bad, 0.0), None);
        assert_eq!(Motor::from_screw(axis, 0.0, bad), None);
        assert_eq!(Rotor::from_axis_angle([1.0, 0.0, 0.0], bad), None);
        assert_eq!(Rotor::from_axis_angle([bad, 0.0, 0.0], 1.0), None);
        assert_eq!(Rotor::between([1.0, 0.0, 0.0], [bad, 0.0, 0.0]), None);
        let row = [1.0, 0.0, 0.0, bad];
        assert_eq!(
            Motor::from_matrix([row, [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]),
            None
        );
    }
    assert_eq!(Rotor::<f64>::from_axis_angle([0.0; 3], 1.0), None);
    assert_eq!(Rotor::<f32>::between([0.0; 3], [1.0, 0.0, 0.0]), None);
}

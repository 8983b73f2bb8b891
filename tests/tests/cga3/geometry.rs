//! Euclidean geometry in cga3 against elementary formulas.

use std::f64::consts::PI;

use ga_runtime::cga3::{
    Circle, Dilator, Direction, DualPlane, FlatPoint, Infinity, Line, Motor, MotorGenerator, Plane,
    Point, Rotor, RoundVector, Sphere, Translator,
};
use ga_runtime::testing::{member, strategy};
use nullcone_tests::plain::{
    Vector, cross, dot, largest_difference, length, minus, motor_coefficients, rotated, unit,
    vector,
};
use proptest::prelude::*;

fn motors() -> impl Strategy<Value = Motor<f64>> + Clone {
    (unit(), -2.0 * PI..2.0 * PI, vector(10.0)).prop_map(|(axis, angle, t)| {
        Translator::from_displacement(t) * Rotor::from_axis_angle(axis, angle).expect("an axis")
    })
}

/// The largest difference of two coefficients.
fn apart(a: Motor<f64>, b: Motor<f64>) -> f64 {
    largest_difference(motor_coefficients(a), motor_coefficients(b))
}

/// Asserts `exp(log M) = M` relative to the size of the motor, up to errors that grow by a factor.
fn check_round_trip(motor: Motor<f64>, conditioning: f64) {
    let size = motor_coefficients(motor)
        .iter()
        .fold(1.0_f64, |m, x| m.max(x.abs()));
    let error = apart(motor.log().exp(), motor);
    assert!(
        error <= 1e-14 * size * conditioning,
        "{motor} is off by {error}"
    );
}

proptest! {
    #[test]
    fn rotors_agree_with_the_formula_of_rodrigues(axis in unit(), angle in -7.0..7.0_f64, x in vector(5.0), scale in 0.1..9.0) {
        let rotor = Rotor::from_axis_angle(axis.map(|a| a * scale), angle).unwrap();
        let image = rotor.transform(Point::from(x)).coordinates();
        prop_assert!(length(minus(image, rotated(axis, angle, x))) < 1e-14 * 10.0);
        let matrix = rotor.to_matrix().map(|row| dot(row, x));
        prop_assert!(length(minus(matrix, image)) < 1e-14 * 10.0);
        // The matrix and the quaternion determine the motor up to its sign.
        let again = Rotor::from_matrix(rotor.to_matrix()).unwrap();
        let same = Motor::from(again);
        let error = apart(same, rotor.into()).min(apart(-same, rotor.into()));
        prop_assert!(error < 1e-14);
        let (v, w) = rotor.to_quaternion();
        prop_assert!(apart(Rotor::from_quaternion(v, w).unwrap().into(), rotor.into()) < 1e-15);
        let (found, turned) = rotor.to_axis_angle();
        let back = Rotor::from_axis_angle(found, turned).unwrap();
        prop_assert!(apart(back.into(), rotor.into()) < 1e-15);
    }

    #[test]
    fn rotations_by_180_degrees_are_read_from_matrices(axis in unit(), off in -1e-7..1e-7_f64) {
        let rotor = Rotor::from_axis_angle(axis, PI + off).unwrap();
        let again = Motor::from(Rotor::from_matrix(rotor.to_matrix()).unwrap());
        let error = apart(again, rotor.into()).min(apart(-again, rotor.into()));
        prop_assert!(error < 1e-14);
    }

    #[test]
    fn the_shortest_rotation_joins_two_directions(a in unit(), b in unit()) {
        let rotor = Rotor::between(a, b.map(|x| 3.0 * x)).unwrap();
        let image = rotor.transform(Point::from(a)).coordinates();
        prop_assert!(length(minus(image, b)) < 1e-14);
        let (axis, angle) = rotor.to_axis_angle();
        prop_assert!(angle <= PI + 1e-15 && dot(axis, a).abs() < 1e-13);
        let opposite = Rotor::between(a, a.map(|x| -x)).unwrap();
        let image = opposite.transform(Point::from(a)).coordinates();
        prop_assert!(length(minus(image, a.map(|x| -x))) < 1e-14);
    }

    #[test]
    fn motors_rotate_and_then_translate(axis in unit(), angle in -7.0..7.0_f64, t in vector(5.0), x in vector(5.0)) {
        let rotor = Rotor::from_axis_angle(axis, angle).unwrap();
        let motor = Translator::from_displacement(t) * rotor;
        let turned = rotated(axis, angle, x);
        let expected: Vector = std::array::from_fn(|k| turned[k] + t[k]);
        let image = motor.transform(Point::from(x)).coordinates();
        prop_assert!(length(minus(image, expected)) < 1e-13);
        prop_assert!(length(minus(motor.translator().displacement(), t)) < 1e-14 * 10.0);
        prop_assert!(apart(motor.rotor().into(), rotor.into()) < 1e-16);
        // Directions are rotated, not translated.
        let direction = motor.transform(Direction::from_vector(x)).vector();
        prop_assert!(length(minus(direction, turned)) < 1e-13);
        let matrix = motor.to_matrix();
        let by_matrix: Vector = matrix.map(|[a, b, c, d]| dot([a, b, c], x) + d);
        prop_assert!(length(minus(by_matrix, expected)) < 1e-13);
        let again = Motor::from_matrix(matrix).unwrap();
        prop_assert!(apart(again, motor).min(apart(-again, motor)) < 1e-13);
        // A rotation about a point leaves the point fixed.
        let about = Motor::about(Point::from(t), rotor);
        prop_assert!(about.transform(Point::from(t)).distance(Point::from(t)) < 1e-13);
        let offset = rotated(axis, angle, minus(x, t));
        let expected: Vector = std::array::from_fn(|k| offset[k] + t[k]);
        prop_assert!(length(minus(about.transform(Point::from(x)).coordinates(), expected)) < 1e-13);
    }

    #[test]
    fn logarithms_survive_a_round_trip(motor in motors()) {
        // Close to a full rotation the error of the axis is divided by the sine of half the angle.
        let sine = (1.0 - motor.scalar().powi(2)).max(0.0).sqrt();
        let conditioning = if motor.scalar() < 0.0 { 1.0 + 4.0 / sine.max(1e-9) } else { 4.0 };
        check_round_trip(motor, conditioning);
    }

    #[test]
    fn generators_survive_a_round_trip(axis in unit(), half in 0.0..3.1_f64, shift in vector(10.0)) {
        let [x, y, z] = axis.map(|a| a * half);
        let generator = MotorGenerator::new(-z, y, -x, shift[0], shift[1], shift[2]);
        let again = generator.exp().log() - generator;
        let error = again.e12.abs() + again.e13.abs() + again.e23.abs()
            + again.e1i.abs() + again.e2i.abs() + again.e3i.abs();
        let conditioning = 1.0 + 1.0 / half.sin().abs().max(if half < 1.0 { 1.0 } else { 1e-3 });
        prop_assert!(error < 1e-13 * conditioning * conditioning, "{generator}: {error}");
    }

    #[test]
    fn interpolation_runs_at_constant_speed_by_the_short_way(a in motors(), b in motors(), t in 0.0..1.0_f64) {
        let between = a.inverse() * b;
        prop_assume!(between.scalar().abs() > 1e-3);
        let at = |t| a.interpolate(b, t);
        let tolerance = 1e-12;
        prop_assert!(apart(at(0.0), a) < tolerance);
        prop_assert!(apart(at(1.0), b).min(apart(at(1.0), -b)) < tolerance);
        // Equal steps in time are equal motions, and the whole rotation is at most 180°.
        let step = |from: f64| at(from).inverse() * at(from + 0.25);
        prop_assert!(apart(step(t * 0.75), step(0.0)) < tolerance);
        let (_, angle) = step(0.0).rotor().to_axis_angle();
        prop_assert!(angle <= 0.25 * PI + 1e-9 || angle >= 2.0 * PI - 0.25 * PI - 1e-9);
    }

    #[test]
    fn lines_and_planes_measure(p in vector(5.0), q in vector(5.0), r in vector(5.0), x in vector(5.0)) {
        let (along, across) = (minus(q, p), cross(minus(q, p), minus(r, p)));
        prop_assume!(length(along) > 0.1 && length(across) > 0.1);
        let [p, q, r] = [p, q, r].map(Point::from);
        let line = Line::through(p, q);
        let far = length(cross(minus(x, p.coordinates()), along)) / length(along);
        let tolerance = 1e-13 * 100.0 / length(along);
        prop_assert!((line.distance(Point::from(x)).unwrap() - far).abs() < tolerance);
        let foot = line.foot(Point::from(x)).unwrap();
        prop_assert!(dot(minus(foot.coordinates(), x), along).abs() < 1e-11 / length(along));
        let plane = Plane::through(p, q, r);
        let height = dot(minus(x, p.coordinates()), across) / length(across);
        let tolerance = 1e-12 * 100.0 / length(across);
        prop_assert!((plane.signed_distance(Point::from(x)).unwrap() - height).abs() < tolerance);
        // The intersection of the plane with the line through x along the normal.
        let meet: FlatPoint<f64> = Line::from_point_direction(Point::from(x), across) & plane;
        let pierced = meet.to_point().unwrap();
        prop_assert!((pierced.distance(Point::from(x)) - height.abs()).abs() < tolerance);
        prop_assert!(plane.signed_distance(pierced).unwrap().abs() < tolerance);
    }

    #[test]
    fn rounds_are_built_and_read(centre in vector(5.0), normal in unit(), radius in 0.1..5.0_f64, angle in 0.0..6.0_f64) {
        let middle = Point::from(centre);
        let sphere = Sphere::from_centre_radius(middle, radius);
        prop_assert!((sphere.radius().unwrap() - radius).abs() < 1e-12 / radius);
        prop_assert!(sphere.centre().unwrap().distance(middle) < 1e-14);
        let circle = Circle::from_centre_normal_radius(middle, normal, radius).unwrap();
        prop_assert!((circle.radius().unwrap() - radius).abs() < 1e-12 / radius);
        prop_assert!(circle.centre().unwrap().distance(middle) < 1e-13);
        prop_assert!(length(minus(circle.unit_normal().unwrap(), normal)) < 1e-14);
        // A point on the circle is on the sphere and in the plane; their meet is the circle.
        let side = cross(normal, if normal[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] });
        let start = side.map(|s| s * radius / length(side));
        let arm = rotated(normal, angle, start);
        let on = Point::from(std::array::from_fn(|k| centre[k] + arm[k]));
        prop_assert!((sphere & on).abs() < 1e-12 && (circle.carrier() & on).abs() < 1e-12);
        let meet = sphere & Plane::from_point_normal(middle, normal);
        prop_assert!(meet.centre().unwrap().distance(middle) < 1e-12);
        prop_assert!((meet.radius().unwrap() - radius).abs() < 1e-11 / radius);
    }

    #[test]
    fn dilators_scale_about_the_origin(x in vector(5.0), factor in 0.05..20.0_f64) {
        let dilator = Dilator::from_factor(factor).unwrap();
        prop_assert!((dilator.factor() - factor).abs() < 1e-14 * factor.max(1.0) * 4.0);
        let image: RoundVector<f64> = dilator.transform(Point::from(x));
        let found = image.centre().unwrap().coordinates();
        prop_assert!(length(minus(found, x.map(|c| c * factor))) < 1e-12 * factor.max(1.0));
        prop_assert!(image.radius_squared().unwrap().abs() < 1e-10 * factor * factor.max(1.0));
    }

    #[test]
    fn reflections_keep_the_plane(normal in unit(), distance in -3.0..3.0_f64, x in vector(5.0)) {
        let mirror = DualPlane::from_normal_distance(normal, distance);
        let image = mirror.sandwich(Point::from(x)).centre().unwrap().coordinates();
        let height = dot(normal, x) - distance;
        let expected: Vector = std::array::from_fn(|k| x[k] - 2.0 * height * normal[k]);
        prop_assert!(length(minus(image, expected)) < 1e-13);
    }

    #[test]
    fn random_members_of_float_types_are_members(motor in member::<Motor<f64>>(strategy::float(0.9))) {
        let [s, a, b, c, d, e, f, g] = motor_coefficients(motor);
        let size = motor_coefficients(motor).iter().fold(1.0_f64, |m, x| m.max(x.abs()));
        prop_assert!(Motor::try_new(s, a, b, c, d, e, f, g, 1e-13 * size * size).is_some());
    }
}

#[test]
fn logarithms_at_the_edges() {
    let translations = [0.0, 1e-300, 1e-12, 1e-6, 1.0, 1e6, 1e12];
    let angles = [
        0.0,
        1e-300,
        1e-200,
        1e-100,
        1e-16,
        1e-12,
        1e-8,
        1e-4,
        0.2499,
        0.2501,
        1.0,
        PI - 1e-12,
        PI,
    ];
    for angle in angles {
        for size in translations {
            for axis in [[1.0, 0.0, 0.0], [0.6, 0.0, 0.8], [0.0, -1.0, 0.0]] {
                let rotor = Rotor::from_axis_angle(axis, angle).unwrap();
                let shift = Translator::from_displacement([0.3 * size, -size, 0.7 * size]);
                check_round_trip(shift * rotor, 4.0);
            }
        }
    }
    let almost = Rotor::from_axis_angle([0.0, 0.6, 0.8], 2.0 * PI - 1e-6).unwrap();
    check_round_trip(Translator::from_displacement([1.0, 2.0, 3.0]) * almost, 1e7);
    // Pure translations are exact, and minus one and minus a translator come back with their sign.
    let shift = Motor::from(Translator::from_displacement([1.0, 2.0, 3.0]));
    assert_eq!(shift.log().exp(), shift);
    assert_eq!(
        shift.log(),
        MotorGenerator::new(0.0, 0.0, 0.0, -0.5, -1.0, -1.5)
    );
    let whole = (-Motor::<f64>::default()).log();
    assert_eq!(whole, MotorGenerator::new(PI, 0.0, 0.0, 0.0, 0.0, 0.0));
    assert!(apart(whole.exp(), -Motor::default()) < 1e-15);
    assert!(apart((-shift).log().exp(), -shift) < 1e-14);
}

#[test]
fn what_does_not_exist_is_none() {
    let nothing = [[0.0; 3], [f64::NAN, 0.0, 1.0], [f64::INFINITY, 0.0, 0.0]];
    for axis in nothing {
        assert_eq!(Rotor::from_axis_angle(axis, 1.0), None);
        assert_eq!(Rotor::between(axis, [1.0, 0.0, 0.0]), None);
        assert_eq!(Rotor::between([1.0, 0.0, 0.0], axis), None);
        assert_eq!(
            Circle::from_centre_normal_radius(Point::default(), axis, 1.0),
            None
        );
    }
    assert_eq!(Rotor::from_axis_angle([1.0, 0.0, 0.0], f64::NAN), None);
    assert_eq!(Rotor::from_quaternion([0.0; 3], 0.0), None);
    let mirror = [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(Rotor::from_matrix(mirror), None);
    assert_eq!(Rotor::from_matrix([[f64::NAN; 3]; 3]), None);
    assert_eq!(
        Motor::from_matrix([
            [1.0, 0.0, 0.0, f64::NAN],
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 1.0, 0.0]
        ]),
        None
    );
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(Dilator::from_factor(factor), None);
    }
    let p = Point::new(1.0, 2.0, 3.0);
    let line = Line::through(p, p);
    assert_eq!(
        (line.unit_direction(), line.normalized(), line.support()),
        (None, None, None)
    );
    assert_eq!((line.foot(p), line.distance(p)), (None, None));
    let plane = Plane::through(p, p, Point::default());
    assert_eq!(
        (plane.unit_normal(), plane.signed_distance(p)),
        (None, None)
    );
    // Three points of a line give a circle without a centre, four points of a plane a sphere
    // without one.
    let [a, b, c] = [0.0, 1.0, 3.0].map(|x| Point::new(x, 0.0, 0.0));
    let circle = Circle::through(a, b, c);
    assert_eq!(
        (circle.centre(), circle.radius(), circle.unit_normal()),
        (None, None, None)
    );
    let sphere = Sphere::through(a, b, Point::new(0.0, 1.0, 0.0), Point::new(1.0, 1.0, 0.0));
    assert_eq!((sphere.centre(), sphere.radius()), (None, None));
    // A sphere of negative squared radius has a centre but no radius.
    let imaginary =
        Sphere::try_from(RoundVector::new(1.0, 0.0, 0.0, 1.0, 1.0).undual()).expect("a sphere");
    assert_eq!(imaginary.radius_squared(), Some(-1.0));
    assert_eq!(imaginary.radius(), None);
    assert_eq!(
        Direction::from_vector([1.0, 0.0, 0.0]).vector(),
        [1.0, 0.0, 0.0]
    );
    assert_eq!(FlatPoint::new(1.0, 0.0, 0.0, 0.0).to_point(), None);
    assert_eq!((p ^ Infinity).to_point(), Some(p));
}

/// Far from the origin, errors in single precision are of the order of the spacing of the numbers
/// there.
#[test]
fn single_precision_far_from_the_origin() {
    let mut seed = 12345_u64;
    let mut number = || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let reach = 1e4;
    let spacing = f64::from(f32::EPSILON) * reach;
    let mut worst = [0.0_f64; 2];
    for _ in 0..2_000 {
        let mut triple =
            |size: f64| [number(), number(), number()].map(|x| f64::from((x * size) as f32));
        let (axis, t, x, y) = (triple(1.0), triple(reach), triple(reach), triple(reach));
        let angle = f64::from((number() * 3.0) as f32);
        let Some(rotor) = Rotor::from_axis_angle(axis.map(|a| a as f32), angle as f32) else {
            continue;
        };
        let motor = Translator::from_displacement(t.map(|a| a as f32)) * rotor;
        let single = coefficients_of(motor);
        let [s, a, b, c, d, e, f, g] = single.map(f64::from);
        // The same motor in double precision, not the one that it was rounded from.
        let double = Motor::new_unchecked(s, a, b, c, d, e, f, g);
        let (p, q) = (x.map(|c| c as f32), y.map(|c| c as f32));
        let image = motor.transform(Point::from(p)).coordinates().map(f64::from);
        let exact = double.transform(Point::from(x)).coordinates();
        worst[0] = worst[0].max(length(minus(image, exact)) / spacing);
        let distance = f64::from(Point::from(p).distance(Point::from(q)));
        worst[1] =
            worst[1].max((distance - Point::from(x).distance(Point::from(y))).abs() / spacing);
    }
    assert!(
        worst[0] <= 8.0 && worst[1] <= 8.0,
        "off by {worst:?} ulp of the distance from the origin"
    );
}

fn coefficients_of(m: Motor<f32>) -> [f32; 8] {
    [
        m.scalar(),
        m.e12(),
        m.e13(),
        m.e23(),
        m.e1i(),
        m.e2i(),
        m.e3i(),
        m.e123i(),
    ]
}

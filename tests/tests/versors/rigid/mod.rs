//! Roots, powers, interpolations and screws of rigid versors, against closed forms in plain
//! coordinates.

mod range;
mod screw;

use std::f64::consts::PI;

use ga_runtime::cga3::{
    Dilator, DualQuaternion, Line, Motor, MotorGenerator, Point, Rotor, Translator,
};
use ga_runtime::geometry::{RotationPath, Screw};
use ga_runtime::scalar::Real;
use nullcone_tests::plain::{
    Vector, cross, largest_difference, length, motor_coefficients, motor_of, times, unit, vector,
};
use proptest::prelude::*;

fn rotor_parts<S: Real>(r: Rotor<S>) -> [S; 4] {
    [r.scalar(), r.e12(), r.e13(), r.e23()]
}

/// The rotation by θ about n, as a rotor's coefficients.
fn rotor_about(n: Vector, angle: f64) -> [f64; 4] {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    [cosine, -sine * n[2], sine * n[1], -sine * n[0]]
}

/// The rotation by θ about the axis through p along n with an advance along it, as a motor's
/// coefficients: with the advance a and m = p × n, the part with ei is `−½ a cos ½θ n − sin ½θ m`,
/// and the coefficient of e123i is `½ a sin ½θ`.
fn screw(p: Vector, n: Vector, angle: f64, advance: f64) -> [f64; 8] {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    let m = cross(p, n);
    let [c, e12, e13, e23] = rotor_about(n, angle);
    let shift = |k: usize| -0.5 * advance * cosine * n[k] - sine * m[k];
    let e123i = 0.5 * advance * sine;
    [c, e12, e13, e23, shift(0), shift(1), shift(2), e123i]
}

/// Close to a full rotation the error of the axis is divided by the sine of half the angle.
fn conditioning(angle: f64) -> f64 {
    if angle < PI {
        1.0
    } else {
        1.0 / (0.5 * angle).sin()
    }
}

proptest! {
    #[test]
    fn powers_rotate_by_a_fraction_of_the_angle(n in unit(), p in vector(5.0), angle in 0.0..6.2_f64, advance in -5.0..5.0_f64, t in -2.0..2.0_f64) {
        let tolerance = 2e-14 * conditioning(angle);
        let power = motor_of(screw(p, n, angle, advance)).powf(t);
        let expected = screw(p, n, t * angle, t * advance);
        prop_assert!(largest_difference(motor_coefficients(power), expected) <= 4.0 * tolerance);
        let [c, e12, e13, e23] = rotor_about(n, angle);
        let rotor = Rotor::new_unchecked(c, e12, e13, e23);
        prop_assert!(largest_difference(rotor_parts(rotor.powf(t)), rotor_about(n, t * angle)) <= tolerance);
        let [x, y, z] = rotor.to_rotation_vector();
        prop_assert!(largest_difference([x, y, z], times(n, angle)) <= tolerance);
        let again = Rotor::from_rotation_vector([x, y, z]).expect("finite");
        prop_assert!(largest_difference(rotor_parts(again), rotor_parts(rotor)) <= tolerance);
        let log = rotor.log();
        prop_assert_eq!([log.e1i, log.e2i, log.e3i], [0.0; 3]);
        prop_assert!(largest_difference(motor_coefficients(log.exp()), motor_coefficients(rotor.into())) <= tolerance);
    }

    #[test]
    fn roots_go_half_the_way(n in unit(), p in vector(5.0), angle in 0.0..6.2_f64, advance in -5.0..5.0_f64) {
        let tolerance = 1e-14 * conditioning(angle);
        let root = motor_of(screw(p, n, angle, advance)).sqrt();
        prop_assert!(largest_difference(motor_coefficients(root), screw(p, n, 0.5 * angle, 0.5 * advance)) <= tolerance);
        let [c, e12, e13, e23] = rotor_about(n, angle);
        let root = Rotor::new_unchecked(c, e12, e13, e23).sqrt();
        prop_assert!(largest_difference(rotor_parts(root), rotor_about(n, 0.5 * angle)) <= tolerance);
    }

    #[test]
    fn translations_and_scalings_have_powers(shift in vector(100.0), factor in 1e-3..1e3_f64, t in -3.0..3.0_f64) {
        let translator = Translator::from_displacement(shift);
        prop_assert!(largest_difference(translator.powf(t).displacement(), times(shift, t)) <= 1e-13);
        prop_assert!(largest_difference(translator.sqrt().displacement(), times(shift, 0.5)) <= 1e-14);
        prop_assert_eq!(translator.log().exp(), translator.into());
        let dilator = Dilator::from_factor(factor).expect("positive");
        prop_assert!((dilator.log() - 0.5 * factor.ln()).abs() <= 1e-15 * factor.ln().abs().max(1.0));
        let power = dilator.powf(t).expect("of moderate size").factor();
        prop_assert!((power / factor.powf(t) - 1.0).abs() <= 1e-14);
        prop_assert!((dilator.sqrt().factor() / factor.sqrt() - 1.0).abs() <= 1e-15);
        prop_assert!(((-dilator).sqrt().factor() / factor.sqrt() - 1.0).abs() <= 1e-15);
        prop_assert_eq!((-dilator).log(), dilator.log());
    }

    /// `sin (1 − t)φ/sin φ · a + sin tφ/sin φ · b` for unit quaternions.
    #[test]
    fn rotors_go_by_slerp(a in unit(), b in unit(), angles in prop::array::uniform2(0.0..6.2_f64), t in -0.5..1.5_f64) {
        let [from, to] = [rotor_about(a, angles[0]), rotor_about(b, angles[1])];
        let cosine: f64 = from.iter().zip(to).map(|(x, y)| x * y).sum();
        prop_assume!(cosine.abs() < 0.999_9 && cosine.abs() > 1e-9);
        let [start, end] = [from, to].map(|[c, x, y, z]| Rotor::new_unchecked(c, x, y, z));
        for path in [RotationPath::Short, RotationPath::Long] {
            let sign = if (cosine > 0.0) == (path == RotationPath::Short) { 1.0 } else { -1.0 };
            let half = (sign * cosine).acos();
            let expected: [f64; 4] = std::array::from_fn(|k| {
                (((1.0 - t) * half).sin() * from[k] + (t * half).sin() * sign * to[k]) / half.sin()
            });
            let found = rotor_parts(start.interpolate_along(end, t, path));
            prop_assert!(largest_difference(found, expected) <= 1e-12, "{path:?}");
        }
        prop_assert_eq!(start.interpolate(end, t), start.interpolate_along(end, t, RotationPath::Short));
    }

    #[test]
    fn motors_go_either_way(n in unit(), p in vector(5.0), angle in 0.1..3.0_f64, advance in -5.0..5.0_f64, t in 0.0..1.0_f64, start in unit(), shift in vector(5.0)) {
        let from = Translator::from_displacement(shift) * Rotor::from_axis_angle(start, 4.0).expect("an axis");
        let between = screw(p, n, angle, advance);
        let to = from * motor_of(between);
        let short = from * motor_of(screw(p, n, t * angle, t * advance));
        // The longer rotation about the same axis, with the same translation along it.
        let long = from * motor_of(screw(p, n, t * (angle - 2.0 * PI), t * advance));
        for end in [to, -to] {
            let found = from.interpolate(end, t);
            prop_assert!(largest_difference(motor_coefficients(found), motor_coefficients(short)) <= 1e-12);
            let found = from.interpolate_along(end, t, RotationPath::Long);
            prop_assert!(largest_difference(motor_coefficients(found), motor_coefficients(long)) <= 1e-11 / angle);
        }
    }

    #[test]
    fn a_versor_and_its_negative_are_the_two_ways(n in unit(), p in vector(5.0), angle in 0.0..6.2_f64, x in vector(3.0)) {
        let any = motor_of(screw(p, n, angle, 1.0));
        let path = if angle <= PI { RotationPath::Short } else { RotationPath::Long };
        prop_assert_eq!(any.path(), path);
        let (short, long) = (any.along(RotationPath::Short), any.along(RotationPath::Long));
        prop_assert_eq!(short, -long);
        prop_assert!(short == any || long == any);
        prop_assert!(short.scalar() >= 0.0 && long.scalar() <= 0.0);
        let x = Point::from(x);
        prop_assert!(short.transform(x).distance(long.transform(x)) <= 1e-14);
        let rotor = any.rotor();
        prop_assert_eq!(rotor.path(), path);
        prop_assert_eq!(Motor::from(rotor.along(RotationPath::Long)), Motor::from(rotor).along(RotationPath::Long));
    }

    #[test]
    fn vectors_are_joined_either_way(a in unit(), b in unit()) {
        let short = Rotor::between(a, b).expect("directions");
        prop_assert_eq!(Rotor::between_along(a, b, RotationPath::Short), Some(short));
        let long = Rotor::between_along(a, b, RotationPath::Long).expect("directions");
        let image = long.transform(Point::from(a)).coordinates();
        prop_assert!(largest_difference(image, b) <= 1e-14);
        let ((n, small), (m, large)) = (short.to_axis_angle(), long.to_axis_angle());
        prop_assert!((small + large - 2.0 * PI).abs() <= 1e-14 && large >= PI - 1e-14);
        prop_assert!(small < 1e-6 || largest_difference(n, times(m, -1.0)) <= 1e-14);
        // Eq. 24: −R = exp(½ (2π − θ) I) with I the unit bivector from a to b.
        let sine = length(cross(a, b));
        prop_assume!(sine > 1e-3);
        let [x, y, z] = times(cross(a, b), 0.5 * large / sine);
        let by_exponential = MotorGenerator::new(z, -y, x, 0.0, 0.0, 0.0).exp();
        prop_assert!(largest_difference(motor_coefficients(by_exponential), motor_coefficients(long.into())) <= 1e-14 / sine);
    }

    #[test]
    fn screws_are_found_and_built(n in unit(), p in vector(5.0), angle in 0.01..6.2_f64, advance in -5.0..5.0_f64) {
        let given = screw(p, n, angle, advance);
        let found = motor_of(given).screw().expect("finite");
        let worst = 1.0 / (0.5 * angle).sin();
        let tolerance = 1e-13 * worst;
        prop_assert!((found.angle - angle).abs() <= tolerance);
        prop_assert!((found.displacement - advance).abs() <= tolerance * worst);
        prop_assert!(largest_difference(found.axis.direction(), n) <= tolerance);
        prop_assert!(found.axis.distance(Point::from(p)).expect("a line") <= tolerance);
        prop_assert!((found.pitch().expect("an axis") - advance / angle).abs() <= 10.0 * tolerance * worst);
        prop_assert!(largest_difference(motor_coefficients(found.to_motor().expect("finite")), given) <= tolerance);
        let generator = found.generator().expect("finite");
        let log = motor_of(given).log();
        prop_assert!(largest_difference([generator.e12, generator.e1i, generator.e3i], [log.e12, log.e1i, log.e3i]) <= tolerance);
        // An axis of any weight, and a fraction of the screw.
        let heavy = Screw { axis: Line::from_point_direction(Point::from(p), times(n, 3.0)), angle, displacement: advance };
        prop_assert!(largest_difference(motor_coefficients(heavy.to_motor().expect("finite")), given) <= 1e-14);
        let half = heavy.part(0.5).to_motor().expect("finite");
        prop_assert!(largest_difference(motor_coefficients(half), screw(p, n, 0.5 * angle, 0.5 * advance)) <= 1e-14);
    }

    /// The nearest motor to `q + ω d` is `q/|q|` with the part of d along q left out.
    #[test]
    fn normalising_repairs_length_and_study_condition(n in unit(), p in vector(5.0), angle in 0.0..6.2_f64, size in 0.1..10.0_f64, noise in prop::array::uniform8(-0.1..0.1_f64)) {
        let exact = screw(p, n, angle, 1.0);
        let off: [f64; 8] = std::array::from_fn(|k| size * (exact[k] + noise[k]));
        let [s, e12, e13, e23, e1i, e2i, e3i, e123i] = off;
        let found = Motor::normalize(DualQuaternion::new(s, e12, e13, e23, e1i, e2i, e3i, e123i));
        let found = motor_coefficients(found.expect("not zero"));
        // ω = e123i takes 1, e12, e13, e23 to e123i, −e3i, e2i, −e1i.
        let (q, d) = ([s, e12, e13, e23], [e123i, -e3i, e2i, -e1i]);
        let product = |a: [f64; 4], b: [f64; 4]| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
        let norm = product(q, q).sqrt();
        let along = product(q, d) / (norm * norm);
        let [x0, x3, x2, x1]: [f64; 4] = std::array::from_fn(|k| (d[k] - along * q[k]) / norm);
        let expected = [s / norm, e12 / norm, e13 / norm, e23 / norm, -x1, x2, -x3, x0];
        prop_assert!(largest_difference(found, expected) <= 1e-14);
        // Norm 1 and the Study condition hold, and a motor that satisfies them already stays as it
        // is.
        let (q, d) = ([found[0], found[1], found[2], found[3]], [found[7], -found[6], found[5], -found[4]]);
        prop_assert!((product(q, q) - 1.0).abs() <= 1e-15 && product(q, d).abs() <= 1e-14);
        let [s, e12, e13, e23, e1i, e2i, e3i, e123i] = exact;
        let same = Motor::normalize(DualQuaternion::new(s, e12, e13, e23, e1i, e2i, e3i, e123i));
        prop_assert!(largest_difference(motor_coefficients(same.expect("not zero")), exact) <= 1e-14);
    }
}

#[test]
fn slerp_is_stable_where_rotors_agree_or_oppose() {
    let n = [0.0, 0.6, 0.8];
    for off in [0.0, 1e-300, 1e-160, 1e-16, 1e-12, 1e-8, 1e-4] {
        // From the identity to a rotation by `off` and to its negative, by 2π − `off`: the short
        // way goes through fractions of `off`.
        let [c, x, y, z] = rotor_about(n, off);
        for end in [
            Rotor::new_unchecked(c, x, y, z),
            Rotor::new_unchecked(-c, -x, -y, -z),
        ] {
            for t in [0.0, 0.25, 0.5, 1.0] {
                let found = rotor_parts(Rotor::default().interpolate(end, t));
                let expected = rotor_about(n, t * off);
                assert!(largest_difference(found, expected) <= 1e-15, "{off:e}");
                assert!(
                    (found[1] - expected[1]).abs() <= 1e-15 * expected[1].abs(),
                    "{off:e}"
                );
            }
        }
        // To rotations just below and above 180°, where the short way changes sides.
        let [c, x, y, z] = rotor_about(n, PI - off);
        let found =
            rotor_parts(Rotor::default().interpolate(Rotor::new_unchecked(c, x, y, z), 0.5));
        assert!(
            largest_difference(found, rotor_about(n, 0.5 * (PI - off))) <= 1e-15,
            "{off:e}"
        );
    }
    // The long way between equal rotors is a full rotation in e12.
    let one = Rotor::<f64>::default();
    let half = one.interpolate_along(one, 0.5, RotationPath::Long);
    assert!(largest_difference(rotor_parts(half), [0.0, 1.0, 0.0, 0.0]) <= 1e-15);
}

#[test]
fn roots_of_full_rotations() {
    let minus_one = -Motor::<f64>::default();
    assert!(
        largest_difference(
            motor_coefficients(minus_one.sqrt()),
            [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
        ) <= 1e-15
    );
    assert_eq!(
        (-Rotor::<f64>::default()).sqrt(),
        Rotor::new_unchecked(0.0, 1.0, 0.0, 0.0)
    );
    // The root of the negative of a translator gives it back when squared.
    let shift = -Motor::from(Translator::from_displacement([2.0, -4.0, 4.0]));
    let root = shift.sqrt();
    assert!(
        largest_difference(motor_coefficients(root * root), motor_coefficients(shift)) <= 1e-14
    );
    assert!(root.scalar().abs() <= 1e-15);
    // The root of a rotation by 180° is one by 90°, in the direction of its sign.
    let half = Rotor::new_unchecked(0.0, 0.0, 0.0, -1.0);
    assert!(
        largest_difference(
            rotor_parts(half.sqrt()),
            [0.5_f64.sqrt(), 0.0, 0.0, -(0.5_f64.sqrt())]
        ) <= 1e-15
    );
    // Near a full rotation the root keeps the plane, however little the rotor differs from −1.
    for sine in [1e-3, 1e-8, 1e-16, 1e-100, 1e-300] {
        let root =
            Rotor::new_unchecked(-(1.0 - sine * sine).sqrt(), 0.0, 0.6 * sine, 0.8 * sine).sqrt();
        let expected = [0.5 * sine, 0.0, 0.6, 0.8];
        assert!(
            largest_difference(rotor_parts(root), expected) <= sine * sine + 1e-15,
            "{sine:e}"
        );
        assert!(
            (root.scalar() / expected[0] - 1.0).abs() <= sine * sine + 1e-15,
            "{sine:e}"
        );
    }
}

#[test]
fn powers_of_full_rotations() {
    let quarter = (-Motor::<f64>::default()).powf(0.5);
    assert!(
        largest_difference(
            motor_coefficients(quarter),
            [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
        ) <= 1e-15
    );
    let shift = -Motor::from(Translator::from_displacement([0.0, 0.0, 6.0]));
    // A third of the full rotation about the axis along the translation, with a third of the
    // translation.
    let third = shift
        .powf(1.0 / 3.0)
        .transform(Point::new(1.0, 0.0, 0.0))
        .coordinates();
    assert!((third[2] - 2.0).abs() <= 1e-14 && (third[0] + 0.5).abs() <= 1e-14);
}

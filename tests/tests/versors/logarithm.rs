//! Exponential and logarithm of rigid motions: against closed forms in plain coordinates, round
//! trips at every angle and size, and results for numbers that are not a motion.
//!
//! Loops over random motions run [`COUNT`] times, fewer in a debug build.

use std::f64::consts::PI;

use ga_runtime::cga3::{Motor, MotorGenerator, Rotor, Translator};
use ga_runtime::scalar::{Dual, Lanes, Real};
use nullcone_tests::plain::{Vector, cross, dot, largest_difference, motor_coefficients, motor_of};
use nullcone_tests::random::SplitMix64;
use proptest::prelude::*;

const COUNT: usize = if cfg!(debug_assertions) {
    40_000
} else {
    1_000_000
};

fn entries<S: Real>(g: MotorGenerator<S>) -> [S; 6] {
    [g.e12, g.e13, g.e23, g.e1i, g.e2i, g.e3i]
}

fn from_entries<S: Real>([e12, e13, e23, e1i, e2i, e3i]: [S; 6]) -> MotorGenerator<S> {
    MotorGenerator {
        e12,
        e13,
        e23,
        e1i,
        e2i,
        e3i,
    }
}

/// The generator and the motor of a right-handed rotation by θ about the axis through p, with an
/// advance along it, in plain coordinates: the velocity of the origin is `advance · n + θ p × n`,
/// and its displacement `advance · n + p − R p`.
fn screw_about(p: Vector, n: Vector, angle: f64, advance: f64) -> ([f64; 6], [f64; 8]) {
    let moment = cross(p, n);
    let velocity: Vector = std::array::from_fn(|k| advance * n[k] + angle * moment[k]);
    let half = 0.5 * angle;
    let generator = [
        -half * n[2],
        half * n[1],
        -half * n[0],
        -0.5 * velocity[0],
        -0.5 * velocity[1],
        -0.5 * velocity[2],
    ];
    // T R with t = advance n + sin θ p × n + (1 − cos θ)(p − n n·p): the ei part is −½ t (cos ½θ −
    // sin ½θ B), and with t = a n + 2 sin ½θ (cos ½θ p×n + sin ½θ p⊥) its vector part is −½ a cos
    // ½θ n − sin ½θ p × n, its trivector part ½ a sin ½θ.
    let (sine, cosine) = half.sin_cos();
    let shift: Vector = std::array::from_fn(|k| -0.5 * advance * cosine * n[k] - sine * moment[k]);
    let motor = [
        cosine,
        -sine * n[2],
        sine * n[1],
        -sine * n[0],
        shift[0],
        shift[1],
        shift[2],
        0.5 * advance * sine,
    ];
    (generator, motor)
}

fn size(numbers: &[f64]) -> f64 {
    numbers.iter().fold(1.0, |most: f64, x| most.max(x.abs()))
}

#[test]
fn closed_forms() {
    let mut numbers = SplitMix64(1);
    let mut worst = [0.0_f64; 2];
    for _ in 0..COUNT {
        let (n, p) = (numbers.axis(), numbers.vector(10.0));
        let (angle, advance) = (numbers.unit() * 2.0 * PI, numbers.vector(10.0)[0]);
        let (generator, motor) = screw_about(p, n, angle, advance);
        let found = motor_coefficients(from_entries(generator).exp());
        // The rounding of the angle is amplified by θ |p| and the advance.
        let arm = size(&generator);
        worst[0] = worst[0].max(largest_difference(found, motor) / arm.max(size(&motor)));
        // The axis is known up to an error divided by the sine of half the angle; below 90° the
        // sine is not needed.
        let conditioning = if angle < PI {
            1.0
        } else {
            1.0 / (0.5 * angle).sin()
        };
        let found = entries(motor_of(motor).log());
        let error = largest_difference(found, generator) / size(&generator) / conditioning;
        worst[1] = worst[1].max(error);
    }
    assert!(worst[0] <= 2e-15, "exp is off by {:e}", worst[0]);
    assert!(worst[1] <= 4e-15, "log is off by {:e}", worst[1]);
}

/// Of `exp(log M)` against M, relative to the largest coefficient and 1.
fn round_trip(motor: [f64; 8]) -> f64 {
    let again = motor_coefficients(motor_of(motor).log().exp());
    largest_difference(again, motor) / size(&motor)
}

#[test]
fn random_motions_survive_a_round_trip() {
    let mut numbers = SplitMix64(2);
    let mut worst = 0.0_f64;
    for _ in 0..COUNT {
        let rotor = Rotor::from_axis_angle(numbers.axis(), numbers.unit() * 6.0).expect("an axis");
        let motor = motor_coefficients(Translator::from_displacement(numbers.vector(10.0)) * rotor);
        let conditioning = if motor[0] > 0.0 {
            1.0
        } else {
            1.0 / (1.0 - motor[0] * motor[0]).sqrt()
        };
        worst = worst.max(round_trip(motor) / conditioning);
    }
    assert!(worst <= 4e-15, "off by {worst:e}");
}

#[test]
fn random_generators_survive_a_round_trip() {
    let mut numbers = SplitMix64(9);
    let mut worst = 0.0_f64;
    for _ in 0..COUNT {
        let (n, p) = (numbers.axis(), numbers.vector(10.0));
        let (angle, advance) = (numbers.unit() * 6.2, numbers.vector(10.0)[0]);
        let (generator, _) = screw_about(p, n, angle, advance);
        let again = entries(from_entries(generator).exp().log());
        let conditioning = if angle < PI {
            1.0
        } else {
            1.0 / (0.5 * angle).sin()
        };
        worst = worst.max(largest_difference(again, generator) / size(&generator) / conditioning);
    }
    assert!(worst <= 5e-15, "off by {worst:e}");
}

#[test]
fn every_angle_and_size_survives_a_round_trip() {
    let mut numbers = SplitMix64(3);
    let angles = [
        0.0,
        1e-300,
        1e-200,
        1e-160,
        1e-155,
        1e-150,
        1e-100,
        1e-30,
        1e-16,
        1e-12,
        1e-8,
        1e-4,
        0.1,
        1.0,
        PI / 2.0,
        PI - 1e-6,
        PI - 1e-12,
        PI,
        PI + 1e-12,
        4.0,
        5.0,
    ];
    for angle in angles {
        for exponent in -12..=12 {
            for _ in 0..20 {
                let rotor = Rotor::from_axis_angle(numbers.axis(), angle).expect("an axis");
                let shift = numbers.vector(10_f64.powi(exponent));
                let motor = motor_coefficients(Translator::from_displacement(shift) * rotor);
                let error = round_trip(motor);
                assert!(error <= 1e-14, "{angle:e}, 1e{exponent}: {error:e}");
                // Relative to the translation as well, however small it is.
                let again = motor_coefficients(motor_of(motor).log().exp());
                let ends = [4, 5, 6, 7].map(|k| again[k] - motor[k]);
                let most = [4, 5, 6, 7]
                    .iter()
                    .fold(0.0, |m: f64, &k| m.max(motor[k].abs()));
                let error = largest_difference(ends, [0.0; 4]);
                assert!(error <= 1e-14 * most, "{angle:e}, 1e{exponent}: {error:e}");
            }
        }
    }
}

#[test]
fn almost_full_rotations_are_as_accurate_as_their_conditioning() {
    let mut numbers = SplitMix64(4);
    for missing in [1e-1, 1e-3, 1e-6, 1e-9, 1e-12] {
        for _ in 0..100 {
            let rotor =
                Rotor::from_axis_angle(numbers.axis(), 2.0 * PI - missing).expect("an axis");
            let motor =
                motor_coefficients(Translator::from_displacement(numbers.vector(10.0)) * rotor);
            let error = round_trip(motor);
            assert!(error <= 4e-15 * (2.0 / missing), "{missing:e}: {error:e}");
        }
    }
    // Half the angle rounds to π, as for a full rotation.
    for missing in [1e-17, 1e-30, 1e-160, 1e-200, 1e-300, 5e-324] {
        for _ in 0..20 {
            let n = numbers.axis();
            let [x, y, z] = n.map(|x| x * missing);
            let t = numbers.vector(10.0).map(|t| 0.5 * t);
            let along = dot(t, n) * missing;
            let motor = [-1.0, -z, y, -x, t[0], t[1], t[2], along];
            let error = round_trip(motor);
            assert!(error <= 2e-15, "{missing:e}: {error:e}");
        }
    }
}

#[test]
fn full_rotations() {
    let one = Motor::<f64>::default();
    let in_e12 = MotorGenerator::new(PI, 0.0, 0.0, 0.0, 0.0, 0.0);
    assert_eq!((-one).log(), in_e12);
    assert!(round_trip(motor_coefficients(-one)) <= 1e-15);
    // The negative of a translator is a full rotation about the axis along the translation: [0, −3,
    // 4] is the plane 3/5 e13 + 4/5 e12 up to its sign.
    let shift = Motor::from(Translator::from_displacement([0.0, -3.0, 4.0]));
    let log = (-shift).log();
    let expected = MotorGenerator::new(-0.8 * PI, -0.6 * PI, 0.0, 0.0, 1.5, -2.0);
    let other = MotorGenerator::new(0.8 * PI, 0.6 * PI, 0.0, 0.0, 1.5, -2.0);
    let error = largest_difference(entries(log), entries(expected))
        .min(largest_difference(entries(log), entries(other)));
    assert!(error <= 1e-15, "{log}");
    // A rotation that is almost full keeps its plane.
    let tilted = Motor::new_unchecked(-1.0, 0.0, 1e-30, 0.0, 0.0, 0.0, 0.0, 0.0);
    assert_eq!(
        tilted.log(),
        MotorGenerator::new(0.0, PI, 0.0, 0.0, 0.0, 0.0)
    );
    // Translations from the smallest to the largest.
    for size in [5e-324, 1e-300, 1e-160, 1.0, 1e160, 1e300] {
        let motor = [-1.0, 0.0, 0.0, 0.0, size, 0.0, -size, 0.0];
        let again = motor_coefficients(motor_of(motor).log().exp());
        assert!(
            largest_difference(again, motor) <= 1e-15 * size.max(1.0),
            "{size:e}"
        );
    }
}

#[test]
fn single_precision() {
    let mut numbers = SplitMix64(5);
    let mut worst = 0.0_f64;
    for _ in 0..COUNT {
        let rotor = Rotor::from_axis_angle(numbers.axis(), numbers.unit() * PI).expect("an axis");
        let motor = motor_coefficients(Translator::from_displacement(numbers.vector(10.0)) * rotor);
        let single = motor.map(|x| x as f32);
        let again = motor_coefficients(motor_of(single).log().exp()).map(f64::from);
        let given = single.map(f64::from);
        worst = worst.max(largest_difference(again, given) / size(&given));
    }
    assert!(worst <= 5e-7, "off by {worst:e}");
    for angle in [0.0_f32, 1e-38, 1e-20, 1e-7, 1e-3] {
        for shift in [1e-12_f32, 1.0, 1e12] {
            let rotor = Rotor::from_axis_angle([0.6, 0.0, 0.8_f32], angle).expect("an axis");
            let motor = Translator::from_displacement([shift, -shift, 0.5 * shift]) * rotor;
            let (given, again) = (
                motor_coefficients(motor),
                motor_coefficients(motor.log().exp()),
            );
            let error = largest_difference(given.map(f64::from), again.map(f64::from));
            assert!(
                error <= 5e-7 * f64::from(shift.max(1.0)),
                "{angle:e}, {shift:e}: {error:e}"
            );
        }
    }
}

#[test]
fn large_angles_are_kept_modulo_full_rotations() {
    let mut numbers = SplitMix64(6);
    for _ in 0..2000 {
        // Rotations by up to 10⁴ radians, against the closed form.
        let (n, p) = (numbers.axis(), numbers.vector(1.0));
        let angle = numbers.unit() * 1e4;
        let (generator, motor) = screw_about(p, n, angle, numbers.unit());
        let error = largest_difference(motor_coefficients(from_entries(generator).exp()), motor)
            / size(&motor);
        assert!(error <= 1e-15 * angle.max(1.0), "{angle}: {error:e}");
    }
    // The last angles of the polynomials and the first beyond them: φ² = 9.95.
    for k in -3..=3 {
        let half = 9.95_f64.sqrt() + f64::from(k) * 1e-15;
        let motor = MotorGenerator::new(half, 0.0, 0.0, 0.0, 0.0, 1.0).exp();
        let (sine, cosine) = half.sin_cos();
        let expected = [cosine, sine, 0.0, 0.0, 0.0, 0.0, cosine, sine];
        assert!(
            largest_difference(motor_coefficients(motor), expected) <= 1e-15,
            "{half}"
        );
    }
}

#[test]
fn finite_numbers_never_become_nan() {
    let mut numbers = SplitMix64(7);
    let extremes = [
        0.0,
        -0.0,
        5e-324,
        1e-160,
        -1.0,
        1.0,
        PI,
        1e160,
        f64::MAX,
        f64::MIN,
    ];
    for round in 0..COUNT {
        let number = |numbers: &mut SplitMix64| match round % 3 {
            0 => numbers.finite(),
            1 => extremes[(numbers.bits() >> 40) as usize % extremes.len()],
            _ => 2.0 * numbers.unit() - 1.0,
        };
        let motor: [f64; 8] = std::array::from_fn(|_| number(&mut numbers));
        let log = entries(motor_of(motor).log());
        assert!(log.iter().all(|x| !x.is_nan()), "log of {motor:?}: {log:?}");
        let generator: [f64; 6] = std::array::from_fn(|_| number(&mut numbers));
        let exp = motor_coefficients(from_entries(generator).exp());
        assert!(
            exp.iter().all(|x| !x.is_nan()),
            "exp of {generator:?}: {exp:?}"
        );
        let single = motor.map(|x| (x as f32).clamp(f32::MIN, f32::MAX));
        let log = entries(motor_of(single).log());
        assert!(
            log.iter().all(|x| !x.is_nan()),
            "log of {single:?}: {log:?}"
        );
        let single = generator.map(|x| (x as f32).clamp(f32::MIN, f32::MAX));
        let exp = motor_coefficients(from_entries(single).exp());
        assert!(
            exp.iter().all(|x| !x.is_nan()),
            "exp of {single:?}: {exp:?}"
        );
    }
}

#[test]
fn nan_and_infinity_do_not_vanish() {
    let (_, motor) = screw_about([1.0, 2.0, 3.0], [0.6, 0.0, 0.8], 1.0, 0.5);
    let identity = motor_coefficients(Motor::<f64>::default());
    let shift = motor_coefficients(Motor::from(Translator::from_displacement([1.0, 2.0, 3.0])));
    for base in [
        motor,
        identity,
        shift,
        identity.map(|x: f64| -x),
        shift.map(|x: f64| -x),
    ] {
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for place in 0..8 {
                let mut motor = base;
                motor[place] = wrong;
                let log = entries(motor_of(motor).log());
                assert!(
                    log.iter().any(|x| !x.is_finite()),
                    "log of {motor:?}: {log:?}"
                );
            }
        }
    }
    for base in [[0.3, -0.2, 0.1, 1.0, 2.0, 3.0], [0.0; 6], [5.0; 6]] {
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for place in 0..6 {
                let mut generator = base;
                generator[place] = wrong;
                let exp = motor_coefficients(from_entries(generator).exp());
                assert!(
                    exp.iter().any(|x| !x.is_finite()),
                    "exp of {generator:?}: {exp:?}"
                );
            }
        }
    }
}

#[test]
fn logarithms_ignore_the_length_of_a_motor() {
    let (generator, motor) = screw_about([1.0, -2.0, 0.5], [0.0, 0.6, 0.8], 2.0, 3.0);
    for factor in [1e-300, 1e-200, 1e-10, 0.5, 2.0, 1e10, 1e200, 1e300] {
        let log = entries(motor_of(motor.map(|x| x * factor)).log());
        assert!(
            largest_difference(log, generator) <= 1e-14,
            "{factor:e}: {log:?}"
        );
    }
}

#[test]
fn lanes_are_singles_side_by_side() {
    let mut numbers = SplitMix64(8);
    // One of the first four lanes needs the careful computation, the others do not.
    let angles = [[0.3, 2.0, 1e-9, 9.0], [0.3, 2.0, 1e-9, 4.0]];
    for angles in angles {
        let generators = angles
            .map(|angle| screw_about(numbers.vector(3.0), numbers.axis(), angle, numbers.unit()).0);
        let side_by_side = std::array::from_fn(|k| Lanes::from_array(generators.map(|g| g[k])));
        let motor = from_entries::<Lanes<f64, 4>>(side_by_side).exp();
        let log = motor.log();
        for lane in 0..4 {
            let alone = from_entries(generators[lane]).exp();
            assert_eq!(
                motor_coefficients(motor).map(|x| x[lane]),
                motor_coefficients(alone)
            );
            assert_eq!(entries(log).map(|x| x[lane]), entries(alone.log()));
        }
    }
    let motors = [
        motor_coefficients(-Motor::<f64>::default()),
        screw_about([1.0, 2.0, 3.0], [1.0, 0.0, 0.0], 5.0, 1.0).1,
    ];
    let side_by_side = std::array::from_fn(|k| Lanes::from_array(motors.map(|m| m[k])));
    let log = motor_of::<Lanes<f64, 2>>(side_by_side).log();
    for lane in 0..2 {
        let alone = entries(motor_of(motors[lane]).log());
        assert_eq!(entries(log).map(|x| x[lane]), alone);
    }
}

#[test]
fn derivatives_of_rotations_by_any_angle() {
    // Of the closed form by the angle: d/dθ at fixed axis and advance.
    for angle in [
        0.0, 1e-300, 1e-20, 1e-12, 1e-8, 1e-4, 0.1, 1.0, 3.0, 6.0, 8.0,
    ] {
        let (p, n, advance) = ([1.0, -2.0, 0.5], [0.0, 0.6, 0.8], 3.0);
        let (generator, motor) = screw_about(p, n, angle, advance);
        let (rate, _) = screw_about(p, n, 1.0, 0.0);
        let moving = std::array::from_fn(|k| Dual::new(generator[k], [rate[k]]));
        let image = motor_coefficients(from_entries::<Dual<f64>>(moving).exp());
        assert_eq!(
            image.map(|x| x.value),
            motor_coefficients(from_entries(generator).exp())
        );
        let (sine, cosine) = (0.5 * angle).sin_cos();
        let moment = cross(p, n);
        let slope = |k: usize| 0.25 * advance * sine * n[k] - 0.5 * cosine * moment[k];
        let expected = [
            -0.5 * sine,
            -0.5 * cosine * n[2],
            0.5 * cosine * n[1],
            -0.5 * cosine * n[0],
            slope(0),
            slope(1),
            slope(2),
            0.25 * advance * cosine,
        ];
        let error = largest_difference(image.map(|x| x.derivative()), expected);
        assert!(error <= 1e-14, "exp at {angle:e}: {error:e}");
        if angle < 6.1 {
            let moving = std::array::from_fn(|k| Dual::new(motor[k], [expected[k]]));
            let log = entries(motor_of::<Dual<f64>>(moving).log());
            let error = largest_difference(log.map(|x| x.derivative()), rate);
            assert!(error <= 1e-12, "log at {angle:e}: {error:e}");
        }
    }
}

proptest! {
    #[test]
    fn generators_survive_a_round_trip(
        n in prop::array::uniform3(-1.0..1.0_f64),
        shift in prop::array::uniform3(-10.0..10.0_f64),
        half in 0.0..3.1_f64,
    ) {
        let length = dot(n, n).sqrt();
        prop_assume!(length > 0.01);
        let [x, y, z] = n.map(|n| n / length * half);
        let generator = [-z, y, -x, shift[0], shift[1], shift[2]];
        let again = entries(from_entries(generator).exp().log());
        let conditioning = if half < PI / 2.0 { 1.0 } else { 1.0 / half.sin() };
        let error = largest_difference(again, generator) / size(&generator);
        prop_assert!(error <= 4e-15 * conditioning, "{error:e}");
    }

    #[test]
    fn the_functions_of_half_the_angle(half in 0.0..3.15_f64, quarter in 0.0..1.57_f64) {
        let x = half * half;
        let (cosine, ratio, slope) = x.sine_by_angle();
        prop_assert!((cosine - half.cos()).abs() <= 4.5e-16);
        prop_assert!((half * ratio - half.sin()).abs() <= 7e-16);
        prop_assert!((x * slope - (cosine - ratio)).abs() <= 1e-15);
        let (sine, cosine) = quarter.sin_cos();
        let (ratio, slope) = cosine.angle_by_sine();
        prop_assert!((ratio * sine - quarter).abs() <= 9e-16);
        // Seven units of 2⁻⁵², the most in thirty million samples.
        prop_assert!((slope * sine * sine - (cosine - ratio)).abs() <= 1.6e-15);
    }
}

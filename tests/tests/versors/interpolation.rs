//! Slerp and nlerp: against closed forms, against the exponential of the logarithm, at the ends of
//! their range, and in slices.

use core::f64::consts::{FRAC_PI_2, PI};

use ga_runtime::batch::{self, Batch, InstructionSet, LengthMismatch};
use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::scalar::{Dual, Lanes, Real};
use nullcone_tests::plain::{Vector, largest_difference, motor_coefficients, unit, vector};
use proptest::prelude::*;

fn motor(axis: Vector, angle: f64, displacement: Vector) -> Motor<f64> {
    let rotor = Rotor::from_axis_angle(axis, angle).expect("an axis");
    Translator::from_displacement(displacement) * rotor
}

fn single(motor: Motor<f64>) -> Motor<f32> {
    let [s, a, b, c, x, y, z, w] = motor_coefficients(motor).map(|x| x as f32);
    Motor::new_unchecked(s, a, b, c, x, y, z, w)
}

fn double(motor: Motor<f32>) -> [f64; 8] {
    [
        motor.scalar(),
        motor.e12(),
        motor.e13(),
        motor.e23(),
        motor.e1i(),
        motor.e2i(),
        motor.e3i(),
        motor.e123i(),
    ]
    .map(f64::from)
}

fn rotor_coefficients(rotor: Rotor<f64>) -> [f64; 4] {
    [rotor.scalar(), rotor.e12(), rotor.e13(), rotor.e23()]
}

/// `sin tφ/sin φ`, without a division by zero.
fn share(angle: f64, t: f64) -> f64 {
    if angle < 1e-5 {
        t * (1.0 + (1.0 - t * t) * angle * angle / 6.0)
    } else {
        (t * angle).sin() / angle.sin()
    }
}

proptest! {
    #[test]
    fn the_factors_are_quotients_of_sines(angle in 0.0..=FRAC_PI_2, exponent in -160.0..0.0_f64, t in 0.0..=1.0_f64) {
        for angle in [angle, angle * 10_f64.powf(exponent)] {
            let factors = angle.cos().arc_factors(t);
            prop_assert!((factors.first - share(angle, 1.0 - t)).abs() <= 9e-16, "{factors:?}");
            prop_assert!((factors.second - share(angle, t)).abs() <= 9e-16, "{factors:?}");
            let single = (angle.cos() as f32).arc_factors(t as f32);
            prop_assert!((f64::from(single.first) - share(angle, 1.0 - t)).abs() <= 1.5e-7);
            prop_assert!((f64::from(single.second) - share(angle, t)).abs() <= 1.5e-7);
        }
    }

    #[test]
    fn the_slopes_are_derivatives(cosine in 0.0..=1.0_f64, t in -1.0..=1.0_f64) {
        let factors = Dual::<f64>::variable(cosine).arc_factors(Dual::constant(t));
        prop_assert!((factors.first.derivative() - factors.first_slope.value).abs() <= 1e-14);
        prop_assert!((factors.second.derivative() - factors.second_slope.value).abs() <= 1e-14);
        // Of the closed form, by a difference.
        let (step, at) = (1e-5, cosine.clamp(1e-4, 0.99));
        let both = [at + step, at - step].map(|c| share(c.acos(), t));
        let slope = at.arc_factors(t).second_slope;
        prop_assert!(((both[0] - both[1]) / (2.0 * step) - slope).abs() <= 1e-8);
    }

    #[test]
    fn slerp_is_the_exponential_of_the_logarithm(
        axes in prop::array::uniform2(unit()),
        angles in prop::array::uniform2(-6.0..6.0_f64),
        shifts in prop::array::uniform2(vector(100.0)),
        t in -4.0..5.0_f64,
    ) {
        let from = motor(axes[0], angles[0], shifts[0]);
        let to = motor(axes[1], angles[1], shifts[1]);
        let between = from.reverse() * to;
        prop_assume!(between.scalar().abs() > 1e-6);
        let short = if between.scalar() < 0.0 { -between } else { between };
        let expected = motor_coefficients(from * (short.log() * t).exp());
        let found = motor_coefficients(from.interpolate(to, t));
        prop_assert!(largest_difference(found, expected) <= 1e-12 * (1.0 + t.abs()));
        let rotor = from.rotor().interpolate(to.rotor(), t);
        prop_assert!(largest_difference(rotor_coefficients(rotor), rotor_coefficients((from * (short.log() * t).exp()).rotor())) <= 1e-14 * (1.0 + t.abs()));
        // In single precision, relative to the displacements, and to twice as much outside.
        let found = double(single(from).interpolate(single(to), t as f32));
        prop_assert!(largest_difference(found, expected) <= 1e-6 * 100.0 * (1.0 + t * t));
    }

    #[test]
    fn slerp_keeps_unit_motors_and_ends(axis in unit(), angle in -PI..PI, shift in vector(1000.0), t in 0.0..=1.0_f64) {
        let from = motor([0.0, 0.6, 0.8], 2.0, [3.0, -900.0, 5.0]);
        let to = motor(axis, angle, shift);
        let found = from.interpolate(to, t);
        let norm = motor_coefficients(found.reverse() * found);
        prop_assert!(largest_difference(norm, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]) <= 2e-12);
        prop_assert_eq!(from.interpolate(to, 0.0), from);
        let end = motor_coefficients(from.interpolate(to, 1.0));
        let expected = motor_coefficients(to);
        let opposite = expected.map(|x| -x);
        prop_assert!(largest_difference(end, expected).min(largest_difference(end, opposite)) <= 1e-12);
    }

    #[test]
    fn translations_are_interpolated_linearly(shifts in prop::array::uniform2(vector(1e4)), t in -1.0..2.0_f64) {
        let [from, to] = shifts.map(|shift| Motor::from(Translator::from_displacement(shift)));
        let expected: Vector = std::array::from_fn(|k| (1.0 - t) * shifts[0][k] + t * shifts[1][k]);
        for found in [from.interpolate(to, t), from.interpolate(-to, t), from.nlerp(to, t)] {
            prop_assert!(largest_difference(found.translator().displacement(), expected) <= 4e-11);
            prop_assert!(largest_difference(rotor_coefficients(found.rotor()), [1.0, 0.0, 0.0, 0.0]) <= 4e-15);
        }
    }

    #[test]
    fn nlerp_is_the_blend_of_two(
        axes in prop::array::uniform2(unit()),
        angles in prop::array::uniform2(-6.0..6.0_f64),
        shifts in prop::array::uniform2(vector(10.0)),
        t in 0.0..=1.0_f64,
    ) {
        let from = motor(axes[0], angles[0], shifts[0]);
        let to = motor(axes[1], angles[1], shifts[1]);
        let blend = Motor::blend(&[(1.0 - t, from), (t, to)]).expect("weights");
        let found = from.nlerp(to, t);
        let sign = if (found.rotor().reverse() * blend.rotor()).scalar() < 0.0 { -1.0 } else { 1.0 };
        let expected = motor_coefficients(blend).map(|x| x * sign);
        prop_assert!(largest_difference(motor_coefficients(found), expected) <= 1e-14);
        let rotor = from.rotor().nlerp(to.rotor(), t);
        prop_assert!(largest_difference(rotor_coefficients(rotor), rotor_coefficients(found.rotor())) <= 1e-15);
        // Half of the way it is slerp.
        let (middle, expected) = (from.nlerp(to, 0.5), from.interpolate(to, 0.5));
        prop_assert!(largest_difference(motor_coefficients(middle), motor_coefficients(expected)) <= 1e-13);
    }

    #[test]
    fn slices_and_lanes_agree_with_single_motors(seeds in prop::collection::vec((unit(), -6.0..6.0_f64, vector(10.0), -1.5..2.5_f64), 0..21)) {
        let to: Vec<_> = seeds.iter().map(|(axis, angle, shift, _)| motor(*axis, *angle, *shift)).collect();
        let from: Vec<_> = to.iter().rev().map(|m| m.reverse()).collect();
        let t: Vec<_> = seeds.iter().map(|seed| seed.3).collect();
        let pairs = from.iter().zip(&to).zip(&t);
        let slerps: Vec<_> = pairs.clone().map(|((a, b), t)| a.interpolate(*b, *t)).collect();
        let nlerps: Vec<_> = pairs.map(|((a, b), t)| a.nlerp(*b, *t)).collect();
        for set in [InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512] {
            let mut found = from.clone();
            Batch::on(set).interpolate(&from, &to, &t, &mut found).expect("lengths");
            prop_assert_eq!(&found, &slerps);
            Batch::on(set).nlerp(&from, &to, &t, &mut found).expect("lengths");
            prop_assert_eq!(&found, &nlerps);
        }
        let [from, to, slerps] = [from, to, slerps].map(|list| list.into_iter().map(single).collect::<Vec<_>>());
        let t: Vec<_> = t.into_iter().map(|t| t as f32).collect();
        let mut found = from.clone();
        batch::interpolate(&from, &to, &t, &mut found).expect("lengths");
        for (found, expected) in found.into_iter().zip(slerps) {
            prop_assert!(largest_difference(double(found), double(expected)) <= 1e-4);
        }
    }
}

#[test]
fn half_turns_have_two_short_ways() {
    let half = Rotor::from_axis_angle([0.0, 0.6, 0.8], PI).expect("an axis");
    for sign in [1.0, -1.0] {
        let end = if sign < 0.0 { -half } else { half };
        let found = rotor_coefficients(Rotor::default().interpolate(end, 0.5));
        let quarter = Rotor::from_axis_angle([0.0, 0.6, 0.8], FRAC_PI_2).expect("an axis");
        let either = [quarter, quarter.reverse()].map(rotor_coefficients);
        let error = either.map(|expected| largest_difference(found, expected));
        assert!(error[0].min(error[1]) <= 4e-16, "{found:?}");
    }
}

#[test]
fn what_is_not_finite_gives_nan_and_nothing_else_does() {
    let (from, to) = (
        motor([1.0, 0.0, 0.0], 1.0, [1e300, 0.0, -1e300]),
        motor([0.0, 1.0, 0.0], 2.0, [0.0, 1e300, 1e300]),
    );
    for t in [-1e3, -1.0, 0.0, 0.3, 1.0, 7.0] {
        let found = motor_coefficients(from.interpolate(to, t));
        assert!(found.iter().all(|x| x.is_finite()), "{t}: {found:?}");
    }
    for t in [f64::NAN, f64::INFINITY] {
        assert!(from.interpolate(to, t).scalar().is_nan());
        assert!(from.nlerp(to, t).scalar().is_nan());
        assert!(from.rotor().interpolate(to.rotor(), t).scalar().is_nan());
    }
    let broken = Motor::new_unchecked(f64::NAN, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    assert!(broken.interpolate(to, 0.5).scalar().is_nan());
    assert!(to.interpolate(broken, 0.5).scalar().is_nan());
    // One lane that is not finite leaves the others as they are.
    let motors = [from, broken, to, from];
    let lanes =
        Motor::from_lanes(&motors).interpolate(Motor::from_lanes(&[to; 4]), Lanes::splat(0.5));
    assert_eq!(lanes.lane(0), from.interpolate(to, 0.5));
    assert_eq!(lanes.lane(3), from.interpolate(to, 0.5));
    assert!(lanes.lane(1).scalar().is_nan());
}

#[test]
fn slices_of_other_lengths_are_refused() {
    let motors = [Motor::<f64>::default(); 3];
    let mut between = motors;
    let error = batch::interpolate(&motors, &motors, &[0.5; 2], &mut between);
    assert_eq!(
        error,
        Err(LengthMismatch {
            expected: 3,
            found: 2
        })
    );
    let error = batch::nlerp(&motors, &motors[..2], &[0.5; 3], &mut between);
    assert_eq!(
        error,
        Err(LengthMismatch {
            expected: 3,
            found: 2
        })
    );
}

//! Normalisation in cga3 from the smallest numbers to the largest.

use ga_runtime::cga3::{DualQuaternion, Motor, Rotor};

/// The dual quaternion `size (1 + 2 e12 + 2 e13 + 4 e23 + 25 shift e123i)`, whose length is 5 size. With
/// `M ~M = size² (25 + 50 shift e123i)` the nearest motor is `(1 + 2 e12 + 2 e13 + 4 e23)(1 − shift e123i)/5 + 5 shift e123i`.
fn sum(size: f64, shift: f64) -> DualQuaternion<f64> {
    let [one, two, four] = [1.0, 2.0, 4.0].map(|x| x * size);
    DualQuaternion::new(one, two, two, four, 0.0, 0.0, 0.0, 25.0 * size * shift)
}

/// `e12 e123i = −e3i`, `e13 e123i = e2i` and `e23 e123i = −e1i`.
fn nearest(shift: f64) -> [f64; 8] {
    let [a, b, c, d] = [0.8, -0.4, 0.4, 4.8].map(|x| x * shift);
    [0.2, 0.4, 0.4, 0.8, a, b, c, d]
}

fn check(motor: Motor<f64>, expected: [f64; 8], what: &str) {
    let found = [
        motor.scalar(),
        motor.e12(),
        motor.e13(),
        motor.e23(),
        motor.e1i(),
        motor.e2i(),
        motor.e3i(),
        motor.e123i(),
    ];
    for (found, expected) in found.into_iter().zip(expected) {
        let deviation = (found - expected).abs();
        assert!(
            deviation <= 1e-15 * expected.abs(),
            "{what}: {found} for {expected}"
        );
    }
}

#[test]
fn length_and_study_condition_are_repaired_at_every_size() {
    for exponent in -300..=300 {
        let size = 10_f64.powi(exponent);
        let motor = sum(size, 1.0).normalize().expect("finite and not zero");
        check(motor, nearest(1.0), &format!("1e{exponent}"));
    }
}

#[test]
fn turn_and_shift_may_differ_in_size() {
    for (turn, shift) in [
        (-200, 150),
        (-150, -150),
        (150, -150),
        (0, 300),
        (140, 160),
        (300, -300),
    ] {
        let (size, shift) = (10_f64.powi(turn), 10_f64.powi(shift));
        let motor = sum(size, shift).normalize().expect("finite and not zero");
        check(motor, nearest(shift), &format!("{size:e}, {shift:e}"));
    }
}

#[test]
fn single_precision_at_every_size() {
    for exponent in -36..=36 {
        let size = 10_f64.powi(exponent) as f32;
        let [one, two, four, shift] = [1.0, 2.0, 4.0, 25.0].map(|x| x * size);
        let sum = DualQuaternion::new(one, two, two, four, 0.0, 0.0, 0.0, shift);
        let motor = sum.normalize().expect("finite and not zero");
        let found = [motor.scalar(), motor.e23(), motor.e1i(), motor.e123i()];
        for (found, expected) in found.into_iter().zip([0.2, 0.8, 0.8, 4.8]) {
            assert!(
                (found / expected - 1.0_f32).abs() <= 6e-7,
                "1e{exponent}: {found}"
            );
        }
    }
}

#[test]
fn quaternions_of_the_least_and_largest_numbers_turn() {
    for size in [f64::from_bits(1), f64::MIN_POSITIVE, f64::MAX] {
        let rotor = Rotor::from_quaternion([0.0, -size, 0.0], 0.0).expect("not zero");
        assert_eq!(rotor.to_quaternion(), ([0.0, -1.0, 0.0], 0.0));
    }
}

#[test]
fn what_has_no_nearest_motor_is_none() {
    let with = |scalar, e123i| DualQuaternion::new(scalar, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, e123i);
    let none = [
        with(0.0, 0.0),
        with(0.0, 1.0),
        with(f64::NAN, 0.0),
        with(f64::INFINITY, 0.0),
        with(1.0, f64::NAN),
        with(1.0, f64::INFINITY),
    ];
    assert_eq!(none.map(DualQuaternion::normalize), [None; 6]);
    let too_far = DualQuaternion::new(1e-200, 0.0, 0.0, 0.0, 1e200, 0.0, 0.0, 0.0);
    assert_eq!(too_far.normalize(), None, "the shift is beyond all numbers");
}

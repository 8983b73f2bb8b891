//! Smooth splines of motions: keys, continuity, ends, and the splines of points.

use std::f64::consts::PI;
use std::ops::Range;

use ga_runtime::Element;
use ga_runtime::cga3::{Direction, Motor, MotorGenerator, Rotor, Translator};
use ga_runtime::geometry::motion::{MotorSpline, RotorSpline, SplineEnd, SplineError};
use nullcone_tests::plain::{Vector, largest_difference, motor_coefficients, unit, vector};
use proptest::prelude::*;

type Key = (f64, Motor<f64>);

/// Two to seven keys at rising times, each rotated by less than 0.8 radians from the one before,
/// with any signs.
fn keys() -> impl Strategy<Value = Vec<Key>> {
    keys_with(0.5..1.5, 0.0..0.8, 2..8)
}

/// Keys with durations between them, angles of the rotations from each to the next, and counts.
fn keys_with(
    durations: Range<f64>,
    angles: Range<f64>,
    count: Range<usize>,
) -> impl Strategy<Value = Vec<Key>> {
    let step = (durations, unit(), angles, vector(3.0), any::<bool>());
    prop::collection::vec(step, count).prop_map(|steps| {
        let (mut time, mut at) = (-1.0, Motor::default());
        let key = |(duration, axis, angle, shift, turned): (f64, Vector, f64, Vector, bool)| {
            time += duration;
            let rotor = Rotor::from_axis_angle(axis, angle).expect("an axis");
            at *= Translator::from_displacement(shift) * rotor;
            (time, if turned { -at } else { at })
        };
        steps.into_iter().map(key).collect()
    })
}

fn parts(v: MotorGenerator<f64>) -> [f64; 6] {
    [v.e12, v.e13, v.e23, v.e1i, v.e2i, v.e3i]
}

fn deviation(a: Motor<f64>, b: Motor<f64>) -> f64 {
    let [a, b] = [a, b].map(motor_coefficients);
    largest_difference(a, b).min(largest_difference(a, b.map(|x| -x)))
}

fn translation(x: f64, y: f64, z: f64) -> Motor<f64> {
    Translator::from_displacement([x, y, z]).into()
}

/// Natural ends, given velocities, and one of each.
fn ends() -> impl Strategy<Value = [SplineEnd<f64>; 2]> {
    let end = || {
        let velocity = (vector(2.0), vector(2.0)).prop_map(|([a, b, c], [d, e, f])| {
            SplineEnd::Velocity(MotorGenerator::new(a, b, c, d, e, f))
        });
        prop_oneof![Just(SplineEnd::Natural), velocity]
    };
    [end(), end()]
}

fn largest_of(numbers: [f64; 6]) -> f64 {
    largest_difference(numbers, [0.0; 6])
}

/// Asserts that a spline passes through its keys, with the conditions at its ends, and that motor,
/// velocity and acceleration agree on both sides of each key, within a bound relative to the
/// largest of each kind.
///
/// The side before a key is seen at the number before its time, where only a part ε of the third
/// derivative is missing.
fn assert_smooth(keys: &[Key], ends: [SplineEnd<f64>; 2], spline: &MotorSpline<f64>, bound: f64) {
    let read = |time: f64| {
        let motor = motor_coefficients(spline.evaluate(time).expect("a time"));
        let velocity = parts(spline.velocity(time).expect("a time"));
        (
            motor,
            velocity,
            parts(spline.acceleration(time).expect("a time")),
        )
    };
    let (mut extent, mut speed, mut bend) = (1.0_f64, 0.0_f64, 0.0_f64);
    for (time, key) in keys {
        let (_, velocity, acceleration) = read(*time);
        extent = motor_coefficients(*key)
            .into_iter()
            .fold(extent, |most, x| most.max(x.abs()));
        speed = speed.max(largest_of(velocity));
        bend = bend.max(largest_of(acceleration));
    }
    for (time, key) in keys {
        let found = spline.evaluate(*time).expect("a time");
        assert!(deviation(found, *key) <= 1e-14 * extent, "key at {time}");
    }
    for (time, _) in &keys[1..keys.len() - 1] {
        let (before, after) = (read(time.next_down()), read(*time));
        let jump = largest_difference(before.0, after.0) / extent;
        assert!(jump <= bound, "the motor jumps by {jump:e} at {time}");
        let jump = largest_difference(before.1, after.1) / speed;
        assert!(jump <= bound, "the velocity jumps by {jump:e} at {time}");
        let jump = largest_difference(before.2, after.2) / bend;
        assert!(
            jump <= bound,
            "the acceleration jumps by {jump:e} at {time}"
        );
    }
    for (time, end) in [(spline.start(), ends[0]), (spline.end(), ends[1])] {
        let (_, velocity, acceleration) = read(time);
        let deviation = match end {
            SplineEnd::Natural => largest_of(acceleration) / bend.max(1.0),
            SplineEnd::Velocity(given) => largest_difference(velocity, parts(given)) / speed,
        };
        assert!(deviation <= bound, "end at {time}: {deviation:e}");
    }
}

proptest! {
    // Up to forty keys each.
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn the_curve_is_twice_continuous_and_passes_through_the_keys(
        keys in keys_with(0.3..3.0, 0.0..170_f64.to_radians(), 2..41),
        ends in ends(),
    ) {
        let spline = MotorSpline::smooth(&keys, ends).expect("a spline");
        assert_smooth(&keys, ends, &spline, 1e-11);
    }

    #[test]
    fn the_largest_rotations_have_a_spline(
        keys in keys_with(1.0..1.0001, 165_f64.to_radians()..170_f64.to_radians(), 20..41),
        ends in ends(),
    ) {
        let spline = MotorSpline::smooth(&keys, ends).expect("a spline");
        assert_smooth(&keys, ends, &spline, 1e-11);
        // No span is divided: in the middle of each, the third derivative does not jump.
        let bend = |time: f64| parts(spline.acceleration(time).expect("a time"));
        for pair in keys.windows(2) {
            let (middle, step) = (0.5 * (pair[0].0 + pair[1].0), 1e-5);
            let [before, at, after] = [-step, 0.0, step].map(|shift| bend(middle + shift));
            let jump: [f64; 6] = core::array::from_fn(|k| (after[k] - 2.0 * at[k] + before[k]) / step);
            let size = largest_of(at) + largest_of(bend(pair[0].0)) + largest_of(bend(pair[1].0));
            assert!(largest_of(jump) <= 1e-2 * size, "{jump:?} at {middle}");
        }
    }

    #[test]
    fn keys_at_very_uneven_times_have_a_spline(
        keys in keys_with(0.05..5.0, 1.0..170_f64.to_radians(), 2..12),
        ends in ends(),
    ) {
        let spline = MotorSpline::smooth(&keys, ends).expect("a spline");
        assert_smooth(&keys, ends, &spline, 1e-9);
    }
}

proptest! {
    #[test]
    fn single_precision_finds_the_same_curve(
        keys in keys_with(0.5..1.5, 0.0..PI / 2.0, 2..20),
        ends in ends(),
    ) {
        let single = |motor: Motor<f64>| motor.map(|x| x as f32);
        let rounded: Vec<_> = keys.iter().map(|&(time, key)| (time as f32, single(key))).collect();
        let rounded_ends = ends.map(|end| match end {
            SplineEnd::Natural => SplineEnd::Natural,
            SplineEnd::Velocity(velocity) => SplineEnd::Velocity(velocity.map(|x| x as f32)),
        });
        let spline = MotorSpline::smooth(&rounded, rounded_ends).expect("a spline");
        let extent = keys.iter().flat_map(|(_, key)| motor_coefficients(*key)).fold(1.0, |most: f64, x| most.max(x.abs()));
        for (time, key) in &rounded {
            let found: Motor<f64> = spline.evaluate(*time).expect("a time").map(f64::from);
            let key: Motor<f64> = key.map(f64::from);
            prop_assert!(deviation(found, key) <= 2e-6 * extent);
        }
        let exact = MotorSpline::smooth(&keys, ends).expect("a spline");
        let (end, _) = rounded[1];
        let middle = (rounded[0].0 + end) * 0.5;
        let found: Motor<f64> = spline.evaluate(middle).expect("a time").map(f64::from);
        let expected = exact.evaluate(f64::from(middle)).expect("a time");
        prop_assert!(deviation(found, expected) <= 1e-4 * extent);
    }

    #[test]
    fn velocity_and_acceleration_are_derivatives(keys in keys(), part in 0.05..0.95_f64) {
        let spline = MotorSpline::smooth(&keys, [SplineEnd::Natural; 2]).expect("moderate rotations");
        let step = 1e-4;
        let time = spline.start() + part * (spline.end() - spline.start());
        prop_assume!(keys.iter().all(|(key, _)| (key - time).abs() > 2.0 * step));
        let at = |t: f64| spline.evaluate(t).expect("a time");
        let difference = (at(time - step).reverse() * at(time + step)).log() * (0.5 / step);
        let velocity = spline.velocity(time).expect("a time");
        prop_assert!(largest_difference(parts(difference), parts(velocity)) <= 1e-5);
        let rate = |t: f64| spline.velocity(t).expect("a time");
        let difference = (rate(time + step) - rate(time - step)) * (0.5 / step);
        let acceleration = spline.acceleration(time).expect("a time");
        prop_assert!(largest_difference(parts(difference), parts(acceleration)) <= 1e-4);
    }

    #[test]
    fn a_change_of_frames_moves_the_curve(keys in keys(), axis in unit(), shift in vector(3.0)) {
        let frame = Translator::from_displacement(shift) * Rotor::from_axis_angle(axis, 2.0).expect("an axis");
        let moved: Vec<Key> = keys.iter().map(|&(time, key)| (time, frame * key)).collect();
        let [spline, moved] = [keys, moved].map(|keys| {
            MotorSpline::smooth(&keys, [SplineEnd::Natural; 2]).expect("moderate rotations")
        });
        for k in 0..20 {
            let time = spline.start() + f64::from(k) / 19.0 * (spline.end() - spline.start());
            let expected = frame * spline.evaluate(time).expect("a time");
            prop_assert!(deviation(moved.evaluate(time).expect("a time"), expected) <= 1e-10);
        }
    }

    #[test]
    fn keys_on_one_screw_at_constant_speed_give_that_screw(axis in unit(), angle in -1.0..1.0_f64, shift in vector(2.0)) {
        let screw = (Translator::from_displacement(shift) * Rotor::from_axis_angle(axis, angle).expect("an axis")).log();
        let keys = [0.0, 0.5, 2.0, 2.5, 3.0].map(|t| (t, (screw * t).exp()));
        for ends in [[SplineEnd::Natural; 2], [SplineEnd::Velocity(screw); 2]] {
            for keys in [&keys[..], &keys[..2]] {
                let spline = MotorSpline::smooth(keys, ends).expect("moderate rotations");
                for k in 0..10 {
                    let time = spline.end() * f64::from(k) / 9.0;
                    prop_assert!(deviation(spline.evaluate(time).expect("a time"), (screw * time).exp()) <= 1e-11);
                    prop_assert!(largest_difference(parts(spline.velocity(time).expect("a time")), parts(screw)) <= 1e-10);
                }
            }
        }
    }
}

/// The clamped cubic spline through (0, 0), (1, 1), (2, 0) with slopes 0 at the ends is
/// `3t² − 2t³` and its mirror image.
#[test]
fn splines_of_translations_are_those_of_points() {
    let keys = [0.0, 1.0, 2.0].map(|t: f64| (t, translation(t, 1.0 - (t - 1.0).abs(), 0.0)));
    let along = MotorGenerator::new(0.0, 0.0, 0.0, -0.5, 0.0, 0.0);
    let spline = MotorSpline::smooth(&keys, [SplineEnd::Velocity(along); 2]).unwrap();
    for k in 0..=20 {
        let t = f64::from(k) / 10.0;
        let u = 1.0 - (t - 1.0).abs();
        let found = spline.evaluate(t).unwrap().translator().displacement();
        let expected = [t, u * u * (3.0 - 2.0 * u), 0.0];
        assert!(
            largest_difference(found, expected) < 1e-14,
            "{t}: {found:?}"
        );
    }
    // Outside of the keys it stands still.
    assert_eq!(spline.evaluate(-1.0), Some(keys[0].1));
    assert_eq!(spline.acceleration(3.0).map(parts), Some([0.0; 6]));
    assert_eq!(spline.acceleration(f64::NAN), None);
}

#[test]
fn keys_that_have_no_spline_are_refused() {
    let keys = [
        (0.0, translation(0.0, 0.0, 0.0)),
        (1.0, translation(1.0, 0.0, 0.0)),
    ];
    let natural = [SplineEnd::Natural; 2];
    assert_eq!(
        MotorSpline::smooth(&keys[..1], natural),
        Err(SplineError::TooFewKeys { found: 1 })
    );
    assert_eq!(
        MotorSpline::smooth(&[keys[1], keys[0]], natural),
        Err(SplineError::NotRising {
            index: 1,
            time: 0.0
        })
    );
    let fast = MotorGenerator::new(f64::INFINITY, 0.0, 0.0, 0.0, 0.0, 0.0);
    assert_eq!(
        MotorSpline::smooth(&keys, [SplineEnd::Natural, SplineEnd::Velocity(fast)]),
        Err(SplineError::NotFinite { index: 1 })
    );
    let rotation =
        |axis| Motor::from(Rotor::from_axis_angle(axis, 170_f64.to_radians()).expect("a rotation"));
    let (x, y) = (rotation([1.0, 0.0, 0.0]), rotation([0.0, 1.0, 0.0]));
    let uneven = [
        (0.0, Motor::default()),
        (1e-300, x),
        (1.0, x * y),
        (1.0 + 1e-12, x),
    ];
    assert_eq!(
        MotorSpline::smooth(&uneven, natural),
        Err(SplineError::NotReached { index: 1 })
    );
}

/// Keys from which a search without continuation does not find a spline.
#[test]
fn rotations_by_120_degrees_about_varying_axes_have_a_spline() {
    let quaternions = [
        ([0.0, 0.0, 0.0], 1.0),
        (
            [
                0.183_597_018_408_631_38,
                -0.550_791_055_225_894_1,
                -0.642_589_564_430_210_2,
            ],
            0.5,
        ),
        (
            [
                0.055_290_389_246_172_134,
                0.232_482_927_566_752_98,
                -0.226_942_031_374_942_12,
            ],
            0.944_135_570_584_232_1,
        ),
        (
            [
                -0.065_778_029_902_413_91,
                -0.636_041_687_345_209_6,
                -0.521_854_152_672_095_6,
            ],
            0.564_617_096_871_946_8,
        ),
    ];
    let keys: Vec<Key> = (0..)
        .map(f64::from)
        .zip(quaternions)
        .map(|(time, (vector, scalar))| {
            let rotor = Rotor::from_quaternion(vector, scalar).expect("a rotation");
            (time, rotor.into())
        })
        .collect();
    let ends = [SplineEnd::Natural; 2];
    let spline = MotorSpline::smooth(&keys, ends).expect("a spline");
    assert_smooth(&keys, ends, &spline, 1e-13);
}

/// Scipy 1.17.1, `RotationSpline` through rotations about one axis, with the velocities of its
/// ends; its rotations, as quaternions, and its angular rates at two times.
#[test]
fn rotations_about_one_axis_agree_with_scipy() {
    let times = [0.0, 1.0, 1.5, 3.5, 4.25, 5.0];
    let angles = [0.0, 150.0, 40.0, 110.0, -50.0, 60.0].map(f64::to_radians);
    let axis = [2.0, -1.0, 2.0];
    let keys: Vec<_> = times
        .into_iter()
        .zip(angles)
        .map(|(time, angle)| (time, Rotor::from_axis_angle(axis, angle).unwrap()))
        .collect();
    let end = |[from, to]: [usize; 2]| {
        let rate = (angles[to] - angles[from]) / (times[to] - times[from]);
        let angular = Direction::from_vector(axis.map(|x| x / 3.0 * rate));
        SplineEnd::Velocity(MotorGenerator::from_velocities(
            angular,
            Direction::from_vector([0.0; 3]),
        ))
    };
    let spline = RotorSpline::smooth(&keys, [end([0, 1]), end([4, 5])]).unwrap();
    let expected = [
        (
            0.25,
            [
                0.278_968_681_488_179_55,
                -0.139_484_340_744_089_75,
                0.908_238_442_362_290_7,
            ],
            [2.674_148_300_204_157_3, 1.486_110_477_135_725_6],
        ),
        (
            2.75,
            [
                0.530_762_258_128_800_6,
                -0.265_381_129_064_400_1,
                0.605_108_012_695_698_2,
            ],
            [1.472_570_560_801_998_8, -1.821_049_369_194_627_7],
        ),
        (
            4.0,
            [
                -0.078_935_790_454_847_36,
                0.039_467_895_227_423_72,
                0.992_965_541_807_395_4,
            ],
            [-2.624_976_713_007_082, 5.299_592_274_929_338],
        ),
    ];
    for (time, [x, y, w], [rate, acceleration]) in expected {
        let found = spline.evaluate(time).unwrap();
        let rotor = Rotor::from_quaternion([x, y, x], w).unwrap();
        assert!(deviation(found.into(), rotor.into()) < 1e-14, "{time}");
        let found = spline.angular_velocity(time).unwrap();
        assert!(
            largest_difference(found, [rate, -rate / 2.0, rate]) < 1e-13,
            "{time}"
        );
        let found = spline.angular_acceleration(time).unwrap();
        let expected = [acceleration, -acceleration / 2.0, acceleration];
        assert!(largest_difference(found, expected) < 1e-12, "{time}");
    }
}

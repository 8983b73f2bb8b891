//! Smooth splines of motions: keys, continuity, ends, and the splines of points.

use ga_runtime::cga3::{Motor, MotorGenerator, Rotor, Translator};
use ga_runtime::geometry::motion::{MotorSpline, RotorSpline, SplineEnd, SplineError};
use nullcone_tests::plain::{Vector, largest_difference, motor_coefficients, unit, vector};
use proptest::prelude::*;

type Key = (f64, Motor<f64>);

/// Keys at rising times, each rotated by less than 0.8 radians from the one before, with any signs.
fn keys() -> impl Strategy<Value = Vec<Key>> {
    let step = (
        0.5..1.5_f64,
        unit(),
        -0.8..0.8_f64,
        vector(3.0),
        any::<bool>(),
    );
    prop::collection::vec(step, 2..8).prop_map(|steps| {
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

proptest! {
    #[test]
    fn the_curve_is_twice_continuous_and_passes_through_the_keys(keys in keys(), given in any::<bool>()) {
        let velocity = MotorGenerator::new(0.1, -0.2, 0.15, 0.4, -0.3, 0.2);
        let ends = if given { [SplineEnd::Velocity(velocity); 2] } else { [SplineEnd::Natural; 2] };
        let spline = MotorSpline::smooth(&keys, ends).expect("moderate rotations");
        let size = keys.iter().flat_map(|(_, key)| motor_coefficients(*key)).fold(1.0, |most: f64, x| most.max(x.abs()));
        for (time, key) in &keys {
            let found = spline.evaluate(*time).expect("a time");
            prop_assert!(deviation(found, *key) <= 2e-12 * size, "{time}");
        }
        let inner = &keys[1..keys.len() - 1];
        for (time, _) in inner {
            let [before, after] = [time - 1e-9, *time].map(|t| {
                (spline.evaluate(t), spline.velocity(t), spline.acceleration(t))
            });
            let motors = [before.0, after.0].map(|m| motor_coefficients(m.expect("a time")));
            prop_assert!(largest_difference(motors[0], motors[1]) <= 1e-6, "the sign does not jump");
            let velocities = [before.1, after.1].map(|v| parts(v.expect("a time")));
            prop_assert!(largest_difference(velocities[0], velocities[1]) <= 1e-5);
            let accelerations = [before.2, after.2].map(|v| parts(v.expect("a time")));
            prop_assert!(largest_difference(accelerations[0], accelerations[1]) <= 1e-4);
        }
        for at in [spline.start(), spline.end()] {
            let (found, expected) = if given {
                (spline.velocity(at), velocity)
            } else {
                (spline.acceleration(at), MotorGenerator::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
            };
            prop_assert!(largest_difference(parts(found.expect("a time")), parts(expected)) <= 1e-10);
        }
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
    // Rotations by nearly half a turn about changing axes.
    let wild: Vec<_> = (0..6)
        .map(|k| {
            let axis = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]][k % 3];
            (
                k as f64,
                Rotor::from_axis_angle(axis, 3.1 * k as f64).unwrap(),
            )
        })
        .collect();
    match RotorSpline::smooth(&wild, natural) {
        Ok(spline) => {
            for (time, key) in &wild {
                let found = spline.evaluate(*time).unwrap();
                assert!((found.reverse() * *key).scalar().abs() > 1.0 - 1e-12);
            }
        }
        Err(error) => assert!(matches!(error, SplineError::NotReached { .. }), "{error}"),
    }
}

//! Curves of motions: their keys, their velocities and their continuity.

use core::f64::consts::PI;

use ga_runtime::cga3::{DualQuaternion, Motor, MotorGenerator, Point, Rotor, Translator};
use ga_runtime::geometry::motion::{MotorSpline, RotorSpline, SplineError};
use ga_runtime::scalar::Dual;
use ga_runtime::testing::assert_close;
use nullcone_tests::plain::{Vector, motor_coefficients, vector};
use proptest::prelude::*;

type Key = (f64, Motor<f64>);

/// A motor that rotates by no more than an angle.
fn motor(angle: f64) -> impl Strategy<Value = Motor<f64>> + Clone {
    let turn = (vector(1.0), -angle..angle);
    (turn, vector(3.0)).prop_filter_map("no axis", |((axis, angle), t)| {
        Some(Translator::from_displacement(t) * Rotor::from_axis_angle(axis, angle)?)
    })
}

fn generator(turn: f64) -> impl Strategy<Value = MotorGenerator<f64>> + Clone {
    (vector(turn), vector(2.0))
        .prop_map(|([a, b, c], [x, y, z])| MotorGenerator::new(a, b, c, x, y, z))
}

/// Keys at increasing times, each rotated by less than 180° from the one before, with any signs.
fn keys() -> impl Strategy<Value = Vec<Key>> + Clone {
    prop::collection::vec((0.2..2.0, motor(2.5), any::<bool>()), 2..7).prop_map(|steps| {
        let (mut time, mut at) = (-1.0, Motor::default());
        let key = |(duration, step, turned): (f64, Motor<f64>, bool)| {
            time += duration;
            at *= step;
            (time, if turned { -at } else { at })
        };
        steps.into_iter().map(key).collect()
    })
}

/// The largest difference of the coefficients of two motors, up to sign.
fn deviation(a: Motor<f64>, b: Motor<f64>) -> f64 {
    let apart = |b: Motor<f64>| {
        let pairs = motor_coefficients(a).into_iter().zip(motor_coefficients(b));
        pairs.fold(0.0, |most: f64, (x, y)| {
            assert!(x.is_finite() && y.is_finite());
            most.max((x - y).abs())
        })
    };
    apart(b).min(apart(-b))
}

fn constant(m: Motor<f64>) -> Motor<Dual<f64>> {
    let [s, a, b, c, x, y, z, w] = motor_coefficients(m).map(Dual::constant);
    Motor::new_unchecked(s, a, b, c, x, y, z, w)
}

fn value(m: Motor<Dual<f64>>) -> Motor<f64> {
    let [s, a, b, c, x, y, z, w] = motor_coefficients(m).map(|x| x.value);
    Motor::new_unchecked(s, a, b, c, x, y, z, w)
}

/// `~M M'`, the velocity in the frame of the moved body. Derivatives of functions of an angle lose
/// digits when the angle is small.
fn velocity(m: Motor<Dual<f64>>) -> [f64; 6] {
    let [s, a, b, c, x, y, z, w] = motor_coefficients(m).map(|x| x.derivative());
    let rate = DualQuaternion::new(s, a, b, c, x, y, z, w);
    let v = DualQuaternion::from(value(m).reverse()) * rate;
    assert!(
        v.scalar.abs() < 1e-7 && v.e123i.abs() < 1e-7,
        "a rate of a motor: {v:?}"
    );
    [v.e12, v.e13, v.e23, v.e1i, v.e2i, v.e3i]
}

fn parts(v: MotorGenerator<f64>) -> [f64; 6] {
    [v.e12, v.e13, v.e23, v.e1i, v.e2i, v.e3i]
}

fn short_log(from: Motor<f64>, to: Motor<f64>) -> MotorGenerator<f64> {
    let between = from.reverse() * to;
    if between.scalar() < 0.0 {
        (-between).log()
    } else {
        between.log()
    }
}

fn translation(t: Vector) -> Motor<f64> {
    Translator::from_displacement(t).into()
}

/// The cubic Hermite curve of two numbers with their slopes.
fn hermite(s: f64, [p, q]: [f64; 2], [v, w]: [f64; 2]) -> f64 {
    let (s2, s3) = (s * s, s * s * s);
    p * (2.0 * s3 - 3.0 * s2 + 1.0)
        + q * (3.0 * s2 - 2.0 * s3)
        + v * (s3 - 2.0 * s2 + s)
        + w * (s3 - s2)
}

proptest! {
    #[test]
    fn a_bezier_curve_leaves_and_arrives_by_its_controls(start in motor(PI), steps in prop::array::uniform3(motor(1.0))) {
        let [a, b, c] = steps;
        let control = [start, start * a, start * a * b, start * a * b * c];
        prop_assert!(deviation(Motor::bezier(control, 0.0), control[0]) < 1e-14);
        prop_assert!(deviation(Motor::bezier(control, 1.0), control[3]) < 1e-13);
        let at = |t: f64| velocity(Motor::bezier(control.map(constant), Dual::variable(t)));
        assert_close!(at(0.0).to_vec(), parts(short_log(control[0], control[1]) * 3.0).to_vec(), 1e-8, 10.0);
        assert_close!(at(1.0).to_vec(), parts(short_log(control[2], control[3]) * 3.0).to_vec(), 1e-8, 10.0);
        // The reversed keys give the reversed curve, and a change of frames moves the whole curve.
        let mut backwards = control;
        backwards.reverse();
        let whole = Motor::bezier(control, 0.3);
        prop_assert!(deviation(Motor::bezier(backwards, 0.7), whole) < 1e-12);
        let (before, after) = (a * c, b * b);
        let moved = Motor::bezier(control.map(|m| before * m * after), 0.3);
        prop_assert!(deviation(moved, before * whole * after) < 1e-12);
    }

    #[test]
    fn curves_of_one_screw_are_that_screw(start in motor(PI), screw in generator(0.4), t in 0.0..1.0) {
        let at = |t: f64| start * (screw * t).exp();
        let control = [0.0, 1.0, 2.0, 3.0].map(at);
        prop_assert!(deviation(Motor::bezier(control, t), at(3.0 * t)) < 1e-13);
        let near = Motor::squad_control(control[0], control[1], control[2]);
        let far = Motor::squad_control(control[1], control[2], control[3]);
        prop_assert!(deviation(control[1].squad(near, far, control[2], t), at(1.0 + t)) < 1e-13);
        let times = [-1.0, -0.25, 0.5, 2.0, 2.125];
        let spline = MotorSpline::through(&times.map(|t| (t, at(t)))).unwrap();
        let time = -1.0 + 3.125 * t;
        prop_assert!(deviation(spline.evaluate(time).unwrap(), at(time)) < 1e-13);
        assert_close!(parts(spline.velocity(time).unwrap()).to_vec(), parts(screw).to_vec(), 1e-12, 1.0);
    }

    #[test]
    fn bezier_curves_of_translations_are_those_of_points(points in prop::array::uniform5(vector(5.0)), t in 0.0..1.0) {
        let found = Motor::bezier(points.map(translation), t).translator().displacement();
        let rest: f64 = 1.0 - t;
        let bernstein = [rest.powi(4), 4.0 * t * rest.powi(3), 6.0 * (t * rest).powi(2), 4.0 * t.powi(3) * rest, t.powi(4)];
        let expected: Vector = std::array::from_fn(|k| points.iter().zip(bernstein).map(|(p, b)| p[k] * b).sum());
        assert_close!(found, expected, 1e-14, 5.0);
    }

    #[test]
    fn squad_does_not_jump_in_speed(start in motor(PI), steps in prop::array::uniform4(motor(1.2))) {
        let mut keys = [start; 5];
        for k in 0..4 {
            keys[k + 1] = keys[k] * steps[k];
        }
        let controls = [1, 2, 3].map(|k| Motor::squad_control(keys[k - 1], keys[k], keys[k + 1]));
        let at = |k: usize, t: f64| {
            let [from, near, far, to] = [keys[k], controls[k - 1], controls[k], keys[k + 1]].map(constant);
            from.squad(near, far, to, Dual::variable(t))
        };
        let (end, begin) = (at(1, 1.0), at(2, 0.0));
        prop_assert!(deviation(value(end), keys[2]) < 1e-12 && deviation(value(begin), keys[2]) < 1e-12);
        assert_close!(velocity(end).to_vec(), velocity(begin).to_vec(), 1e-8, 10.0);
        // The mean of the screws to both sides.
        let expected = (short_log(keys[2], keys[3]) - short_log(keys[2], keys[1])) * 0.5;
        assert_close!(velocity(begin).to_vec(), parts(expected).to_vec(), 1e-8, 10.0);
        // The same for rotors.
        let [from, near, far, to] = [keys[1], controls[0], controls[1], keys[2]];
        let turned = from.rotor().squad(near.rotor(), far.rotor(), to.rotor(), 0.3);
        prop_assert!(deviation(turned.into(), from.squad(near, far, to, 0.3).rotor().into()) < 1e-13);
        let control = Rotor::squad_control(keys[0].rotor(), keys[1].rotor(), keys[2].rotor());
        prop_assert!(deviation(control.into(), controls[0].rotor().into()) < 1e-13);
    }

    #[test]
    fn splines_pass_their_keys_without_a_jump(keys in keys()) {
        let spline = MotorSpline::through(&keys).unwrap();
        let constants: Vec<_> = keys.iter().map(|&(t, m)| (Dual::constant(t), constant(m))).collect();
        let curve = MotorSpline::through(&constants).unwrap();
        let at = |t: f64| curve.evaluate(Dual::variable(t)).unwrap();
        let scale = 20.0;
        for (k, &(time, motor)) in keys.iter().enumerate() {
            prop_assert!(deviation(spline.evaluate(time).unwrap(), motor) < 1e-12);
            let here = parts(spline.velocity(time).unwrap());
            // The formula of the parabola through three keys.
            let leg = |k: usize| {
                let duration = keys[k + 1].0 - keys[k].0;
                (duration, short_log(keys[k].1, keys[k + 1].1) * (1.0 / duration))
            };
            let expected = if k == 0 {
                leg(0).1
            } else if k + 1 == keys.len() {
                leg(k - 1).1
            } else {
                let ((g, v), (h, w)) = (leg(k - 1), leg(k));
                (v * h + w * g) * (1.0 / (g + h))
            };
            assert_close!(here.to_vec(), parts(expected).to_vec(), 1e-11, scale);
            // Position, sign and velocity from both sides.
            let step = 1e-9;
            if k > 0 {
                assert_close!(velocity(at(time - step)).to_vec(), here.to_vec(), 1e-6, scale);
            }
            if k + 1 < keys.len() {
                assert_close!(velocity(at(time + step)).to_vec(), here.to_vec(), 1e-6, scale);
            }
            let [before, after] = [time - step, time + step].map(|t| spline.evaluate(t).unwrap());
            assert_close!(before, after, 1e-6);
        }
        // Between the keys, by dual numbers and by finite differences.
        let (start, end) = (spline.start(), spline.end());
        prop_assert!(start == keys[0].0 && end == keys[keys.len() - 1].0);
        for k in 1..40 {
            let time = start + (end - start) * f64::from(k) / 40.0;
            let here = parts(spline.velocity(time).unwrap());
            assert_close!(velocity(at(time)).to_vec(), here.to_vec(), 1e-8, scale);
            let h = 1e-4;
            let [a, b] = [time - h, time + h].map(|t| motor_coefficients(spline.evaluate(t).unwrap()));
            let rate: Vec<f64> = b.iter().zip(a).map(|(b, a)| (b - a) / (2.0 * h)).collect();
            let exact = motor_coefficients(at(time)).map(|x| x.derivative()).to_vec();
            assert_close!(rate, exact, 2e-3, scale);
        }
    }

    #[test]
    fn splines_are_equivariant_under_changes_of_frames(keys in keys(), before in motor(PI), after in motor(PI), t in 0.0..1.0) {
        let spline = MotorSpline::through(&keys).unwrap();
        let moved: Vec<_> = keys.iter().map(|&(time, m)| (time, before * m * after)).collect();
        let moved = MotorSpline::through(&moved).unwrap();
        let time = spline.start() + t * (spline.end() - spline.start());
        let expected = before * spline.evaluate(time).unwrap() * after;
        prop_assert!(deviation(moved.evaluate(time).unwrap(), expected) < 1e-10);
        // The same for other units of time and other signs.
        let slower: Vec<_> = keys.iter().map(|&(time, m)| (4.0 * time + 1.0, -m)).collect();
        let slower = MotorSpline::through(&slower).unwrap().evaluate(4.0 * time + 1.0).unwrap();
        prop_assert!(deviation(slower, spline.evaluate(time).unwrap()) < 1e-10);
    }

    #[test]
    fn splines_of_translations_are_those_of_points(places in prop::array::uniform4((vector(5.0), 0.1..2.0)), t in 0.0..1.0) {
        let mut time = 0.0;
        let keys = places.map(|(place, duration)| {
            time += duration;
            (time, place)
        });
        let spline = MotorSpline::through(&keys.map(|(time, place)| (time, translation(place)))).unwrap();
        let [(t0, p0), (t1, p1), (t2, p2), (t3, p3)] = keys;
        let h = t2 - t1;
        let expected: Vector = std::array::from_fn(|k| {
            // The slopes of the parabolas through three points, by Newton's divided differences.
            let slope = |(a, p): (f64, f64), (b, q): (f64, f64), (c, r): (f64, f64)| {
                let (first, second) = ((q - p) / (b - a), (r - q) / (c - b));
                first + (second - first) / (c - a) * (b - a)
            };
            let v = slope((t0, p0[k]), (t1, p1[k]), (t2, p2[k]));
            let w = slope((t1, p1[k]), (t2, p2[k]), (t3, p3[k]));
            hermite(t, [p1[k], p2[k]], [v * h, w * h])
        });
        let found = spline.evaluate(t1 + t * h).unwrap().translator().displacement();
        assert_close!(found, expected, 1e-12, 10.0);
        // With given velocities.
        let velocities = [p0, p3].map(|v| MotorGenerator::new(0.0, 0.0, 0.0, -0.5 * v[0], -0.5 * v[1], -0.5 * v[2]));
        let spline = MotorSpline::with_velocities(&[(t1, translation(p1), velocities[0]), (t2, translation(p2), velocities[1])]).unwrap();
        let found = spline.evaluate(t1 + t * h).unwrap().translator().displacement();
        let expected: Vector = std::array::from_fn(|k| hermite(t, [p1[k], p2[k]], [p0[k] * h, p3[k] * h]));
        assert_close!(found, expected, 1e-12, 10.0);
    }

    #[test]
    fn velocities_are_kept(keys in keys(), velocities in prop::collection::vec(generator(2.0), 7)) {
        let keys: Vec<_> = keys.into_iter().zip(velocities).map(|((t, m), v)| (t, m, v)).collect();
        let spline = MotorSpline::with_velocities(&keys).unwrap();
        for &(time, motor, velocity) in &keys {
            prop_assert!(deviation(spline.evaluate(time).unwrap(), motor) < 1e-12);
            assert_close!(parts(spline.velocity(time).unwrap()).to_vec(), parts(velocity).to_vec(), 1e-12, 10.0);
        }
        for (k, pair) in keys.windows(2).enumerate() {
            let just_before = spline.velocity(pair[1].0 - 1e-9).unwrap();
            assert_close!(parts(just_before).to_vec(), parts(keys[k + 1].2).to_vec(), 1e-5, 10.0);
        }
    }

    #[test]
    fn rotor_splines_are_splines_of_motors(keys in keys(), t in 0.0..1.0) {
        let rotors: Vec<_> = keys.iter().map(|&(time, m)| (time, m.rotor())).collect();
        let motors: Vec<_> = rotors.iter().map(|&(time, r)| (time, Motor::from(r))).collect();
        let (turning, moving) = (RotorSpline::through(&rotors).unwrap(), MotorSpline::through(&motors).unwrap());
        let time = turning.start() + t * (turning.end() - turning.start());
        prop_assert_eq!(Motor::from(turning.evaluate(time).unwrap()), moving.evaluate(time).unwrap());
        // R' = R [ω]× by differences of matrices, ω in the frame of the body.
        let [wx, wy, wz] = turning.angular_velocity(time).unwrap();
        let h = 1e-5;
        let inside = time.clamp(turning.start() + 2.0 * h, turning.end() - 2.0 * h);
        prop_assume!(inside == time && keys.iter().all(|key| (key.0 - time).abs() > 2.0 * h));
        let [before, here, after] = [-h, 0.0, h].map(|h| turning.evaluate(time + h).unwrap().to_matrix());
        let skew = [[0.0, -wz, wy], [wz, 0.0, -wx], [-wy, wx, 0.0]];
        for i in 0..3 {
            for j in 0..3 {
                let exact: f64 = (0..3).map(|k| here[i][k] * skew[k][j]).sum();
                let found = (after[i][j] - before[i][j]) / (2.0 * h);
                prop_assert!((exact - found).abs() < 1e-4, "{exact} {found}");
            }
        }
    }
}

fn rotation(angle: f64) -> Motor<f64> {
    let rotor = Rotor::from_axis_angle([0.0, 0.0, 1.0], angle);
    rotor.map(Motor::from).unwrap_or_default()
}

#[test]
fn outside_its_keys_a_spline_stands_still() {
    let spline = MotorSpline::through(&[(1.0, rotation(0.1)), (2.0, rotation(0.9))]).unwrap();
    for early in [0.999, -1e300, f64::NEG_INFINITY] {
        assert_eq!(spline.evaluate(early), Some(rotation(0.1)));
        assert_eq!(parts(spline.velocity(early).unwrap()), [0.0; 6]);
    }
    for late in [2.001, 1e300, f64::INFINITY] {
        assert_eq!(spline.evaluate(late), Some(rotation(0.9)));
        assert_eq!(parts(spline.velocity(late).unwrap()), [0.0; 6]);
    }
    assert_eq!(spline.evaluate(f64::NAN), None);
    assert_eq!(spline.velocity(f64::NAN), None);
    // At the ends it has the velocity of the inner side.
    for end in [1.0, 2.0] {
        assert_close!(spline.velocity(end).unwrap().e12, -0.4, 1e-15);
    }
    let turning =
        RotorSpline::through(&[(1.0, rotation(0.1).rotor()), (2.0, rotation(0.9).rotor())])
            .unwrap();
    assert_eq!(turning.evaluate(f64::NAN), None);
    assert_eq!(turning.angular_velocity(0.0), Some([0.0; 3]));
    assert_close!(
        turning.angular_velocity(1.5).unwrap(),
        [0.0, 0.0, 0.8],
        1e-15
    );
}

#[test]
fn bad_keys_are_named() {
    let keys = |times: &[f64]| -> Vec<Key> { times.iter().map(|&t| (t, rotation(t))).collect() };
    let refused = |times: &[f64]| MotorSpline::through(&keys(times)).unwrap_err();
    assert_eq!(refused(&[]), SplineError::TooFewKeys { found: 0 });
    assert_eq!(refused(&[1.0]), SplineError::TooFewKeys { found: 1 });
    assert_eq!(
        refused(&[1.0, 2.0, 2.0]),
        SplineError::NotRising {
            index: 2,
            time: 2.0
        }
    );
    assert_eq!(
        refused(&[1.0, 0.5, 2.0]),
        SplineError::NotRising {
            index: 1,
            time: 0.5
        }
    );
    assert_eq!(
        refused(&[0.0, -0.0]),
        SplineError::NotRising {
            index: 1,
            time: -0.0
        }
    );
    assert_eq!(
        refused(&[0.0, f64::INFINITY]),
        SplineError::Time {
            index: 1,
            time: f64::INFINITY
        }
    );
    assert_eq!(
        refused(&[1.0, 0.5]).to_string(),
        "key 1 at 0.5 is not after the one before it"
    );
    let SplineError::Time { index: 0, time } = refused(&[f64::NAN, 1.0]) else {
        panic!("not a number is a time");
    };
    assert!(time.is_nan());
    let lost = Motor::new_unchecked(1.0, 0.0, 0.0, 0.0, f64::NAN, 0.0, 0.0, 0.0);
    let spoilt = [(0.0, rotation(0.0)), (1.0, lost)];
    assert_eq!(
        MotorSpline::through(&spoilt),
        Err(SplineError::NotFinite { index: 1 })
    );
    let fast = MotorGenerator::new(0.0, 0.0, f64::INFINITY, 0.0, 0.0, 0.0);
    let still = fast * 0.0;
    assert!(still.e23.is_nan());
    for velocity in [fast, still] {
        let moving = [
            (0.0, rotation(0.0), velocity),
            (1.0, rotation(0.0), velocity),
        ];
        assert_eq!(
            MotorSpline::with_velocities(&moving),
            Err(SplineError::NotFinite { index: 0 })
        );
    }
    // A speed, and a duration, beyond the range of the scalar.
    let far = [
        (0.0, rotation(0.0)),
        (5e-324, translation([1e300, 0.0, 0.0])),
        (1.0, rotation(0.0)),
    ];
    assert_eq!(
        MotorSpline::through(&far),
        Err(SplineError::OutOfRange { index: 0 })
    );
    let long = [(-f64::MAX, rotation(0.0)), (f64::MAX, rotation(1.0))];
    assert_eq!(
        MotorSpline::through(&long),
        Err(SplineError::OutOfRange { index: 0 })
    );
    let rotor = rotation(1.0).rotor();
    assert_eq!(
        RotorSpline::through(&[(0.0, rotor)]),
        Err(SplineError::TooFewKeys { found: 1 })
    );
}

#[test]
fn a_velocity_can_ask_for_the_long_way() {
    // 270° in a second, from 90° to 360°.
    let velocity = MotorGenerator::new(-0.75 * PI, 0.0, 0.0, 0.0, 0.0, 0.0);
    let keys = [
        (0.0, rotation(0.5 * PI), velocity),
        (1.0, rotation(0.0), velocity),
    ];
    let spline = MotorSpline::with_velocities(&keys).unwrap();
    for k in 0..=8 {
        let t = f64::from(k) / 8.0;
        assert!(
            deviation(
                spline.evaluate(t).unwrap(),
                rotation(0.5 * PI + 1.5 * PI * t)
            ) < 1e-14
        );
    }
}

#[test]
fn a_curve_of_one_control_is_that() {
    assert_eq!(Motor::bezier([rotation(0.3)], 0.7), rotation(0.3));
    let two = Motor::bezier([rotation(0.0), rotation(1.0)], 0.25);
    assert!(deviation(two, rotation(0.25)) < 1e-15);
}

#[test]
fn times_that_are_not_finite_give_none() {
    let keys = [0.0, 1.0, 1.5, 2.0].map(rotation);
    let [a, b, c, d] = keys;
    for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for motor in [
            Motor::bezier(keys, t),
            Motor::bezier([a, b], t),
            a.squad(b, c, d, t),
        ] {
            assert!(
                motor_coefficients(motor).iter().any(|x| !x.is_finite()),
                "{t}: {motor}"
            );
        }
    }
    // Beyond its ends the curve continues with the same screw.
    for t in [-1.0, 2.5] {
        let found = Motor::bezier([0.0, 0.5, 1.0, 1.5].map(rotation), t);
        assert!(deviation(found, rotation(1.5 * t)) < 1e-14);
    }
}

#[test]
fn single_precision_goes_the_same_way() {
    let screw = |t: f32| {
        Translator::from_displacement([0.0, 0.0, t])
            * Rotor::from_axis_angle([0.0, 0.0, 1.0], t).unwrap()
    };
    let spline = MotorSpline::through(&[0.0_f32, 1.0, 3.0, 3.5].map(|t| (t, screw(t)))).unwrap();
    for k in 0..=35 {
        let t = k as f32 / 10.0;
        let x = Point::new(1.0, 2.0, 3.0);
        let apart = spline
            .evaluate(t)
            .unwrap()
            .transform(x)
            .distance(screw(t).transform(x));
        assert!(apart < 4e-6, "{t}: {apart}");
    }
}

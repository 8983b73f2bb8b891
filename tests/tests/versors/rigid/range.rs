//! Numbers at the ends of the range, single precision and lanes.

use ga_runtime::cga3::{Dilator, Motor, Rotor, Translator};
use ga_runtime::geometry::RotationPath;
use ga_runtime::scalar::Lanes;
use nullcone_tests::plain::{largest_difference, motor_coefficients, motor_of};

use super::{rotor_about, rotor_parts, screw};

#[test]
fn nan_does_not_vanish_from_roots_and_powers() {
    for base in [
        screw([1.0, 2.0, 3.0], [0.6, 0.0, 0.8], 1.0, 0.5),
        screw([1.0, 2.0, 3.0], [0.6, 0.0, 0.8], 4.0, 0.5),
        motor_coefficients(-Motor::default()),
    ] {
        for place in 0..8 {
            let mut given = base;
            given[place] = f64::NAN;
            for result in [motor_of(given).sqrt(), motor_of(given).powf(0.3)] {
                assert!(
                    motor_coefficients(result).iter().any(|x| x.is_nan()),
                    "{given:?}: {result}"
                );
            }
            if place < 4 {
                let rotor = Rotor::new_unchecked(given[0], given[1], given[2], given[3]);
                for result in [rotor.sqrt(), rotor.powf(0.3)] {
                    assert!(
                        rotor_parts(result).iter().any(|x| x.is_nan()),
                        "{rotor}: {result}"
                    );
                }
            }
        }
    }
}

#[test]
fn small_scalings_keep_their_figures() {
    for small in [1e-300_f64, 1e-20, 1e-12, 1e-6, 1e-2] {
        let dilator = Dilator::exp(small).expect("finite");
        assert!((dilator.eoi() / small.sinh() - 1.0).abs() <= 1e-15);
        assert!((dilator.log() / small - 1.0).abs() <= 1e-15, "{small:e}");
        assert!(
            (dilator.sqrt().log() / (0.5 * small) - 1.0).abs() <= 1e-15,
            "{small:e}"
        );
    }
    for exponent in [-300, -100, 100, 300] {
        let factor = 10_f64.powi(exponent);
        let dilator = Dilator::from_factor(factor).expect("positive");
        assert!((dilator.log() / (0.5 * factor.ln()) - 1.0).abs() <= 1e-15);
        assert!((dilator.sqrt().factor() / factor.sqrt() - 1.0).abs() <= 1e-15);
    }
}

#[test]
fn single_precision() {
    let n = [0.0_f32, 0.6, 0.8];
    for angle in [0.0_f32, 1e-20, 0.1, 1.0, 3.0, std::f32::consts::PI, 5.0] {
        let rotor = Rotor::from_axis_angle(n, angle).expect("an axis");
        let half = Rotor::from_axis_angle(n, 0.5 * angle).expect("an axis");
        for found in [rotor.sqrt(), rotor.powf(0.5)] {
            let error = largest_difference(
                rotor_parts(found).map(f64::from),
                rotor_parts(half).map(f64::from),
            );
            assert!(error <= 5e-7, "{angle}: {error:e}");
        }
        let motor = Translator::from_displacement([1.0, 2.0, 3.0]) * rotor;
        let again = motor.screw().expect("finite").to_motor().expect("finite");
        let error = largest_difference(
            motor_coefficients(again).map(f64::from),
            motor_coefficients(motor).map(f64::from),
        );
        assert!(error <= 4e-6, "{angle}: {error:e}");
    }
}

#[test]
fn lanes_are_singles_side_by_side() {
    let n = [0.0, 0.6, 0.8];
    // A root of each form side by side.
    let rotors = [
        rotor_about(n, 1.0),
        rotor_about(n, 5.0),
        [-1.0, 0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0, 0.0],
    ];
    let [c, x, y, z] = std::array::from_fn(|k| Lanes::from_array(rotors.map(|r| r[k])));
    let together = Rotor::new_unchecked(c, x, y, z);
    let t = Lanes::from_array([0.5, 0.25, 0.125, 3.0]);
    for (lane, [c, x, y, z]) in rotors.into_iter().enumerate() {
        let alone = Rotor::new_unchecked(c, x, y, z);
        assert_eq!(
            rotor_parts(together.sqrt()).map(|x| x[lane]),
            rotor_parts(alone.sqrt())
        );
        assert_eq!(
            rotor_parts(together.powf(t)).map(|x| x[lane]),
            rotor_parts(alone.powf(t[lane]))
        );
        let along = rotor_parts(together.along(RotationPath::Long)).map(|x| x[lane]);
        assert_eq!(along, rotor_parts(alone.along(RotationPath::Long)));
    }
    let motors = [
        screw([1.0, 0.0, 2.0], n, 1.0, 3.0),
        screw([1.0, 0.0, 2.0], n, 5.0, 3.0),
    ];
    let [s, a, b, c, d, e, f, g] = std::array::from_fn(|k| Lanes::from_array(motors.map(|m| m[k])));
    let together = Motor::new_unchecked(s, a, b, c, d, e, f, g);
    for (lane, alone) in motors.into_iter().enumerate() {
        assert_eq!(
            motor_coefficients(together.sqrt()).map(|x| x[lane]),
            motor_coefficients(motor_of(alone).sqrt())
        );
    }
}

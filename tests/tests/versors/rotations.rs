//! Rotations in all their forms, slerp and motions along screws, against those of scipy.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use std::f64::consts::PI;

use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::geometry::EulerOrder;
use ga_runtime::scalar::Real;
use nullcone_tests::oracle::{extract, whole};
use serde_json::Value;

/// `f32` or `f64`, with the error that is allowed, relative to the largest number of a case or to
/// 1.
trait Precision: Real<Mask = bool> + Into<f64> {
    const BOUND: f64;
}
impl Precision for f32 {
    const BOUND: f64 = 1e-5;
}
impl Precision for f64 {
    const BOUND: f64 = 1e-12;
}

#[test]
fn an_extract_agrees() {
    agree(&extract("anim/rotations.json"));
}

#[test]
fn the_whole_file_agrees() {
    if let Some(truth) = whole("anim/rotations.json") {
        assert_eq!(list(&truth["quat"]).len(), 71);
        agree(&truth);
    }
}

fn agree(truth: &Value) {
    forms_agree::<f32>(truth);
    forms_agree::<f64>(truth);
    slerps_agree::<f32>(truth);
    slerps_agree::<f64>(truth);
    screws_agree::<f32>(truth);
    screws_agree::<f64>(truth);
}

/// Every form is converted to the rotor and back.
fn forms_agree<S: Precision>(truth: &Value) {
    for (case, quaternion) in list(&truth["quat"]).iter().enumerate() {
        let [x, y, z, w] = numbers::<S, 4>(quaternion);
        let rows: [Value; 3] = array(&truth["matrix"][case]);
        let matrix = rows.map(|row| numbers::<S, 3>(&row));
        let vector = numbers::<S, 3>(&truth["rotvec"][case]);
        let angles = numbers::<S, 3>(&truth["euler_zyx_intrinsic_rad"][case]);
        let expected = numbers::<S, 4>(&truth["rotor_s_e12_e13_e23"][case]);

        let rotors = [
            Rotor::from_quaternion([x, y, z], w).unwrap(),
            Rotor::from_matrix(matrix).unwrap(),
            Rotor::from_rotation_vector(vector).unwrap(),
            Rotor::from_euler(EulerOrder::Zyx, angles).unwrap(),
        ];
        for (form, rotor) in rotors.into_iter().enumerate() {
            assert_near_either(parts(rotor), expected, &format!("case {case}, form {form}"));
            let rows = rotor.to_matrix();
            for k in 0..3 {
                assert_near(rows[k], matrix[k], &format!("matrix {case}, form {form}"));
            }
            let ([x, y, z], w) = rotor.to_quaternion();
            let given = numbers::<S, 4>(quaternion);
            assert_near_either([x, y, z, w], given, &format!("quaternion {case}"));
            // At a half turn both directions of the axis are right.
            let found = rotor.along(Default::default()).to_rotation_vector();
            let length = vector
                .map(Into::into)
                .iter()
                .map(|x: &f64| x * x)
                .sum::<f64>()
                .sqrt();
            if length > PI - 1e-5 {
                assert_near_either(found, vector, &format!("rotation vector {case}"));
            } else {
                assert_near(found, vector, &format!("rotation vector {case}"));
            }
            // At gimbal lock the angles are not determined, but the rotation is.
            let found = rotor.to_euler(EulerOrder::Zyx);
            let again = Rotor::from_euler(EulerOrder::Zyx, found).unwrap();
            assert_near_either(parts(again), expected, &format!("Euler angles {case}"));
            let pitch: f64 = angles[1].into();
            if pitch.cos() > 0.1 && length < 3.0 {
                assert_near(found, angles, &format!("Euler angles {case}"));
            }
        }
    }
}

fn slerps_agree<S: Precision>(truth: &Value) {
    let near = list(&truth["slerp_near"]);
    for (case, slerp) in list(&truth["slerp"]).iter().chain(near).enumerate() {
        let [from, to] = ["a", "b"].map(|end| rotor::<S>(&slerp[end]));
        let is_half_turn = slerp["angle"]
            .as_f64()
            .is_some_and(|angle| angle > PI - 1e-3);
        for (time, expected) in list(&slerp["u"]).iter().zip(list(&slerp["quat"])) {
            let t = S::from_f64(time.as_f64().unwrap());
            let expected = parts(rotor::<S>(expected));
            let found = from.interpolate(to, t);
            let what = format!("slerp {case} at {time}");
            if is_half_turn && !is_near_either(parts(found), expected) {
                // The other way round is as short.
                let other = from.interpolate(-to, t);
                assert_near_either(parts(other), expected, &what);
            } else {
                assert_near_either(parts(found), expected, &what);
            }
            let motor = Motor::from(from).interpolate(to.into(), t).rotor();
            if !is_half_turn {
                assert_near_either(parts(motor), expected, &what);
            }
        }
    }
    assert_eq!(near.len(), 5);
}

fn screws_agree<S: Precision>(truth: &Value) {
    for (case, motion) in list(&truth["motor_interpolation"]).iter().enumerate() {
        let [from, to] = ["a", "b"].map(|end| motor::<S>(&motion[end]));
        for (time, expected) in list(&motion["u"]).iter().zip(list(&motion["matrix"])) {
            let t = S::from_f64(time.as_f64().unwrap());
            let rows = matrix::<S>(expected);
            let found = from.interpolate(to, t).to_matrix();
            for k in 0..3 {
                assert_near(found[k], rows[k], &format!("motion {case} at {time}"));
            }
        }
        // The motion from one to the other, in the coordinates of space.
        let between = (to * from.reverse()).along(Default::default()).log();
        let [omega, v] = ["omega", "v"].map(|part| numbers::<S, 3>(&motion["log_screw"][part]));
        let found: [S; 3] = between.angular_velocity().vector();
        assert_near(found, omega, &format!("angular velocity {case}"));
        let origin = Point::new(S::zero(), S::zero(), S::zero());
        let found = between.velocity_at(origin).vector();
        assert_near(found, v, &format!("velocity {case}"));
    }
}

fn rotor<S: Precision>(quaternion: &Value) -> Rotor<S> {
    let [x, y, z, w] = numbers::<S, 4>(quaternion);
    Rotor::from_quaternion([x, y, z], w).unwrap()
}

fn motor<S: Precision>(rows: &Value) -> Motor<S> {
    let rows = matrix::<S>(rows);
    let rotor = Rotor::from_matrix(rows.map(|[x, y, z, _]| [x, y, z])).unwrap();
    Translator::from_displacement(rows.map(|row| row[3])) * rotor
}

/// The first three rows.
fn matrix<S: Precision>(rows: &Value) -> [[S; 4]; 3] {
    let rows: [Value; 4] = array(rows);
    let [x, y, z, _] = rows.map(|row| numbers::<S, 4>(&row));
    [x, y, z]
}

fn parts<S: Precision>(rotor: Rotor<S>) -> [S; 4] {
    [rotor.scalar(), rotor.e12(), rotor.e13(), rotor.e23()]
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

fn array<const N: usize>(value: &Value) -> [Value; N] {
    list(value).to_vec().try_into().unwrap()
}

fn numbers<S: Precision, const N: usize>(value: &Value) -> [S; N] {
    array(value).map(|x| S::from_f64(x.as_f64().unwrap()))
}

fn error<S: Precision, const N: usize>(found: [S; N], expected: [S; N], sign: f64) -> f64 {
    let [found, expected] = [found, expected].map(|x| x.map(|x| -> f64 { x.into() }));
    let size = expected.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
    let errors = found
        .iter()
        .zip(expected)
        .map(|(x, y)| (x - sign * y).abs());
    errors.fold(0.0, |most: f64, error| {
        assert!(error.is_finite());
        most.max(error)
    }) / size
}

fn is_near_either<S: Precision, const N: usize>(found: [S; N], expected: [S; N]) -> bool {
    error(found, expected, 1.0).min(error(found, expected, -1.0)) <= S::BOUND
}

#[track_caller]
fn assert_near<S: Precision, const N: usize>(found: [S; N], expected: [S; N], what: &str) {
    let error = error(found, expected, 1.0);
    assert!(
        error <= S::BOUND,
        "{what}: {found:?} for {expected:?}, {error:e}"
    );
}

/// Near up to the sign.
#[track_caller]
fn assert_near_either<S: Precision, const N: usize>(found: [S; N], expected: [S; N], what: &str) {
    assert!(
        is_near_either(found, expected),
        "{what}: {found:?} for {expected:?}"
    );
}

//! Views and Euler angles, against glam.

use std::f64::consts::{FRAC_PI_2, PI};

use ga_runtime::cga3::{Direction, Motor, Point, Rotor};
use ga_runtime::geometry::{EulerOrder, LookAtError};
use ga_runtime::scalar::Dual;
use glam_034::dcamera::rh::view::look_at_mat4;
use glam_034::{DMat3, DQuat, DVec3, EulerRot};
use nullcone_tests::plain::{length, minus, near_all, vector};
use proptest::prelude::*;

/// glam's counterparts: intrinsic and extrinsic.
const GLAM: [(EulerOrder, EulerRot, EulerRot); 12] = [
    (EulerOrder::Xyz, EulerRot::XYZ, EulerRot::XYZEx),
    (EulerOrder::Xzy, EulerRot::XZY, EulerRot::XZYEx),
    (EulerOrder::Yxz, EulerRot::YXZ, EulerRot::YXZEx),
    (EulerOrder::Yzx, EulerRot::YZX, EulerRot::YZXEx),
    (EulerOrder::Zxy, EulerRot::ZXY, EulerRot::ZXYEx),
    (EulerOrder::Zyx, EulerRot::ZYX, EulerRot::ZYXEx),
    (EulerOrder::Xyx, EulerRot::XYX, EulerRot::XYXEx),
    (EulerOrder::Xzx, EulerRot::XZX, EulerRot::XZXEx),
    (EulerOrder::Yxy, EulerRot::YXY, EulerRot::YXYEx),
    (EulerOrder::Yzy, EulerRot::YZY, EulerRot::YZYEx),
    (EulerOrder::Zxz, EulerRot::ZXZ, EulerRot::ZXZEx),
    (EulerOrder::Zyz, EulerRot::ZYZ, EulerRot::ZYZEx),
];

fn rows(matrix: DMat3) -> [f64; 9] {
    matrix.transpose().to_cols_array()
}

fn entries(rotor: Rotor<f64>) -> [f64; 9] {
    let [a, b, c] = rotor.to_matrix();
    [a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]]
}

/// Whether an angle is a whole number of turns, within a bound.
fn is_whole(angle: f64, bound: f64) -> bool {
    (angle / (2.0 * PI) - (angle / (2.0 * PI)).round()).abs() * 2.0 * PI <= bound
}

/// The middle of the second angle's range, whose ends are half a turn apart.
fn middle(order: EulerOrder) -> f64 {
    let [first, _, third] = order.axes();
    if first == third { FRAC_PI_2 } else { 0.0 }
}

proptest! {
    #[test]
    fn euler_angles_are_those_of_glam(a in -PI..PI, b in -1.5..1.5_f64, c in -PI..PI) {
        for (order, intrinsic, extrinsic) in GLAM {
            let angles = [a, b + middle(order), c];
            let [first, second, third] = angles;
            let made = Rotor::from_euler(order, angles).unwrap();
            near_all(entries(made), rows(DMat3::from_euler(intrinsic, first, second, third)), 1e-14);
            let fixed = Rotor::from_euler_extrinsic(order, angles).unwrap();
            near_all(entries(fixed), rows(DMat3::from_euler(extrinsic, first, second, third)), 1e-14);
            // Away from gimbal lock the angles are unique within their ranges.
            for (found, sign) in [(made.to_euler(order), 1.0), ((-made).to_euler(order), -1.0)] {
                prop_assert!((found[1] - second).abs() < 1e-13, "{order:?} {sign} {found:?} {angles:?}");
                prop_assert!(is_whole(found[0] - first, 1e-13) && is_whole(found[2] - third, 1e-13));
                prop_assert!(found[0].abs() <= PI && found[2].abs() <= PI);
            }
            let found = fixed.to_euler_extrinsic(order);
            prop_assert!((found[1] - second).abs() < 1e-13);
            prop_assert!(is_whole(found[0] - first, 1e-13) && is_whole(found[2] - third, 1e-13));
            // With the same axis twice glam's second angle may be negative.
            if middle(order) == 0.0 {
                let quaternion = DQuat::from_euler(intrinsic, first, second, third);
                let theirs: [f64; 3] = quaternion.to_euler(intrinsic).into();
                let ours = made.to_euler(order);
                prop_assert!((0..3).all(|k| is_whole(ours[k] - theirs[k], 1e-12)));
            }
        }
    }

    /// Near gimbal lock the angles may differ, but not the rotation.
    #[test]
    fn near_gimbal_lock_the_rotation_is_kept(a in -PI..PI, c in -PI..PI, exponent in -20.0..0.0_f64, side in prop::bool::ANY) {
        let off = if exponent < -19.0 { 0.0 } else { 10_f64.powf(exponent) };
        for order in EulerOrder::ALL {
            let end = if side { FRAC_PI_2 - off } else { off - FRAC_PI_2 };
            let angles = [a, middle(order) + end, c];
            let made = Rotor::from_euler(order, angles).unwrap();
            let again = Rotor::from_euler(order, made.to_euler(order)).unwrap();
            near_all(entries(again), entries(made), 2e-14);
            let made = Rotor::from_euler_extrinsic(order, angles).unwrap();
            let found = made.to_euler_extrinsic(order);
            near_all(entries(Rotor::from_euler_extrinsic(order, found).unwrap()), entries(made), 2e-14);
            if off == 0.0 {
                prop_assert_eq!(found[2], 0.0);
                prop_assert_eq!(Rotor::from_euler(order, angles).unwrap().to_euler(order)[2], 0.0);
            }
        }
    }

    #[test]
    fn views_are_those_of_glam(eye in vector(20.0), target in vector(20.0), up in vector(3.0), x in vector(20.0)) {
        prop_assume!(length(minus(eye, target)) > 0.1);
        let forward = DVec3::from(target) - DVec3::from(eye);
        prop_assume!(forward.normalize().cross(DVec3::from(up)).length() > 0.01);
        let view = Motor::look_at(eye.into(), target.into(), up.into()).unwrap();
        let theirs = look_at_mat4(eye.into(), target.into(), DVec3::from(up).normalize());
        let image = view.transform(Point::from(x)).coordinates();
        near_all(image, theirs.transform_point3(x.into()).into(), 1e-11);
        let ahead = view.transform(Point::from(target)).coordinates();
        near_all(ahead, [0.0, 0.0, -forward.length()], 1e-12);
        near_all(view.transform(Point::from(eye)).coordinates(), [0.0; 3], 1e-12);
        // `up` lies above the middle of the picture.
        let upward = view.transform(Direction::from(up));
        prop_assert!(upward.x().abs() < 1e-12 && upward.y() > 0.0);
    }
}

#[test]
fn views_without_a_direction_are_errors() {
    let (o, up) = (Point::default(), Direction::new(0.0, 1.0, 0.0));
    let at = |x: f64, y: f64, z: f64| Motor::look_at(o, Point::new(x, y, z), up).unwrap_err();
    assert_eq!(at(0.0, 0.0, 0.0), LookAtError::NoDirection);
    assert_eq!(at(0.0, -3.0, 0.0), LookAtError::UpAlongView);
    assert_eq!(at(1e-9, 3.0, 0.0), LookAtError::UpAlongView);
    assert_eq!(at(f64::NAN, 0.0, 1.0), LookAtError::NotFinite);
    assert_eq!(at(f64::INFINITY, 0.0, 1.0), LookAtError::NotFinite);
    let target = Point::new(0.0, 0.0, -1.0);
    let look = |eye: Point<f64>, up: Direction<f64>| Motor::look_at(eye, target, up).unwrap_err();
    assert_eq!(look(o, Direction::default()), LookAtError::UpIsZero);
    assert_eq!(
        look(o, Direction::new(0.0, f64::NAN, 0.0)),
        LookAtError::NotFinite
    );
    // The difference of two finite points overflows.
    let far = Point::new(f64::MAX, 0.0, 0.0);
    let near = Point::new(-f64::MAX, 0.0, 0.0);
    let error = Motor::look_at(near, far, up);
    assert_eq!(error.unwrap_err(), LookAtError::NotFinite);
    assert!(Motor::look_at(o, Point::new(1e-6, 3.0, 0.0), up).is_ok());
    assert!(Motor::look_at(Point::new(0.0, 0.0, 1e300), target, up).is_ok());
}

#[test]
fn euler_angles_must_be_finite() {
    for bad in [f64::NAN, f64::INFINITY] {
        for place in 0..3 {
            let mut angles = [0.1; 3];
            angles[place] = bad;
            assert_eq!(Rotor::from_euler(EulerOrder::Xyz, angles), None);
            assert_eq!(Rotor::from_euler_extrinsic(EulerOrder::Zxz, angles), None);
        }
    }
    let identity = Rotor::<f64>::default();
    for order in EulerOrder::ALL {
        assert_eq!(identity.to_euler(order), [0.0; 3]);
    }
}

/// The derivative of an intrinsic rotation about x, y, z by its second angle.
#[test]
fn euler_angles_have_derivatives() {
    let angles = [0.3_f64, 0.4, 0.5];
    let variables = Dual::variables(angles);
    let rotor = Rotor::from_euler(EulerOrder::Xyz, variables).unwrap();
    let found = rotor.to_euler(EulerOrder::Xyz);
    for (k, angle) in found.into_iter().enumerate() {
        let mut expected = [0.0; 3];
        expected[k] = 1.0;
        assert!((angle.value - angles[k]).abs() < 1e-15);
        near_all(angle.derivatives, expected, 1e-14);
    }
}

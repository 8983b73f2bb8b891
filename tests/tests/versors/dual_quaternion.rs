//! Motors as dual quaternions, compared with quaternion arithmetic written out.

use ga_runtime::cga3::{DualQuaternion, Motor, Point, Rotor, Translator};
use ga_runtime::geometry::{DualQuaternionParts, NotUnit};
use ga_runtime::testing::{member, strategy};
use nullcone_tests::plain::{near_all, vector};
use proptest::prelude::*;

/// `[x, y, z, w]`.
type Quaternion = [f64; 4];

/// Hamilton's product, from `ij = k`, `jk = i`, `ki = j`.
fn times([ax, ay, az, aw]: Quaternion, [bx, by, bz, bw]: Quaternion) -> Quaternion {
    [
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    ]
}

fn conjugate([x, y, z, w]: Quaternion) -> Quaternion {
    [-x, -y, -z, w]
}

fn plus(a: Quaternion, b: Quaternion) -> Quaternion {
    [0, 1, 2, 3].map(|k| a[k] + b[k])
}

fn scaled(a: Quaternion, factor: f64) -> Quaternion {
    a.map(|x| x * factor)
}

/// `q + ε d`.
type Dual = [Quaternion; 2];

fn dual_times(a: Dual, b: Dual) -> Dual {
    [
        times(a[0], b[0]),
        plus(times(a[0], b[1]), times(a[1], b[0])),
    ]
}

fn dual_of(parts: DualQuaternionParts<f64>) -> Dual {
    [parts.real, parts.dual].map(|([x, y, z], w)| [x, y, z, w])
}

fn parts_of([[x, y, z, w], [dx, dy, dz, dw]]: Dual) -> DualQuaternionParts<f64> {
    DualQuaternionParts {
        real: ([x, y, z], w),
        dual: ([dx, dy, dz], dw),
    }
}

#[track_caller]
fn assert_dual_near(a: Dual, b: Dual, tolerance: f64) {
    near_all(a[0], b[0], tolerance);
    near_all(a[1], b[1], tolerance);
}

fn motors() -> impl Strategy<Value = Motor<f64>> + Clone {
    member(strategy::float(0.9))
}

proptest! {
    #[test]
    fn products_are_those_of_dual_quaternions(a in motors(), b in motors()) {
        let product = dual_times(dual_of(a.to_dual_quaternion()), dual_of(b.to_dual_quaternion()));
        let size = product.iter().flatten().fold(1.0_f64, |most, x| most.max(x.abs()));
        assert_dual_near(dual_of((a * b).to_dual_quaternion()), product, 1e-14 * size);
        let [q, d] = dual_of(a.to_dual_quaternion());
        assert_dual_near(dual_of(a.reverse().to_dual_quaternion()), [conjugate(q), conjugate(d)], 0.0);
    }

    #[test]
    fn the_dual_part_is_half_the_translation_times_the_rotation(axis in vector(5.0), angle in -7.0..7.0_f64, t in vector(5.0)) {
        prop_assume!(axis.iter().map(|x| x * x).sum::<f64>() > 0.01);
        let rotor = Rotor::from_axis_angle(axis, angle).unwrap();
        let parts = (Translator::from_displacement(t) * rotor).to_dual_quaternion();
        let size = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
        let (sine, cosine) = (0.5 * angle).sin_cos();
        let [x, y, z] = axis.map(|x| x / size * sine);
        let q = [x, y, z, cosine];
        let half = times([0.5 * t[0], 0.5 * t[1], 0.5 * t[2], 0.0], q);
        assert_dual_near(dual_of(parts), [q, half], 1e-14);
    }

    #[test]
    fn points_move_as_kavan_says(motor in motors(), x in vector(5.0)) {
        let hat = dual_of(motor.to_dual_quaternion());
        let [q, d] = hat;
        let point: Dual = [[0.0, 0.0, 0.0, 1.0], [x[0], x[1], x[2], 0.0]];
        let conjugated = [conjugate(q), scaled(conjugate(d), -1.0)];
        let moved = dual_times(dual_times(hat, point), conjugated);
        let [a, b, c] = motor.transform(Point::from(x)).coordinates();
        let size = moved[1].iter().fold(1.0_f64, |most, x| most.max(x.abs()));
        assert_dual_near(moved, [[0.0, 0.0, 0.0, 1.0], [a, b, c, 0.0]], 1e-13 * size);
    }

    #[test]
    fn motors_survive_a_round_trip(motor in motors(), size in 1e-3..1e3_f64) {
        let dual = dual_of(motor.to_dual_quaternion());
        prop_assert_eq!(
            DualQuaternion::from_parts(motor.to_dual_quaternion()),
            DualQuaternion::from(motor),
        );
        let again = Motor::from_dual_quaternion(parts_of(dual.map(|q| scaled(q, size)))).unwrap();
        let largest = dual.iter().flatten().fold(1.0_f64, |most, x| most.max(x.abs()));
        assert_dual_near(dual_of(again.to_dual_quaternion()), dual, 1e-14 * largest);
    }

    #[test]
    fn rounding_is_repaired(motor in motors(), noise in prop::array::uniform8(-1e-10..1e-10_f64)) {
        let [q, d] = dual_of(motor.to_dual_quaternion());
        let bent = [
            [0, 1, 2, 3].map(|k| q[k] + noise[k]),
            [0, 1, 2, 3].map(|k| d[k] + noise[k + 4]),
        ];
        let mended = Motor::from_dual_quaternion(parts_of(bent)).unwrap();
        let [p, e] = dual_of(mended.to_dual_quaternion());
        let norm: f64 = p.iter().map(|x| x * x).sum();
        let study: f64 = (0..4).map(|k| p[k] * e[k]).sum();
        let size = e.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
        near_all([norm, study / size], [1.0, 0.0], 1e-15 * 8.0);
        assert_dual_near([p, e], [q, d], 1e-8 * size);
    }
}

#[test]
fn errors_say_why_numbers_are_not_a_motion() {
    let from = |q, d| Motor::from_dual_quaternion(parts_of([q, d]));
    let (one, zero) = ([0.0, 0.0, 0.0, 1.0], [0.0; 4]);
    assert_eq!(from(one, zero), Ok(Motor::default()));
    assert_eq!(from(zero, zero), Err(NotUnit::NoRotation));
    assert_eq!(from(zero, one), Err(NotUnit::NoRotation));
    assert_eq!(from(one, one), Err(NotUnit::NotPerpendicular));
    let (little, much) = ([1e-9, 0.0, 0.0, 1e-9], [1e9, 0.0, 0.0, 1e3]);
    assert!(from(one, little).is_ok());
    assert_eq!(from(one, much), Err(NotUnit::NotPerpendicular));
    assert!(from(one, [1e9, 0.0, 0.0, 1.0]).is_ok());
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..4 {
            let mut broken = one;
            broken[place] = bad;
            assert_eq!(from(broken, zero), Err(NotUnit::NotFinite));
            assert_eq!(from(one, broken), Err(NotUnit::NotFinite));
        }
    }
    // A translation beyond the range of the scalar.
    assert_eq!(
        from([0.0, 0.0, 0.0, 1e-200], [1e200, 0.0, 0.0, 0.0]),
        Err(NotUnit::NotFinite)
    );
    assert!(
        NotUnit::NotPerpendicular
            .to_string()
            .contains("perpendicular")
    );
    // Magnitudes whose squares leave the range are accepted.
    for size in [1e-200, 1e200] {
        let motor = from([0.0, 0.6 * size, 0.0, 0.8 * size], [0.0; 4]).unwrap();
        near_all(
            dual_of(motor.to_dual_quaternion())[0],
            [0.0, 0.6, 0.0, 0.8],
            1e-15,
        );
    }
}

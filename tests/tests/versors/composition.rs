//! The product of two motors in registers, against the product over the integers.

use ga_runtime::cga3::Motor;
use ga_runtime::scalar::Ring;
use proptest::prelude::*;

fn motor<S: Ring>(coefficients: [i8; 8]) -> Motor<S> {
    let [s, e12, e13, e23, e1i, e2i, e3i, e123i] =
        coefficients.map(|x| S::from_integer(i64::from(x)));
    Motor::new_unchecked(s, e12, e13, e23, e1i, e2i, e3i, e123i)
}

fn integers(motor: Motor<f32>) -> Motor<i64> {
    Motor::new_unchecked(
        motor.scalar() as i64,
        motor.e12() as i64,
        motor.e13() as i64,
        motor.e23() as i64,
        motor.e1i() as i64,
        motor.e2i() as i64,
        motor.e3i() as i64,
        motor.e123i() as i64,
    )
}

proptest! {
    /// Sums of eight products of bytes are exact in `f32`.
    #[test]
    fn motors_are_composed_without_error_where_there_is_no_rounding(a in any::<[i8; 8]>(), b in any::<[i8; 8]>()) {
        let composed = motor::<f32>(a).compose(motor(b));
        prop_assert_eq!(integers(composed), motor::<i64>(a) * motor::<i64>(b));
        let composed = motor::<f64>(a).compose(motor(b));
        prop_assert_eq!(composed, motor::<f64>(a) * motor::<f64>(b));
    }
}

#[test]
fn what_is_not_a_number_stays_so() {
    let broken = Motor::new_unchecked(f32::NAN, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    let composed = broken.compose(Motor::default());
    assert!(composed.scalar().is_nan() && composed.e1i().is_nan());
}

//! The smooth step.

use ga_runtime::scalar::{Dual, Lanes, smooth_step};
use nullcone_tests::plain::near;
use proptest::prelude::*;

proptest! {
    #[test]
    fn a_smooth_step_is_the_cubic_between_two_ends(low in -5.0..5.0_f64, width in 0.1..5.0_f64, t in -1.0..2.0_f64) {
        let (high, x) = (low + width, low + t * width);
        let inside = t.clamp(0.0, 1.0);
        let step = smooth_step(low, high, Dual::variable(x).value);
        near(step, 3.0 * inside.powi(2) - 2.0 * inside.powi(3), 1e-13);
        // Its slope, 6 t (1 − t) / width, is zero at both ends and beyond them.
        let slope = smooth_step(Dual::constant(low), Dual::constant(high), Dual::variable(x));
        near(slope.derivative(), 6.0 * inside * (1.0 - inside) / width, 1e-12 / width);
        // Symmetric about the middle.
        near(smooth_step(low, high, low + high - x), 1.0 - step, 1e-13);
    }
}

#[test]
fn a_step_without_width_jumps() {
    let jump = |x: f64| smooth_step(2.0, 2.0, x);
    assert_eq!([jump(1.0), jump(2.0), jump(3.0)], [0.0, 1.0, 1.0]);
    assert_eq!([jump(-f64::INFINITY), jump(f64::INFINITY)], [0.0, 1.0]);
    assert_eq!(smooth_step(2.0, 1.0, 1.5), 0.0);
    assert!(jump(f64::NAN).is_nan() && smooth_step(0.0, 1.0, f64::NAN).is_nan());
    assert_eq!(smooth_step(0.0, 1.0, f64::INFINITY), 1.0);
}

#[test]
fn lanes_step_each_for_itself() {
    let lanes = |x: [f64; 4]| Lanes::from_array(x);
    let found = smooth_step(
        lanes([0.0; 4]),
        lanes([1.0, 1.0, 2.0, 0.0]),
        lanes([0.5, 2.0, 0.5, -1.0]),
    );
    assert_eq!(found, lanes([0.5, 1.0, 0.15625, 0.0]));
}

#[test]
fn steps_wider_than_the_range_are_smooth() {
    let (low, high) = (-f64::MAX, f64::MAX);
    let step = |x: f64| smooth_step(low, high, x);
    assert_eq!([step(low), step(0.0), step(high)], [0.0, 0.5, 1.0]);
    assert_eq!([step(-f64::INFINITY), step(f64::INFINITY)], [0.0, 1.0]);
    assert_eq!([step(0.5 * low), step(0.5 * high)], [0.15625, 0.84375]);
    assert!(step(f64::NAN).is_nan());
}

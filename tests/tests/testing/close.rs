//! `assert_close!` fails where it should, and its message says why.

use ga_runtime::dense::Algebra;
use ga_runtime::testing::{Deviation, assert_close, check_close, strategy};
use proptest::prelude::*;

/// The message of the deviation, if there is one.
fn message(result: Result<(), Deviation>) -> String {
    result
        .err()
        .map_or_else(|| "close".to_owned(), |deviation| deviation.to_string())
}

#[test]
fn the_tolerance_is_relative_to_the_largest_coefficient() {
    assert_close!([1e6, 1e-9], [1e6, 0.0]);
    assert_close!([0.0, 0.0], [0.0, 0.0]);
    assert_close!(1e-20, 1.01e-20, 0.1);
    assert_close!(1.0_f32 / 3.0, 0.333_333_4_f32);
    assert_close!(0.1_f32, 0.1_f64);
    assert_close!([] as [f64; 0], Vec::<f64>::new());
    assert!(check_close(&1e-20, &2e-20, None, None).is_err());
    assert!(check_close(&[1.0, 1e-9], &[1.0, 0.0], None, None).is_err());
    assert!(check_close(&1e-17, &0.0, None, None).is_err());
    assert!(check_close(&1e-17, &0.0, None, Some(1.0)).is_ok());
    assert!(check_close(&0.1_f32, &0.100_01_f32, None, None).is_err());
}

#[test]
fn infinities_and_nan_fail() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(check_close(&value, &value, None, None).is_err());
        assert!(check_close(&[1.0, value], &[1.0, 2.0], Some(f64::INFINITY), None).is_err());
        assert!(check_close(&[1.0, 2.0], &[1.0, value], Some(1e300), None).is_err());
    }
    assert!(check_close(&1.0, &1.0, Some(f64::NAN), None).is_err());
    assert!(check_close(&1.0, &1.0, None, Some(f64::NAN)).is_err());
    assert!(check_close(&f64::MAX, &-f64::MAX, None, None).is_err());
}

#[test]
fn messages_name_the_worst_coefficient() -> Result<(), ga_runtime::dense::DenseError> {
    assert_eq!(
        message(check_close(
            &[[1.0, 2.0], [3.0, 4.0]],
            &[[1.0, 2.5], [3.0, 3.0]],
            Some(1e-3),
            None
        )),
        "[1][1] is 4.0 on the left, 3.0 on the right, a relative deviation of 2.5e-1 where 1.0e-3 is allowed"
    );
    assert_eq!(
        message(check_close(&1.0, &f64::NAN, None, None)),
        "the value is 1.0 on the left, NaN on the right"
    );
    assert_eq!(
        message(check_close(&vec![1.0, 2.0], &[1.0], None, None)),
        "2 coefficients on the left, 1 on the right"
    );
    let plane = Algebra::<f64>::with_signature(2, 0, 0)?;
    let result = check_close(
        &[plane.zero(), plane.pseudoscalar()],
        &[plane.zero(), plane.one()],
        Some(0.1),
        None,
    );
    assert!(message(result).starts_with("[1].e12 is 1.0 on the left, 0.0 on the right"));
    Ok(())
}

#[test]
#[should_panic(
    expected = "left + 1.0 is not close to [3.0].iter().sum::<f64>(): the value is 2.0 on the left, 3.0"
)]
fn the_assertion_panics() {
    let left = 1.0;
    assert_close!(left + 1.0, [3.0].iter().sum::<f64>());
}

proptest! {
    /// Half the tolerance passes and twice the tolerance fails, for every coefficient and
    /// magnitude.
    #[test]
    fn the_tolerance_is_the_border(
        values in proptest::collection::vec(strategy::float(1.0), 1..20),
        place in any::<prop::sample::Index>(),
        exponent in -100_i32..100,
        tolerance in 1e-9..1e-3,
    ) {
        prop_assume!(values.iter().any(|value| *value != 0.0));
        let magnitude = 10_f64.powi(exponent);
        let exact: Vec<f64> = values.iter().map(|value| value * magnitude).collect();
        let largest = exact.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        let with_error = |error: f64| {
            let mut changed = exact.clone();
            changed[place.index(exact.len())] += error * largest;
            changed
        };
        prop_assert!(check_close(&exact, &with_error(0.5 * tolerance), Some(tolerance), None).is_ok());
        prop_assert!(check_close(&exact, &with_error(2.0 * tolerance), Some(tolerance), None).is_err());
    }

    #[test]
    fn floats_stay_within_their_magnitude(value in strategy::float(3.0)) {
        prop_assert!(value.abs() <= 3.0);
    }
}

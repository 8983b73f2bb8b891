//! Quantiles against numpy, and laws.

use ga_numerics::order_statistics::{Sorted, median, median_element};
use proptest::prelude::*;

/// `numpy.quantile(values, share)` of numpy 2.
#[test]
fn quantiles_are_those_of_numpy() {
    let mut values = [9.5, -3.25, 0.5, 7.0, 2.0, 2.0, -11.0];
    let sorted = Sorted::new(&mut values).unwrap();
    for (share, expected) in [
        (0.0, -11.0),
        (0.1, -6.35),
        (0.25, -1.375),
        (0.5, 2.0),
        (0.9, 8.0),
        (1.0, 9.5),
    ] {
        let found: f64 = sorted.quantile(share);
        assert!((found - expected).abs() < 1e-14, "{share}: {found}");
    }
}

#[test]
fn what_has_no_order_has_no_median() {
    assert_eq!(median::<f32>(&mut []), None);
    assert_eq!(median_element::<i32>(&mut []), None);
    assert_eq!(median(&mut [1.0, f64::NAN, 2.0]), None);
    assert_eq!(median(&mut [1.0, -f64::NAN, 2.0]), None);
}

#[test]
fn infinite_values_have_quantiles() {
    let mut values = [f64::INFINITY, 1.0, f64::INFINITY];
    let sorted = Sorted::new(&mut values).unwrap();
    assert_eq!(sorted.median(), f64::INFINITY);
    assert_eq!(sorted.quantile(0.9), f64::INFINITY);
    assert_eq!(sorted.quantile(0.0), 1.0);
}

proptest! {
    /// A share p of n values: at most (n − 1) p + 1 values are below, at most the others above.
    #[test]
    fn a_quantile_has_its_share_below(
        values in prop::collection::vec(-1e3..1e3f64, 1..40),
        share in 0.0..=1.0f64,
    ) {
        let found = Sorted::new(&mut values.clone()).unwrap().quantile(share);
        let below = values.iter().filter(|value| **value < found).count() as f64;
        let above = values.iter().filter(|value| **value > found).count() as f64;
        let steps = (values.len() - 1) as f64;
        prop_assert!(below <= (steps * share).floor() + 1.0);
        prop_assert!(above <= (steps * (1.0 - share)).floor() + 1.0);
    }

    #[test]
    fn the_median_element_is_one_of_the_values(values in prop::collection::vec(-9..9i32, 1..40)) {
        let found = median_element(&mut values.clone()).unwrap();
        prop_assert!(values.contains(&found));
        prop_assert!(values.iter().filter(|value| **value < found).count() <= values.len() / 2);
        prop_assert!(values.iter().filter(|value| **value > found).count() < values.len().div_ceil(2));
    }
}

//! Correlations against SciPy and against plain counting.

use ga_video::opinion::correlation::{kendall, pearson, ranks, spearman};
use proptest::prelude::*;

#[test]
fn correlations_equal_those_of_scipy() {
    for (scores, truth) in super::oracle().into_iter().flatten() {
        let (x, y) = (scores.objective(), scores.subjective());
        for (found, name) in [
            (pearson(x, y), "plcc_raw"),
            (spearman(x, y), "srocc"),
            (kendall(x, y), "krocc"),
        ] {
            let expected = truth[name].as_f64().unwrap();
            assert!(
                (found.unwrap() - expected).abs() < 1e-12,
                "{name}: {found:?}"
            );
        }
    }
}

/// Few different numbers, so that many are equal.
fn rows() -> impl Strategy<Value = Vec<(i8, i8)>> {
    prop::collection::vec((-4..5_i8, -4..5_i8), 2..40)
}

proptest! {
    #[test]
    fn kendall_counts_all_pairs(rows in rows()) {
        let (x, y): (Vec<f64>, Vec<f64>) =
            rows.iter().map(|(a, b)| (f64::from(*a), f64::from(*b))).unzip();
        let (mut difference, mut first, mut second) = (0_i32, 0, 0);
        for i in 0..rows.len() {
            for j in 0..i {
                let signs = [rows[i].0.cmp(&rows[j].0) as i32, rows[i].1.cmp(&rows[j].1) as i32];
                difference += signs[0] * signs[1];
                first += signs[0].abs();
                second += signs[1].abs();
            }
        }
        let found = kendall(&x, &y);
        if first == 0 || second == 0 {
            prop_assert_eq!(found, None);
        } else {
            let expected = f64::from(difference) / (f64::from(first) * f64::from(second)).sqrt();
            prop_assert!((found.unwrap() - expected).abs() < 1e-12);
        }
    }

    #[test]
    fn a_rank_is_the_mean_place_among_equals(rows in rows()) {
        let values: Vec<f64> = rows.iter().map(|(a, _)| f64::from(*a)).collect();
        for (value, rank) in values.iter().zip(ranks(&values)) {
            let below = values.iter().filter(|v| *v < value).count() as f64;
            let equal = values.iter().filter(|v| *v == value).count() as f64;
            prop_assert_eq!(rank, below + (equal + 1.0) / 2.0);
        }
    }

    #[test]
    fn scale_and_place_do_not_matter(
        rows in rows(),
        scale in 1e-200..1e200_f64,
        place in -1e3..1e3_f64,
    ) {
        let (x, y): (Vec<f64>, Vec<f64>) =
            rows.iter().map(|(a, b)| (f64::from(*a), f64::from(*b))).unzip();
        let scaled: Vec<f64> = x.iter().map(|v| scale * (v + place.round())).collect();
        let (before, after) = (pearson(&x, &y), pearson(&scaled, &y));
        prop_assert_eq!(before.is_some(), after.is_some());
        if let (Some(before), Some(after)) = (before, after) {
            prop_assert!((before - after).abs() < 1e-9, "{} {}", before, after);
            let monotonic: Vec<f64> = x.iter().map(|v| v.powi(3)).collect();
            prop_assert_eq!(spearman(&monotonic, &y), spearman(&x, &y));
        }
    }
}

#[test]
fn there_is_none_without_variation() {
    for of in [pearson, spearman, kendall] {
        assert_eq!(of(&[], &[]), None);
        assert_eq!(of(&[1.0], &[2.0]), None);
        assert_eq!(of(&[1.0, 1.0], &[2.0, 3.0]), None);
        assert_eq!(of(&[1.0, 2.0], &[3.0, 3.0]), None);
        assert!((of(&[0.0, 2.0], &[3.0, 1.0]).unwrap() + 1.0).abs() < 1e-15);
    }
}

#[test]
fn numbers_at_the_ends_of_the_range_are_correlated() {
    let places = [1.0, 2.0, 3.0];
    for values in [[-f64::MAX, 0.0, f64::MAX], [0.0, 5e-324, 1e-323]] {
        assert_eq!(pearson(&values, &places), Some(1.0));
        assert_eq!(pearson(&places, &values), Some(1.0));
    }
}

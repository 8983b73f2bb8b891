//! Intervals and tests of significance against closed forms.

use ga_files::table::Table;
use ga_video::opinion::logistic::{Curve, Logistic4, Logistic5};
use ga_video::opinion::performance::{self, Bootstrap};
use ga_video::opinion::{OpinionError, Scores};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// Opinions between 1 and 5, and two measures of them with normal errors of these sizes.
fn measures(count: usize, errors: [f64; 2], seed: u64) -> [Scores; 2] {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
    let opinions: Vec<f64> = (0..count).map(|_| 3.0 + 0.6 * normal()).collect();
    errors.map(|error| {
        let measured = opinions.iter().map(|y| y + error * normal()).collect();
        Scores::new(measured, opinions.clone()).unwrap()
    })
}

#[test]
fn performance_is_as_scipy_says() {
    for (scores, truth) in super::oracle().into_iter().flatten() {
        let fit = Logistic5::fit(&scores).unwrap();
        let found = performance::of(&scores, &fit);
        let truth = &truth["logistic5"];
        assert!(found.linear_correlation > truth["plcc"].as_f64().unwrap() - 1e-6);
        assert!(found.root_mean_square_error < truth["rmse"].as_f64().unwrap() + 1e-6);
        // All intervals are around their numbers.
        let intervals = performance::with_intervals(&scores, &fit, &Bootstrap::default()).unwrap();
        for interval in [
            intervals.linear_correlation,
            intervals.spearman,
            intervals.kendall,
            intervals.outlier_ratio,
        ] {
            assert!(interval.low <= interval.value && interval.value <= interval.high);
            assert!(interval.high - interval.low < 0.3);
        }
        // A curve fits a draw better than it fits all scores.
        assert!(intervals.root_mean_square_error.low < found.root_mean_square_error);
    }
}

/// For normal numbers, R. A. Fisher's transformation `artanh r` has the standard deviation
/// `1 / √(n − 3)`.
#[test]
fn intervals_are_those_of_normal_numbers() {
    let [scores, _] = measures(300, [0.5, 1.0], 7);
    let fit = Logistic5::fit(&scores).unwrap();
    let bootstrap = Bootstrap {
        draws: 2000,
        ..Bootstrap::default()
    };
    let found = performance::with_intervals(&scores, &fit, &bootstrap)
        .unwrap()
        .linear_correlation;
    let (middle, half) = (found.value.atanh(), 1.96 / 297.0_f64.sqrt());
    for (end, expected) in [(found.low, middle - half), (found.high, middle + half)] {
        assert!((end.atanh() - expected).abs() < 0.35 * half, "{found:?}");
    }
}

#[test]
fn intervals_do_not_depend_on_threads_but_on_the_seed() {
    let [scores, _] = measures(40, [0.5, 1.0], 3);
    let fit = Logistic4::fit(&scores).unwrap();
    let found = |threads: usize, seed: u64| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let bootstrap = Bootstrap {
            draws: 60,
            seed,
            ..Bootstrap::default()
        };
        pool.install(|| performance::with_intervals(&scores, &fit, &bootstrap))
            .unwrap()
    };
    assert_eq!(found(1, 5), found(3, 5));
    assert_ne!(found(1, 5), found(1, 6));
}

#[test]
fn outliers_are_off_by_two_deviations() {
    // A line from 1 to 5, one opinion 1 above it, and another 0.5 below.
    let x: Vec<f64> = (0..41).map(|k| 0.1 * f64::from(k)).collect();
    let mut opinions: Vec<f64> = x.iter().map(|x| 1.0 + x).collect();
    opinions[10] += 1.0;
    opinions[30] -= 0.5;
    let scores = Scores::new(x, opinions).unwrap();
    let fit = Logistic5::fit(&scores).unwrap();
    assert_eq!(performance::of(&scores, &fit).outlier_ratio, 2.0 / 41.0);
    let wide = scores.clone().with_deviations(vec![0.3; 41]).unwrap();
    assert_eq!(performance::of(&wide, &fit).outlier_ratio, 1.0 / 41.0);
    let wider = scores.with_deviations(vec![0.6; 41]).unwrap();
    assert_eq!(performance::of(&wider, &fit).outlier_ratio, 0.0);
}

#[test]
fn the_better_of_two_measures_is_found() {
    let bootstrap = Bootstrap {
        draws: 300,
        ..Bootstrap::default()
    };
    let compared = |errors| {
        let [first, second] = measures(120, errors, 11);
        let fits = [&first, &second].map(|scores| Logistic4::fit(scores).unwrap());
        performance::difference([&first, &second], [&fits[0], &fits[1]], &bootstrap).unwrap()
    };
    let better = compared([0.2, 0.8]);
    assert!(better.linear_correlation.low > 0.0 && better.spearman.low > 0.0);
    assert!(better.correlation_p_value < 1e-6 && better.error_p_value < 1e-6);
    let worse = compared([0.8, 0.2]);
    assert!(worse.linear_correlation.high < 0.0);
    let equal = compared([0.5, 0.5]);
    assert!(equal.linear_correlation.low < 0.0 && equal.linear_correlation.high > 0.0);
    assert!(equal.correlation_p_value > 0.05 && equal.error_p_value > 0.05);
    // A measure beside itself.
    let [first, _] = measures(50, [0.5, 0.5], 2);
    let fit = Logistic4::fit(&first).unwrap();
    let same = performance::difference([&first, &first], [&fit, &fit], &bootstrap).unwrap();
    assert_eq!((same.correlation_p_value, same.error_p_value), (1.0, 1.0));
    assert_eq!((same.spearman.low, same.spearman.high), (0.0, 0.0));
}

#[test]
fn wrong_settings_are_refused() {
    let [scores, _] = measures(20, [0.5, 0.5], 1);
    let fit = Logistic4::fit(&scores).unwrap();
    let error = |bootstrap| performance::with_intervals(&scores, &fit, &bootstrap).unwrap_err();
    let confidence = Bootstrap {
        confidence: 1.0,
        ..Bootstrap::default()
    };
    assert_eq!(error(confidence), OpinionError::Confidence(1.0));
    let draws = Bootstrap {
        draws: 0,
        ..Bootstrap::default()
    };
    assert!(matches!(
        error(draws),
        OpinionError::TooFew { what: "draws", .. }
    ));
}

/// What is read from the semicolons and decimal commas of a spreadsheet is what a program writes.
#[test]
fn scores_of_spreadsheets_are_read() {
    let scores = |text: &str| {
        let table = Table::with_names(text.as_bytes()).unwrap();
        Scores::of_column(&table, "objective")
    };
    let plain = "objective,subjective\n30.1,2.1\n31.5,2.9\n33,3.5\n35.2,4.1\n38,4.6\n40.1,4.7\n";
    let expected = scores(plain).unwrap();
    assert_eq!(scores(&plain.replace(',', "\t")).unwrap(), expected);
    assert_eq!(
        scores(&format!("\u{feff}{}", plain.replace('\n', "\r\n"))).unwrap(),
        expected
    );
    for missing in ["NA", ""] {
        let message = scores(&plain.replace("4.6", missing))
            .unwrap_err()
            .to_string();
        let said = format!("line 6, column subjective: {missing:?} is not a finite number");
        assert_eq!(message, said);
    }
    let Some(path) = nullcone_shared_data::shared("cases/video/csv-semicolon/fit.csv") else {
        return;
    };
    assert_eq!(
        scores(&std::fs::read_to_string(path).unwrap()).unwrap(),
        expected
    );
}

//! What a threshold does to normal errors.

use ga_numerics::ransac::{Consensus, Search, SelectedNoise};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use statrs::distribution::{ContinuousCDF, Normal};

/// A number between 0 and 1.
pub(super) fn unit(random: &mut ChaCha8Rng) -> f64 {
    (f64::from(random.next_u32()) + 0.5) / 4_294_967_296.0
}

/// Normal numbers with the mean 3 and the deviation 0.5.
fn numbers(random: &mut ChaCha8Rng, count: usize) -> Vec<f64> {
    let normal = Normal::new(3.0, 0.5).unwrap();
    let number = |_| normal.inverse_cdf(unit(random));
    (0..count).map(number).collect()
}

/// The mean of those numbers that are within a threshold of it, and these.
fn trimmed(numbers: &[f64], threshold: f64) -> (f64, Vec<f64>) {
    let mut mean = 3.0;
    loop {
        let near = numbers.iter().filter(|x| (**x - mean).abs() < threshold);
        let near: Vec<f64> = near.copied().collect();
        let next = near.iter().sum::<f64>() / near.len() as f64;
        if next == mean {
            return (mean, near);
        }
        mean = next;
    }
}

/// The mean of few numbers of which a threshold leaves out the outer ones: its true value is in the
/// region of 95 %, and their variance is what it was before.
#[test]
fn a_region_holds_for_what_a_threshold_keeps() {
    const RUNS: u32 = 4000;
    for (count, threshold) in [(12, f64::INFINITY), (12, 1.5), (40, 1.25), (100, 1.0)] {
        let mut random = ChaCha8Rng::seed_from_u64(7);
        let (mut within, mut shown, mut variances) = (0_u32, 0_u32, 0.0);
        for _ in 0..RUNS {
            let numbers = numbers(&mut random, count);
            let (mean, near) = trimmed(&numbers, threshold);
            let cost = near.iter().map(|x| (x - mean).powi(2)).sum();
            let noise = SelectedNoise::new(cost, [near.len(), 1], threshold, 1);
            let Some((noise, variance)) = noise.and_then(|one| Some((one, one.of_region(1)?)))
            else {
                continue;
            };
            shown += 1;
            variances += noise.variance;
            let covariance = variance / near.len() as f64;
            within += u32::from((mean - 3.0).powi(2) <= 3.841_459 * covariance);
        }
        assert!(shown > 17 * RUNS / 20, "{count} {threshold}: {shown}");
        let part = f64::from(within) / f64::from(shown);
        assert!((part - 0.95).abs() < 0.02, "{count} {threshold}: {part}");
        let mean = variances / f64::from(shown);
        if count == 100 {
            assert!(
                (mean / 0.25 - 1.0).abs() < 0.1,
                "{count} {threshold}: {mean}"
            );
        }
    }
}

#[test]
fn noise_without_a_meaning_is_none() {
    let new = SelectedNoise::new;
    assert!(new(f64::NAN, [20, 5], 1.0, 1).is_none());
    assert!(new(1.0, [20, 5], f64::NAN, 1).is_none());
    assert!(new(1.0, [20, 5], -1.0, 1).is_none());
    assert!(new(1.0, [20, 5], 1.0, 0).is_none());
    assert!(new(1.0, [5, 5], 10.0, 1).is_none());
    assert!(new(1.0, [7, 5], 10.0, 1).is_some_and(|noise| noise.of_region(5).is_none()));
}

/// Errors of numbers from a level.
struct Level([f64; 4]);

impl Consensus for Level {
    type Model = f64;
    const SAMPLE: usize = 1;

    fn count(&self) -> usize {
        self.0.len()
    }

    fn fit(&self, sample: &[usize], models: &mut Vec<f64>) {
        models.push(self.0[sample[0]]);
    }

    fn squared_error(&self, level: &f64, observation: usize) -> f64 {
        (self.0[observation] - level).powi(2)
    }
}

/// With a threshold of 3 an error of 2 costs 4; one of 5 costs 9, as does one that is not a number.
#[test]
fn the_cost_of_an_error_ends_at_the_square_of_the_threshold() {
    let search = Search {
        threshold: 3.0,
        confidence: 0.99,
        least_samples: 1,
        samples: 10,
        seed: 1,
    };
    let problem = Level([2.0, 5.0, f64::NAN, 0.0]);
    let candidate = search.rate(&problem, 0.0, f64::INFINITY).unwrap();
    assert_eq!((candidate.cost, candidate.inliers), (22.0, 2));
    assert_eq!(search.inliers(&problem, &0.0), [0, 3]);
    assert!(search.rate(&problem, 0.0, 22.0).is_none());
    assert!(search.rate(&problem, 0.0, 22.5).is_some());
}

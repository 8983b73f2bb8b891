//! Lists of random values, for uses other than property tests.

use alloc::vec::Vec;

use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, RngSeed, TestRunner};

/// `count` values of a strategy, the same values for the same seed: inputs of a benchmark, for
/// instance.
///
/// ```
/// use ga_runtime::cga3::Motor;
/// use ga_runtime::testing::{member, sample, strategy};
///
/// let motors: Vec<Motor<f64>> = sample(&member(strategy::float(0.9)), 100, 1);
/// assert_eq!(motors.len(), 100);
/// assert_eq!(motors, sample(&member(strategy::float(0.9)), 100, 1));
/// assert_ne!(motors, sample(&member(strategy::float(0.9)), 100, 2));
/// ```
///
/// # Panics
/// If the strategy rejects nearly all values that it draws.
pub fn sample<V: Strategy>(strategy: &V, count: usize, seed: u64) -> Vec<V::Value> {
    let mut runner = TestRunner::new(Config {
        failure_persistence: None,
        rng_algorithm: RngAlgorithm::ChaCha,
        rng_seed: RngSeed::Fixed(seed),
        ..Config::default()
    });
    let draw = |_| match strategy.new_tree(&mut runner) {
        Ok(tree) => tree.current(),
        Err(reason) => panic!("the strategy gives no values: {reason}"),
    };
    (0..count).map(draw).collect()
}

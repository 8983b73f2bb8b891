//! The common parts of the tests that `product_tests!` generates.
//!
//! There are hundreds of these tests. The common parts are not generic, so that the compiler does
//! not build the runner again for each of them.

use alloc::vec::Vec;
use core::fmt::Debug;

use proptest::collection::vec;
use proptest::test_runner::TestCaseError;

use super::declared::{Members, algebra_of, runner};
use super::strategy::prime;
use crate::Element;
use crate::dense::{Algebra, Multivector};
use crate::scalar::Prime61;

/// The construction of members of a type over the prime field.
#[must_use]
pub fn members<T: Element<Scalar = Prime61>>() -> Members<Prime61> {
    Members::new(T::METRIC, T::BLADES, T::IS_FREE)
}

/// A test that takes the reference algebra and the numbers of each operand.
type TestOfNumbers<'a> = dyn Fn(&Algebra<Prime61>, &[Vec<Prime61>]) -> Option<()> + 'a;

/// Runs a test on random numbers, as many for each operand as `counts` says, the same in every run.
/// The test returns `None` where the numbers do not make operands, and panics where it fails.
///
/// # Panics
/// If the test fails, with the smallest failing numbers that were found.
pub fn for_all_numbers(metric: &[&[(i64, i64)]], counts: &[usize], test: &TestOfNumbers<'_>) {
    let algebra = algebra_of(metric);
    let strategy: Vec<_> = counts.iter().map(|&count| vec(prime(), count)).collect();
    let outcome = runner().run(&strategy, |numbers| {
        test(&algebra, &numbers).ok_or_else(|| TestCaseError::reject("a plane with α²b² = 1"))
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}

/// Asserts that the result equals that of the reference; the operands are for the message.
///
/// # Panics
/// If they differ.
pub fn assert_same(
    operation: &str,
    operands: &[&dyn Debug],
    found: &Multivector<Prime61>,
    expected: &Multivector<Prime61>,
) {
    assert!(
        found == expected,
        "{operation} of {operands:?} is {found:?}, and {expected:?} by the dense reference"
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Ring;

    /// The metric of the Euclidean plane.
    const METRIC: &[&[(i64, i64)]] = &[&[(1, 1), (0, 1)], &[(0, 1), (1, 1)]];

    #[test]
    fn every_case_is_run() {
        let count = core::cell::Cell::new(0);
        for_all_numbers(METRIC, &[2, 1], &|algebra, numbers| {
            assert_eq!((numbers[0].len(), numbers[1].len()), (2, 1));
            let found = algebra.scalar(numbers[1][0]);
            assert_same("itself", &[], &found, &found);
            count.set(count.get() + 1);
            Some(())
        });
        assert_eq!(count.get(), 256);
    }

    #[test]
    #[should_panic(expected = "the sum of []")]
    fn a_difference_fails() {
        for_all_numbers(METRIC, &[1], &|algebra, numbers| {
            let found = algebra.scalar(numbers[0][0]);
            let other = algebra.scalar(numbers[0][0] + Prime61::one());
            assert_same("the sum", &[], &found, &other);
            Some(())
        });
    }
}

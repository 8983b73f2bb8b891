//! The common parts of the tests that `product_tests!` generates.
//!
//! There are hundreds of these tests. The common parts are not generic, so that the compiler does
//! not build the runner again for each of them.

use alloc::vec::Vec;
use core::fmt::Debug;
use core::iter::{Product, Sum};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Sub, SubAssign};

use proptest::collection::vec;
use proptest::test_runner::TestCaseError;

use super::declared::{Members, runner};
use super::quiet::quietly;
use super::strategy::prime;
use crate::Element;
use crate::dense::{Algebra, Multivector};
use crate::scalar::Prime61;

/// The construction of members of a type over the prime field.
#[must_use]
pub fn members<T: Element<Scalar = Prime61>>() -> Members<Prime61> {
    Members::new(T::METRIC, T::BLADES, T::IS_FREE)
}

/// The construction of blades among the members of a type over the prime field.
#[must_use]
pub fn blades<T: Element<Scalar = Prime61>>() -> Members<Prime61> {
    Members::new(T::METRIC, T::BLADES, false)
}

/// A test that takes the reference algebra and the numbers of each operand.
type TestOfNumbers<'a> = dyn Fn(&Algebra<Prime61>, &[Vec<Prime61>]) -> Option<()> + 'a;

/// Runs a test on random numbers, as many for each operand as `counts` says. The test returns
/// `None` where the numbers do not make operands, and panics where it fails.
///
/// # Panics
/// Once, if the test fails, with the smallest failing numbers that were found.
pub fn for_all_numbers(
    metric: &[&[(i64, i64)]],
    basis: &[&str],
    counts: &[usize],
    test: &TestOfNumbers<'_>,
) {
    let algebra = match Algebra::declared(metric, basis) {
        Ok(algebra) => algebra,
        Err(error) => panic!("{error}"),
    };
    let strategy: Vec<_> = counts.iter().map(|&count| vec(prime(), count)).collect();
    let outcome = runner().run(&strategy, |numbers| {
        let made = quietly(|| test(&algebra, &numbers)).map_err(TestCaseError::fail)?;
        made.ok_or_else(|| TestCaseError::reject("a plane with α²b² = 1"))
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

/// Asserts that the coefficients of an element by name are those of the blades that the names mean:
/// outer products of basis vectors in the order of the name.
///
/// # Panics
/// If they are not.
pub fn check_coefficients<T: Element<Scalar = Prime61> + Debug>(
    element: T,
    algebra: &Algebra<Prime61>,
) {
    assert_eq!(T::NAMES.len(), T::BLADES.len());
    assert_eq!(element.coefficients().len(), T::BLADES.len());
    let mut sum = algebra.zero();
    for ((name, value), &blade) in element.coefficients().zip(T::BLADES) {
        assert_eq!(
            element.coefficient_of(name),
            Some(value),
            "{name} of {element:?}"
        );
        let is_reversed = T::REVERSED.contains(&blade);
        let rising = if is_reversed { -value } else { value };
        sum = sum
            + algebra
                .zero()
                .map(|other, zero| if other == blade { rising } else { zero });
    }
    assert_eq!(
        sum,
        algebra.element(&element),
        "the coefficients of {element:?}"
    );
    assert_eq!(element.coefficient_of("not a blade"), None);
}

/// Asserts that assignments and sums of many elements agree with the operators.
///
/// # Panics
/// If they do not.
pub fn check_linear<T>(a: T, b: T, factor: Prime61)
where
    T: Element<Scalar = Prime61> + Debug + PartialEq + Default,
    T: Add<Output = T> + Sub<Output = T> + Mul<Prime61, Output = T> + Div<Prime61, Output = T>,
    T: AddAssign + SubAssign + MulAssign<Prime61> + DivAssign<Prime61>,
    T: Sum + for<'a> Sum<&'a T>,
{
    let assigned = |assign: &dyn Fn(&mut T)| {
        let mut element = a;
        assign(&mut element);
        element
    };
    assert_eq!(assigned(&|x| *x += b), a + b);
    assert_eq!(assigned(&|x| *x -= b), a - b);
    assert_eq!(assigned(&|x| *x *= factor), a * factor);
    assert_eq!(assigned(&|x| *x /= factor), a / factor);
    let many = [a, b, a];
    assert_eq!(many.into_iter().sum::<T>(), a + b + a);
    assert_eq!(many.iter().sum::<T>(), a + b + a);
    assert_eq!(core::iter::empty::<T>().sum::<T>(), T::default());
}

/// Asserts that assignment and products of many elements agree with the operator.
///
/// # Panics
/// If they do not.
pub fn check_product<T>(a: T, b: T)
where
    T: Element<Scalar = Prime61> + Debug + PartialEq + Mul<Output = T> + MulAssign,
    T: Product + for<'a> Product<&'a T>,
{
    let mut product = a;
    product *= b;
    assert_eq!(product, a * b);
    let many = [a, b, a];
    assert_eq!(many.into_iter().product::<T>(), a * b * a);
    assert_eq!(many.iter().product::<T>(), a * b * a);
    let one = core::iter::empty::<T>().product::<T>();
    assert_eq!((one * a, a * one), (a, a));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Ring;

    /// The metric of the Euclidean plane.
    const METRIC: &[&[(i64, i64)]] = &[&[(1, 1), (0, 1)], &[(0, 1), (1, 1)]];

    const BASIS: &[&str] = &["e1", "e2"];

    #[test]
    fn every_case_is_run() {
        let count = core::cell::Cell::new(0);
        for_all_numbers(METRIC, BASIS, &[2, 1], &|algebra, numbers| {
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
        for_all_numbers(METRIC, BASIS, &[1], &|algebra, numbers| {
            let found = algebra.scalar(numbers[0][0]);
            let other = algebra.scalar(numbers[0][0] + Prime61::one());
            assert_same("the sum", &[], &found, &other);
            Some(())
        });
    }
}

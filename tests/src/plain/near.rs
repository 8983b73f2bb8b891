//! Assertions that numbers, vectors and multivectors are close.

use ga_runtime::Element;
use ga_runtime::dense::Multivector;
use ga_runtime::geometry::relation::Tolerance;
use ga_runtime::testing::{algebra_of, to_dense};

use super::{Vector, length, minus};

/// The tolerance of tests: 10⁻⁹, relative and absolute.
pub fn tolerance() -> Tolerance<f64> {
    Tolerance::new(1e-9, 1e-9)
}

/// The largest magnitude of some numbers; NaN if any of them is NaN, unlike by [`f64::max`].
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(0.0, |most: f64, number| {
        let size = number.abs();
        if most.is_nan() || size <= most {
            most
        } else {
            size
        }
    })
}

/// The largest difference between corresponding numbers; NaN if any of them is NaN.
pub fn largest_difference<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    largest(a.into_iter().zip(b).map(|(x, y)| x - y))
}

/// Asserts that corresponding numbers differ by no more than a bound; NaN fails.
#[track_caller]
pub fn near_all<const N: usize>(found: [f64; N], expected: [f64; N], bound: f64) {
    let off = largest_difference(found, expected);
    assert!(off <= bound, "{found:?} is not {expected:?}, by {off}");
}

/// Asserts that two numbers differ by no more than a bound.
#[track_caller]
pub fn near(found: f64, expected: f64, bound: f64) {
    assert!(
        (found - expected).abs() <= bound,
        "{found} is not {expected}, by {}",
        (found - expected).abs()
    );
}

/// Asserts that two vectors lie no further apart than a bound.
#[track_caller]
pub fn near_vector(found: Vector, expected: Vector, bound: f64) {
    let off = length(minus(found, expected));
    assert!(off <= bound, "{found:?} is not {expected:?}, by {off}");
}

/// All coefficients of an element, in the dense reference.
pub fn dense<T: Element<Scalar = f64>>(element: &T) -> Multivector<f64> {
    to_dense(&algebra_of(T::METRIC), element)
}

/// Asserts that two multivectors are equal within a bound relative to the largest coefficient.
#[track_caller]
pub fn near_dense(found: &Multivector<f64>, expected: &Multivector<f64>, bound: f64) {
    let size = |m: &Multivector<f64>| largest(m.coefficients().iter().copied());
    let off = size(&(found - expected));
    assert!(
        off <= bound * size(expected).max(1.0),
        "{found}\nis not {expected}\nby {off}"
    );
}

/// Asserts that one multivector is a positive multiple of another.
#[track_caller]
pub fn positive_multiple(found: &Multivector<f64>, expected: &Multivector<f64>, bound: f64) {
    let norm = |m: &Multivector<f64>| m.coefficients().iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!(
        norm(expected) > 0.0 && norm(found) > 0.0,
        "{found} against {expected}"
    );
    near_dense(
        &found.scale(1.0 / norm(found)),
        &expected.scale(1.0 / norm(expected)),
        bound,
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nan_is_the_largest_wherever_it_stands() {
        assert_eq!(largest([1.0, -3.0, 2.0]), 3.0);
        for numbers in [[f64::NAN, 1.0], [1.0, f64::NAN]] {
            assert!(largest(numbers).is_nan());
            assert!(largest_difference(numbers, [0.0, 1.0]).is_nan());
        }
    }
}

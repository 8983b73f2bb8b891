//! Members of declared types, and tests written from declarations.

use alloc::vec::Vec;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

use super::strategy::prime;
use crate::Element;
use crate::dense::{Algebra, Multivector};
use crate::scalar::{Field, Prime61, Ring};

/// Emits one test for each declared product of an algebra, which demands exact equality with the dense reference
/// over the prime field on random members of the operands' types, and one for the arithmetic of each type.
///
/// The tests come from the declaration, so that a product added there is tested without further word.
///
/// ```
/// ga_runtime::algebra! {
///     mod vga2 {
///         basis e1, e2;
///         signature 2, 0, 0;
///         /// A vector.
///         struct Vector { e1, e2 }
///         /// A bivector.
///         struct Bivector { e12 }
///         products { wedge(Vector, Vector); }
///     }
/// }
/// # mod tests {
/// ga_runtime::testing::product_tests!(super::vga2);
/// # }
/// # fn main() {}
/// ```
#[macro_export]
macro_rules! __product_tests {
    ($($algebra:tt)*) => {
        $($algebra)* ! { [$crate::__private::macros::product_tests] $($algebra)* }
    };
}

/// How many random cases each test tries.
const CASES: u32 = 48;

/// The dense algebra of a metric given as fractions.
///
/// # Panics
/// If the metric is not square and symmetric, which that of a declared algebra always is.
pub fn algebra_of<S: Field>(metric: &[&[(i64, i64)]]) -> Algebra<S> {
    let entry = |&(numerator, denominator): &(i64, i64)| S::from_ratio(numerator, denominator);
    let rows = metric.iter().map(|row| row.iter().map(entry).collect());
    match Algebra::new(rows.collect()) {
        Ok(algebra) => algebra,
        Err(error) => panic!("the metric of a declared algebra is invalid: {error}"),
    }
}

/// All coefficients of an element.
pub fn to_dense<T: Element>(algebra: &Algebra<T::Scalar>, element: &T) -> Multivector<T::Scalar> {
    algebra.zero().map(|blade, _| element.coefficient(blade))
}

/// The dense form of constants given as (blade, numerator, denominator).
pub fn constant_to_dense<S: Field>(
    algebra: &Algebra<S>,
    terms: &[(usize, i64, i64)],
) -> Multivector<S> {
    algebra.zero().map(|blade, zero| {
        terms
            .iter()
            .filter(|(other, ..)| *other == blade)
            .fold(zero, |sum, &(_, n, d)| sum + S::from_ratio(n, d))
    })
}

/// Random members of a declared type, their free numbers drawn from `number`.
///
/// Where any stored coefficients make a member, these are the numbers. Unit versors are products of
/// `(1 + αb)²/(1 − α²b²)` with random α over the 2-blades b of the basis that the type has or that its vectors span;
/// for a type of vectors, that versor acts on a basis vector of square 1. Over floating point, keep `number` within ±0.9.
pub fn member<T, N>(number: N) -> impl Strategy<Value = T> + Clone
where
    T: Element + core::fmt::Debug,
    T::Scalar: Field,
    N: Strategy<Value = T::Scalar> + Clone,
{
    let count = if T::IS_FREE {
        T::BLADES.len()
    } else {
        planes::<T>().len()
    };
    let algebra = algebra_of::<T::Scalar>(T::METRIC);
    vec(number, count).prop_filter_map("a plane with α²b² = 1", move |numbers| {
        if T::IS_FREE {
            let mut numbers = numbers.iter().copied();
            let mut next = |_| numbers.next().unwrap_or_else(T::Scalar::zero);
            return Some(T::from_coefficients_unchecked(&mut next));
        }
        let versor = unit_versor::<T>(&algebra, &numbers)?;
        Some(T::from_coefficients_unchecked(&mut |blade| {
            versor.coefficient(blade)
        }))
    })
}

/// Random members over the prime field.
pub fn exact_member<T: Element<Scalar = Prime61> + core::fmt::Debug>()
-> impl Strategy<Value = T> + Clone {
    member::<T, _>(prime())
}

/// A strategy for the one value of a constant.
pub fn only<T: Clone + core::fmt::Debug>(value: T) -> impl Strategy<Value = T> + Clone {
    Just(value)
}

/// Runs a test on random values, the same in every run. The test panics where it fails, and the values are then
/// shrunk.
///
/// # Panics
/// With the smallest failing values that were found.
pub fn for_all<V: Strategy>(strategy: V, test: impl Fn(V::Value)) {
    let config = Config {
        cases: CASES,
        failure_persistence: None,
        ..Config::default()
    };
    let mut runner = TestRunner::new_with_rng(
        config,
        proptest::test_runner::TestRng::deterministic_rng(
            proptest::test_runner::RngAlgorithm::ChaCha,
        ),
    );
    let outcome = runner.run(&strategy, |values| {
        test(values);
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}

fn planes<T: Element>() -> Vec<usize> {
    let of_grade = |grade: u32| {
        T::BLADES
            .iter()
            .copied()
            .filter(move |b| b.count_ones() == grade)
    };
    let vectors: Vec<_> = of_grade(1).collect();
    let spanned = vectors
        .iter()
        .flat_map(|a| vectors.iter().filter(move |b| *b > a).map(move |b| a | b));
    let mut planes: Vec<_> = of_grade(2).chain(spanned).collect();
    planes.sort_unstable();
    planes.dedup();
    planes
}

fn unit_versor<T: Element>(
    algebra: &Algebra<T::Scalar>,
    numbers: &[T::Scalar],
) -> Option<Multivector<T::Scalar>>
where
    T::Scalar: Field,
{
    let mut versor = algebra.one();
    for (&plane, &alpha) in planes::<T>().iter().zip(numbers) {
        let blade = algebra.blade(plane).ok()?.scale(alpha);
        let root = algebra.one() + &blade;
        let norm = (algebra.one() - blade.geometric(&blade)).coefficient(0);
        if norm == T::Scalar::zero() {
            return None;
        }
        versor = versor.geometric(&root.geometric(&root).scale(norm.recip()));
    }
    if T::BLADES.iter().any(|blade| blade.count_ones() != 1) {
        return Some(versor);
    }
    let is_unit = |blade: &&usize| {
        let vector = algebra.blade(**blade).ok();
        vector.is_some_and(|v| v.geometric(&v) == algebra.one())
    };
    let unit = T::BLADES.iter().find(is_unit)?;
    Some(versor.sandwich(&algebra.blade(*unit).ok()?))
}

//! Strategies for proptest: scalars, and multivectors of any algebra.
//!
//! A strategy for multivectors takes the strategy of their coefficients, so that the same test runs
//! over [`prime`] exactly and over [`float`] up to rounding.

use alloc::vec::Vec;

use proptest::collection::vec;
use proptest::prelude::*;

use crate::dense::{Algebra, Multivector};
use crate::scalar::{Prime61, Ring};

/// Any element of the prime field. Most are drawn uniformly from the whole field, the others are
/// small integers of either sign, including zero and one.
pub fn prime() -> impl Strategy<Value = Prime61> + Clone {
    prop_oneof![
        7 => (0..Prime61::MODULUS).prop_map(Prime61::new),
        1 => (-3_i64..=3).prop_map(Prime61::from),
    ]
}

/// Any element of the prime field except zero.
pub fn nonzero_prime() -> impl Strategy<Value = Prime61> + Clone {
    prop_oneof![
        7 => (1..Prime61::MODULUS).prop_map(Prime61::new),
        1 => (1_i64..=3).prop_map(Prime61::from),
        1 => (-3_i64..=-1).prop_map(Prime61::from),
    ]
}

/// A number from −`magnitude` to `magnitude`. One in eight is exactly zero, −`magnitude` or
/// `magnitude`.
pub fn float(magnitude: f64) -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        7 => -magnitude..=magnitude,
        1 => prop::sample::select(&[0.0, -1.0, 1.0]).prop_map(move |factor| factor * magnitude),
    ]
}

/// A multivector with every coefficient from the given strategy.
pub fn multivector<S: Ring, C: Strategy<Value = S> + Clone>(
    algebra: &Algebra<S>,
    coefficient: C,
) -> impl Strategy<Value = Multivector<S>> + Clone + use<S, C> {
    let algebra = algebra.clone();
    vec(coefficient, algebra.size())
        .prop_map(move |coefficients| with_coefficients(&algebra, |blade| coefficients[blade]))
}

/// A multivector of one grade.
pub fn of_grade<S: Ring, C: Strategy<Value = S> + Clone>(
    algebra: &Algebra<S>,
    grade: usize,
    coefficient: C,
) -> impl Strategy<Value = Multivector<S>> + Clone + use<S, C> {
    multivector(algebra, coefficient).prop_map(move |multivector| multivector.grade(grade))
}

/// A vector.
pub fn vector<S: Ring, C: Strategy<Value = S> + Clone>(
    algebra: &Algebra<S>,
    component: C,
) -> impl Strategy<Value = Multivector<S>> + Clone + use<S, C> {
    let algebra = algebra.clone();
    vec(component, algebra.dimension()).prop_map(move |components| {
        with_coefficients(&algebra, |blade| match blade.is_power_of_two() {
            true => components[blade.trailing_zeros() as usize],
            false => S::zero(),
        })
    })
}

/// The geometric product of `factors` vectors. They may be null, so that the product need not have
/// an inverse.
pub fn versor<S: Ring, C: Strategy<Value = S> + Clone>(
    algebra: &Algebra<S>,
    factors: usize,
    component: C,
) -> impl Strategy<Value = Multivector<S>> + Clone + use<S, C> {
    let one = algebra.one();
    vec(vector(algebra, component), factors).prop_map(move |vectors| {
        vectors
            .iter()
            .fold(one.clone(), |product, vector| product * vector)
    })
}

/// A symmetric matrix with entries from the given strategy: the metric of an algebra.
pub fn metric<S: Ring, C: Strategy<Value = S> + Clone>(
    dimension: usize,
    entry: C,
) -> impl Strategy<Value = Vec<Vec<S>>> + Clone {
    vec(vec(entry, dimension), dimension).prop_map(|matrix| {
        let rows = 0..matrix.len();
        let mirrored = |row: usize, column: usize| matrix[row.max(column)][row.min(column)];
        rows.clone()
            .map(|row| rows.clone().map(|column| mirrored(row, column)).collect())
            .collect()
    })
}

fn with_coefficients<S: Ring>(
    algebra: &Algebra<S>,
    coefficient: impl Fn(usize) -> S,
) -> Multivector<S> {
    algebra.zero().map(|blade, _| coefficient(blade))
}

//! Benchmarks of an algebra's products, for criterion.
//!
//! This module does not depend on criterion: only the macro names it, in the crate that uses the
//! macro.

use alloc::vec::Vec;
use core::fmt::Debug;
use core::hint::black_box;

use proptest::prelude::*;

use super::{member, strategy};
use crate::Element;
use crate::scalar::Real;

/// Registers a criterion group that times an operation on random members of the operands' types,
/// and rivals on the same inputs.
///
/// The crate that uses it depends on criterion itself, in any version that has `BenchmarkGroup`.
///
/// ```no_run
/// use criterion::{Criterion, criterion_group, criterion_main};
/// use ga_runtime::testing::bench_product;
///
/// ga_runtime::algebra! {
///     /// The plane.
///     mod vga2 {
///         basis e1, e2;
///         signature 2, 0, 0;
///         /// A vector.
///         struct Vector { e1, e2 }
///         /// A complex number.
///         struct Complex { scalar, e12 }
///         products { geometric(Vector, Vector) -> Complex; }
///     }
/// }
/// use vga2::Vector;
///
/// fn products(criterion: &mut Criterion) {
///     bench_product!(criterion, "vector * vector", |a: Vector<f64>, b: Vector<f64>| a * b);
///     bench_product!(
///         criterion,
///         "vector * vector, compared",
///         seed = 7,
///         |a: Vector<f64>, b: Vector<f64>| a * b,
///         rival "by hand" => (a.e1 * b.e1 + a.e2 * b.e2, a.e1 * b.e2 - a.e2 * b.e1),
///         rival "arrays" with v = [a.e1, a.e2], w = [b.e1, b.e2]
///             => [v[0] * w[0] + v[1] * w[1], v[0] * w[1] - v[1] * w[0]],
///     );
/// }
/// criterion_group!(benches, products);
/// criterion_main!(benches);
/// ```
///
/// # Grammar
///
/// `bench_product!(criterion, name, seed = number, |a: A, b: B, …| operation, rival name =>
/// operation, …)`
///
/// - `criterion` is the `&mut Criterion`, `name` that of the group. The operation appears in it as
///   `product`.
/// - Operands are members of declared types over a [`Real`] scalar, passed by value and drawn by
///   [`member`] with numbers up to 0.9. `a: A = (strategy)` draws from another strategy, and then A
///   may be any type that is `Copy`, such as `f64` for the t of an interpolation.
/// - The seed, 1 by default, determines which members are drawn: 1,024 of each, the same in every
///   run.
/// - A `rival` is timed in the same group on the same operands. The values after `with` are
///   computed once for each input, before the timing starts, and passed to its operation by
///   reference. This is the place for conversions to another library's types.
/// - `criterion = path;` at the start gives the path of criterion, if it is not `::criterion`.
///
/// # What is timed
///
/// One iteration passes once over all inputs and writes all results to a list. Inputs and results
/// are opaque to the compiler as lists, so that no computation is removed or done beforehand, and
/// yet a loop may be vectorised as it would be in a program. The group's throughput is in elements:
/// the time of one operation is the reported time divided by 1,024.
#[doc(hidden)]
#[macro_export]
macro_rules! __bench_product {
    (criterion = $($path:ident)::+ ; $($rest:tt)+) => {
        $crate::__bench_product!(@ [$($path)::+] $($rest)+)
    };
    (@ strategy $type:ty) => { $crate::testing::operand::<$type>() };
    (@ strategy $type:ty, $strategy:expr) => { $strategy };
    (
        @ [$($path:tt)+]
        $criterion:expr,
        $name:expr,
        $(seed = $seed:expr,)?
        |$($operand:ident : $type:ty $(= ($strategy:expr))?),+ $(,)?| $operation:expr
        $(, rival $rival:literal $(with $($prepared:ident = $preparation:expr),+)? => $rival_operation:expr)*
        $(,)?
    ) => {{
        #[allow(unused_mut, unused_assignments)]
        let mut seed: u64 = 1;
        $(seed = $seed;)?
        let strategies = ($($crate::__bench_product!(@ strategy $type $(, $strategy)?),)+);
        let operands: ::std::vec::Vec<($($type,)+)> =
            $crate::testing::sample(&strategies, $crate::testing::OPERANDS, seed);
        let mut group = $criterion.benchmark_group($name);
        group.throughput($($path)+::Throughput::Elements(operands.len() as u64));
        let mut pass = $crate::testing::pass(&operands, |&($($operand,)+)| $operation);
        group.bench_function("product", |bencher| bencher.iter(&mut pass));
        $crate::__bench_product!(
            @ rivals group, operands, ($($operand,)+),
            $([$rival, [$($($prepared = $preparation),+)?], $rival_operation])*
        );
        group.finish();
    }};
    (@ rivals $group:ident, $operands:ident, $pattern:tt, $([$rival:literal, $preparations:tt, $operation:expr])*) => {
        $($crate::__bench_product!(@ rival $group, $rival, $operands, $pattern, $preparations, $operation);)*
    };
    (@ rival $group:ident, $rival:literal, $operands:ident, $pattern:tt, [], $operation:expr) => {
        #[allow(unused_variables)]
        let mut pass = $crate::testing::pass(&$operands, |&$pattern| $operation);
        $group.bench_function($rival, |bencher| bencher.iter(&mut pass));
    };
    (
        @ rival $group:ident, $rival:literal, $operands:ident, $pattern:tt,
        [$($prepared:ident = $preparation:expr),+], $operation:expr
    ) => {
        #[allow(unused_variables)]
        let prepared: ::std::vec::Vec<_> =
            $operands.iter().map(|&$pattern| ($($preparation,)+)).collect();
        let mut pass = $crate::testing::pass(&prepared, |($($prepared,)+)| $operation);
        $group.bench_function($rival, |bencher| bencher.iter(&mut pass));
    };
    (@ $($rest:tt)*) => {
        ::core::compile_error!(
            "expected `bench_product!(criterion, name, seed = number, |a: A, b: B| operation, rival \"name\" => operation)`"
        )
    };
    ($($rest:tt)+) => {
        $crate::__bench_product!(@ [::criterion] $($rest)+)
    };
}

/// The number of operands of each type in a benchmark: enough that none is a constant, few enough
/// for the first-level cache.
#[doc(hidden)]
pub const OPERANDS: usize = 1024;

/// The default strategy for an operand of a benchmark.
#[doc(hidden)]
pub fn operand<T>() -> impl Strategy<Value = T> + Clone
where
    T: Element + Debug,
    T::Scalar: Real,
{
    member(strategy::float(0.9).prop_map(<T::Scalar as Real>::from_f64))
}

/// The routine to time: one pass over all operands, results written to a list.
#[doc(hidden)]
pub fn pass<A, R>(operands: &[A], operation: impl Fn(&A) -> R) -> impl FnMut() {
    let mut results: Vec<R> = operands.iter().map(&operation).collect();
    move || {
        let operands = black_box(operands);
        let results = black_box(results.as_mut_slice());
        for (result, operand) in results.iter_mut().zip(operands) {
            *result = operation(operand);
        }
    }
}

//! One benchmark group: an operation, and the contenders that perform it.

use std::hint::black_box;
use std::time::Duration;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput};

use crate::inputs::INPUTS;

/// Criterion with short runs. `run.sh` repeats whole passes instead, so that a slow moment of the
/// machine affects all contenders alike.
#[must_use]
pub fn criterion() -> Criterion {
    Criterion::default()
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_millis(250))
        .sample_size(20)
        .nresamples(1000)
        .without_plots()
}

/// A benchmark group whose members do the same work on the same inputs.
pub struct Comparison<'a> {
    group: BenchmarkGroup<'a, WallTime>,
}

impl<'a> Comparison<'a> {
    /// A group named `family/operation-type`.
    pub fn new(criterion: &'a mut Criterion, name: &str) -> Self {
        let mut group = criterion.benchmark_group(name);
        group.throughput(Throughput::Elements(INPUTS as u64));
        Self { group }
    }

    /// Times an operation over a list of inputs, with the results written to a list. This is a loop
    /// as users write it, which the compiler may reorder and vectorise.
    pub fn map<A, R>(&mut self, contender: &str, inputs: &[A], operation: impl Fn(&A) -> R) {
        let mut results: Vec<R> = inputs.iter().map(&operation).collect();
        self.group.bench_function(contender, |bencher| {
            bencher.iter(|| {
                let inputs = black_box(inputs);
                let results = black_box(results.as_mut_slice());
                for (result, a) in results.iter_mut().zip(inputs) {
                    *result = operation(a);
                }
            });
        });
    }

    /// Like [`Comparison::map`], over two lists of operands.
    pub fn zip<A, B, R>(
        &mut self,
        contender: &str,
        left: &[A],
        right: &[B],
        operation: impl Fn(&A, &B) -> R,
    ) {
        let mut results: Vec<R> = left
            .iter()
            .zip(right)
            .map(|(a, b)| operation(a, b))
            .collect();
        self.group.bench_function(contender, |bencher| {
            bencher.iter(|| {
                let (left, right) = (black_box(left), black_box(right));
                let results = black_box(results.as_mut_slice());
                for ((result, a), b) in results.iter_mut().zip(left).zip(right) {
                    *result = operation(a, b);
                }
            });
        });
    }

    /// Times an operation that itself takes a list of inputs and fills a list of results.
    pub fn whole<A, R: Clone>(
        &mut self,
        contender: &str,
        inputs: &[A],
        results: &[R],
        operation: impl Fn(&[A], &mut [R]),
    ) {
        let mut results = results.to_vec();
        self.group.bench_function(contender, |bencher| {
            bencher.iter(|| operation(black_box(inputs), black_box(results.as_mut_slice())));
        });
    }

    /// Times an operation that takes a whole list and has one result.
    pub fn once<A, R>(&mut self, contender: &str, inputs: &[A], operation: impl Fn(&[A]) -> R) {
        self.group
            .throughput(Throughput::Elements(inputs.len() as u64));
        self.group.bench_function(contender, |bencher| {
            bencher.iter(|| black_box(operation(black_box(inputs))));
        });
    }

    /// Times an operation with each operand and result opaque to the compiler, so that each call is
    /// performed on its own.
    pub fn one_by_one<A, B, R>(
        &mut self,
        contender: &str,
        left: &[A],
        right: &[B],
        operation: impl Fn(&A, &B) -> R,
    ) {
        self.group.bench_function(contender, |bencher| {
            bencher.iter(|| {
                for (a, b) in left.iter().zip(right) {
                    black_box(operation(black_box(a), black_box(b)));
                }
            });
        });
    }
}

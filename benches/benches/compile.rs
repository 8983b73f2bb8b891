//! The optimised compiler itself; `build-time.sh` measures the time that users wait for.

use criterion::{Criterion, criterion_group, criterion_main};
use nullcone_benches::{comparison, declaration};
use proc_macro2::TokenStream;
use quote::quote;

fn functions() -> [(&'static str, TokenStream); 5] {
    [
        (
            "motor-point",
            quote! { (m: Motor, p: Point) -> Point { m * p * reverse(m) } },
        ),
        (
            "motor-circle",
            quote! { (m: Motor, c: Circle) -> Circle { m * c * reverse(m) } },
        ),
        (
            "motor-motor",
            quote! { (m: Motor, n: Motor) -> Motor { m * n } },
        ),
        (
            "four-points",
            quote! { (p: Point, q: Point, r: Point, s: Point) -> Sphere { p ^ q ^ r ^ s } },
        ),
        (
            "line-sphere",
            quote! { (l: Line, s: Sphere) -> PointPair { l & s } },
        ),
    ]
}

fn compile(criterion: &mut Criterion) {
    let Some(cga3) = declaration::cga3() else {
        return;
    };
    let mut group = criterion.benchmark_group("compile/function");
    for (name, function) in functions() {
        let compiled = ga_compiler::compile_function(cga3.clone(), function.clone());
        assert!(compiled.is_ok(), "{name} does not compile");
        group.bench_function(name, |bencher| {
            bencher.iter(|| ga_compiler::compile_function(cga3.clone(), function.clone()).is_ok());
        });
    }
    group.finish();

    let mut group = criterion.benchmark_group("compile/algebra");
    group.sample_size(10);
    let placed = quote! { [ga_runtime] #cga3 };
    group.bench_function("cga3", |bencher| {
        bencher.iter(|| ga_compiler::expand_algebra(placed.clone()).is_empty());
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = compile
}
criterion_main!(benches);

//! A whole program: the picture of the example `ray_tracer`, 192 × 108 pixels, one thread.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nullcone_benches::comparison;
use nullcone_benches::scene;

fn ray_trace(criterion: &mut Criterion) {
    let size = [192, 108];
    let mut group = criterion.benchmark_group("scene/ray-trace");
    group.throughput(Throughput::Elements((size[0] * size[1]) as u64));
    for contender in scene::contenders().unwrap_or_default() {
        group.bench_function(contender.name, |bencher| {
            bencher.iter(|| (contender.render)(black_box(size)));
        });
    }
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = ray_trace
}
criterion_main!(benches);

//! Measures of two pictures of 1,920 × 1,080 pixels. A copy of the frame, in the same run, is the
//! unit.

use std::hint::black_box;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use ga_image::plane::Plane;
use ga_image::quality::{MutualInformation, Ssim};
use ga_video::attention::Attention;
use nullcone_benches::comparison;

const WIDTH: usize = 1920;
const HEIGHT: usize = 1080;

/// A smooth picture with a texture, and the same with noise.
fn frames() -> [Plane<u8>; 2] {
    let mut state = 1u32;
    let mut noise = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 27) as f64
    };
    let a = Plane::from_fn(WIDTH, HEIGHT, |column, row| {
        let (x, y) = (column as f64 / 90.0, row as f64 / 70.0);
        (120.0 + 60.0 * x.sin() * y.cos() + 20.0 * (9.0 * x).sin() * (11.0 * y).sin()) as u8
    });
    let b = a.map(|v| (f64::from(v) + noise() - 16.0) as u8);
    [a, b]
}

fn copying(group: &mut BenchmarkGroup<'_, WallTime>, frame: &Plane<u8>) {
    let mut copy = frame.clone();
    group.bench_function("copy", |bench| {
        bench.iter(|| copy.values_mut().copy_from_slice(black_box(frame).values()));
    });
}

fn information(criterion: &mut Criterion) {
    let [a, b] = frames();
    let mut group = criterion.benchmark_group("quality/mutual-information-1080p");
    let mut information = MutualInformation::new();
    group.bench_function("nullcone, noise", |bench| {
        bench.iter(|| information.compare(black_box(&a), &b))
    });
    group.bench_function("nullcone, equal", |bench| {
        bench.iter(|| information.compare(black_box(&a), &a))
    });
    copying(&mut group, &a);
    group.finish();
}

fn similarity(criterion: &mut Criterion) {
    let [a, b] = frames();
    let ssim = Ssim::new(255.0);
    let mut group = criterion.benchmark_group("quality/ssim-1080p");
    group.bench_function("nullcone", |bench| {
        bench.iter(|| ssim.compare(black_box(&a), &b))
    });
    group.bench_function("nullcone, five scales", |bench| {
        bench.iter(|| ssim.multiscale(black_box(&a), &b))
    });
    copying(&mut group, &a);
    group.finish();
}

/// The map of attention of each frame, from contours and motion, and SSIM weighted by it.
fn attention(criterion: &mut Criterion) {
    let [a, b] = frames();
    // The frame after: the camera has moved by 6 columns and 2 rows.
    let next = Plane::from_fn(WIDTH, HEIGHT, |column, row| {
        a.row((row + 2).min(HEIGHT - 1))[(column + 6).min(WIDTH - 1)]
    });
    let ssim = Ssim::new(255.0);
    let mut attention = Attention::new([WIDTH, HEIGHT]).expect("the frame has pixels");
    let mut group = criterion.benchmark_group("quality/attention-1080p");
    let mut frames = [&a, &next].into_iter().cycle();
    group.bench_function("nullcone, map", |bench| {
        bench.iter(|| {
            let frame = frames.next().unwrap_or(&a);
            attention
                .next(black_box(frame))
                .map(|weights| weights.plane().get(0, 0))
        });
    });
    group.bench_function("nullcone, map and weighted SSIM", |bench| {
        bench.iter(|| {
            let frame = frames.next().unwrap_or(&a);
            let weights = attention.next(black_box(frame))?;
            ssim.compare_weighted(frame, &b, weights)
        });
    });
    copying(&mut group, &a);
    group.finish();
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = information, similarity, attention
}
criterion_main!(benches);

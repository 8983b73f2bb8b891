//! Pictures of 1,920 × 1,080 pixels: quality, blur, halving, edges. A copy of the frame, in the
//! same run, is the unit.
//!
//! The rival's structural similarity is that of blocks of 8 × 8 pixels beside each other, which is
//! less work than a window around each pixel.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use ga_image::canny::Canny;
use ga_image::filter::{Border, Gaussian, Gradient};
use ga_image::plane::Plane;
use ga_image::pyramid::halved;
use ga_image::quality::{Ssim, psnr};
use ga_image::threshold::otsu;
use image::GrayImage;
use image_compare::Algorithm;
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

fn rival(plane: &Plane<u8>) -> GrayImage {
    GrayImage::from_raw(WIDTH as u32, HEIGHT as u32, plane.values().to_vec())
        .expect("the frame has its size")
}

fn quality(criterion: &mut Criterion) {
    let [a, b] = frames();
    let [image_a, image_b] = [&a, &b].map(rival);
    let mut copy = a.clone();

    let mut group = criterion.benchmark_group("image/ssim-1080p");
    let ssim = Ssim::new(255.0);
    group.bench_function("nullcone", |bench| {
        bench.iter(|| ssim.compare(black_box(&a), &b))
    });
    group.bench_function("image-compare, blocks", |bench| {
        bench.iter(|| {
            image_compare::gray_similarity_structure(
                &Algorithm::MSSIMSimple,
                black_box(&image_a),
                &image_b,
            )
        });
    });
    group.bench_function("copy", |bench| {
        bench.iter(|| copy.values_mut().copy_from_slice(black_box(&a).values()));
    });
    group.finish();

    let mut group = criterion.benchmark_group("image/psnr-1080p");
    group.bench_function("nullcone", |bench| {
        bench.iter(|| psnr(black_box(&a), &b, 255.0))
    });
    group.bench_function("image-compare, root mean square", |bench| {
        bench.iter(|| {
            image_compare::gray_similarity_structure(
                &Algorithm::RootMeanSquared,
                black_box(&image_a),
                &image_b,
            )
        });
    });
    group.bench_function("copy", |bench| {
        bench.iter(|| copy.values_mut().copy_from_slice(black_box(&a).values()));
    });
    group.finish();
}

fn filters(criterion: &mut Criterion) {
    let [a, _] = frames();
    let image = rival(&a);
    let floats = a.map(f32::from);

    let mut group = criterion.benchmark_group("image/gaussian-1080p");
    let gaussian = Gaussian::new(1.5).expect("σ is positive");
    group.bench_function("nullcone u8", |bench| {
        bench.iter(|| gaussian.blur(black_box(&a), Border::Reflect));
    });
    group.bench_function("nullcone f32", |bench| {
        bench.iter(|| gaussian.blur(black_box(&floats), Border::Reflect));
    });
    group.bench_function("image u8", |bench| {
        bench.iter(|| image::imageops::blur(black_box(&image), 1.5));
    });
    group.bench_function("copy u8", |bench| bench.iter(|| black_box(&a).clone()));
    group.finish();

    let mut group = criterion.benchmark_group("image/halved-1080p");
    group.bench_function("nullcone u8", |bench| bench.iter(|| halved(black_box(&a))));
    group.bench_function("nullcone f32", |bench| {
        bench.iter(|| halved(black_box(&floats)))
    });
    group.bench_function("copy u8", |bench| bench.iter(|| black_box(&a).clone()));
    group.finish();
}

fn edges(criterion: &mut Criterion) {
    let [smooth, noisy] = frames();
    let mut copy = noisy.clone();
    let [mut dx, mut dy] = [(); 2].map(|()| Plane::filled(WIDTH, HEIGHT, 0));

    let mut group = criterion.benchmark_group("sobel/1080p");
    group.bench_function("nullcone dx", |bench| {
        bench.iter(|| Gradient::Sobel.horizontal_into(black_box(&noisy), Border::Mirror, &mut dx));
    });
    group.bench_function("nullcone dx and dy", |bench| {
        bench.iter(|| Gradient::Sobel.of_into(black_box(&noisy), Border::Mirror, &mut dx, &mut dy));
    });
    group.bench_function("copy", |bench| {
        bench.iter(|| {
            copy.values_mut()
                .copy_from_slice(black_box(&noisy).values())
        });
    });
    group.finish();

    let mut group = criterion.benchmark_group("otsu/1080p");
    for (name, frame) in [("nullcone, smooth", &smooth), ("nullcone, noise", &noisy)] {
        group.bench_function(name, |bench| bench.iter(|| otsu(black_box(frame))));
    }
    group.bench_function("copy", |bench| {
        bench.iter(|| {
            copy.values_mut()
                .copy_from_slice(black_box(&noisy).values())
        });
    });
    group.finish();

    // The lower thresholds find edges at a third of the pixels.
    let mut group = criterion.benchmark_group("canny/1080p");
    for (name, [low, high]) in [
        ("nullcone, few edges", [80.0, 160.0]),
        ("nullcone, many edges", [20.0, 60.0]),
    ] {
        let mut canny = Canny::new(low, high).expect("the thresholds are in order");
        group.bench_function(name, |bench| {
            bench.iter(|| canny.edges_into(black_box(&noisy), &mut copy));
        });
    }
    group.bench_function("copy", |bench| {
        bench.iter(|| {
            copy.values_mut()
                .copy_from_slice(black_box(&noisy).values())
        });
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = quality, filters, edges
}
criterion_main!(benches);

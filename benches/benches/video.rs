//! Key frames of video: signatures, mutual information, and all of the analysis, for each frame of
//! 1,920 × 1,080 and of 1,280 × 720 pixels. A copy of the luma, in the same run, is the unit.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use ga_image::plane::Plane;
use ga_image::quality::MutualInformation;
use ga_image::ycbcr::YCbCr;
use ga_video::keyframe::{Analyser, Options, signature};
use ga_video::{Frame, Planes, Samples};
use nullcone_benches::comparison;

/// Frames of a texture under a slowly moving camera, with noise.
fn frames([width, height]: [usize; 2], count: usize) -> Vec<Samples> {
    let mut state = 1u32;
    let mut noise = move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 29)
    };
    let mut plane = |width: usize, height: usize, time: usize| {
        Plane::from_fn(width, height, |column, row| {
            let (x, y) = ((column + 2 * time) as f64 / 90.0, row as f64 / 70.0);
            let value =
                120.0 + 60.0 * x.sin() * y.cos() + 20.0 * (9.0 * x).sin() * (11.0 * y).sin();
            (value + noise()) as u8
        })
    };
    let frame = |time| {
        Samples::Eight(Planes {
            luma: plane(width, height, time),
            differences: [0, 1].map(|_| plane(width / 2, height / 2, time)),
        })
    };
    (0..count).map(frame).collect()
}

fn keyframes(criterion: &mut Criterion) {
    for size in [[1920, 1080], [1280, 720]] {
        let mut group = criterion.benchmark_group(format!("video/keyframes-{}p", size[1]));
        let samples = frames(size, 8);
        let lumas: Vec<Plane<u8>> = samples
            .iter()
            .map(|s| s.eight_bits().luma.clone())
            .collect();
        let mut copy = lumas[0].clone();
        group.throughput(Throughput::Elements(1));
        group.bench_function("copy of the luma", |bench| {
            bench.iter(|| {
                copy.values_mut()
                    .copy_from_slice(black_box(&lumas[1]).values())
            });
        });
        group.bench_function("signature of red", |bench| {
            bench.iter(|| signature::red(black_box(&samples[0]), YCbCr::default()));
        });
        let mut information = MutualInformation::new();
        group.bench_function("mutual information", |bench| {
            bench.iter(|| information.compare(black_box(&lumas[0]), &lumas[1]));
        });
        // Back and forth over the frames, so that there is no cut.
        let mut frame = Frame::default();
        let mut frames: Vec<Frame> = samples
            .into_iter()
            .map(|samples| Frame {
                samples,
                ..Frame::default()
            })
            .collect();
        let mut analyser = Analyser::new(Options::default(), YCbCr::default());
        let mut index = 0;
        group.bench_function("nullcone, all of the analysis", |bench| {
            bench.iter(|| {
                let place = [0, 1, 2, 3, 4, 5, 6, 7, 6, 5, 4, 3, 2, 1][index % 14];
                std::mem::swap(&mut frame, &mut frames[place]);
                frame.time_seconds = index as f64 / 25.0;
                let candidate = analyser.push(black_box(&frame));
                std::mem::swap(&mut frame, &mut frames[place]);
                index += 1;
                candidate
            });
        });
        group.finish();
    }
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = keyframes
}
criterion_main!(benches);

//! Comfort of stereoscopic video: all measures of one frame of 1,920 × 1,080 pixels an eye, on one
//! thread. The matcher of features for any two views and a copy of the luma, in the same run, are
//! what it compares with: no other library measures stereoscopic frames.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use ga_image::plane::Plane;
use ga_image::ycbcr::YCbCr;
use ga_vision::comfort::FrameMeter;
use ga_vision::feature::{ViewOptions, match_views};
use ga_vision::video::{Planes, Samples};
use nullcone_benches::comparison;

const SIZE: [usize; 2] = [1920, 1080];

/// A number from 0 to 1 for a point of a lattice.
fn lattice(x: i64, y: i64) -> f64 {
    let mixed = (x.wrapping_mul(0x9e37_79b9) ^ y.wrapping_mul(0x85eb_ca6b)) as u64;
    let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(0x2545_f491_4f6c_dd1d);
    (mixed >> 40) as f64 / (1u64 << 24) as f64
}

/// A texture of patches of several sizes.
fn texture(x: f64, y: f64) -> f64 {
    let patches = [(5.0, 25.0), (17.0, 45.0), (60.0, 60.0), (230.0, 70.0)];
    patches.into_iter().fold(20.0, |sum, (side, height)| {
        let [x, y] = [x / side, y / side];
        let [column, row] = [x.floor(), y.floor()];
        let [s, t] = [x - column, y - row].map(|t| t * t * (3.0 - 2.0 * t));
        let at = |i: i64, j: i64| lattice(column as i64 + i, row as i64 + j);
        let [above, below] = [0, 1].map(|j| at(0, j) + s * (at(1, j) - at(0, j)));
        sum + height * (above + t * (below - above))
    })
}

/// A view of the texture on a slanted plane, with parallax from 10 to 50 pixels.
fn view(side: f64) -> Samples {
    let [width, height] = SIZE;
    let plane = |width: usize, height: usize, scale: f64| {
        Plane::from_fn(width, height, |column, row| {
            let [x, y] = [column, row].map(|x| scale * x as f64);
            texture(x + side * (10.0 + 40.0 * y / SIZE[1] as f64), y) as u8
        })
    };
    Samples::Eight(Planes {
        luma: plane(width, height, 1.0),
        differences: [0, 1].map(|_| plane(width / 2, height / 2, 2.0)),
    })
}

fn frames(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("comfort/frame-1080p");
    group.throughput(Throughput::Elements(1));
    let views = [0.0, 1.0].map(view);
    let lumas = views.each_ref().map(|view| view.eight_bits().luma.clone());
    let mut copy = lumas[0].clone();
    group.bench_function("copy of the luma", |bench| {
        bench.iter(|| {
            copy.values_mut()
                .copy_from_slice(black_box(&lumas[1]).values())
        });
    });
    let mut meter = FrameMeter::new(SIZE, YCbCr::default());
    group.bench_function("all measures", |bench| {
        bench.iter(|| {
            let found = meter.measure(black_box(&views[0]), &views[1]);
            found.map(|measures| measures.matches.len())
        });
    });
    group.sample_size(10);
    group.bench_function("match_views", |bench| {
        bench.iter(|| match_views(black_box(&lumas[0]), &lumas[1], &ViewOptions::default()));
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = frames
}
criterion_main!(benches);

//! Comfort of stereoscopic video of 1,920 × 1,080 pixels an eye, held in memory.
//!
//! `comfort/shot-1080p` analyses a shot of 4 seconds, all rows of all frames, on two threads and on
//! one; the order of the eyes is examined once. `comfort/frame-1080p` has its parts on one thread:
//! the measures of a frame, the delay at a frame, and the order of the eyes, which is needed once
//! a shot. The matcher of features for any two views and a copy of the luma, in the same run, are
//! what the measures compare with: no other library measures stereoscopic frames.

use std::hint::black_box;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use ga_image::plane::Plane;
use ga_image::y4m::Sampling;
use ga_image::ycbcr::YCbCr;
use ga_video::comfort::asynchrony::AsynchronyMeter;
use ga_video::comfort::monitor::{Monitor, Options};
use ga_video::comfort::stereoscopy::{Alignment, Stereoscopy, StereoscopyMeter};
use ga_video::comfort::{FrameMeter, Viewing};
use ga_video::{Frame, Planes, Properties, Samples};
use ga_vision::feature::{ViewOptions, match_views};
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

/// The number of frames in memory, after which the motion repeats.
const FRAMES: usize = 24;

/// The frames of a shot.
const SHOT: usize = 96;

/// Both views of each frame: a slanted background with parallax from 10 to 50 pixels, and squares
/// before it, which move.
fn film() -> Vec<[Frame; 2]> {
    const WORLD: [usize; 2] = [SIZE[0] + 160, SIZE[1] + 80];
    let world = Plane::from_fn(WORLD[0], WORLD[1], |column, row| {
        texture(column as f64, row as f64) as u8
    });
    let view = |frame: usize, eye: usize| {
        let angle = frame as f64 / FRAMES as f64 * std::f64::consts::TAU;
        let moved = [
            (30.0 + 24.0 * angle.sin()) as usize,
            (30.0 + 15.0 * angle.cos() + 8.0 * (2.0 * angle).sin()) as usize,
        ];
        let plane = |scale: usize| {
            let [width, height] = SIZE.map(|side| side / scale);
            Plane::from_fn(width, height, |column, row| {
                let [x, y] = [scale * column, scale * row];
                let near = x + eye * 30;
                let is_near = (near + 2 * moved[0]) % 480 < 220 && (y + moved[1]) % 360 < 170;
                match is_near {
                    true => 255 - world.row(y)[near],
                    false => {
                        let far = 60 - eye * (10 + 40 * y / SIZE[1]);
                        world.row(y + moved[1])[x + moved[0] + far]
                    }
                }
            })
        };
        Frame {
            index: frame,
            time_seconds: frame as f64 / 24.0,
            samples: Samples::Eight(Planes {
                luma: plane(1),
                differences: [plane(2), plane(2)],
            }),
        }
    };
    (0..FRAMES)
        .map(|frame| [view(frame, 0), view(frame, 1)])
        .collect()
}

fn shots(criterion: &mut Criterion) {
    let film = film();
    let properties = Properties {
        size: SIZE,
        sampling: Sampling::default(),
        bit_depth: 8,
        colours: YCbCr::default(),
        pixel_aspect: [1, 1],
        frames_per_second: Some([24, 1]),
        frame_count: None,
    };
    let mut group = criterion.benchmark_group("comfort/shot-1080p");
    group.throughput(Throughput::Elements(SHOT as u64));
    group.sample_size(10);
    for (name, threads) in [("two threads", 2), ("one thread", 1)] {
        let options = Options {
            viewing: Viewing::default(),
            layout: None,
            threads,
        };
        group.bench_function(name, |bench| {
            bench.iter_batched(
                || Monitor::new(&properties, options),
                |monitor| {
                    let mut monitor = monitor?;
                    let mut known = 0;
                    let mut count = |stereoscopy| {
                        known += usize::from(stereoscopy != Stereoscopy::Unknown);
                    };
                    for _ in 0..SHOT / FRAMES {
                        monitor.push(black_box(&film), &mut |record| count(record.stereoscopy))?;
                    }
                    monitor.finish(&mut |record| count(record.stereoscopy));
                    // Otherwise the order of the eyes was examined more than once.
                    assert_eq!(known, SHOT, "frames with a known order of the eyes");
                    Ok::<_, ga_video::comfort::ComfortError>(known)
                },
                BatchSize::PerIteration,
            );
        });
    }
    group.finish();
}

fn frames(criterion: &mut Criterion) {
    let film = film();
    let views = film[0].each_ref().map(|view| &view.samples);
    let mut group = criterion.benchmark_group("comfort/frame-1080p");
    group.throughput(Throughput::Elements(1));
    let lumas = views.map(|view| view.eight_bits().luma.clone());
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
            let found = meter.measure(black_box(views[0]), views[1]);
            found.map(|measures| measures.matches.len())
        });
    });
    let mut asynchrony = AsynchronyMeter::default();
    let mut next = film.iter().cycle();
    group.bench_function("delay", |bench| {
        bench.iter(|| {
            let [left, right] = next.next()?;
            asynchrony.push(&left.samples, &right.samples)
        });
    });
    group.sample_size(10);
    group.bench_function("order of the eyes", |bench| {
        bench.iter(|| {
            let mut order = StereoscopyMeter::default();
            let added = order.add(black_box(views[0]), views[1], &Alignment::default());
            added.map(|()| order.verdict())
        });
    });
    group.bench_function("match_views", |bench| {
        bench.iter(|| match_views(black_box(&lumas[0]), &lumas[1], &ViewOptions::default()));
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = shots, frames
}
criterion_main!(benches);

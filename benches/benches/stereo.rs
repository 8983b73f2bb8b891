//! Dense stereo on two pairs of the Middlebury data sets, in one thread, with memory kept from one
//! pair to the next.
//!
//! The rival is semi-global matching as its paper states it, in plain Rust: the census of 7 × 7
//! pixels, eight paths, sub-pixel places by a parabola, and nothing after that. It stores its costs
//! and sums for all pixels, and allocates them each time. It is compiled for the target of the
//! build, while the matcher takes the best instructions of the processor in any build; with
//! `-C target-cpu=native` both have them.

use std::error::Error;
use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_vision::matcher::{Matcher, MatcherOptions, Mode};
use nullcone_benches::comparison;
use nullcone_shared_data::shared;

/// A pair: its name, the views, and the range of disparities.
const PAIRS: [(&str, [&str; 2], usize); 2] = [
    (
        "motorcycle",
        [
            "data/vision/middlebury/motorcycle_left.png",
            "data/vision/middlebury/motorcycle_right.png",
        ],
        64,
    ),
    (
        "aloe",
        [
            "data/vision/opencv/aloeL.jpg",
            "data/vision/opencv/aloeR.jpg",
        ],
        224,
    ),
];

const MODES: [(&str, Mode); 3] = [
    ("nullcone fast", Mode::Fast),
    ("nullcone balanced", Mode::Balanced),
    ("nullcone best", Mode::Best),
];

fn views(paths: [&str; 2]) -> Result<Option<[Plane<u8>; 2]>, Box<dyn Error>> {
    let (Some(left), Some(right)) = (shared(paths[0]), shared(paths[1])) else {
        return Ok(None);
    };
    let grey = |path| Ok::<_, Box<dyn Error>>(ga_image::file::read(path)?.to_grey(Luma::Bt601));
    Ok(Some([grey(left)?, grey(right)?]))
}

fn stereo(criterion: &mut Criterion) {
    for (name, paths, range) in PAIRS {
        let Ok(Some([left, right])) = views(paths) else {
            continue;
        };
        let mut group = criterion.benchmark_group(format!("stereo/{name}"));
        group.sample_size(10).warm_up_time(Duration::from_millis(1));
        for (contender, mode) in MODES {
            let options = MatcherOptions {
                range: [0, range as i32],
                mode,
                threads: 1,
            };
            let Ok(mut matcher) = Matcher::new(options, left.width(), left.height()) else {
                continue;
            };
            group.bench_function(contender, |bench| {
                bench.iter(|| matcher.run(black_box(&left), &right));
            });
        }
        group.bench_function("plain semi-global matching", |bench| {
            bench.iter(|| plain::disparities(black_box(&left), &right, range));
        });
        group.finish();
    }
}

/// Semi-global matching without any of the means to make it fast or robust.
mod plain {
    use ga_image::plane::Plane;

    const P1: u16 = 8;
    const P2: u16 = 32;
    const PATHS: [[isize; 2]; 8] = [
        [1, 0],
        [-1, 0],
        [0, 1],
        [0, -1],
        [1, 1],
        [-1, -1],
        [1, -1],
        [-1, 1],
    ];

    pub(crate) fn disparities(left: &Plane<u8>, right: &Plane<u8>, range: usize) -> Vec<f32> {
        let size = [left.width(), left.height()];
        let costs = costs([census(left), census(right)], size, range);
        let mut sums = vec![0u16; costs.len()];
        for direction in PATHS {
            add_path(&costs, size, range, direction, &mut sums);
        }
        sums.chunks_exact(range).map(best).collect()
    }

    fn census(view: &Plane<u8>) -> Vec<u64> {
        let [width, height] = [view.width(), view.height()].map(usize::cast_signed);
        let level = |x: isize, y: isize| {
            let [x, y] = [x.clamp(0, width - 1), y.clamp(0, height - 1)];
            view.values()[(y * width + x).cast_unsigned()]
        };
        let mut bits = Vec::with_capacity(view.values().len());
        for y in 0..height {
            for x in 0..width {
                let centre = level(x, y);
                let mut word = 0;
                for dy in -3..=3 {
                    for dx in -3..=3 {
                        if (dx, dy) != (0, 0) {
                            word = word << 1 | u64::from(level(x + dx, y + dy) < centre);
                        }
                    }
                }
                bits.push(word);
            }
        }
        bits
    }

    fn costs(census: [Vec<u64>; 2], [width, height]: [usize; 2], range: usize) -> Vec<u8> {
        let mut costs = vec![48; width * height * range];
        let rows = census[0]
            .chunks_exact(width)
            .zip(census[1].chunks_exact(width));
        for ((left, right), costs) in rows.zip(costs.chunks_exact_mut(width * range)) {
            for x in 0..width {
                for d in 0..range.min(x + 1) {
                    costs[x * range + d] = (left[x] ^ right[x - d]).count_ones() as u8;
                }
            }
        }
        costs
    }

    /// Adds the costs of the paths in one direction. Each pixel has a margin of one number on
    /// either side, so that the loop over disparities has no special cases.
    fn add_path(
        costs: &[u8],
        [width, height]: [usize; 2],
        range: usize,
        [dx, dy]: [isize; 2],
        sums: &mut [u16],
    ) {
        let stride = range + 2;
        let mut paths = vec![u16::MAX / 2; width * height * stride];
        let is_reversed = dy < 0 || (dy == 0 && dx < 0);
        for step in 0..width * height {
            let pixel = if is_reversed {
                width * height - 1 - step
            } else {
                step
            };
            let x = (pixel % width).cast_signed() - dx;
            let y = (pixel / width).cast_signed() - dy;
            let costs = &costs[pixel * range..][..range];
            let place = pixel * stride;
            let is_inside =
                (0..width.cast_signed()).contains(&x) && (0..height.cast_signed()).contains(&y);
            if !is_inside {
                for (path, cost) in paths[place + 1..].iter_mut().zip(costs) {
                    *path = u16::from(*cost);
                }
                continue;
            }
            let from = (y * width.cast_signed() + x).cast_unsigned() * stride;
            let (before, after) = if from < place {
                let (low, high) = paths.split_at_mut(place);
                (&low[from..][..stride], &mut high[1..=range])
            } else {
                let (low, high) = paths.split_at_mut(from);
                (&high[..stride], &mut low[place + 1..][..range])
            };
            let same = &before[1..=range];
            let least = same.iter().copied().fold(u16::MAX, u16::min);
            for d in 0..range {
                let changed = before[d].min(before[d + 2]) + P1;
                after[d] = u16::from(costs[d]) + same[d].min(changed).min(least + P2) - least;
            }
        }
        for (sums, paths) in sums.chunks_exact_mut(range).zip(paths.chunks_exact(stride)) {
            for (sum, path) in sums.iter_mut().zip(&paths[1..]) {
                *sum += path;
            }
        }
    }

    fn best(sums: &[u16]) -> f32 {
        let mut place = 0;
        for d in 1..sums.len() {
            if sums[d] < sums[place] {
                place = d;
            }
        }
        let mut disparity = place as f32;
        if place > 0 && place + 1 < sums.len() {
            let [a, b, c] = [sums[place - 1], sums[place], sums[place + 1]].map(f32::from);
            let curvature = a - 2.0 * b + c;
            if curvature > 0.0 {
                disparity += 0.5 * (a - c) / curvature;
            }
        }
        disparity
    }
}

criterion_group! { name = benches; config = comparison::criterion(); targets = stereo }
criterion_main!(benches);

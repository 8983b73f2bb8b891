//! Matches the pairs with known disparities of the shared data, and prints how far the maps are
//! from the truth, the least time of processors that each took, and the least time by the clock.
//!
//! ```text
//! cargo run --release -p ga-vision --example stereo_table -- [MODE] [CHANGE] [THREADS] [PAIR]
//! ```
//!
//! MODE is fast, balanced or best; CHANGE is exposure, noise or offset; PAIR is the name of one
//! pair.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::sample::Sample;
use ga_vision::disparity::DisparityMap;
use ga_vision::disparity::evaluation::ErrorMap;
use ga_vision::disparity::file;
use ga_vision::matcher::{Matcher, MatcherOptions, Mode};

/// How often each pair is matched.
const REPEATS: usize = 4;
/// What is printed of each pair: percentages of errors above 0.5, 1, 2 and 3 px, the average error
/// in px, and two times in ms.
const COLUMNS: usize = 7;

type Failure = Box<dyn std::error::Error>;

/// A pair: name, left and right view, truth, the scale of the truth, the range of disparities.
type Pair = (
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    f64,
    i32,
);

const PAIRS: [Pair; 10] = [
    (
        "motorcycle",
        "middlebury/motorcycle_left.png",
        "middlebury/motorcycle_right.png",
        "middlebury/motorcycle_disp.pfm",
        1.0,
        64,
    ),
    (
        "aloe",
        "opencv/aloeL.jpg",
        "opencv/aloeR.jpg",
        "opencv/aloeGT.png",
        1.0,
        224,
    ),
    (
        "venus",
        "stereo/mb2001_venus/left.png",
        "stereo/mb2001_venus/right.png",
        "stereo/mb2001_venus/disp_left.png",
        8.0,
        32,
    ),
    (
        "teddy",
        "stereo/mb2003_Teddy/left.png",
        "stereo/mb2003_Teddy/right.png",
        "stereo/mb2003_Teddy/disp_left.png",
        4.0,
        64,
    ),
    (
        "art",
        "stereo/mb2005_Art/left.png",
        "stereo/mb2005_Art/right.png",
        "stereo/mb2005_Art/disp_left.png",
        3.0,
        80,
    ),
    (
        "reindeer",
        "stereo/mb2005_Reindeer/left.png",
        "stereo/mb2005_Reindeer/right.png",
        "stereo/mb2005_Reindeer/disp_left.png",
        3.0,
        80,
    ),
    (
        "baby",
        "stereo/mb2006_Baby1/left.png",
        "stereo/mb2006_Baby1/right.png",
        "stereo/mb2006_Baby1/disp_left.png",
        3.0,
        80,
    ),
    (
        "midd",
        "stereo/mb2006_Midd1/left.png",
        "stereo/mb2006_Midd1/right.png",
        "stereo/mb2006_Midd1/disp_left.png",
        3.0,
        80,
    ),
    (
        "wood",
        "stereo/mb2006_Wood1/left.png",
        "stereo/mb2006_Wood1/right.png",
        "stereo/mb2006_Wood1/disp_left.png",
        3.0,
        80,
    ),
    (
        "terrace",
        "stereo/eth3d_terrace/im0.png",
        "stereo/eth3d_terrace/im1.png",
        "stereo/eth3d_terrace/disp0.pfm",
        1.0,
        32,
    ),
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/vision")
}

fn grey(path: &str) -> Result<Plane<u8>, Failure> {
    Ok(ga_image::file::read(folder().join(path))?.to_grey(Luma::Bt601))
}

fn row(pair: Pair, change: &str, mode: Mode, threads: usize) -> Result<[f64; COLUMNS], Failure> {
    let (name, left, right, truth, scale, max_disparity) = pair;
    let (left, right) = changed(change, grey(left)?, grey(right)?);
    let truth: DisparityMap = file::read(folder().join(truth), Some(scale))?;
    let options = MatcherOptions {
        range: [0, max_disparity],
        mode,
        threads,
    };
    let mut matcher = Matcher::new(options, left.width(), left.height())?;
    let mut found = matcher.run(&left, &right)?;
    let [mut least, mut clock] = [f64::INFINITY; 2];
    for _ in 0..REPEATS {
        let (before, begin) = (processor_ms(), Instant::now());
        found = matcher.run(&left, &right)?;
        clock = clock.min(1e3 * begin.elapsed().as_secs_f64());
        least = least.min(processor_ms() - before);
    }
    let errors = ErrorMap::new(&found.disparity, &truth)?;
    let average = errors.average_px().unwrap_or(f64::NAN);
    let [half, one, two, three] = [0.5, 1.0, 2.0, 3.0].map(|threshold| errors.bad(threshold));
    let row = [half, one, two, three, average, least, clock];
    print_row(name, row);
    Ok(row)
}

fn print_row(name: &str, [half, one, two, three, average, least, clock]: [f64; COLUMNS]) {
    println!(
        "{name:12} {half:7.2} {one:6.2} {two:6.2} {three:6.2} {average:6.3} {least:7.1} {clock:7.1}"
    );
}

/// The views under worse conditions: the right one with another exposure, both with noise of
/// standard deviation 4, or the right one half a row higher.
fn changed(change: &str, left: Plane<u8>, right: Plane<u8>) -> (Plane<u8>, Plane<u8>) {
    match change {
        "exposure" => (left, right.map(|v| u8::from_f32(0.8 * f32::from(v) + 12.0))),
        "noise" => {
            // The sum of twelve uniform numbers is almost normal.
            let mut state = 1u64;
            let mut uniform = move || {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                (state >> 40) as f32 / (1u32 << 24) as f32
            };
            let mut noisy = |v: u8| {
                let sum: f32 = (0..12).map(|_| uniform()).sum();
                u8::from_f32(f32::from(v) + 4.0 * (sum - 6.0))
            };
            (left.map(&mut noisy), right.map(&mut noisy))
        }
        "offset" => {
            let half = Plane::from_fn(right.width(), right.height(), |column, row| {
                let pair = [row, (row + 1).min(right.height() - 1)];
                let [a, b] = pair.map(|row| f32::from(right.row(row)[column]));
                u8::from_f32((a + b) / 2.0)
            });
            (left, half)
        }
        _ => (left, right),
    }
}

/// The time that the threads of this process have run on a processor, in milliseconds: unlike the
/// time of the clock, it is not changed by other programs. Only Linux tells it; elsewhere it is 0.
fn processor_ms() -> f64 {
    let run_time = |task: std::fs::DirEntry| -> Option<f64> {
        let text = std::fs::read_to_string(task.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse().ok()
    };
    let tasks = std::fs::read_dir("/proc/self/task").into_iter().flatten();
    1e-6 * tasks.flatten().filter_map(run_time).sum::<f64>()
}

fn table(pairs: &[Pair], change: &str, mode: Mode, threads: usize) -> Result<(), Failure> {
    println!(
        "{:12} {:>7} {:>6} {:>6} {:>6} {:>6} {:>7} {:>7}",
        mode_name(mode),
        "bad-0.5",
        "bad-1",
        "bad-2",
        "bad-3",
        "avg",
        "ms",
        "clock"
    );
    let mut sums = [0.0; COLUMNS];
    for pair in pairs {
        for (sum, value) in sums.iter_mut().zip(row(*pair, change, mode, threads)?) {
            *sum += value / pairs.len() as f64;
        }
    }
    print_row("mean", sums);
    Ok(())
}

fn mode_name(mode: Mode) -> &'static str {
    match mode {
        Mode::Fast => "fast",
        Mode::Balanced => "balanced",
        Mode::Best => "best",
    }
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let named = |mode: &Mode| {
        arguments
            .iter()
            .any(|argument| argument == mode_name(*mode))
    };
    let modes: Vec<Mode> = [Mode::Fast, Mode::Balanced, Mode::Best]
        .into_iter()
        .filter(named)
        .collect();
    let change = ["exposure", "noise", "offset"]
        .into_iter()
        .find(|change| arguments.iter().any(|a| a == change))
        .unwrap_or("");
    let threads = arguments
        .iter()
        .find_map(|argument| argument.parse().ok())
        .unwrap_or(1);
    let chosen = |pair: &&Pair| arguments.iter().any(|argument| argument == pair.0);
    let mut pairs: Vec<Pair> = PAIRS.iter().filter(chosen).copied().collect();
    if pairs.is_empty() {
        pairs.extend(PAIRS);
    }
    for mode in if modes.is_empty() {
        vec![Mode::Balanced]
    } else {
        modes
    } {
        if let Err(error) = table(&pairs, change, mode, threads) {
            eprintln!("{error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

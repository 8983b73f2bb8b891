//! Matches the pairs with known disparities of the shared data, and prints how far the maps are from
//! the truth and how long each took.
//!
//! ```text
//! cargo run --release -p ga-vision --example stereo_table -- [fast|balanced|best] [threads]
//! ```

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_vision::disparity::DisparityMap;
use ga_vision::disparity::evaluation::ErrorMap;
use ga_vision::disparity::file;
use ga_vision::matcher::{Matcher, MatcherOptions, Mode};

type Failure = Box<dyn std::error::Error>;

/// A pair: name, left and right view, truth, the scale of the truth, the range of disparities.
type Pair = (
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    f64,
    usize,
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

fn row(pair: Pair, mode: Mode, threads: usize) -> Result<[f64; 5], Failure> {
    let (name, left, right, truth, scale, max_disparity) = pair;
    let (left, right) = (grey(left)?, grey(right)?);
    let truth: DisparityMap = file::read_truth(folder().join(truth), scale)?;
    let options = MatcherOptions {
        max_disparity,
        mode,
        threads,
    };
    let mut matcher = Matcher::new(options, left.width(), left.height())?;
    let mut found = matcher.run(&left, &right)?;
    let mut least = f64::INFINITY;
    for _ in 0..5 {
        let start = Instant::now();
        found = matcher.run(&left, &right)?;
        least = least.min(1e3 * start.elapsed().as_secs_f64());
    }
    let errors = ErrorMap::new(&found.disparity, &truth)?;
    let average = errors.average_px().unwrap_or(f64::NAN);
    let [one, two, three] = [1.0, 2.0, 3.0].map(|threshold| errors.bad(threshold));
    println!("{name:12} {one:6.2} {two:6.2} {three:6.2} {average:6.3} {least:7.1}");
    Ok([one, two, three, average, least])
}

fn table(mode: Mode, threads: usize) -> Result<(), Failure> {
    println!(
        "{:12} {:>6} {:>6} {:>6} {:>6} {:>7}",
        mode_name(mode),
        "bad-1",
        "bad-2",
        "bad-3",
        "avg",
        "ms"
    );
    let mut sums = [0.0; 5];
    for pair in PAIRS {
        for (sum, value) in sums.iter_mut().zip(row(pair, mode, threads)?) {
            *sum += value / PAIRS.len() as f64;
        }
    }
    let [one, two, three, average, time] = sums;
    println!(
        "{:12} {one:6.2} {two:6.2} {three:6.2} {average:6.3} {time:7.1}",
        "mean"
    );
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
    let threads = arguments
        .iter()
        .find_map(|argument| argument.parse().ok())
        .unwrap_or(1);
    for mode in if modes.is_empty() {
        vec![Mode::Balanced]
    } else {
        modes
    } {
        if let Err(error) = table(mode, threads) {
            eprintln!("{error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

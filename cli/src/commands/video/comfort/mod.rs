//! The comfort of stereoscopic video.

pub(super) mod align;
mod input;
mod line;
mod table;

use std::path::PathBuf;

use anyhow::{Result, ensure};
use clap::ValueEnum;
use ga_vision::comfort::monitor::{Options, analyse};
use ga_vision::comfort::{Summary, Viewing};

use crate::output;
use crate::progress::Progress;

/// Measure how comfortable stereoscopic video is, frame by frame.
///
/// Eleven quantities get a score from 0 to 15: green up to 7, orange up to 13, red above. The
/// picture's width is the screen's, of 16:9 and 55 inches at three picture heights if nothing else
/// is stated. Where a frame does not show a quantity, its score is null and its state says why:
/// "not measurable" or "unknown".
///
/// --json prints one line for each frame, while the video is read:
/// {"frame": 0, "rows": {"brightness": {"score", "level", "raw", "unit", "offset_codes"},
/// "colour", "vertical": {…, "shift_px", "rotation_degrees", "zoom_percent"},
/// "asynchrony": {…, "frames"}, "parallax_deviation": {…, "median_px"},
/// "stereoscopy": {…, "verdict"}, "weak_depth", "rich_depth", "over_convergence",
/// "over_divergence", "focal_gap": {…, "sharpness_log2", "zoom_percent"}}}.
/// Numbers are those of the right view less those of the left one: it is brighter by offset_codes,
/// lower by shift_px, rotated counter-clockwise, larger by zoom_percent, and late by frames.
/// median_px is the median of x_L − x_R, positive in front of the screen.
///
/// For instance
///
///   nullcone video comfort film.y4m --layout side-by-side --json
///   nullcone video comfort left.y4m right.y4m --layout two-files --csv > comfort.csv
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(in crate::commands::video) struct Arguments {
    /// The video of both views, or of the left one; - is Y4M from standard input.
    #[arg(value_name = "FILE")]
    video: PathBuf,
    /// The video of the right view.
    #[arg(value_name = "RIGHT")]
    right: Option<PathBuf>,
    /// Where the views lie; two-files if RIGHT is given.
    #[arg(long, value_enum)]
    layout: Option<LayoutName>,
    /// The diagonal of the screen, which has 16:9.
    #[arg(long, value_name = "INCHES", default_value_t = 55.0)]
    screen_inches: f64,
    /// The distance of the eyes from the screen; three heights of the screen if it is not given.
    #[arg(long, value_name = "METRES")]
    distance_metres: Option<f64>,
    /// Print a line of JSON for each frame.
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Print a table with a line for each frame.
    #[arg(long)]
    csv: bool,
    /// Write the summary as JSON.
    #[arg(long, value_name = "FILE.json")]
    summary: Option<PathBuf>,
    /// The number of threads, 1 or 2. Results do not depend on it.
    #[arg(long, value_name = "COUNT", default_value_t = 2)]
    threads: usize,
}

/// How the two views are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::commands::video) enum LayoutName {
    /// The left view in the left half of each frame.
    SideBySide,
    /// The left view in the upper half of each frame.
    TopBottom,
    /// One file for each view.
    TwoFiles,
}

pub(in crate::commands::video) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    ensure!(
        (1..=2).contains(&arguments.threads),
        "--threads {}: it must be 1 or 2",
        arguments.threads
    );
    let viewing = Viewing::of_screen(arguments.screen_inches, arguments.distance_metres)?;
    let layout = input::layout(arguments.layout, arguments.right.as_deref())?;
    let mut source = input::open(&arguments.video, arguments.right.as_deref(), layout)?;
    let count = source.properties().frame_count.map(|count| count as u64);
    let options = Options {
        viewing,
        layout: input::halves(layout),
        threads: arguments.threads,
    };
    let progress = Progress::new(1, quiet);
    progress.step("analysing");
    let mut summary = Summary::default();
    let mut printed = match arguments.csv {
        true => output::print(&line::csv_header()?),
        false => Ok(()),
    };
    let result = analyse(&mut source, options, |record| {
        summary.add(&record);
        let frames = summary.frames as u64;
        if frames.is_multiple_of(8) {
            progress.at(frames, count.unwrap_or(2 * frames));
        }
        if printed.is_ok() {
            let text = match (arguments.json, arguments.csv) {
                (true, _) => line::json(&record),
                (_, true) => line::csv(&record),
                (false, false) => return,
            };
            printed = text.and_then(|text| output::print(&text));
        }
    });
    drop(progress);
    printed?;
    if let Some(path) = arguments.summary.as_ref().filter(|_| result.is_ok()) {
        let text = serde_json::to_string_pretty(&table::json(&summary, &viewing))? + "\n";
        ga_files::write(path, text.as_bytes())?;
    }
    if !arguments.json && !arguments.csv && !quiet && summary.frames > 0 {
        output::print(&table::text(&summary, &viewing))?;
    }
    // What was analysed before an error is reported.
    Ok(result?)
}

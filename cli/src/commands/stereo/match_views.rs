//! `nullcone stereo match`: the disparities of two rectified views.

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context as _, Result};
use clap::ValueEnum;
use ga_image::plane::Plane;
use ga_image::png;
use ga_image::sample::Sample;
use ga_vision::disparity::picture::ColourScale;
use ga_vision::disparity::{DisparityMap, file};
use ga_vision::matcher::{Matcher, MatcherOptions, Mode as MatcherMode};
use serde::Serialize;

use super::picture::{self, Panel};
use super::rectify::RIG;
use super::views;
use crate::format::Format;
use crate::frame::{self, Command, Context, command_line};
use crate::output;

/// More threads than this are taken for a mistake.
const MOST_THREADS: i64 = 1024;

/// Find the disparity of each pixel of two rectified views.
///
/// What the left view shows at column u of a row, the right view shows at column u − d of the same
/// row; d is the disparity, from 0 up to but without the number of --max-disparity. Pictures in
/// colour are taken as grey. `nullcone stereo rectify` makes rectified views of others.
///
/// For instance
///
///   nullcone stereo match left.png right.png --max-disparity 64 --out d.pfm --picture d.png --json
///
/// prints {"width_px": …, "height_px": …, "max_disparity_px": 64, "mode": "balanced",
/// "least_px": …, "greatest_px": …, "density": …, "mean_confidence": …, "seconds": …}. density is
/// the percentage of pixels whose disparity is known, and seconds is the time of the matching. The
/// disparities are the same for any number of threads.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The left view.
    #[arg(value_name = "LEFT")]
    left: PathBuf,
    /// The right view.
    #[arg(value_name = "RIGHT")]
    right: PathBuf,
    /// Disparities are less than this number of pixels.
    #[arg(long, value_name = "N")]
    max_disparity: usize,
    /// How much work is done.
    #[arg(long, value_enum, default_value_t = Mode::Balanced)]
    mode: Mode,
    /// The number of threads; by default as many as the machine can run at the same time.
    #[arg(long, value_name = "N", value_parser = threads())]
    threads: Option<u16>,
    /// The disparities in pixels of the left view, as floats.
    #[arg(long, value_name = "FILE.pfm")]
    out: PathBuf,
    /// Write how certain each disparity is, from black for not at all, in grey with 8 bits.
    #[arg(long, value_name = "FILE.png")]
    confidence: Option<PathBuf>,
    /// Write a picture of the disparities in colours.
    #[arg(long, value_name = "FILE.png")]
    picture: Option<PathBuf>,
}

pub(super) fn threads() -> clap::builder::RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(1..=MOST_THREADS)
}

/// How much work is done.
#[derive(Clone, Copy, Debug, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Mode {
    /// The least time.
    Fast,
    /// More accurate on flat surfaces.
    Balanced,
    /// Also more accurate beside near objects.
    Best,
}

impl From<Mode> for MatcherMode {
    fn from(mode: Mode) -> Self {
        match mode {
            Mode::Fast => Self::Fast,
            Mode::Balanced => Self::Balanced,
            Mode::Best => Self::Best,
        }
    }
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    out: String,
    #[serde(skip)]
    next: Option<String>,
    width_px: usize,
    height_px: usize,
    max_disparity_px: usize,
    mode: Mode,
    least_px: Option<f32>,
    greatest_px: Option<f32>,
    density: f64,
    mean_confidence: f64,
    seconds: f64,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        let mut files = context.files([&arguments.left, &arguments.right])?;
        files.write("--out", &arguments.out, &[Format::Pfm])?;
        files.write_if_given(
            "--confidence",
            arguments.confidence.as_ref(),
            &[Format::Png],
        )?;
        files.write_if_given("--picture", arguments.picture.as_ref(), &[Format::Png])?;
        let progress = context.progress(3);
        progress.step("reading the views");
        let [left, right] = views::read_pair(&arguments.left, &arguments.right)?;

        progress.step("matching");
        let begin = Instant::now();
        let options = MatcherOptions {
            max_disparity: arguments.max_disparity,
            mode: arguments.mode.into(),
            threads: arguments.threads.map_or(0, usize::from),
        };
        let named = || {
            let [left, right] = [&arguments.left, &arguments.right].map(|path| path.display());
            format!("{left} and {right}")
        };
        let mut matcher = Matcher::new(options, left.width(), left.height()).with_context(named)?;
        let found = matcher.run(&left, &right).with_context(named)?;
        let seconds = begin.elapsed().as_secs_f64();
        // The files need memory as well.
        drop((matcher, left, right));

        progress.step("writing");
        let map = &found.disparity;
        let mut files = vec![(&arguments.out, file::encode(map)?)];
        if let Some(path) = &arguments.confidence {
            let levels = found.confidence.map(u8::from_unit);
            files.push((path, png::encode(&levels)?));
        }
        if let Some(path) = &arguments.picture {
            files.push((path, png::encode(&picture_of(map))?));
        }
        output::write_together(files)?;
        drop(progress);

        let pixels = (map.width() * map.height()) as f64;
        let confidence = found.confidence.values().iter().map(|c| f64::from(*c));
        Ok(Report {
            out: arguments.out.display().to_string(),
            next: arguments.reconstruction(),
            width_px: map.width(),
            height_px: map.height(),
            max_disparity_px: arguments.max_disparity,
            mode: arguments.mode,
            least_px: map.range().map(|[least, _]| least),
            greatest_px: map.range().map(|[_, greatest]| greatest),
            density: 100.0 * map.known() as f64 / pixels,
            mean_confidence: confidence.sum::<f64>() / pixels,
            seconds,
        })
    }
}

impl Arguments {
    /// How the same views are reconstructed, where the file of cameras is beside them that
    /// `nullcone stereo rectify` writes.
    fn reconstruction(&self) -> Option<String> {
        let rig = self.left.with_file_name(RIG);
        let words = [
            "nullcone stereo reconstruct".as_ref(),
            self.left.as_os_str(),
            self.right.as_os_str(),
            "--rig".as_ref(),
            rig.as_os_str(),
            "--out".as_ref(),
            "model.glb".as_ref(),
        ];
        rig.is_file().then(|| command_line(words))
    }
}

/// The map in the colours of its own range.
fn picture_of(map: &DisparityMap) -> Plane<[u8; 3]> {
    let range = map.range().unwrap_or_default().map(f64::from);
    let scale = ColourScale::viridis(range);
    picture::beside(&[Panel {
        caption: "disparity".into(),
        picture: scale.disparities(map),
        scale,
        most: format!("{:.1} px", range[1]),
        marks: vec![(ColourScale::unknown, "unknown")],
    }])
}

impl frame::Report for Report {
    fn next(&self) -> Option<String> {
        self.next.clone()
    }

    fn text(&self) -> String {
        let range = match (self.least_px, self.greatest_px) {
            (Some(least), Some(greatest)) => format!("{least:.2} to {greatest:.2} px"),
            _ => "none".into(),
        };
        format!(
            "{}: {} × {} pixels, {:.2} % known\ndisparities {range}\nmean confidence {:.3}\n\
             matched in {:.3} s\n",
            self.out,
            self.width_px,
            self.height_px,
            self.density,
            self.mean_confidence,
            self.seconds
        )
    }
}

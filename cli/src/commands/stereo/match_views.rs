//! `nullcone stereo match`: the disparities of two rectified views.

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context as _, Result};
use clap::ValueEnum;
use ga_image::png;
use ga_image::sample::Sample;
use ga_vision::disparity::{file, picture};
use ga_vision::matcher::{MatchSummary, Matcher, MatcherOptions, Mode as MatcherMode};
use serde::Serialize;

use super::rectify::RIG;
use super::views::{self, ViewPair};
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
    #[command(flatten)]
    views: ViewPair,
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
    #[serde(flatten)]
    found: MatchSummary,
    seconds: f64,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let mut files = context.files(self.views.paths())?;
        files.write("--out", &self.out, &[Format::Pfm])?;
        files.write_if_given("--confidence", self.confidence.as_ref(), &[Format::Png])?;
        files.write_if_given("--picture", self.picture.as_ref(), &[Format::Png])?;
        let progress = context.progress(3);
        progress.step("reading the views");
        let [left, right] = views::read_pair(&self.views.left, &self.views.right)?;

        progress.step("matching");
        let begin = Instant::now();
        let options = MatcherOptions {
            max_disparity: self.max_disparity,
            mode: self.mode.into(),
            threads: self.threads.map_or(0, usize::from),
        };
        let found = Matcher::new(options, left.width(), left.height())
            .and_then(|mut matcher| matcher.run(&left, &right))
            .with_context(|| self.views.named())?;
        let seconds = begin.elapsed().as_secs_f64();
        // The files need memory as well.
        drop((left, right));

        progress.step("writing");
        let map = &found.disparity;
        let mut files = vec![(&self.out, file::encode(map)?)];
        if let Some(path) = &self.confidence {
            let levels = found.confidence.map(u8::from_unit);
            files.push((path, png::encode(&levels)?));
        }
        if let Some(path) = &self.picture {
            files.push((path, png::encode(&picture::captioned(map))?));
        }
        output::write_together(files)?;
        drop(progress);

        Ok(Report {
            out: self.out.display().to_string(),
            next: self.reconstruction(),
            width_px: map.width(),
            height_px: map.height(),
            max_disparity_px: self.max_disparity,
            mode: self.mode,
            found: found.summary(),
            seconds,
        })
    }
}

impl Arguments {
    /// How the same views are reconstructed, where the file of cameras is beside them that
    /// `nullcone stereo rectify` writes.
    fn reconstruction(&self) -> Option<String> {
        let ViewPair { left, right } = &self.views;
        let rig = left.with_file_name(RIG);
        let words = [
            "nullcone stereo reconstruct".as_ref(),
            left.as_os_str(),
            right.as_os_str(),
            "--rig".as_ref(),
            rig.as_os_str(),
            "--out".as_ref(),
            "model.glb".as_ref(),
        ];
        rig.is_file().then(|| command_line(words))
    }
}

impl frame::Report for Report {
    fn next(&self) -> Option<String> {
        self.next.clone()
    }

    fn text(&self) -> String {
        let range = match (self.found.least, self.found.greatest) {
            (Some(least), Some(greatest)) => format!("{least:.2} to {greatest:.2} px"),
            _ => "none".into(),
        };
        format!(
            "{}: {} × {} pixels, {:.2} % known\ndisparities {range}\nmean confidence {:.3}\n\
             matched in {:.3} s\n",
            self.out,
            self.width_px,
            self.height_px,
            self.found.density,
            self.found.mean_confidence,
            self.seconds
        )
    }
}

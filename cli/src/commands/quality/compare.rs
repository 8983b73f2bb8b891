//! `nullcone quality compare`: a picture or a video against its reference.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Error, Result, bail, ensure};
use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::quality::Weights;
use ga_video::VideoError;
use ga_video::quality::{
    self, ComparedFiles, MeasureRow, POOLED, PictureQuality, VideoComparison, VideoQuality,
};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{Command, Context, Shown, Warning};
use crate::output;

/// Measure how much a picture or a video differs from its reference.
///
/// psnr and attention_psnr are in decibels and null where nothing differs; ms_ssim is null where a
/// side has less than 176 pixels. Pictures are compared in luma by BT.601; videos in luma as they
/// store it, and their numbers are means over the frames. For instance
///
///   nullcone quality compare reference.png compressed.png --json
///
/// prints {"psnr": …, "ssim": …, "ms_ssim": …, "attention_psnr": …, "attention_ssim": …}. For
/// videos follow the number of frames, PSNR of Cb and Cr, (6 Y + Cb + Cr) / 8, and in "pooled" the
/// mean, harmonic mean, least value and percentiles of each measure.
///
/// One of two videos may come from standard input:
///
///   ffmpeg -i small.mp4 -f yuv4mpegpipe - | nullcone quality compare original.y4m - --json
///
/// Where a video breaks off, the frames before are reported, and the program fails. The page of
/// --report shows a video with charts over time, a picture with a map of SSIM.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(super) struct Arguments {
    /// The reference: a picture (PNG, JPEG, PGM, PPM, PFM, TIFF, BMP, WebP) or a video (Y4M, - for
    /// Y4M on standard input, a folder of numbered pictures; MP4 where the program is built with
    /// feature mp4).
    #[arg(value_name = "REF")]
    reference: PathBuf,
    /// What is measured: a picture or a video of the same size.
    #[arg(value_name = "DIST")]
    distorted: PathBuf,
    /// Weights of the pixels, the same for all frames: black does not count, white counts most
    /// [default: 0.2 + 0.8 A by a model of attention A to contours and motion of the reference].
    #[arg(long, value_name = "MAP.png")]
    attention: Option<PathBuf>,
    /// Write a row for each frame: frame, time_seconds and the measures; inf where nothing differs.
    #[arg(long, value_name = "FRAMES.csv")]
    csv: Option<PathBuf>,
    /// Draw the measures of a video over time.
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

/// What was measured.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum Measures {
    Pictures(PictureQuality),
    Videos(VideoQuality),
}

impl Command for Arguments {
    type Report = Shown<Measures>;

    fn run(&self, context: &Context) -> Result<Self::Report> {
        let paths = [&self.reference, &self.distorted];
        ensure!(
            !paths.iter().all(|path| path.as_os_str() == "-"),
            "standard input can be one of the two videos only"
        );
        let inputs = paths.into_iter().chain(&self.attention);
        let mut files = context.files(inputs)?;
        files.write_if_given("--csv", self.csv.as_ref(), &[Format::Csv])?;
        files.write_if_given("--plot", self.plot.as_ref(), &[Format::Svg])?;
        let differ = |picture: &Path, other: &Path| {
            bail!(
                "{} is a picture and {} is not",
                picture.display(),
                other.display()
            )
        };
        match paths.map(|path| is_picture(path)) {
            // What is missing beside a picture is a picture: its reader says what is wrong.
            [Some(true), Some(true) | None] | [None, Some(true)] => self.pictures(context),
            [Some(true), Some(false)] => differ(paths[0], paths[1]),
            [Some(false), Some(true)] => differ(paths[1], paths[0]),
            _ => self.videos(context),
        }
    }
}

/// Whether a file begins as a picture does; `None` where it cannot be read.
fn is_picture(path: &Path) -> Option<bool> {
    if path.as_os_str() == "-" {
        return Some(false);
    }
    let format = file::detect(path).ok()?;
    Some(format.is_some_and(|format| format != file::Format::Y4m))
}

impl Arguments {
    fn pictures(&self, context: &Context) -> Result<Shown<Measures>> {
        ensure!(
            self.plot.is_none(),
            "--plot draws measures over time, and pictures have none"
        );
        let [reference, distorted] = [&self.reference, &self.distorted].map(file::read);
        let (reference, distorted) = (reference?, distorted?);
        let size = [reference.width(), reference.height()];
        let map = self.read_map(size)?;
        let frame = quality::compare_pictures(&reference, &distorted, map);
        let frame = frame.with_context(|| self.names())?;
        let found = PictureQuality::new(&frame, size);
        let text = found.rows().iter().map(line).collect();
        let warnings = warnings(found.reasons());
        let page = context.report().map(|_| {
            let map = quality::similarity_map(&reference, &distorted)?;
            let page = found.page(self.files(), &map);
            page.context("cannot encode the map of SSIM")
        });
        let page = page.transpose()?;
        let mut shown = Shown::new(Measures::Pictures(found), text);
        if let Some(path) = &self.csv {
            output::stage(&mut shown.files, path, quality::csv(&[frame]).as_bytes())?;
        }
        Ok(Shown {
            warnings: Some(warnings),
            page,
            ..shown
        })
    }

    fn videos(&self, context: &Context) -> Result<Shown<Measures>> {
        let reference = ga_video::open(&self.reference)?;
        let distorted = ga_video::open(&self.distorted)?;
        let size = reference.properties().size;
        let map = self.read_map(size)?;
        let comparison = VideoComparison::new(reference, distorted, map);
        let mut comparison = comparison.with_context(|| self.names())?;

        let (count, range) = (comparison.frame_count(), comparison.range());
        let progress = context.progress(count.unwrap_or(0) as u64);
        progress.step("comparing");
        let mut frames = Vec::new();
        let compared = comparison.try_for_each(|frame| {
            frames.push(frame?);
            // Where no length is stated, the bar is that of the frames so far.
            let done = frames.len();
            progress.at(done as u64, count.unwrap_or(done).max(done) as u64);
            Ok::<(), VideoError>(())
        });
        drop(progress);
        let Some(mut found) = VideoQuality::new(&frames, size, range) else {
            compared.with_context(|| self.names())?;
            bail!("{}: the videos have no frames", self.names());
        };
        found.error = compared.as_ref().err().map(ToString::to_string);
        let text = text(&found);
        let warnings = warnings(found.reasons());
        let files = self.files();
        let drawn = Shown::new(found, text).with_plot(
            self.plot.as_ref(),
            context,
            |_| quality::svg(&frames, &files.name()),
            |found, svg| found.page(files, &frames, svg),
        );
        let mut shown = drawn?;
        if let Some(path) = &self.csv {
            output::stage(&mut shown.files, path, quality::csv(&frames).as_bytes())?;
        }
        shown.warnings = Some(warnings);
        shown.failure = compared.err().map(|error| {
            let done = frames.len();
            Error::new(error).context(format!("{}: {done} frames are reported", self.names()))
        });
        Ok(shown.map(Measures::Videos))
    }

    /// The weights of a picture in grey, as it states them.
    fn read_map(&self, [width, height]: [usize; 2]) -> Result<Option<Weights>> {
        let Some(path) = &self.attention else {
            return Ok(None);
        };
        let map: Plane = file::read(path)?.to_grey(Luma::Bt601);
        ensure!(
            [map.width(), map.height()] == [width, height],
            "{} has {} × {} pixels, and {} has {width} × {height}",
            path.display(),
            map.width(),
            map.height(),
            self.reference.display()
        );
        let weights = Weights::new(map).with_context(|| path.display().to_string())?;
        Ok(Some(weights))
    }

    fn names(&self) -> String {
        let [reference, distorted] = [&self.reference, &self.distorted].map(|p| p.display());
        format!("{reference} and {distorted}")
    }

    fn files(&self) -> ComparedFiles<'_> {
        ComparedFiles {
            reference: &self.reference,
            distorted: &self.distorted,
            map: self.attention.as_deref(),
        }
    }
}

fn warnings<'a>(reasons: impl Iterator<Item = (&'static str, &'a str)>) -> Vec<Warning> {
    let message = |(key, reason): (&str, &str)| format!("{key} is null: {reason}");
    let warning = |reason| Warning::new("too_few_pixels", message(reason));
    reasons.map(warning).collect()
}

fn line(row: &MeasureRow) -> String {
    format!("{:16}{:>10}{}\n", row.name, row.number, row.remark)
}

/// The means, then a table of what else was found over the frames.
fn text(found: &VideoQuality) -> String {
    let mut text = format!("{} frames, means:\n", found.frames);
    text.extend(found.rows().iter().map(line));
    text.push('\n');
    let names = ("over frames", POOLED.map(String::from));
    for (name, numbers) in std::iter::once(names).chain(found.pooled_rows()) {
        let columns = numbers.map(|number| format!("{number:>10}"));
        text += &format!("{name:16}{}\n", columns.concat());
    }
    text
}

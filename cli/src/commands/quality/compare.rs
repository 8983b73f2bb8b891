//! `nullcone quality compare`: a picture or a video against its reference.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Error, Result, bail, ensure};
use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::quality::Weights;
use ga_video::quality::{
    self, ComparedFiles, FRAME_COUNT, FRAME_RATE, MeasureRow, Moments, POOLED, PictureQuality,
    Scaled, TimeAlignment, VideoComparison, VideoQuality,
};
use ga_video::{Properties, VideoError};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{Command, Context, Shown, Warning};
use crate::output;

/// Measure how much a picture or a video differs from its reference.
///
/// For instance
///
///   nullcone quality compare reference.png compressed.png --json
///
/// prints, of pictures in luma by BT.601 and of videos in luma as they store it,
///
///   psnr, attention_psnr     PSNR in decibels, also weighted by attention
///   ssim, ms_ssim, attention_ssim
///                            structural similarity, 1 where luma is identical
///
/// and of the colours
///
///   psnr_cb, psnr_cr         PSNR of Cb and Cr; of pictures by BT.601 from 0 to 255
///   psnr_6_1_1               (6 Y + Cb + Cr) / 8 of the three PSNRs in decibels
///   psnr_all                 PSNR by all samples of Y, Cb and Cr together, which ffmpeg calls
///                            average; of pictures by those of red, green and blue
///   ciede2000                the mean difference of colours CIEDE2000 over the pixels, of 8 bits
///                            as sRGB: 0 for equal colours, about 1 where it can just be seen
///   identical, differs_in    whether nothing differs, also not in colours, alpha and properties,
///                            and what does
///
/// PSNR is infinite, and null in JSON, where the part that it measures is identical. Beside every
/// number that is null stands why, as in "psnr_reason": "luma is identical, colours differ". SSIM
/// needs 11 pixels on either side, MS-SSIM 176.
///
/// Of videos these are means over the frames; a mean of PSNRs is infinite where one frame is
/// identical. "psnr_of_mean_mse" and the like are PSNR of the mean squared error of all frames,
/// which is finite unless all are identical; ffmpeg prints that. "pooled" has the mean, harmonic
/// mean, least value and percentiles of each measure. Videos that differ in size, depth, sampling
/// or range are an error; other properties and times that differ are warned of.
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
    /// Scale the frames of a video of another size to that of the reference: by the means over the
    /// area of each pixel where it shrinks, otherwise by cubic convolution.
    #[arg(long)]
    scale: bool,
    /// Compare each frame of the second video with that of the reference that is nearest in time,
    /// after the constant offset by which the videos are most alike. Both are read twice.
    #[arg(long)]
    align_times: bool,
    /// Write a row for each frame: frame, time_seconds, the measures, inf where the part that they
    /// measure is identical, and distorted_frame.
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
    Videos(Videos),
}

/// What was measured of videos, and what was done before.
#[derive(Serialize)]
pub(super) struct Videos {
    #[serde(flatten)]
    quality: VideoQuality,
    #[serde(skip_serializing_if = "Option::is_none")]
    alignment: Option<TimeAlignment>,
    /// Columns and rows that were scaled to those of the reference.
    #[serde(skip_serializing_if = "Option::is_none")]
    scaled_from: Option<[usize; 2]>,
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
        ensure!(
            !self.scale && !self.align_times,
            "--scale and --align-times are for videos"
        );
        let [reference, distorted] = [&self.reference, &self.distorted].map(file::read);
        let (reference, distorted) = (reference?, distorted?);
        let size = [reference.width(), reference.height()];
        let map = self.read_map(size)?;
        let frame = quality::compare_pictures(&reference, &distorted, map);
        let frame = frame.with_context(|| self.names())?;
        let found = PictureQuality::new(&frame, size);
        let text = found.rows().iter().map(line).collect();
        let warnings = too_few_pixels(found.too_small_for());
        let page = context.report().map(|_| {
            let map = quality::similarity_map(&reference, &distorted)?;
            let page = found.page(self.files(&[]), &map);
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
        let progress = context.progress(0);
        let alignment = self.align_times.then(|| {
            progress.step("reading the times of frames");
            self.align()
        });
        let alignment = alignment.transpose()?;
        let reference = ga_video::open(&self.reference)?;
        let mut distorted = ga_video::open(&self.distorted)?;
        let Properties {
            size, pixel_aspect, ..
        } = *reference.properties();
        let map = self.read_map(size)?;
        let mut notes = Vec::new();
        if let Some(found) = &alignment {
            notes.push(Warning::new("aligned_times", in_words(found)).into_note());
        }
        let own = distorted.properties().size;
        let scaled_from = (self.scale && own != size).then_some(own);
        if let Some([width, height]) = scaled_from {
            let scaled = Scaled::new(distorted, size, pixel_aspect);
            let message = format!(
                "{} was scaled from {width} × {height} to {} × {} pixels by {}",
                self.distorted.display(),
                size[0],
                size[1],
                scaled.method()
            );
            notes.push(Warning::new("scaled", message).into_note());
            distorted = Box::new(scaled);
        }
        let comparison = VideoComparison::new(reference, distorted, map);
        let mut comparison = comparison.with_context(|| self.names())?;
        if let Some(found) = &alignment {
            comparison = comparison.of_pairs(found.pairs.clone());
        }

        let mut properties = comparison.property_differences();
        properties.extend(alignment.as_ref().and_then(TimeAlignment::frame_difference));
        let count = comparison.frame_count();
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
        let error = compared.as_ref().err().map(ToString::to_string);
        let Some(quality) = VideoQuality::new(&frames, size, &properties, error) else {
            compared.with_context(|| self.names())?;
            bail!("{}: the videos have no frames", self.names());
        };
        let mut warnings = too_few_pixels(quality.too_small_for());
        let differ = |found| Warning::new("properties_differ", found);
        // What is said of the alignment covers rates and numbers of frames.
        let is_said = |what| alignment.is_some() && [FRAME_RATE, FRAME_COUNT].contains(&what);
        let unsaid = properties.iter().filter(|found| !is_said(found.what));
        warnings.extend(unsaid.map(differ));
        let other = VideoQuality::first_at_another_time(&frames);
        if let Some(frame) = other.filter(|_| alignment.is_none()) {
            let message = format!(
                "frame {} is shown at {:.3} s in the reference and at {:.3} s in the other video: \
                 frames are compared by their numbers, with --align-times by their times",
                frame.index,
                frame.time_seconds,
                frame.time_seconds + frame.time_offset_seconds
            );
            warnings.push(Warning {
                frame: Some(frame.index),
                ..Warning::new("frame_times_differ", message)
            });
        }
        warnings.extend(notes);
        let text = text(&quality);
        let messages: Vec<String> = warnings.iter().map(Warning::line_of_text).collect();
        let files = self.files(&messages);
        let videos = Videos {
            quality,
            alignment,
            scaled_from,
        };
        let drawn = Shown::new(videos, text).with_plot(
            self.plot.as_ref(),
            context,
            |_| quality::svg(&frames, &files.name()),
            |found, svg| found.quality.page(files, &frames, svg),
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

    /// Which frames show the same moments.
    fn align(&self) -> Result<TimeAlignment> {
        let paths = [&self.reference, &self.distorted];
        ensure!(
            paths.iter().all(|path| path.as_os_str() != "-"),
            "--align-times reads the videos twice, and standard input can be read once"
        );
        let [reference, distorted] = paths.map(|path| Moments::of(ga_video::open(path)?));
        let found = TimeAlignment::find(&reference?, &distorted?);
        found.with_context(|| format!("{}: no frames show the same moments", self.names()))
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

    fn files<'a>(&'a self, notes: &'a [String]) -> ComparedFiles<'a> {
        ComparedFiles {
            reference: &self.reference,
            distorted: &self.distorted,
            map: self.attention.as_deref(),
            notes,
        }
    }
}

fn too_few_pixels<'a>(reasons: impl Iterator<Item = (&'a str, &'a str)>) -> Vec<Warning> {
    let message = |(key, reason): (&str, &str)| format!("{key} is null: {reason}");
    let warning = |reason| Warning::new("too_few_pixels", message(reason));
    reasons.map(warning).collect()
}

fn in_words(found: &TimeAlignment) -> String {
    let unshifted = found.unshifted_mean_square_difference;
    let unshifted = unshifted.map_or_else(String::new, |unshifted| {
        format!(" against {unshifted:.2} without offset")
    });
    format!(
        "frames are compared by their times with an offset of {:+.3} s (mean squared difference of \
         small pictures {:.2}{unshifted}); {} frames of the reference and {} of the other video are \
         left out",
        found.offset_seconds,
        found.mean_square_difference,
        found.unmatched_reference_frames,
        found.unmatched_distorted_frames
    )
}

fn line(row: &MeasureRow) -> String {
    format!("{:32}{:>10}{}\n", row.name, row.number, row.remark)
}

/// PSNR of mean squared errors and the means, then a table of what else was found over the frames.
fn text(found: &VideoQuality) -> String {
    let mut text = format!(
        "{} frames, {} of them identical\n",
        found.frames, found.identical_frames
    );
    text.extend(found.rows().iter().map(line));
    text.push('\n');
    let names = ("over frames", POOLED.map(String::from));
    for (name, numbers) in std::iter::once(names).chain(found.pooled_rows()) {
        let columns = numbers.map(|number| format!("{number:>10}"));
        text += &format!("{name:20}{}\n", columns.concat());
    }
    text
}

//! `nullcone quality compare`: a picture or a video against its reference.

mod found;
mod merged;
mod videos;

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, bail, ensure};
use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::quality::Weights;
use ga_video::quality::{self, ComparedFiles, MeasureRow, PictureQuality};
use serde::{Deserialize, Serialize};

pub(crate) use self::merged::{FORMATS, merged};
use self::videos::Videos;
use crate::format::Format;
use crate::frame::{Command, Context, Shown, Warning};
use crate::output;
use crate::part::{PartArguments, PartWritten};

/// The words of the command.
pub(crate) const COMMAND: &str = "quality compare";

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
///   vif                      visual information fidelity over four scales: how much is left of
///                            the information of luma, 1 where it is identical
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
/// needs 11 pixels on either side, VIF 16, MS-SSIM 176.
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
/// --report shows a video with charts over time, pictures beside each other with a map of SSIM.
#[derive(Clone, Debug, Serialize, Deserialize, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The reference: a picture (PNG, JPEG, PGM, PPM, PFM, TIFF, BMP, WebP) or a video (Y4M, - for
    /// Y4M on standard input, a folder of numbered pictures, or a film that ffmpeg reads where it
    /// is installed; H.264 in MP4 also where the program is built with the feature `mp4`).
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
    #[arg(long, value_name = "FRAMES.csv", conflicts_with = "part")]
    #[serde(skip)]
    csv: Option<PathBuf>,
    /// Draw the measures of a video over time.
    #[arg(long, value_name = "FILE.svg", conflicts_with = "part")]
    #[serde(skip)]
    plot: Option<PathBuf>,
    #[command(flatten)]
    #[serde(skip)]
    part: PartArguments,
}

/// What was measured.
#[derive(Serialize)]
#[serde(untagged)]
pub(crate) enum Measures {
    Pictures(PictureQuality),
    Videos(Videos),
    Part(PartWritten),
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
        self.part.check(&mut files)?;
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
            _ => match self.part.asked() {
                Some((frames, path)) => self.part_of_videos(frames, path, context),
                None => self.videos(context),
            },
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
        ensure!(
            self.part.are_all(),
            "--frames chooses frames of videos, and pictures have none"
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
            let page = found.page(self.files(&[]), [&reference, &distorted], &map);
            page.context("cannot encode the pictures")
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

fn line(row: &MeasureRow) -> String {
    format!("{:32}{:>10}{}\n", row.name, row.number, row.remark)
}

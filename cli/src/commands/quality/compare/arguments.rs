//! What is compared, and what is said of it in either case.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::quality::Weights;
use ga_video::quality::{ComparedFiles, MeasureRow};
use serde::{Deserialize, Serialize};

use crate::frame::Warning;
use crate::part::PartArguments;

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
    pub(super) reference: PathBuf,
    /// What is measured: a picture or a video of the same size.
    #[arg(value_name = "DIST")]
    pub(super) distorted: PathBuf,
    /// Weights of the pixels, the same for all frames: black does not count, white counts most
    /// [default: 0.2 + 0.8 A by a model of attention A to contours and motion of the reference].
    #[arg(long, value_name = "MAP.png")]
    pub(super) attention: Option<PathBuf>,
    /// Scale the frames of a video of another size to that of the reference: by the means over the
    /// area of each pixel where it shrinks, otherwise by cubic convolution.
    #[arg(long)]
    pub(super) scale: bool,
    /// Compare each frame of the second video with that of the reference that is nearest in time,
    /// after the constant offset by which the videos are most alike. Both are read twice.
    #[arg(long)]
    pub(super) align_times: bool,
    /// Write a row for each frame: frame, time_seconds, the measures, inf where the part that they
    /// measure is identical, and distorted_frame.
    #[arg(long, value_name = "FRAMES.csv", conflicts_with = "part")]
    #[serde(skip)]
    pub(super) csv: Option<PathBuf>,
    /// Draw the measures of a video over time.
    #[arg(long, value_name = "FILE.svg", conflicts_with = "part")]
    #[serde(skip)]
    pub(super) plot: Option<PathBuf>,
    #[command(flatten)]
    #[serde(skip)]
    pub(super) part: PartArguments,
}

impl Arguments {
    /// The weights of a picture in grey, as it states them.
    pub(super) fn read_map(&self, [width, height]: [usize; 2]) -> Result<Option<Weights>> {
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

    pub(super) fn names(&self) -> String {
        let [reference, distorted] = [&self.reference, &self.distorted].map(|p| p.display());
        format!("{reference} and {distorted}")
    }

    pub(super) fn files<'a>(&'a self, notes: &'a [String]) -> ComparedFiles<'a> {
        ComparedFiles {
            reference: &self.reference,
            distorted: &self.distorted,
            map: self.attention.as_deref(),
            notes,
        }
    }
}

/// A warning for each measure that small pictures do not have.
pub(super) fn too_few_pixels<'a>(
    reasons: impl Iterator<Item = (&'a str, &'a str)>,
) -> Vec<Warning> {
    let message = |(key, reason): (&str, &str)| format!("{key} is null: {reason}");
    let warning = |reason| Warning::new("too_few_pixels", message(reason));
    reasons.map(warning).collect()
}

/// A measure as a line of text.
pub(super) fn line(row: &MeasureRow) -> String {
    format!("{:32}{:>10}{}\n", row.name, row.number, row.remark)
}

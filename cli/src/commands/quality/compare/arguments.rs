//! The options of the command.

use std::borrow::Cow;
use std::path::PathBuf;

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
pub(crate) struct Arguments {
    /// The reference: a picture (PNG, JPEG, PGM, PPM, PFM) or a video (Y4M, - for Y4M on standard
    /// input, a folder of numbered pictures; MP4 where the program is built with feature mp4).
    #[arg(value_name = "REF")]
    pub(super) reference: PathBuf,
    /// What is measured: a picture or a video of the same size.
    #[arg(value_name = "DIST")]
    pub(super) distorted: PathBuf,
    /// Weights of the pixels, the same for all frames: black does not count, white counts most
    /// [default: 0.2 + 0.8 A by a model of attention A to contours and motion of the reference].
    #[arg(long, value_name = "MAP.png")]
    pub(super) attention: Option<PathBuf>,
    /// Write a row for each frame: frame, time_seconds and the measures; inf where nothing differs.
    #[arg(long, value_name = "FRAMES.csv")]
    pub(super) csv: Option<PathBuf>,
    /// Draw the measures of a video over time.
    #[arg(long, value_name = "FILE.svg")]
    pub(super) plot: Option<PathBuf>,
}

impl Arguments {
    pub(super) fn names(&self) -> String {
        let [reference, distorted] = [&self.reference, &self.distorted].map(|p| p.display());
        format!("{reference} and {distorted}")
    }

    /// The last part of the path of what is measured.
    pub(super) fn distorted_name(&self) -> Cow<'_, str> {
        let path = &self.distorted;
        path.file_name()
            .unwrap_or(path.as_os_str())
            .to_string_lossy()
    }
}

//! The options of the command.

use std::path::PathBuf;

use clap::ArgGroup;

use crate::commands::stereo::matching::MatchingArguments;
use crate::commands::stereo::views::ViewPair;
use crate::frame::Check;
use crate::part::Frames;

/// Find the disparity of each pixel of two rectified views.
///
/// What the left view shows at column u of a row, the right view shows at column u − d of the same
/// row; d is the disparity, from that of --min-disparity up to but without that of --max-disparity.
/// --auto-range finds both from corners that the two views show. Pictures in colour are taken as
/// grey. `nullcone stereo rectify` makes rectified views of others.
///
/// For instance
///
///   nullcone stereo match left.png right.png --max-disparity 64 --out d.pfm --picture d.png --json
///
/// prints {"width_px": …, "height_px": …, "min_disparity_px": 0, "max_disparity_px": 64,
/// "range_points": null, "mode": "balanced", "least_px": …, "greatest_px": …, "density": …,
/// "mean_confidence": …, "textured": …, "seconds": …}. density is the percentage of pixels whose
/// disparity is known, textured that of pixels whose costs have a minimum, which is none in areas
/// of one level, range_points the number of corners that --auto-range found, and seconds the time
/// of the matching. The disparities are the same for any number of threads. Where most of them are
/// uncertain, a warning says what `nullcone stereo diagnose` finds, and the verdict is doubtful.
///
/// With %d or %04d in the name of --out, where the number of the frame is written, LEFT and RIGHT
/// are films or folders of numbered pictures, which are matched frame by frame in luma. --json then
/// prints {"out": …, "frames": …, "first_frame": …, "last_frame": …, "min_disparity_px": …,
/// "max_disparity_px": …, "range_points": …, "mode": …, "per_frame": [{"frame": …, "least_px": …,
/// …}, …]}. The range of --auto-range is that of the first frame.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
#[command(group = ArgGroup::new("range").args(["max_disparity", "auto_range"]).required(true))]
pub(crate) struct Arguments {
    #[command(flatten)]
    pub(super) views: ViewPair,
    #[command(flatten)]
    pub(super) matching: MatchingArguments,
    /// Find the range of disparities from corners that both views show.
    #[arg(long, conflicts_with = "min_disparity")]
    pub(super) auto_range: bool,
    /// The disparities of the left view: .pfm holds floats in pixels, infinite where unknown, and
    /// .png whole numbers of 16 bits, 256 × the disparity, 0 where unknown.
    #[arg(long, value_name = "FILE")]
    pub(super) out: PathBuf,
    /// Write how certain each disparity is, from black for not at all, in grey with 8 bits.
    #[arg(long, value_name = "FILE.png")]
    pub(super) confidence: Option<PathBuf>,
    /// Write a picture of the disparities in colours.
    #[arg(long, value_name = "FILE.png")]
    pub(super) picture: Option<PathBuf>,
    /// Match these frames of films alone, the first included and the last not, as A.. and ..B too.
    /// Their files are those that all frames would have.
    #[arg(long, value_name = "A..B")]
    pub(super) frames: Option<Frames>,
    #[command(flatten)]
    pub(super) check: Check,
}

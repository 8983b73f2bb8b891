//! The options of the command.

use std::path::PathBuf;

use anyhow::Result;
use clap::{ArgGroup, ValueEnum};

use super::super::stereo::Axes;
use crate::camera_file::ChosenPair;
use crate::commands::contour::settling;
use crate::format::Format;
use crate::frame::{Check, Context};

/// Find contours: the borders of the bright regions of a picture, a closed curve that settles at
/// edges, or a closed curve in space that two cameras see.
///
///   nullcone contour IMAGE --out c.svg --json
///       The borders of the regions above Otsu's threshold and of their holes, with the circles and
///       ellipses that are fitted to them. Points at the border of the picture are not fitted:
///       "points_at_border" is how many there are.
///   nullcone contour IMAGE --snake --out c.svg --json
///       A snake: from the largest border, which must lie whole in the picture, or from --circle, a
///       closed curve settles at edges. --json prints its energy before and after each step. The
///       verdict is doubtful where it still moves, has collapsed, or rests on the border of the
///       picture.
///   nullcone contour LEFT RIGHT --rig rig.yml --out curve.obj --json
///       A snake in each view. Both are matched along the epipolar lines, and triangulated into a
///       closed curve in metres; --fit adds the circle or the line nearest to it. The views are as
///       the cameras took them. --json prints {"length_metres": …, "gap_max_metres": …,
///       "deviation_rms_px": …, "circle": {"centre_metres": […], "normal": […],
///       "radius_metres": …, "rms_metres": …}, "points": [{"position_metres": […], …}, …], …}.
///
/// Pixel coordinates count from the centre of the top left pixel. The left camera is at the origin
/// of the curve. As for nullcone stereo reconstruct, y is up and the camera looks along −z by
/// default; with --axes camera, y is down and it looks along z.
#[derive(Clone, Debug, clap::Args)]
#[command(
    verbatim_doc_comment,
    group(ArgGroup::new("a snake").args(["snake", "rig"]).multiple(true))
)]
pub(crate) struct Arguments {
    /// The picture, or the left and the right view: names, or a pattern with `*`, `?` or `[abc]`,
    /// whose pictures are sorted by the numbers in their names.
    #[arg(value_name = "IMAGE or GLOB", required = true, num_args = 1..=2)]
    pub(super) images: Vec<PathBuf>,
    /// The two cameras: a file of any format (docs/stereo.md lists them), such as YAML as nullcone
    /// stereo calibrate writes it.
    #[arg(long, value_name = "FILE")]
    pub(super) rig: Option<PathBuf>,
    #[command(flatten)]
    pub(super) chosen: ChosenPair,
    /// What is written: the picture with the contours over it (.svg), or for two views the curve as
    /// a closed line (.obj, .ply, .glb or .gltf).
    #[arg(long, value_name = "FILE")]
    pub(super) out: Option<PathBuf>,
    /// The level above which pixels belong to regions, instead of Otsu's.
    #[arg(long, value_name = "LEVEL", conflicts_with = "snake")]
    pub(super) threshold: Option<u8>,
    /// Leave out borders that enclose less than this area, in pixels.
    #[arg(long, value_name = "PIXELS", default_value_t = 0.0)]
    pub(super) least_area: f64,
    /// Let a closed curve settle at edges; two views always do.
    #[arg(long)]
    pub(super) snake: bool,
    #[command(flatten)]
    pub(super) snake_arguments: settling::SnakeArguments,
    /// Fit a figure to the curve of two views.
    #[arg(long, value_enum, value_name = "FIGURE", requires = "rig")]
    pub(super) fit: Option<Figure>,
    /// Which way the axes of the curve point.
    #[arg(long, value_enum, default_value_t = Axes::YUp, requires = "rig")]
    pub(super) axes: Axes,
    #[command(flatten)]
    pub(super) check: Check,
}

/// A figure that is fitted to a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Figure {
    /// The circle with the least squared distances.
    Circle,
    /// The line with the least squared distances.
    Line,
}

/// Fails where the file that is to be written is not of its format, or cannot be written.
pub(super) fn check_out(
    arguments: &Arguments,
    context: &Context,
    formats: &[Format],
) -> Result<Option<Format>> {
    let inputs = arguments.images.iter().chain(&arguments.rig);
    let mut files = context.files(inputs)?;
    files.write_if_given("--out", arguments.out.as_ref(), formats)
}

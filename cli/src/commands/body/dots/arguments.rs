//! The options of the command.

use std::path::PathBuf;

use crate::frame::Check;
use crate::person::{CameraFiles, DottedCharacter};

/// Find the dots on a character's skin in films of calibrated cameras, and by them its joints.
///
/// The films of two views or more show the character that `nullcone body paint` made; --character
/// is the one that was painted, without its dots, and --seed the one of that command. In each frame
/// the dots are found as coloured discs on grey. Those of two views are taken for dots of the
/// body by their hues and distances, the pose is fitted to them, and by the pose all other dots are
/// recognised. Each frame is found by itself.
///
/// The result has the pixels of the joints in each view, with standard deviations, and is read by
/// `nullcone people --joints` and `nullcone body fit --joints`, whose help describes the file. A
/// joint is left out of a frame where no view shows a dot of the bones that meet there, and all
/// joints are where the body is not recognised: a warning says why. Frames of equal numbers
/// were taken at one time; the shortest film ends all.
///
/// Films are Y4M, MP4 and what else ffmpeg reads where it is installed (H.264 in MP4 also where the
/// program was built with the feature `mp4`), folders of numbered pictures, patterns such as
/// film_%04d.png, or one picture for each view. They may be smaller or larger than the pictures of
/// the cameras, where the file of these says their size; the pixels of the joints are those of the
/// cameras. A view belongs to the camera of the name of its film without the ending, or where no
/// camera has such a name, to that in its place.
///
/// For instance
///
///   nullcone body dots front.y4m side.y4m --views views.json --out joints.json
///   nullcone people front.y4m side.y4m --joints joints.json --views views.json --out person
///
/// --json prints {"verdict": "good", "out": "joints.json", "seed": 1, "frames": …,
/// "frames_per_second": …, "frames_without_joints": …, "joints": […], "joints_left_out": …,
/// "frames_with_joints_left_out": …, "reprojection_rms_px": …, "milliseconds_per_frame": …,
/// "views": [{"name": …, "film": …, "dots": …, "dots_recognised": …, "reprojection_rms_px": …}, …],
/// "per_frame": [{"dots": […], "dots_recognised": […], "reprojection_rms_px": …,
/// "joints_left_out": […]}, …], "warnings": […]}. dots and dots_recognised count the dots of a view
/// over all frames, and in a frame those of each view. Reprojection errors are those of dots, in
/// pixels of the cameras, and null where none is recognised.
///
/// The verdict is doubtful where a warning says what to look at, and failed where the body is not
/// recognised in more than half of the frames.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The films, one for each view: names, or patterns with `*`, `?` or `[abc]`.
    #[arg(value_name = "FILM", required = true)]
    pub(super) films: Vec<PathBuf>,
    #[command(flatten)]
    pub(super) cameras: CameraFiles,
    /// The file of joints to be written.
    #[arg(long, value_name = "JOINTS.json")]
    pub(super) out: PathBuf,
    #[command(flatten)]
    pub(super) character: DottedCharacter,
    #[command(flatten)]
    pub(super) check: Check,
}

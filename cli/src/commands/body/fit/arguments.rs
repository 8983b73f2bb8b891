//! The options of the command.

use std::path::PathBuf;

use crate::frame::Check;
use crate::person::{CameraFiles, FitLengths, JointFiles};

/// Fit a character to the joints of a person that calibrated views show, one or more.
///
/// The most likely poses are searched: those in which the character's joints, with bones of its own
/// lengths, are seen nearest to where the views show them. Frames are fitted together, so that body
/// and joints do not accelerate more than the clip shows them to; with --independent each is fitted
/// by itself. The character has the size of the person, in metres, or is given it by --fit-lengths.
///
/// The joints are in one file for all views, or in a detector's file or folder for each view: lists
/// of COCO and AlphaPose, a folder of OpenPose (JSON of one frame a file, as Pose2Sim writes too)
/// or MMPose, a film of MMPose or MediaPipe Pose, or CSV of DeepLabCut. What a file is follows from
/// what it holds, and the names of joints from the file or their number: 17 (coco17), 18 (coco18),
/// 25 (body25), 26 (halpe26), 33 (mediapipe), 133 (coco133), 135 (body135) or 136 (halpe136).
/// --model names others. Numbers of pictures that a detector left out are frames in which no joint
/// is seen; warnings say how many. The file for all views is
///
///   {"version": 1, "frames_per_second": 120, "deviation_px": 2, "joints": ["Hips", "Head", …],
///    "views": [{"name": "left", "frames": [[[640.5, 360.2], null, …], …]},
///              {"name": "right", "frames": [[[602.1, 360.0], [601.7, 48.3], …], …]}]}
///
/// with [u, v] in pixels from the centre of the top left one for each joint in each frame, or null
/// where the view does not show it, or [u, v, deviation] with its own standard deviation. Joints
/// have the names of the character's, or those that `nullcone animate` understands.
///
/// The cameras are in a file of any format (--rig), in the order of the views: a stereo rig for
/// two, such as OpenCV's YAML, a camera for one. For more, --views has the file of `nullcone render
/// --views`: each view belongs to the picture of its name, with or without the ending, such as the
/// view "view-003" or view-003.json to view-003.png; where no name is that of a picture, they are
/// in one order.
///
/// The result is binary glTF with the character's skin and one animation. With --rig the first
/// camera is at the origin and looks along −z, with x to the right and y up; with --views the
/// character stands in the coordinates of that file. To see the frame at 0.5 s:
///
///   nullcone skin fitted.glb --animation 0 --time 0.5 --method motor --out frame.obj
///   nullcone render frame.obj --out frame.png
///
/// For instance
///
///   nullcone body fit --joints J.json --rig rig.yml --character person.glb --out fitted.glb --json
///
/// prints {"character": "person.glb", "out": "fitted.glb", "views": 2, "frames": …,
/// "frames_per_second": …, "joints": […], "joints_without_counterpart": […],
/// "reprojection_rms_px": …, "reprojection_max_px": …, "joints_unseen": …,
/// "frames_with_unseen_joints": …, "milliseconds_per_frame": …, "per_view": [{"name": …,
/// "joints_seen": …, "reprojection_rms_px": …}, …], "per_frame": [{"reprojection_rms_px": …,
/// "joints_unseen": […]}, …]}. joints_without_counterpart are joints of the file that the skeleton
/// does not have; joints_unseen counts joints that no view shows, over all frames.
/// milliseconds_per_frame is that of the fit with all threads. --fit-lengths adds "length_factors",
/// for each joint by how much longer the way from the joint above it has become.
///
/// The verdict is good, or doubtful where a view or a frame is fitted badly: the distances from its
/// pixels are more than three of their standard deviations as the root mean square.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    pub(super) joints: JointFiles,
    #[command(flatten)]
    pub(super) cameras: CameraFiles,
    /// The character: a skinned mesh in glTF, or `mannequin` for the person of `nullcone demo`.
    #[arg(long, value_name = "C.glb|mannequin")]
    pub(super) character: PathBuf,
    /// The file to be written.
    #[arg(long, value_name = "OUT.glb")]
    pub(super) out: PathBuf,
    /// Give the character the lengths of the person, which two views or more show: a factor for the
    /// whole body (size), or one for each bone (bones, also without a word).
    #[arg(
        long,
        value_enum,
        value_name = "WHAT",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "bones"
    )]
    pub(super) fit_lengths: Option<FitLengths>,
    /// Fit each frame by itself.
    #[arg(long)]
    pub(super) independent: bool,
    #[command(flatten)]
    pub(super) check: Check,
}

//! The options of the command.

use std::path::PathBuf;

use crate::frame::Check;
use crate::person::{CameraFiles, FitLengths, JointFiles, MANNEQUIN};

/// Make an animated character of films of a person, in which a detector found the joints.
///
/// The person is seen by calibrated cameras, one or more. A character with the person's lengths is
/// fitted to the joints in all frames together, and stands on the floor with y up, in metres. The
/// joints and the cameras are those of `nullcone body fit`, whose help describes their files.
/// Before the fit, left and right are put in order where views exchange them, and it is found how
/// the cameras and the times of the views stand to each other: warnings say where they do not fit
/// together, and --refine-cameras and --synchronise put that right.
///
/// The films are for looking at: one for each view, in the order of the views of the joints, as
/// Y4M, MP4 and what else ffmpeg reads where it is installed (H.264 in MP4 also where the program
/// was built with the feature `mp4`), folders of numbered pictures or patterns. There may be fewer,
/// or none. They may be smaller than the pictures of the cameras, where the file of these says
/// their size.
///
/// The folder of --out gets, all or nothing:
///
///   character.glb      the character with the motion as its first animation
///   motion.bvh         the motion of its joints
///   joints.csv         where the joints are, in metres: frame,time_seconds,NAME_x,NAME_y,NAME_z,…
///   joints.trc         the same for OpenSim, in millimetres
///   overlay-VIEW.y4m   each film with the body drawn over it; .mp4 with the feature `mp4`
///   report.html        how good it is, with the figure that plays beside the films
///   report.json        what --json prints
///
/// In the overlays the person's left is blue, the right orange and the middle grey; found joints
/// are white dots, and a cross is a joint that was found more than three of its standard deviations
/// away from where the body has it.
///
/// For instance
///
///   nullcone people a.mp4 b.mp4 --joints a.json b.json --views VIEWS.json --out person --json
///
/// prints {"verdict": "good", "character": "mannequin", "out": "person", "frames": …,
/// "frames_per_second": …, "views": [{"name": …, "joints_seen": …, "reprojection_median_px": …,
/// "reprojection_rms_px": …, "offset_frames": …, "offset_deviation_frames": …,
/// "rotation_degrees": …, "rotation_deviation_degrees": …, "frames_with_exchanged_sides": […],
/// "film": …, "film_frames": …}, …],
/// "bones": [{"joint": …, "length_metres": …, "deviation_metres": …}, …], "contacts": [{"joint": …,
/// "start": …, "end": …, "slide_metres": …}, …], "up": [x, y, z], "up_is": …,
/// "up_deviation_degrees": …, "floor": …, "joints": […], "joints_without_counterpart": […],
/// "reprojection_median_px": …, …, "per_frame": […], "files": […], "warnings": […]}. up is the
/// direction in the world of the cameras, and floor the height along it in metres; offset_frames is
/// the frame of the view that shows what frame 0 of the first view shows, and null where the motion
/// does not show it.
///
/// The verdict is doubtful where a warning says what to look at, and failed where the body is far
/// from most joints.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The films: names, or patterns with `*`, `?` or `[abc]`.
    #[arg(value_name = "FILM")]
    pub(super) films: Vec<PathBuf>,
    #[command(flatten)]
    pub(super) joints: JointFiles,
    #[command(flatten)]
    pub(super) cameras: CameraFiles,
    /// The character: a skinned mesh in glTF, or `mannequin` for the person of `nullcone demo`.
    #[arg(long, value_name = "C.glb|mannequin", default_value = MANNEQUIN)]
    pub(super) character: PathBuf,
    /// The folder that the files are written to; it is created where it is missing.
    #[arg(long, value_name = "DIR")]
    pub(super) out: PathBuf,
    /// Which lengths of the character become those of the person; by default those of all bones
    /// where there are two views or more, which show them, and none where there is one.
    #[arg(long, value_enum, value_name = "WHAT")]
    pub(super) fit_lengths: Option<FitLengths>,
    /// Shift the views in time where their motions show that they do not begin together.
    #[arg(long)]
    pub(super) synchronise: bool,
    /// Rotate the cameras a little where the joints show that the calibration is off. Their places
    /// stay, which joints hardly show.
    #[arg(long)]
    pub(super) refine_cameras: bool,
    /// The direction that is up in the world of the cameras: an axis such as `z` or `-y`, or three
    /// numbers `X,Y,Z`. By default it is found by feet that stand and by the posture.
    #[arg(long, value_name = "AXIS|X,Y,Z", value_parser = up, allow_hyphen_values = true)]
    pub(super) up: Option<[f64; 3]>,
    /// The height of the floor, along the direction that is up from the origin of the cameras'
    /// world. By default it is found by feet that stand.
    #[arg(long, value_name = "METRES")]
    pub(super) floor: Option<f64>,
    /// Write no films with the body drawn over them; the page has them nevertheless.
    #[arg(long)]
    pub(super) no_overlay: bool,
    /// Write the film with the body drawn over it of this view alone, and no other file: a task for
    /// each view, beside one with --no-overlay, writes what one process writes.
    #[arg(long, value_name = "NAME", conflicts_with = "no_overlay")]
    pub(super) overlay_of: Option<String>,
    #[command(flatten)]
    pub(super) check: Check,
}

/// A direction, as an axis or by its coordinates.
fn up(text: &str) -> Result<[f64; 3], String> {
    let axis = text.strip_prefix('-').unwrap_or(text);
    if let Some(axis) = ["x", "y", "z"].iter().position(|name| *name == axis) {
        let length = if text.starts_with('-') { -1.0 } else { 1.0 };
        let mut up = [0.0; 3];
        up[axis] = length;
        return Ok(up);
    }
    let numbers = text
        .split(',')
        .map(|word| word.trim().parse().ok().filter(|x: &f64| x.is_finite()));
    let numbers: Option<Vec<f64>> = numbers.collect();
    match numbers.as_deref() {
        Some(&[x, y, z]) if [x, y, z] != [0.0; 3] => Ok([x, y, z]),
        _ => Err("an axis such as z or -y, or three numbers X,Y,Z that are not all 0".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::up;

    #[test]
    fn directions_are_axes_or_coordinates() {
        assert_eq!(up("z"), Ok([0.0, 0.0, 1.0]));
        assert_eq!(up("-y"), Ok([0.0, -1.0, 0.0]));
        assert_eq!(up("0.5,-2, 1e-3"), Ok([0.5, -2.0, 0.001]));
        for wrong in [
            "", "w", "--z", "1,2", "0,0,0", "1,2,3,4", "1,nan,0", "inf,0,0",
        ] {
            assert!(up(wrong).is_err(), "{wrong}");
        }
    }
}

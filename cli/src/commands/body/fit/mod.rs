//! `nullcone body fit`: a character in the pose of a person in views.

mod cameras;
mod report;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use clap::ValueEnum;
use ga_anim::clip::Clip;
use ga_anim::gltf::{Rigged, character};
use ga_anim::pose::Pose;
use ga_anim::skeleton::Skeleton;
use ga_body::format::correspondence::correspondence;
use ga_body::format::{DetectorOptions, JointViews};
use ga_body::{BodyFit, BodyModel, FittedPose, Lengths, Observation, fit_lengths};
use ga_camera::Camera;
use ga_mannequin::Human;
use ga_mesh::gltf;

use crate::figure::Figure;
use crate::files::Files;
use crate::format::Format;
use crate::progress::Progress;
use crate::{model, output};
use cameras::CameraFiles;
use report::Report;

/// Fit a character to the joints of a person that calibrated views show, one or more.
///
/// The most likely poses are searched: those in which the character's joints, with bones of its own
/// lengths, are seen nearest to where the views show them. Frames are fitted together, so that body
/// and joints do not accelerate more than the clip shows them to; with --independent each is fitted
/// by itself. The character has the size of the person, in metres, or is given it by --fit-lengths.
///
/// The joints are in one file for all views, or in a file or folder of COCO or OpenPose for each
/// view. The file for all views is
///
///   {"version": 1, "frames_per_second": 120, "deviation_px": 2, "joints": ["Hips", "Head", …],
///    "views": [{"name": "left", "frames": [[[640.5, 360.2], null, …], …]},
///              {"name": "right", "frames": [[[602.1, 360.0], [601.7, 48.3], …], …]}]}
///
/// with [u, v] in pixels from the centre of the top left one for each joint in each frame, or null
/// where the view does not show it, or [u, v, deviation] with its own standard deviation. Joints
/// have the names of the character's, or those that `nullcone animate` understands.
///
/// The cameras are in OpenCV's YAML (--rig), in the order of the views: a stereo rig for two, a
/// camera for one. For more, --views has the file of `nullcone render --views`: each view belongs
/// to the picture of its name, with or without the ending, such as the view "view-003" or
/// view-003.json to view-003.png; where no name is that of a picture, they are in one order.
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
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The joints in the views: one file, or a file or folder for each view.
    #[arg(long, value_name = "J.json", required = true, num_args = 1..)]
    joints: Vec<PathBuf>,
    #[command(flatten)]
    cameras: CameraFiles,
    /// The character: a skinned mesh in glTF, or `mannequin` for the person of `nullcone demo`.
    #[arg(long, value_name = "C.glb|mannequin")]
    character: PathBuf,
    /// The file to be written.
    #[arg(long, value_name = "OUT.glb")]
    out: PathBuf,
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
    fit_lengths: Option<FitLengths>,
    /// Frames a second, where the joints do not state it; 30 where nothing does.
    #[arg(long, value_name = "RATE", allow_negative_numbers = true)]
    fps: Option<f64>,
    /// The standard deviation of a detector's joints of confidence 1, for COCO and OpenPose.
    #[arg(
        long,
        value_name = "PX",
        default_value_t = DetectorOptions::default().deviation_px,
        allow_negative_numbers = true
    )]
    deviation: f64,
    /// Which person of each picture, from 0 in the order of the file, for COCO and OpenPose; by
    /// default the one with the greatest sum of confidences.
    #[arg(long, value_name = "N")]
    person: Option<usize>,
    /// Fit each frame by itself.
    #[arg(long)]
    independent: bool,
    /// Print one JSON object instead of lines.
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum FitLengths {
    /// One factor for the whole body.
    Size,
    /// A factor for each bone.
    Bones,
}

/// The name of the person that the program makes itself.
const MANNEQUIN: &str = "mannequin";
const DEFAULT_RATE: f64 = 30.0;

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    let inputs = arguments.joints.iter().chain(arguments.cameras.path());
    let mut files = Files::reading(inputs).printing("--json", arguments.json);
    if !is_mannequin(&arguments.character) {
        files = files.and_reading([&arguments.character]);
    }
    files.write("--out", &arguments.out, &[Format::Glb])?;
    let deviation = arguments.deviation;
    ensure!(
        deviation > 0.0 && deviation.is_finite(),
        "--deviation {deviation}: a standard deviation in pixels is greater than 0 and finite"
    );
    let progress = Progress::new(5, quiet);
    progress.step("reading");
    let options = DetectorOptions {
        deviation_px: deviation,
        person: arguments.person,
        ..DetectorOptions::default()
    };
    let joints = JointViews::read(&arguments.joints, &options)?;
    let cameras = arguments.cameras.read(&joints)?;
    let mut body = read_character(&arguments.character)?;
    let rate = arguments
        .fps
        .or(joints.frames_per_second())
        .unwrap_or(DEFAULT_RATE);
    ensure!(
        rate > 0.0 && rate.is_finite(),
        "--fps {rate}: the number of frames per second must be greater than 0 and finite"
    );
    let of_joints = || names(&arguments.joints);
    let mut matched = Matched::new(&joints, body.skeleton()).with_context(of_joints)?;
    let observations: Vec<Observation> = (0..joints.frame_count())
        .filter_map(|frame| joints.observation(frame, &matched.order))
        .collect();

    if let Some(lengths) = arguments.fit_lengths {
        progress.step("fitting lengths");
        let fitted = matched.fit_lengths(&body, &cameras, &observations, lengths);
        body = fitted.with_context(of_joints)?;
    }
    progress.step("fitting poses");
    let begin = Instant::now();
    let fitted = fit(
        &matched.model,
        &cameras,
        &observations,
        rate,
        arguments.independent,
        &progress,
    )
    .with_context(of_joints)?;
    let seconds = begin.elapsed().as_secs_f64();

    progress.step("writing");
    let poses = fitted.iter().map(|fit| fit.pose.clone()).collect();
    let clip = Clip::new(1.0 / rate, poses)?;
    let document = body.with_clip("fitted", &clip);
    let document = document.with_context(|| arguments.character.display().to_string())?;
    let contents = gltf::to_glb(&document).context("the fitted character cannot be written")?;
    output::write(&arguments.out, &contents)?;
    drop(progress);
    let report = Report::new(arguments, &joints, &matched, &fitted, [rate, seconds]);
    match (arguments.json, quiet) {
        (true, _) => output::print_json(&report),
        (false, true) => Ok(()),
        (false, false) => output::print(&report.lines()),
    }
}

fn names(paths: &[PathBuf]) -> String {
    let names: Vec<String> = paths
        .iter()
        .map(|path| path.display().to_string())
        .collect();
    names.join(", ")
}

/// Whether a character is the one that the program makes itself. A file of that name is written
/// with its folder, as in `./mannequin`.
fn is_mannequin(path: &Path) -> bool {
    path.as_os_str() == MANNEQUIN
}

/// The character that is fitted.
fn read_character(path: &Path) -> Result<Rigged> {
    if is_mannequin(path) {
        return mannequin();
    }
    let shown = || path.display().to_string();
    let document = gltf::read(path)?;
    // Without a skin there is no body to be posed.
    character(&document).with_context(shown)?;
    Rigged::new(&document).with_context(shown)
}

/// The person that the program makes itself, as one from a file.
fn mannequin() -> Result<Rigged> {
    let Human {
        mesh,
        skeleton,
        weights,
    } = Human::new();
    let rest = Clip::new(1.0, vec![Pose::rest(skeleton.len())])?;
    let figure = Figure {
        name: MANNEQUIN.to_owned(),
        mesh,
        skeleton,
        weights,
        paint: None,
    };
    let document = gltf::parse(&model::glb(&figure, &rest, MANNEQUIN, None)?)?;
    Ok(Rigged::new(&document)?)
}

/// The joints of a file that a skeleton has.
struct Matched {
    model: BodyModel,
    /// For each point of the model which joint of the file it is.
    order: Vec<Option<usize>>,
    without_counterpart: Vec<String>,
    /// By the name of the joint, where lengths were fitted.
    length_factors: Option<BTreeMap<String, f64>>,
}

impl Matched {
    fn new(joints: &JointViews, skeleton: &Skeleton) -> Result<Self> {
        let found = correspondence(joints.joints(), skeleton)?;
        let (mut order, mut of_skeleton, mut without_counterpart) = (vec![], vec![], vec![]);
        for (index, (name, joint)) in joints.joints().iter().zip(found).enumerate() {
            match joint {
                Some(joint) => {
                    order.push(Some(index));
                    of_skeleton.push(skeleton.joints()[joint].name.clone());
                }
                None => without_counterpart.push(name.clone()),
            }
        }
        Ok(Self {
            model: BodyModel::of_joints(skeleton.clone(), &of_skeleton)?,
            order,
            without_counterpart,
            length_factors: None,
        })
    }

    /// The character with the lengths that the views show. The model then is that of this
    /// character.
    fn fit_lengths(
        &mut self,
        body: &Rigged,
        cameras: &[Camera],
        observations: &[Observation],
        lengths: FitLengths,
    ) -> Result<Rigged> {
        let lengths = match lengths {
            FitLengths::Size => Lengths::OneFactor,
            FitLengths::Bones => Lengths::EachBone,
        };
        let factors = fit_lengths(&self.model, cameras, observations, lengths)?.factors;
        let body = body.with_lengths(&factors)?;
        let points = self.model.points().iter();
        let names: Vec<String> = points.map(|point| point.name.clone()).collect();
        self.model = BodyModel::of_joints(body.skeleton().clone(), &names)?;
        let joints = body.skeleton().joints().iter();
        let by_name = joints
            .zip(factors)
            .map(|(j, factor)| (j.name.clone(), factor));
        self.length_factors = Some(by_name.collect());
        Ok(body)
    }
}

fn fit(
    model: &BodyModel,
    cameras: &[Camera],
    observations: &[Observation],
    rate: f64,
    independent: bool,
    progress: &Progress,
) -> Result<Vec<FittedPose>> {
    let fit = BodyFit::new(model, cameras)?;
    if !independent {
        return Ok(fit.clip(observations, rate)?);
    }
    let count = observations.len() as u64;
    let frames = observations.iter().enumerate().map(|(frame, observation)| {
        progress.at(frame as u64, count);
        fit.frame(observation)
            .with_context(|| format!("frame {frame}"))
    });
    frames.collect()
}

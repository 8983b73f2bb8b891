//! `nullcone body fit`: a character in the pose of a person in views.

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, Result, bail, ensure};
use ga_anim::clip::Clip;
use ga_anim::gltf::{Rigged, character};
use ga_anim::skeleton::Skeleton;
use ga_mannequin::Human;
use ga_runtime::cga3::{Motor, Rotor};
use ga_vision::body::format::correspondence::correspondence;
use ga_vision::body::format::{DetectorOptions, JointViews};
use ga_vision::body::{BodyFit, BodyModel, FittedPose, Observation};
use ga_vision::camera::Camera;
use ga_vision::format::camera::CameraFile;
use ga_vision::format::rig::RigFile;
use serde::Serialize;

use crate::figure::Figure;
use crate::progress::Progress;
use crate::{model, output};

/// Fit a character to the joints of a person that one or two calibrated views show.
///
/// The most likely poses are searched: those in which the character's joints, with bones of its own
/// lengths, are seen nearest to where the views show them. Frames are fitted together, so that body
/// and joints do not accelerate more than the clip shows them to; with --independent each is fitted
/// by itself.
///
/// The joints are in one file for all views, or in a file or folder of COCO or OpenPose for each
/// view in the order of the rig. Two views need a stereo rig and one view a camera, in OpenCV's
/// YAML. The character has the size of the person, in metres.
///
/// The result is binary glTF with the character's skin and one animation. It stands in front of
/// the first camera, which is at the origin and looks along −z, with x to the right and y up.
///
/// For instance
///
///   nullcone body fit --joints J.json --rig rig.yml --character person.glb --out fitted.glb --json
///
/// prints {"character": "person.glb", "out": "fitted.glb", "views": 2, "frames": …,
/// "frames_per_second": …, "joints": […], "joints_without_counterpart": […], "reprojection_rms_px":
/// …, "reprojection_max_px": …, "joints_unseen": …, "frames_with_unseen_joints": …,
/// "milliseconds_per_frame": …, "per_frame": [{"reprojection_rms_px": …, "joints_unseen": […]},
/// …]}. joints_without_counterpart are joints of the file that the skeleton does not have;
/// joints_unseen counts joints that no view shows, over all frames.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The joints in the views.
    #[arg(long, value_name = "J.json", required = true, num_args = 1..)]
    joints: Vec<PathBuf>,
    /// The cameras: a stereo rig for two views, a camera for one.
    #[arg(long, value_name = "rig.yml")]
    rig: PathBuf,
    /// The character: a skinned mesh in glTF, or `mannequin` for the person of `nullcone demo`.
    #[arg(long, value_name = "C.glb|mannequin")]
    character: PathBuf,
    /// The file to be written.
    #[arg(long, value_name = "OUT.glb")]
    out: PathBuf,
    /// Frames a second, where the joints do not state it; 30 where nothing does.
    #[arg(long, value_name = "RATE", allow_negative_numbers = true)]
    fps: Option<f64>,
    /// The standard deviation of a detector's joints of confidence 1, for COCO and OpenPose.
    #[arg(long, value_name = "PX", default_value_t = DetectorOptions::default().deviation_px)]
    deviation: f64,
    /// Fit each frame by itself.
    #[arg(long)]
    independent: bool,
    /// Print one JSON object instead of lines.
    #[arg(long)]
    json: bool,
}

/// What is printed.
#[derive(Serialize)]
struct Report {
    character: String,
    out: String,
    views: usize,
    frames: usize,
    frames_per_second: f64,
    joints: Vec<String>,
    joints_without_counterpart: Vec<String>,
    reprojection_rms_px: f64,
    reprojection_max_px: f64,
    joints_unseen: usize,
    frames_with_unseen_joints: usize,
    milliseconds_per_frame: f64,
    per_frame: Vec<FrameReport>,
}

#[derive(Serialize)]
struct FrameReport {
    reprojection_rms_px: f64,
    joints_unseen: Vec<String>,
}

/// The name of the person that the program makes itself.
const MANNEQUIN: &str = "mannequin";
const DEFAULT_RATE: f64 = 30.0;

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    let ending = arguments.out.extension().unwrap_or_default();
    ensure!(
        ending.eq_ignore_ascii_case("glb"),
        "--out {}: the fitted character is a file of the kind .glb",
        arguments.out.display()
    );
    let progress = Progress::new(4, quiet);
    progress.step("reading");
    let options = DetectorOptions {
        deviation_px: arguments.deviation,
        ..DetectorOptions::default()
    };
    let joints = JointViews::read(&arguments.joints, &options)?;
    let cameras = cameras(&arguments.rig, joints.views().len())?;
    let body = Body::read(&arguments.character)?;
    let rate = arguments
        .fps
        .or(joints.frames_per_second())
        .unwrap_or(DEFAULT_RATE);
    ensure!(
        rate > 0.0 && rate.is_finite(),
        "--fps {rate}: the number of frames per second must be greater than 0 and finite"
    );
    let matched =
        Matched::new(&joints, body.skeleton()).with_context(|| names(&arguments.joints))?;
    let observations: Vec<Observation> = (0..joints.frame_count())
        .filter_map(|frame| joints.observation(frame, &matched.order))
        .collect();

    progress.step("fitting");
    let begin = Instant::now();
    let fitted = fit(
        &matched.model,
        &cameras,
        &observations,
        rate,
        arguments.independent,
        &progress,
    )
    .with_context(|| names(&arguments.joints))?;
    let seconds = begin.elapsed().as_secs_f64();

    progress.step("writing");
    let poses = fitted.iter().map(|fit| fit.pose.clone()).collect();
    let clip = Clip::new(1.0 / rate, poses)?;
    let contents = body
        .to_glb(&clip)
        .context("the fitted character cannot be written")?;
    ga_files::write(&arguments.out, &contents)?;
    drop(progress);
    let report = Report::new(arguments, &matched, &fitted, [rate, seconds], cameras.len());
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

/// The cameras of so many views, in a world with y up.
fn cameras(path: &Path, views: usize) -> Result<Vec<Camera>> {
    let found = match views {
        1 => vec![Camera {
            intrinsics: CameraFile::read(path)?.intrinsics,
            world_to_camera: Motor::default(),
        }],
        2 => {
            let rig = RigFile::read(path)?.rig;
            vec![rig.left, rig.right]
        }
        _ => bail!(
            "{}: the joints are in {views} views, and a rig has one camera or two",
            path.display()
        ),
    };
    // From y up and z backwards to y down and z forwards.
    let half_turn_about_x = Rotor::new_unchecked(0.0, 0.0, 0.0, -1.0);
    let upright = found.into_iter().map(|camera| Camera {
        world_to_camera: camera.world_to_camera * Motor::from(half_turn_about_x),
        ..camera
    });
    Ok(upright.collect())
}

/// The character that is fitted.
enum Body {
    Made(Box<Figure>),
    Read(Box<Rigged>),
}

impl Body {
    fn read(path: &Path) -> Result<Self> {
        if path.as_os_str() == MANNEQUIN && !path.exists() {
            let Human {
                mesh,
                skeleton,
                weights,
            } = Human::new();
            return Ok(Self::Made(Box::new(Figure {
                name: MANNEQUIN.to_owned(),
                mesh,
                skeleton,
                weights,
                paint: None,
            })));
        }
        let shown = || path.display().to_string();
        let document = ga_mesh::gltf::read(path)?;
        // Without a skin there is no body to be posed.
        character(&document).with_context(shown)?;
        let rigged = Rigged::new(&document).with_context(shown)?;
        Ok(Self::Read(Box::new(rigged)))
    }

    fn skeleton(&self) -> &Skeleton {
        match self {
            Self::Made(figure) => &figure.skeleton,
            Self::Read(rigged) => rigged.skeleton(),
        }
    }

    fn to_glb(&self, clip: &Clip) -> Result<Vec<u8>> {
        const NAME: &str = "fitted";
        match self {
            Self::Made(figure) => model::glb(figure, clip, NAME, None),
            Self::Read(rigged) => Ok(ga_mesh::gltf::to_glb(&rigged.with_clip(NAME, clip)?)?),
        }
    }
}

/// The joints of a file that a skeleton has.
struct Matched {
    model: BodyModel,
    /// For each point of the model which joint of the file it is.
    order: Vec<Option<usize>>,
    without_counterpart: Vec<String>,
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
        })
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

impl Report {
    fn new(
        arguments: &Arguments,
        matched: &Matched,
        fitted: &[FittedPose],
        [frames_per_second, seconds]: [f64; 2],
        views: usize,
    ) -> Self {
        let points = matched.model.points();
        let per_frame = fitted.iter().map(|fit| FrameReport {
            reprojection_rms_px: fit.root_mean_square_px,
            joints_unseen: fit
                .unseen
                .iter()
                .map(|&point| points[point].name.clone())
                .collect(),
        });
        let per_frame: Vec<FrameReport> = per_frame.collect();
        let residuals = fitted
            .iter()
            .flat_map(|fit| fit.residuals_px.iter().flatten().flatten());
        let (sum, max, count) = residuals.fold((0.0, 0.0_f64, 0_usize), |(sum, max, count), x| {
            (sum + x * x, max.max(*x), count + 1)
        });
        let unseen = per_frame.iter().map(|frame| frame.joints_unseen.len());
        Self {
            character: arguments.character.display().to_string(),
            out: arguments.out.display().to_string(),
            views,
            frames: fitted.len(),
            frames_per_second,
            joints: points.iter().map(|point| point.name.clone()).collect(),
            joints_without_counterpart: matched.without_counterpart.clone(),
            reprojection_rms_px: (sum / count.max(1) as f64).sqrt(),
            reprojection_max_px: max,
            joints_unseen: unseen.clone().sum(),
            frames_with_unseen_joints: unseen.filter(|count| *count > 0).count(),
            milliseconds_per_frame: 1e3 * seconds / fitted.len().max(1) as f64,
            per_frame,
        }
    }

    fn lines(&self) -> String {
        let mut lines = format!(
            "{}: {} frames of {} joints in {} views\n",
            self.out,
            self.frames,
            self.joints.len(),
            self.views
        );
        lines += &format!(
            "reprojection   {:.2} px RMS, {:.2} px at most\n",
            self.reprojection_rms_px, self.reprojection_max_px
        );
        lines += &format!(
            "unseen         {} joints in {} frames\n",
            self.joints_unseen, self.frames_with_unseen_joints
        );
        lines += &format!(
            "time           {:.2} ms a frame\n",
            self.milliseconds_per_frame
        );
        if !self.joints_without_counterpart.is_empty() {
            let names = self.joints_without_counterpart.join(", ");
            lines += &format!("not of the skeleton: {names}\n");
        }
        lines
    }
}

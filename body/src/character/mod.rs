//! A character in the poses of a person whose joints views show.

use std::collections::BTreeMap;
use std::time::Instant;

use ga_anim::MotionFileError;
use ga_anim::clip::Clip;
use ga_anim::gltf::Rigged;
use ga_anim::motion_file::Loss;
use ga_anim::recording::RecordingError;
use ga_camera::Camera;
use ga_mesh::gltf::Document;
use serde::Serialize;

use crate::agreement::Agreement;
use crate::fit::{BodyFit, FittedPose};
use crate::format::correspondence::correspondence;
use crate::format::{JointView, JointViews};
use crate::lengths::{Lengths, fit_lengths};
use crate::mean_square::MeanSquare;
use crate::{BodyError, BodyModel, Observation};

/// The fit of a character to the joints of a person.
///
/// ```
/// use ga_anim::gltf::Rigged;
/// use ga_anim::skeleton::{Joint, Skeleton};
/// use ga_body::character::CharacterFit;
/// use ga_body::format::JointViews;
/// use ga_camera::{Camera, Intrinsics};
///
/// let joint = |name: &str, parent, y: f64| Joint {
///     name: name.into(),
///     parent,
///     head: [0.0, y, 0.0],
///     tail: [0.0, y + 0.3, 0.0],
/// };
/// let arm = Rigged::of_skeleton(&Skeleton::new(vec![
///     joint("Shoulder", None, 0.0),
///     joint("Elbow", Some(0), 0.3),
///     joint("Wrist", Some(1), 0.6),
/// ])?);
/// // 4 m in front of a camera, and upright.
/// let joints = JointViews::decode(br#"{"version": 1, "joints": ["Shoulder", "Elbow", "Wrist"],
///     "views": [{"name": "front", "frames": [[[0, 0], [0, -75], [0, -150]]]}]}"#)?;
/// let intrinsics = Intrinsics::new([1000.0, 1000.0], [0.0, 0.0])?;
/// let (eye, target) = ([0.0, 0.0, 4.0].into(), [0.0, 0.0, 0.0].into());
/// let camera = Camera::look_at(intrinsics, eye, target, [0.0, 1.0, 0.0]).ok_or("no direction")?;
///
/// let fitted = CharacterFit::new(arm, &joints, &[camera])?.fit(30.0, true, |_, _| ())?;
/// assert_eq!(fitted.report.joints, ["Shoulder", "Elbow", "Wrist"]);
/// assert!(fitted.report.reprojection_rms_px < 0.1);
/// assert_eq!(fitted.to_document("pose")?.0.animations.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct CharacterFit<'a> {
    character: Rigged,
    joints: &'a JointViews,
    cameras: &'a [Camera],
    model: BodyModel,
    observations: Vec<Observation>,
    without_counterpart: Vec<String>,
    /// By the name of the joint, where lengths were fitted.
    length_factors: Option<BTreeMap<String, f64>>,
}

/// A character in the poses of a person.
#[derive(Clone, Debug)]
pub struct FittedCharacter {
    /// The character, with the lengths of the person where they were fitted.
    pub character: Rigged,
    /// For each frame the pose of the character.
    pub poses: Vec<FittedPose>,
    /// How far the poses are from the pixels, in standard deviations of these.
    pub agreement: Agreement,
    /// What was found.
    pub report: CharacterReport,
}

/// What was found of a person.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CharacterReport {
    /// The number of views.
    pub views: usize,
    /// The number of frames.
    pub frames: usize,
    /// The frame rate of the animation.
    pub frames_per_second: f64,
    /// The names of the character's joints that were fitted.
    pub joints: Vec<String>,
    /// The names of joints of the person that the character does not have.
    pub joints_without_counterpart: Vec<String>,
    /// The root mean square of the distances from pixels.
    pub reprojection_rms_px: f64,
    /// The greatest of these distances.
    pub reprojection_max_px: f64,
    /// How many joints no view shows, over all frames.
    pub joints_unseen: usize,
    /// In how many frames there are such joints.
    pub frames_with_unseen_joints: usize,
    /// The time of the fit, with all threads.
    pub milliseconds_per_frame: f64,
    /// Where lengths were fitted, by the name of each joint by how much longer the way from the
    /// joint above it has become.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length_factors: Option<BTreeMap<String, f64>>,
    /// One for each view.
    pub per_view: Vec<ViewReport>,
    /// One for each frame.
    pub per_frame: Vec<FrameReport>,
}

/// What was found in a view.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ViewReport {
    /// The name of the view.
    pub name: String,
    /// How many joints it shows, over all frames.
    pub joints_seen: usize,
    /// The root mean square of the distances from its pixels.
    pub reprojection_rms_px: f64,
}

/// What was found in a frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FrameReport {
    /// The root mean square of the distances from its pixels, over all views.
    pub reprojection_rms_px: f64,
    /// The names of the joints that no view shows.
    pub joints_unseen: Vec<String>,
}

impl<'a> CharacterFit<'a> {
    /// A character, and the joints of a person in the views of cameras. Joints are matched by their
    /// [names](mod@crate::format::correspondence).
    ///
    /// # Errors
    /// [`BodyError::UnknownJoint`] and [`BodyError::TooFewJoints`].
    pub fn new(
        character: Rigged,
        joints: &'a JointViews,
        cameras: &'a [Camera],
    ) -> Result<Self, BodyError> {
        let skeleton = character.skeleton();
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
        let frames = 0..joints.frame_count();
        Ok(Self {
            model: BodyModel::of_joints(skeleton.clone(), &of_skeleton)?,
            observations: frames
                .filter_map(|frame| joints.observation(frame, &order))
                .collect(),
            character,
            joints,
            cameras,
            without_counterpart,
            length_factors: None,
        })
    }

    /// Gives the character the lengths of the person, which two views or more show.
    ///
    /// # Errors
    /// Those of [`fit_lengths`], and [`BodyError::Character`].
    pub fn fit_lengths(&mut self, lengths: Lengths) -> Result<(), BodyError> {
        let fitted = fit_lengths(&self.model, self.cameras, &self.observations, lengths)?;
        let factors = fitted.factors;
        self.character = self.character.with_lengths(&factors)?;
        let skeleton = self.character.skeleton();
        self.model = BodyModel::of_joints(skeleton.clone(), &self.joint_names())?;
        let joints = skeleton.joints().iter();
        let names = joints.map(|joint| joint.name.clone());
        self.length_factors = Some(names.zip(factors).collect());
        Ok(())
    }

    /// The most likely poses: of a clip that is smooth over time, or of each frame by itself. For
    /// these, `done` is told how many frames of how many are fitted.
    ///
    /// # Errors
    /// Those of [`BodyFit::clip`], [`BodyError::FrameRate`] among them; where a frame cannot be
    /// fitted by itself, [`BodyError::Frame`].
    pub fn fit(
        self,
        frames_per_second: f64,
        independent: bool,
        mut done: impl FnMut(usize, usize),
    ) -> Result<FittedCharacter, BodyError> {
        if !(frames_per_second > 0.0 && frames_per_second.is_finite()) {
            return Err(BodyError::FrameRate(frames_per_second));
        }
        let begin = Instant::now();
        let fit = BodyFit::new(&self.model, self.cameras)?;
        let count = self.observations.len();
        let poses = if independent {
            let frames = self.observations.iter().enumerate();
            let poses = frames.map(|(frame, observation)| {
                done(frame, count);
                fit.frame(observation).map_err(|error| BodyError::Frame {
                    frame,
                    error: Box::new(error),
                })
            });
            poses.collect::<Result<_, _>>()?
        } else {
            fit.clip(&self.observations, frames_per_second)?
        };
        let seconds = begin.elapsed().as_secs_f64();
        Ok(FittedCharacter {
            agreement: Agreement::new(&poses, &self.observations),
            report: self.report(&poses, frames_per_second, seconds),
            character: self.character,
            poses,
        })
    }

    /// The names of the joints that are fitted.
    fn joint_names(&self) -> Vec<String> {
        let points = self.model.points().iter();
        points.map(|point| point.name.clone()).collect()
    }

    fn report(
        &self,
        poses: &[FittedPose],
        frames_per_second: f64,
        seconds: f64,
    ) -> CharacterReport {
        let joints = self.joint_names();
        let of_frame = |fit: &FittedPose| FrameReport {
            reprojection_rms_px: fit.root_mean_square_px,
            joints_unseen: fit.unseen.iter().map(|&p| joints[p].clone()).collect(),
        };
        let per_frame: Vec<FrameReport> = poses.iter().map(of_frame).collect();
        let views = self.joints.views().iter().enumerate();
        let of_view = |(view, joints): (usize, &JointView)| {
            let residuals = poses.iter().flat_map(|fit| &fit.residuals_px[view]);
            let residuals: MeanSquare = residuals.copied().flatten().collect();
            ViewReport {
                name: joints.name.clone(),
                joints_seen: residuals.count,
                reprojection_rms_px: residuals.root().unwrap_or(0.0),
            }
        };
        let residuals = poses.iter().flat_map(|fit| fit.residuals_px.as_slice());
        let residuals = residuals.flatten().copied().flatten();
        let unseen = per_frame.iter().map(|frame| frame.joints_unseen.len());
        CharacterReport {
            views: self.joints.views().len(),
            frames: poses.len(),
            frames_per_second,
            joints_without_counterpart: self.without_counterpart.clone(),
            reprojection_rms_px: residuals
                .clone()
                .collect::<MeanSquare>()
                .root()
                .unwrap_or(0.0),
            reprojection_max_px: residuals.fold(0.0, f64::max),
            joints_unseen: unseen.clone().sum(),
            frames_with_unseen_joints: unseen.filter(|count| *count > 0).count(),
            milliseconds_per_frame: 1e3 * seconds / poses.len().max(1) as f64,
            length_factors: self.length_factors.clone(),
            per_view: views.map(of_view).collect(),
            per_frame,
            joints,
        }
    }
}

impl FittedCharacter {
    /// The character with its poses as the first animation, of this name, or one with a number
    /// where another animation has it; and what of the poses is not there.
    ///
    /// # Errors
    /// [`MotionFileError`] where the document of the character cannot hold it.
    pub fn to_document(&self, name: &str) -> Result<(Document, Vec<Loss>), MotionFileError> {
        let poses = self.poses.iter().map(|fit| fit.pose.clone()).collect();
        let clip = Clip::new(1.0 / self.report.frames_per_second, poses);
        let clip = clip.map_err(RecordingError::from)?;
        self.character.with_clip(name, &clip)
    }
}

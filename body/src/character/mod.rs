//! A character in the poses of a person whose joints views show.

mod findings;
mod report;

pub use findings::{Finding, Severity};
pub use report::{BoneReport, CharacterReport, FrameReport, ViewReport};

use std::time::Instant;

use ga_anim::MotionFileError;
use ga_anim::clip::Clip;
use ga_anim::gltf::Rigged;
use ga_anim::motion_file::Loss;
use ga_anim::recording::RecordingError;
use ga_camera::Camera;
use ga_mesh::gltf::Document;
use ga_numerics::order_statistics::median;
use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;

use self::findings::Found;
use crate::agreement::Agreement;
use crate::fit::FittedPose;
use crate::format::correspondence::correspondence;
use crate::format::{JointView, JointViews};
use crate::gap::disagreeing;
use crate::ground::{Ground, GroundOptions};
use crate::landmarks::{Anatomy, SkinPoint};
use crate::lengths::Lengths;
use crate::mean_square::MeanSquare;
use crate::model::BodyPoint;
use crate::person::{FittedPerson, Person};
use crate::registration::{
    RegisteredView, Registration, RegistrationOptions, other_poses, register, resampled,
};
use crate::sides::{Exchanged, pairs};
use crate::{BodyError, BodyModel, JointPixel, Observation};

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
    cameras: Vec<Camera>,
    model: BodyModel,
    /// With sides and times put right.
    observations: Vec<Observation>,
    /// For each point of the model what it is beside a joint.
    skin: Vec<Option<SkinPoint>>,
    without_counterpart: Vec<String>,
    lengths: Option<Lengths>,
    /// In which frames of the views sides were exchanged.
    exchanged: Option<Exchanged>,
    registration: Option<Registration>,
    /// The views whose cameras are in the other pose of a planar board.
    mirrored: Vec<usize>,
    ground: Option<GroundOptions>,
    is_refined: bool,
    is_synchronised: bool,
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
    /// The names of the points of the poses: joints, and points of the skin.
    pub points: Vec<String>,
    /// The cameras as they were used, in the world of the poses.
    pub cameras: Vec<Camera>,
    /// For each frame what the views show of the points, with their sides and times as they were
    /// used.
    pub observations: Vec<Observation>,
    /// What was found.
    pub report: CharacterReport,
    /// What makes the result doubtful, or should be known.
    pub findings: Vec<Finding>,
}

impl<'a> CharacterFit<'a> {
    /// A character, and the joints of a person in the views of cameras. Joints are matched by their
    /// [names](mod@crate::format::correspondence).
    ///
    /// # Errors
    /// [`BodyError::Views`], [`BodyError::UnknownJoint`] and [`BodyError::TooFewJoints`].
    pub fn new(
        character: Rigged,
        joints: &'a JointViews,
        cameras: &[Camera],
    ) -> Result<Self, BodyError> {
        let (expected, found) = (cameras.len(), joints.views().len());
        if expected != found {
            return Err(BodyError::Views { expected, found });
        }
        let skeleton = character.skeleton();
        let found = correspondence(joints.joints(), skeleton)?;
        let anatomy = Anatomy::new(skeleton);
        let (mut order, mut points, mut skin, mut without) = (vec![], vec![], vec![], vec![]);
        for (index, (name, joint)) in joints.joints().iter().zip(found).enumerate() {
            let beside = match joint {
                Some(_) => None,
                None => anatomy.as_ref().and_then(|anatomy| anatomy.point(name)),
            };
            match (joint, &beside) {
                (Some(joint), _) => points.push(BodyPoint::at_joint(skeleton, joint)),
                (None, Some(beside)) => points.push(beside.point.clone()),
                (None, None) => {
                    without.push(name.clone());
                    continue;
                }
            }
            order.push(Some(index));
            skin.push(beside);
        }
        let frames = 0..joints.frame_count();
        Ok(Self {
            model: BodyModel::new(skeleton.clone(), points)?,
            observations: frames
                .filter_map(|frame| joints.observation(frame, &order))
                .collect(),
            character,
            joints,
            cameras: cameras.to_vec(),
            skin,
            exchanged: None,
            registration: None,
            mirrored: Vec::new(),
            ground: None,
            is_refined: false,
            is_synchronised: false,
            without_counterpart: without,
            lengths: None,
        })
    }

    /// Gives the character the lengths of the person, which two views or more show.
    #[must_use]
    pub fn with_lengths(self, lengths: Option<Lengths>) -> Self {
        Self { lengths, ..self }
    }

    /// Finds the ground on which the person stands, and holds feet that stand; the result is in a
    /// world with y up and the floor at y = 0.
    #[must_use]
    pub fn with_ground(self, ground: GroundOptions) -> Self {
        let ground = Some(ground);
        Self { ground, ..self }
    }

    /// Takes of the two poses in which a camera sees a planar board almost alike the one in which
    /// it looks at the board from above without being upside down, where the joints fit that far
    /// better. For worlds in which the board lies on the floor, in a plane of two axes through the
    /// origin. To be asked for before [`registered`](Self::registered).
    ///
    /// Where the middle of the board is, is found by the joints, so that rotations are right to
    /// about a degree. One view does not show it.
    #[must_use]
    pub fn with_board_poses(mut self) -> Self {
        if let Some(found) = other_poses(&self.cameras, &self.observations) {
            (self.cameras, self.mirrored) = found;
        }
        self
    }

    /// Puts left and right in order where views alone show that they are exchanged, and finds how
    /// the views stand to each other in space and time; where it is asked for, the cameras and the
    /// times of the views are those found.
    ///
    /// Nothing is done for one view.
    #[must_use]
    pub fn registered(
        mut self,
        options: &RegistrationOptions,
        refine_cameras: bool,
        synchronise: bool,
    ) -> Self {
        self.put_sides_right();
        self.registration = register(&self.cameras, &self.observations, options);
        let Some(found) = &self.registration else {
            return self;
        };
        (self.is_refined, self.is_synchronised) = (refine_cameras, synchronise);
        if refine_cameras {
            self.cameras.clone_from(&found.cameras);
        }
        if synchronise {
            let offsets = found.views.iter().map(RegisteredView::known_offset);
            self.observations = resampled(&self.observations, &offsets.collect::<Vec<_>>());
        }
        self
    }

    /// How the views stand to each other, where that was asked for and found.
    #[must_use]
    pub fn registration(&self) -> Option<&Registration> {
        self.registration.as_ref()
    }

    fn put_sides_right(&mut self) {
        let pairs = pairs(self.model.points());
        let found = Exchanged::by_views(&self.cameras, &self.observations, &pairs);
        self.observations = found.put_right(&self.observations, &pairs);
        self.exchanged = Some(found);
    }

    /// The most likely poses: of a clip that is smooth over time, or of each frame by itself. For
    /// these, `done` is told how many frames of how many are fitted.
    ///
    /// # Errors
    /// Those of [`BodyFit::clip`](crate::BodyFit::clip), [`BodyError::FrameRate`] among them; where
    /// a frame cannot be fitted by itself, [`BodyError::Frame`].
    pub fn fit(
        mut self,
        frames_per_second: f64,
        independent: bool,
        mut done: impl FnMut(usize, usize),
    ) -> Result<FittedCharacter, BodyError> {
        if !(frames_per_second > 0.0 && frames_per_second.is_finite()) {
            return Err(BodyError::FrameRate(frames_per_second));
        }
        let begin = Instant::now();
        if self.exchanged.is_none() && !independent {
            self.put_sides_right();
        }
        let left_out = match independent {
            true => Vec::new(),
            false => disagreeing(&self.cameras, &self.observations),
        };
        let used = without_views(&self.observations, &left_out);
        let person = Person::new(
            &self.model,
            &self.skin,
            &self.cameras,
            &used,
            frames_per_second,
        );
        let mut fitted = match independent {
            false => person.fit(self.lengths, self.ground.as_ref())?,
            true => person.fit_frames(self.lengths, &mut done)?,
        };
        let seconds = begin.elapsed().as_secs_f64();
        let agreement = Agreement::new(&fitted.poses, &fitted.observations);
        self.measure_views(&left_out, &mut fitted);
        let character = match &fitted.proportions {
            Some(proportions) => self.character.with_lengths(&proportions.factors())?,
            None => self.character.clone(),
        };
        let report = self.report(&fitted, frames_per_second, seconds);
        let to_world = fitted
            .ground
            .as_ref()
            .map_or(Motor::default(), Ground::to_y_up);
        let cameras = self.cameras.iter().map(|camera| Camera {
            world_to_camera: camera.world_to_camera * to_world.reverse(),
            ..*camera
        });
        let cameras: Vec<Camera> = cameras.collect();
        let mut poses = fitted.poses;
        for fit in &mut poses {
            fit.pose.root = to_world * fit.pose.root;
            for point in &mut fit.points {
                *point = to_world.transform(*point);
            }
        }
        let names: Vec<&str> = self
            .joints
            .views()
            .iter()
            .map(|view| view.name.as_str())
            .collect();
        let findings = findings::of(&Found {
            views: &names,
            report: &report,
            agreement: &agreement,
            poses: &poses,
            cameras: &cameras,
            observations: &fitted.observations,
            left_out: &left_out,
            mirrored: &self.mirrored,
            is_synchronised: self.is_synchronised,
            is_refined: self.is_refined,
            registration: self.registration.as_ref(),
            is_on_ground: self.ground.is_none() || report.ground.is_some() || independent,
        });
        Ok(FittedCharacter {
            points: self.point_names(),
            observations: fitted.observations,
            findings,
            agreement,
            cameras,
            report,
            character,
            poses,
        })
    }

    /// What views that were left out show of the poses.
    fn measure_views(&self, views: &[usize], fitted: &mut FittedPerson) {
        for (frame, pose) in fitted.poses.iter_mut().enumerate() {
            for &view in views {
                let pixels = &self.observations[frame].views[view];
                let distance = |(pixel, point): (&Option<JointPixel>, &Point<f64>)| {
                    let [u, v] = self.cameras[view].project(*point).ok()?;
                    let position = (*pixel)?.position;
                    Some((u - position[0]).hypot(v - position[1]))
                };
                pose.residuals_px[view] = pixels.iter().zip(&pose.points).map(distance).collect();
                fitted.observations[frame].views[view].clone_from(pixels);
            }
        }
    }

    /// The frames of a view in which sides were exchanged, by the views alone or by the body.
    fn exchanged_frames(&self, view: usize, fitted: &FittedPerson) -> Vec<usize> {
        let offset = match (&self.registration, self.is_synchronised) {
            (Some(found), true) => found.views[view].known_offset().round() as i64,
            _ => 0,
        };
        let by_views = self.exchanged.as_ref().map(|exchanged| &exchanged.0[view]);
        let by_body = &fitted.exchanged.0[view];
        let is_exchanged = |frame: &usize| {
            let of_body = usize::try_from(*frame as i64 - offset).ok();
            let of_body = of_body
                .and_then(|frame| by_body.get(frame))
                .copied()
                .unwrap_or(false);
            by_views.is_some_and(|by_views| by_views[*frame]) != of_body
        };
        (0..self.joints.frame_count())
            .filter(is_exchanged)
            .collect()
    }

    /// The names of the points that are fitted.
    fn point_names(&self) -> Vec<String> {
        let points = self.model.points().iter();
        points.map(|point| point.name.clone()).collect()
    }

    fn report(
        &self,
        fitted: &FittedPerson,
        frames_per_second: f64,
        seconds: f64,
    ) -> CharacterReport {
        let joints = self.point_names();
        let poses = fitted.poses.as_slice();
        let length_factors = fitted.proportions.as_ref().map(|proportions| {
            let names = self.model.skeleton().joints().iter();
            let names = names.map(|joint| joint.name.clone());
            names.zip(proportions.factors()).collect()
        });
        let of_frame = |fit: &FittedPose| FrameReport {
            reprojection_rms_px: fit.root_mean_square_px,
            joints_unseen: fit
                .unseen
                .iter()
                .filter(|&&point| self.skin[point].is_none())
                .map(|&point| joints[point].clone())
                .collect(),
        };
        let per_frame: Vec<FrameReport> = poses.iter().map(of_frame).collect();
        let views = self.joints.views().iter().enumerate();
        let registered = self.registration.as_ref();
        let of_view = |(view, joints): (usize, &JointView)| {
            let residuals = poses.iter().flat_map(|fit| &fit.residuals_px[view]);
            let mut residuals: Vec<f64> = residuals.copied().flatten().collect();
            let mean: MeanSquare = residuals.iter().copied().collect();
            let registered = registered.map(|found| found.views[view]);
            let offset = registered.filter(|found| found.offset_deviation.is_finite());
            ViewReport {
                name: joints.name.clone(),
                joints_seen: mean.count,
                reprojection_median_px: median(&mut residuals).unwrap_or(0.0),
                reprojection_rms_px: mean.root().unwrap_or(0.0),
                offset_frames: offset.map(|found| found.offset_frames),
                offset_deviation_frames: offset.map(|found| found.offset_deviation),
                rotation_degrees: registered.map(|found| found.angle().to_degrees()),
                rotation_deviation_degrees: registered
                    .map(|found| found.rotation_deviation.to_degrees()),
                frames_with_exchanged_sides: self.exchanged_frames(view, fitted),
            }
        };
        let residuals = poses.iter().flat_map(|fit| fit.residuals_px.as_slice());
        let residuals = residuals.flatten().copied().flatten();
        let of_kind = |is_skin: bool| {
            let points = joints.iter().zip(&self.skin);
            let own = points.filter(|(_, skin)| skin.is_some() == is_skin);
            own.map(|(name, _)| name.clone()).collect::<Vec<String>>()
        };
        let unseen = per_frame.iter().map(|frame| frame.joints_unseen.len());
        CharacterReport {
            views: self.joints.views().len(),
            frames: poses.len(),
            frames_per_second,
            joints_without_counterpart: self.without_counterpart.clone(),
            reprojection_median_px: median(&mut residuals.clone().collect::<Vec<_>>())
                .unwrap_or(0.0),
            reprojection_rms_px: residuals
                .clone()
                .collect::<MeanSquare>()
                .root()
                .unwrap_or(0.0),
            reprojection_max_px: residuals.fold(0.0, f64::max),
            joints_unseen: unseen.clone().sum(),
            frames_with_unseen_joints: unseen.filter(|count| *count > 0).count(),
            milliseconds_per_frame: 1e3 * seconds / poses.len().max(1) as f64,
            length_factors,
            deviation_factor: fitted.noise,
            bones: bones(fitted),
            ground: fitted.ground.clone(),
            per_view: views.map(of_view).collect(),
            per_frame,
            joints: of_kind(false),
            points_of_the_skin: of_kind(true),
        }
    }
}

/// The same without what some views show.
fn without_views(observations: &[Observation], views: &[usize]) -> Vec<Observation> {
    let mut used = observations.to_vec();
    for observation in &mut used {
        for &view in views {
            observation.views[view].fill(None);
        }
    }
    used
}

/// The lengths of bones.
fn bones(fitted: &FittedPerson) -> Vec<BoneReport> {
    let joints = fitted.model.skeleton().joints();
    let bones = joints.iter().enumerate().filter_map(|(index, joint)| {
        let above = joints[joint.parent?].head;
        let length = Vector::from(joint.head).distance(above.into());
        let deviation = fitted
            .proportions
            .as_ref()
            .and_then(|own| own.deviation(index));
        (length > 0.0).then(|| BoneReport {
            joint: joint.name.clone(),
            length_metres: length,
            deviation_metres: deviation.map(|deviation| deviation * length),
        })
    });
    bones.collect()
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

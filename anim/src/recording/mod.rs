//! Recordings: the local transforms of a hierarchy of joints, frame by frame.
//!
//! A [`Recording`] is motion as files have it: joints with local axes of their own, a transform of
//! each relative to its parent in every frame, and numbers beside them such as the weights of morph
//! targets. It is what is compressed, sampled and mixed. Lengths are in metres.
//!
//! # Recordings and clips
//!
//! A [`Clip`](crate::clip::Clip) of [`Pose`](crate::pose::Pose)s has no local axes: its motors take
//! a point of the mesh at rest to the pose. Use it where a mesh is moved: for skinning, and for
//! retargeting between bodies. With F the motor of a joint's frame in model space, F₀ that at rest,
//! and G the joint's total motion in the clip,
//!
//! ```text
//! G = F ~F₀,   F = G F₀.
//! ```
//!
//! [`Recording::to_skeleton`] and [`Recording::to_clip`] convert one way, [`Recording::from_clip`]
//! the other way.

mod blend;
mod conversion;
mod cycle;
mod error;
mod from_bvh;
mod from_compressed;
mod from_gltf;
mod grid;
mod mirror;
mod mirror_axes;
mod model_space;
mod played;
mod resample;
mod to_gltf;

use crate::frame_position::frame_at;
use crate::kinematics::KinematicsError;
use crate::transform::Transform;

pub use blend::{blend, blend_played};
pub use cycle::{Cycle, Seam};
pub use error::RecordingError;
pub use from_gltf::GltfMotion;
pub use model_space::{model_maps, model_motors};
pub use played::Played;

/// A joint of a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedJoint {
    /// The name. Names need not differ: joints are known by their index.
    pub name: String,
    /// The index of the parent joint, or `None` for a root.
    pub parent: Option<usize>,
    /// The transform relative to the parent at rest.
    pub rest: Transform<f64>,
}

/// Numbers beside the joints, one a frame: the weight of a morph target, or a value of a user.
#[derive(Clone, Debug, PartialEq)]
pub struct ScalarTrack {
    /// What the numbers are.
    pub name: String,
    /// One number a frame.
    pub values: Vec<f64>,
}

/// The local transforms of a hierarchy of joints in frames at equal time steps, and scalar tracks.
///
/// Parents come before their children, so one pass over the joints from first to last always meets
/// a parent before its children.
///
/// # Examples
///
/// ```
/// use ga_anim::recording::{RecordedJoint, Recording};
/// use ga_anim::transform::Transform;
/// use ga_runtime::cga3::{Motor, Translator};
///
/// let at = |x| Transform::from(Motor::from(Translator::from_displacement([x, 0.0, 0.0])));
/// let joint = |name: &str, parent, x| RecordedJoint { name: name.into(), parent, rest: at(x) };
/// let recording = Recording::new(
///     vec![joint("hip", None, 0.0), joint("knee", Some(0), 0.4)],
///     0.01,
///     vec![at(0.0), at(0.4), at(0.1), at(0.4)],
///     vec![],
/// )?;
/// assert_eq!(recording.frame_count(), 2);
/// assert_eq!(recording.frame(1), Some(&[at(0.1), at(0.4)][..]));
/// # Ok::<(), ga_anim::recording::RecordingError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    joints: Vec<RecordedJoint>,
    parents: Vec<Option<usize>>,
    frame_time: f64,
    locals: Vec<Transform<f64>>,
    tracks: Vec<ScalarTrack>,
    /// For each joint the end of its bone, see [`Recording::ends`].
    ends: Vec<Option<[f64; 3]>>,
}

impl Recording {
    /// A recording of these joints, parents first. `locals` has the transforms relative to the
    /// parents, frame after frame, and within a frame in the order of the joints. The first frame
    /// is at time 0.
    ///
    /// # Errors
    ///
    /// [`RecordingError::NoJoints`], [`RecordingError::NoFrames`],
    /// [`RecordingError::ParentNotBefore`], [`RecordingError::FrameTime`],
    /// [`RecordingError::Length`], [`RecordingError::Transform`], [`RecordingError::TrackLength`]
    /// and [`RecordingError::TrackValue`].
    pub fn new(
        joints: Vec<RecordedJoint>,
        frame_time: f64,
        locals: Vec<Transform<f64>>,
        tracks: Vec<ScalarTrack>,
    ) -> Result<Self, RecordingError> {
        if joints.is_empty() {
            return Err(RecordingError::NoJoints);
        }
        if locals.is_empty() {
            return Err(RecordingError::NoFrames);
        }
        if !frame_time.is_finite() || frame_time <= 0.0 {
            return Err(RecordingError::FrameTime(frame_time));
        }
        check_joints(&joints)?;
        check_locals(&joints, &locals)?;
        check_tracks(&tracks, locals.len() / joints.len())?;
        Ok(Self {
            parents: joints.iter().map(|joint| joint.parent).collect(),
            ends: vec![None; joints.len()],
            joints,
            frame_time,
            locals,
            tracks,
        })
    }

    /// The joints, parents before children.
    #[must_use]
    pub fn joints(&self) -> &[RecordedJoint] {
        &self.joints
    }

    /// The parent of each joint, as the jobs of this module take them.
    #[must_use]
    pub fn parents(&self) -> &[Option<usize>] {
        &self.parents
    }

    /// Where the bones of joints end on which no other joint hangs, as the End Sites of a BVH file
    /// say it: relative to the joint, with the axes of model space at rest, in metres.
    #[must_use]
    pub fn ends(&self) -> &[Option<[f64; 3]>] {
        &self.ends
    }

    /// The time from one frame to the next, in seconds.
    #[must_use]
    pub fn frame_time(&self) -> f64 {
        self.frame_time
    }

    /// How many frames there are; never 0.
    #[must_use]
    pub fn frame_count(&self) -> usize {
        self.locals.len() / self.joints.len()
    }

    /// The time of the last frame, in seconds.
    #[must_use]
    pub fn duration(&self) -> f64 {
        (self.frame_count() - 1) as f64 * self.frame_time
    }

    /// The transforms of a frame relative to the parents, in the order of the joints.
    #[must_use]
    pub fn frame(&self, frame: usize) -> Option<&[Transform<f64>]> {
        let begin = frame.checked_mul(self.joints.len())?;
        self.locals.get(begin..begin + self.joints.len())
    }

    /// All transforms, frame after frame.
    #[must_use]
    pub fn locals(&self) -> &[Transform<f64>] {
        &self.locals
    }

    /// The scalar tracks.
    #[must_use]
    pub fn tracks(&self) -> &[ScalarTrack] {
        &self.tracks
    }

    /// The recording with these scalar tracks in place of its own.
    ///
    /// # Errors
    ///
    /// [`RecordingError::TrackLength`] and [`RecordingError::TrackValue`].
    pub fn with_tracks(self, tracks: Vec<ScalarTrack>) -> Result<Self, RecordingError> {
        check_tracks(&tracks, self.frame_count())?;
        Ok(Self { tracks, ..self })
    }

    /// The local transforms at a time in seconds: those of the frame there, or in between by
    /// [`Transform::interpolate`]. Before the first frame and after the last one they are those of
    /// that frame.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::SliceLength`] unless `locals` has one place for each joint.
    pub fn sample(&self, time: f64, locals: &mut [Transform<f64>]) -> Result<(), KinematicsError> {
        let count = self.joints.len();
        if locals.len() != count {
            let (expected, found) = (count, locals.len());
            return Err(KinematicsError::SliceLength { expected, found });
        }
        self.fill(self.position(time), locals);
        Ok(())
    }

    /// The local transforms at a time in frames, into one place for each joint.
    fn fill(&self, position: f64, locals: &mut [Transform<f64>]) {
        let (before, part) = frame_at(position, self.frame_count() - 1);
        let count = self.joints.len();
        let frames = &self.locals[before * count..];
        locals.copy_from_slice(&frames[..count]);
        if part > 0.0 {
            for (local, after) in locals.iter_mut().zip(&frames[count..]) {
                *local = local.interpolate(after, part);
            }
        }
    }

    /// The value of a scalar track at a time in seconds, linearly between frames; `None` when there
    /// is no such track.
    #[must_use]
    pub fn sample_track(&self, track: usize, time: f64) -> Option<f64> {
        let track = self.tracks.get(track)?;
        Some(self.track_at(track, self.position(time)))
    }

    /// The value of a track at a time in frames.
    fn track_at(&self, track: &ScalarTrack, position: f64) -> f64 {
        let (before, part) = frame_at(position, self.frame_count() - 1);
        let value = track.values[before];
        match track.values.get(before + 1) {
            Some(after) => value + (after - value) * part,
            None => value,
        }
    }

    /// A time in seconds as a time in frames.
    fn position(&self, time: f64) -> f64 {
        time / self.frame_time
    }
}

fn check_joints(joints: &[RecordedJoint]) -> Result<(), RecordingError> {
    for (index, joint) in joints.iter().enumerate() {
        let name = || joint.name.clone();
        if let Some(parent) = joint.parent.filter(|&parent| parent >= index) {
            let name = name();
            return Err(RecordingError::ParentNotBefore { name, parent });
        }
        if !is_sound(&joint.rest) {
            let (name, frame) = (name(), None);
            return Err(RecordingError::Transform { name, frame });
        }
    }
    Ok(())
}

fn check_locals(joints: &[RecordedJoint], locals: &[Transform<f64>]) -> Result<(), RecordingError> {
    if !locals.len().is_multiple_of(joints.len()) {
        return Err(RecordingError::Length {
            transforms: locals.len(),
            joints: joints.len(),
        });
    }
    match locals.iter().position(|local| !is_sound(local)) {
        None => Ok(()),
        Some(at) => Err(RecordingError::Transform {
            name: joints[at % joints.len()].name.clone(),
            frame: Some(at / joints.len()),
        }),
    }
}

/// Whether all numbers are finite and the rotor is a unit rotor as far as single precision goes.
fn is_sound(transform: &Transform<f64>) -> bool {
    let rotor = transform.rotor();
    let square = rotor.norm_squared();
    let numbers = [transform.translation(), transform.scale].map(|v| v.coordinates());
    (square - 1.0).abs() < 1e-4 && numbers.as_flattened().iter().all(|x| x.is_finite())
}

fn check_tracks(tracks: &[ScalarTrack], frames: usize) -> Result<(), RecordingError> {
    for ScalarTrack { name, values } in tracks {
        let name = || name.clone();
        if values.len() != frames {
            return Err(RecordingError::TrackLength {
                name: name(),
                expected: frames,
                found: values.len(),
            });
        }
        if let Some(frame) = values.iter().position(|value| !value.is_finite()) {
            return Err(RecordingError::TrackValue {
                name: name(),
                frame,
                value: values[frame],
            });
        }
    }
    Ok(())
}

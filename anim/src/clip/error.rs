//! What can be wrong with a clip, its layers, its events and its compressed form.

use crate::kinematics::KinematicsError;

/// Poses that do not form a clip, what cannot be done with one, or a file that is not a compressed
/// clip. Frames, joints, layers and events count from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ClipError {
    /// There is no pose.
    #[error("a clip has at least one frame")]
    Empty,
    /// The time from one frame to the next is 0, negative, infinite or not a number.
    #[error("{0} seconds is not a time from one frame to the next")]
    FrameTime(f64),
    /// Two poses have another number of joints.
    #[error("frame {frame} has {found} joints, but the first has {expected}")]
    JointCount {
        /// The frame, from 0.
        frame: usize,
        /// How many joints the first frame has.
        expected: usize,
        /// How many this one has.
        found: usize,
    },
    /// A rate is 0, negative, infinite or not a number, or gives a clip out of proportion to this
    /// one.
    #[error("{0} is not a number of frames per second for this clip")]
    Rate(f64),
    /// A time is negative, infinite or not a number.
    #[error("{0} seconds is not a time of a clip")]
    Time(f64),
    /// The time of an event is infinite or not a number.
    #[error("event {index} is at the time {time}")]
    EventTime {
        /// The event, from 0.
        index: usize,
        /// Its time.
        time: f64,
    },
    /// A pose has another number of joints than the one below it.
    #[error("layer {layer} has {found} joints, but the pose below has {expected}")]
    LayerJointCount {
        /// The layer.
        layer: usize,
        /// How many joints the pose below has.
        expected: usize,
        /// How many the layer has.
        found: usize,
    },
    /// There is not one factor for each joint.
    #[error("layer {layer} has {found} weights for {expected} joints")]
    LayerWeightCount {
        /// The layer.
        layer: usize,
        /// How many joints there are.
        expected: usize,
        /// How many factors there are.
        found: usize,
    },
    /// A weight is not from 0 to 1.
    #[error("a weight of layer {layer} is {weight}, not from 0 to 1")]
    LayerWeight {
        /// The layer.
        layer: usize,
        /// The weight.
        weight: f64,
    },
    /// The clip is for another skeleton.
    #[error("a clip of {found} joints for a skeleton of {expected}")]
    SkeletonJointCount {
        /// How many joints the skeleton has.
        expected: usize,
        /// How many the clip has.
        found: usize,
    },
    /// There is no such joint.
    #[error("there is no joint {joint} in a skeleton of {count}")]
    NoJoint {
        /// The joint that was asked for.
        joint: usize,
        /// How many joints there are.
        count: usize,
    },
    /// The direction up is zero or not finite.
    #[error("{0:?} is not a direction")]
    Up([f64; 3]),
    /// There is not one motor for each frame of the clip.
    #[error("{found} motions for {expected} frames")]
    MotionCount {
        /// How many frames the clip has.
        expected: usize,
        /// How many motions there are.
        found: usize,
    },
    /// A setting is not a positive finite number; a shell may be 0.
    #[error("the {name} must be positive and finite, but is {value}")]
    Setting {
        /// `"tolerance"`, `"shell"` or `"tolerance of tracks"`.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// The recording is not within a tolerance of the document that it was made of.
    #[error(
        "shear in matrices of nodes moves points by {deviation} m, which is not within {tolerance} \
         m"
    )]
    Deviation {
        /// How far it is from the document in metres.
        deviation: f64,
        /// The tolerance in metres.
        tolerance: f64,
    },
    /// A bound is for a joint that the recording does not have.
    #[error("a bound is for joint {joint}, but there are {joints} joints")]
    BoundJoint {
        /// The index of the joint.
        joint: usize,
        /// How many joints there are.
        joints: usize,
    },
    /// There are more joints than a compressed clip may have.
    #[error("{joints} joints, but at most {most} can be compressed")]
    TooManyJoints {
        /// How many joints there are.
        joints: usize,
        /// How many there may be.
        most: usize,
    },
    /// With the most bits a joint stays beyond its tolerance.
    #[error(
        "joint {joint:?} cannot be kept within {tolerance} m: with the most bits of the format its \
         error is {error:.2e} m, since its places are too far apart or too far away for that"
    )]
    Bound {
        /// The joint.
        joint: String,
        /// Its tolerance in metres.
        tolerance: f64,
        /// The error in metres that remains.
        error: f64,
    },
    /// Decoding in single precision takes a joint beyond its tolerance.
    #[error(
        "joint {joint:?} cannot be kept within {tolerance} m in single precision, as in frame \
         {frame}: its place, {distance:.0} m from the origin, is too far away for that"
    )]
    Precision {
        /// The joint.
        joint: String,
        /// A frame in which it is beyond it.
        frame: usize,
        /// Its tolerance in metres.
        tolerance: f64,
        /// How far it is from the origin in that frame, in metres.
        distance: f64,
    },
    /// A scalar track cannot be kept within its tolerance.
    #[error("track {track:?} cannot be kept within {tolerance}: its values are too large for that")]
    Track {
        /// The track.
        track: String,
        /// The tolerance.
        tolerance: f64,
    },
    /// The hierarchy has no model space.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
    /// The file does not begin as a clip.
    #[error("the file is not a compressed clip: it does not begin with \"NULLCLIP\"")]
    NotAClip,
    /// The format has another version.
    #[error("the clip has version {0} of the format, and this program reads version 1")]
    Version(u32),
    /// The file ends early.
    #[error("the file ends in its {section}: it has {found} bytes of {expected}")]
    Truncated {
        /// The part of the file that is not complete.
        section: &'static str,
        /// How many bytes it should have.
        expected: u64,
        /// How many it has.
        found: u64,
    },
    /// Bytes follow the end.
    #[error("the file has {found} bytes, but its header announces {expected}")]
    TooLong {
        /// How many bytes it should have.
        expected: u64,
        /// How many it has.
        found: u64,
    },
    /// A part is damaged.
    #[error("the {section} of the file are damaged: their checksum does not match")]
    Checksum {
        /// The part of the file.
        section: &'static str,
    },
    /// A part that is whole by its checksum says something impossible.
    #[error("the clip is invalid: {what} {index}")]
    Invalid {
        /// What is wrong.
        what: &'static str,
        /// Which joint, track or segment has it, or which number.
        index: u64,
    },
    /// The numbers at the beginning say something impossible.
    #[error("the clip is invalid: {0}")]
    Header(&'static str),
    /// The clip has more of something than the format can say.
    #[error("the clip has {count} {what}, more than a file can hold")]
    TooMany {
        /// Joints, frames, tracks or bytes.
        what: &'static str,
        /// How many.
        count: usize,
    },
}

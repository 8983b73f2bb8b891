//! What can be wrong with a recording, and with what is done with one.

use crate::clip::ClipError;
use crate::kinematics::KinematicsError;
use crate::retarget::structure::BodyProblem;
use crate::skeleton::SkeletonError;

/// Joints and frames that do not form a recording, or a recording that cannot be blended, mirrored,
/// converted or carried to a skeleton. Recordings, joints and frames count from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RecordingError {
    /// There is no joint.
    #[error("the recording has no joints")]
    NoJoints,
    /// There is no frame.
    #[error("the recording has no frames")]
    NoFrames,
    /// A joint's parent is not among the joints before it.
    #[error("joint {name:?} has joint {parent} as its parent, which does not come before it")]
    ParentNotBefore {
        /// The joint.
        name: String,
        /// The index that it has as its parent.
        parent: usize,
    },
    /// The time from one frame to the next is 0, negative, infinite or not a number.
    #[error("{0} seconds is not a time from one frame to the next")]
    FrameTime(f64),
    /// The transforms are not a whole number of frames.
    #[error("{transforms} transforms are not a whole number of frames of {joints} joints")]
    Length {
        /// How many transforms there are.
        transforms: usize,
        /// How many joints a frame has.
        joints: usize,
    },
    /// A transform has a coefficient that is infinite or not a number, or a motor that is not a
    /// unit motor.
    #[error("joint {name:?} has no rigid motion or no finite factors in {}", place(*frame))]
    Transform {
        /// The joint.
        name: String,
        /// The frame, from 0; `None` at rest.
        frame: Option<usize>,
    },
    /// A track does not have one number for each frame.
    #[error("track {name:?} has {found} numbers for {expected} frames")]
    TrackLength {
        /// The track.
        name: String,
        /// How many frames there are.
        expected: usize,
        /// How many numbers the track has.
        found: usize,
    },
    /// A track has a number that is infinite or not a number.
    #[error("track {name:?} is {value} in frame {frame}")]
    TrackValue {
        /// The track.
        name: String,
        /// The frame, from 0.
        frame: usize,
        /// The number.
        value: f64,
    },
    /// What is to be matched by its structure is no person.
    #[error("{body} cannot be matched by its structure: {problem}; a map of the joints is needed")]
    NotAPerson {
        /// Which of both.
        body: String,
        /// What it lacks.
        problem: BodyProblem,
    },
    /// Neither a pose nor the motion says what the rotations of the joints mean.
    #[error(
        "the joints do not stand as a person at rest, and no part of a body is known whose motion \
         says what their rotations mean: give a pose of reference"
    )]
    NoReference,
    /// The frame of reference is not in the motion.
    #[error("the motion has no frame {frame} for reference: it has {frames}, counted from 0")]
    ReferenceFrame {
        /// The frame.
        frame: usize,
        /// How many frames there are.
        frames: usize,
    },
    /// A joint that the pose of reference does not have.
    #[error("the pose of reference has no joint {name:?}")]
    ReferenceJoint {
        /// The joint.
        name: String,
    },
    /// A length of one unit in metres is 0, negative, infinite or not a number.
    #[error("{0} metres is not the length of a unit")]
    Unit(f64),
    /// A rate is 0, negative, infinite or not a number.
    #[error("{0} is not a number of frames per second")]
    Rate(f64),
    /// A recording would be out of proportion to what it is made of.
    #[error("{frames} frames of {joints} joints are more than {limit} transforms")]
    TooLarge {
        /// How many frames there would be.
        frames: f64,
        /// How many joints there are.
        joints: usize,
        /// The greatest number of transforms.
        limit: usize,
    },
    /// A weight is negative, infinite or not a number.
    #[error("the weight of recording {recording} is {weight}, not 0 or more")]
    Weight {
        /// The recording.
        recording: usize,
        /// Its weight.
        weight: f64,
    },
    /// All weights are 0, or their sum overflows.
    #[error("the weights have the sum {0}, by which they cannot be divided")]
    Sum(f64),
    /// A recording has another number of joints than the first.
    #[error("recording {recording} has {found} joints, but the first has {expected}")]
    JointCount {
        /// The recording.
        recording: usize,
        /// How many joints the first has.
        expected: usize,
        /// How many this one has.
        found: usize,
    },
    /// A joint has another name than in the first recording.
    #[error(
        "joint {joint} of recording {recording} is {found:?}, but that of the first is {expected:?}"
    )]
    JointName {
        /// The recording.
        recording: usize,
        /// The joint.
        joint: usize,
        /// Its name in the first recording.
        expected: String,
        /// Its name in this one.
        found: String,
    },
    /// A joint has another parent than in the first recording.
    #[error("joint {name:?} of recording {recording} has another parent than in the first")]
    JointParent {
        /// The recording.
        recording: usize,
        /// The name of the joint.
        name: String,
    },
    /// A joint is scaled.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
    /// The frame of a joint is scaled non-uniformly.
    #[error("joint {name:?} is scaled non-uniformly, so that no joint below it can rotate")]
    NonUniformScale {
        /// Its name.
        name: String,
    },
    /// The joints do not form a skeleton.
    #[error(transparent)]
    Skeleton(#[from] SkeletonError),
    /// The frames do not form a clip.
    #[error(transparent)]
    Clip(#[from] ClipError),
    /// The normal of the plane is zero, or a coefficient is not finite.
    #[error("the plane has no direction")]
    MirrorPlane,
    /// A pair names a joint that does not exist.
    #[error("there is no joint {joint} in a skeleton of {count}")]
    MirrorNoJoint {
        /// The joint.
        joint: usize,
        /// How many joints there are.
        count: usize,
    },
    /// A joint is in two pairs.
    #[error("joint {name:?} is in more than one pair")]
    PairedTwice {
        /// Its name.
        name: String,
    },
    /// A joint of one side has none on the other.
    #[error("joint {name:?} has no counterpart {expected:?}")]
    NoCounterpart {
        /// Its name.
        name: String,
        /// The name that the counterpart would have.
        expected: String,
    },
    /// A joint is scaled so that its image is not a rotation, a translation and factors along its
    /// axes.
    #[error(
        "joint {name:?} is scaled non-uniformly or by a negative factor in {}, and has no mirror image",
        frame.map_or("rest".to_owned(), |frame| format!("frame {frame}"))
    )]
    MirrorScaled {
        /// Its name.
        name: String,
        /// The frame, from 0; `None` at rest.
        frame: Option<usize>,
    },
    /// The parents of two counterparts are not counterparts.
    #[error("joints {name:?} and {other:?} are a pair, but their parents are not")]
    PairParents {
        /// The name of a joint.
        name: String,
        /// The name of its counterpart.
        other: String,
    },
    /// No joint of the recording belongs to one of the skeleton, by name or by the map.
    #[error("no joint of the motion belongs to a joint of the skeleton, by name or by the map")]
    NoMatch,
    /// No leg was found: matched long bones above a foot on the ground.
    #[error(
        "rig and motion have no leg in common; a leg is a chain of long bones above one that lies on the ground"
    )]
    NoLegs,
    /// The recording has no frame.
    #[error("the motion has no frames")]
    NoMotion,
    /// A range of frames is empty or goes beyond the recording.
    #[error("frames {from} to {to} are not in a motion of {frames} frames, counted from 0")]
    FrameRange {
        /// The first frame.
        from: usize,
        /// The last frame.
        to: usize,
        /// How many frames the recording has.
        frames: usize,
    },
    /// The recording's numbers are so large that computations overflow.
    #[error("frame {frame} of the motion overflows")]
    Overflow {
        /// The frame, from 0.
        frame: usize,
    },
    /// A setting of foot locking is not positive and finite.
    #[error("{name} cannot be {value}")]
    FootLocking {
        /// What it is.
        name: &'static str,
        /// The number.
        value: f64,
    },
    /// The text is not JSON, or not an object of names and lists of names.
    #[error(
        "a map is an object {{\"joint of the motion\": \"joint of the skeleton\"}}, or with a list \
         of joints of the skeleton: {0}"
    )]
    MapJson(String),
    /// The recording has no such joint.
    #[error("the motion has no joint {name:?}")]
    MapSource {
        /// The name.
        name: String,
    },
    /// The skeleton has no such joint.
    #[error("the skeleton has no joint {name:?}")]
    MapTarget {
        /// The name.
        name: String,
    },
    /// Two joints of the recording are to move one joint.
    #[error("joint {name:?} of the skeleton is listed twice in the map")]
    MapTwice {
        /// The joint of the skeleton.
        name: String,
    },
    /// A joint of the recording has two entries.
    #[error("joint {name:?} of the motion is listed twice in the map")]
    MapRepeated {
        /// The joint of the recording.
        name: String,
    },
}

fn place(frame: Option<usize>) -> String {
    frame.map_or("rest".to_owned(), |frame| format!("frame {frame}"))
}

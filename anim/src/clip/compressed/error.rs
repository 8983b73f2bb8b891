use super::file::FileError;
use crate::recording::ModelSpaceError;

/// Why a recording cannot be compressed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CompressError {
    /// A setting is not a positive finite number; a shell may be 0.
    #[error("the {name} must be positive and finite, but is {value}")]
    Setting {
        /// `"tolerance"`, `"shell"` or `"tolerance of tracks"`.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A bound is for a joint that the recording does not have.
    #[error("a bound is for joint {joint}, but there are {joints} joints")]
    Joint {
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
    #[error("joint {joint:?} cannot be kept within {tolerance} m; {error} m is the least reached")]
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
        "joint {joint:?} cannot be kept within {tolerance} m in single precision, as in frame {frame}: \
         its place is too far from the origin"
    )]
    Precision {
        /// The joint.
        joint: String,
        /// A frame in which it is beyond it.
        frame: usize,
        /// Its tolerance in metres.
        tolerance: f64,
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
    ModelSpace(#[from] ModelSpaceError),
    /// The clip does not fit into the file format.
    #[error(transparent)]
    File(#[from] FileError),
}

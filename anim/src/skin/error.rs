//! Why positions, weights and motions do not fit together.

use crate::pose::PoseError;
use ga_runtime::batch::LengthMismatch;
use ga_runtime::batch::skin::SkinError as BatchError;

/// Why positions, weights and motions do not fit together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SkinError {
    /// There are weights for another number of vertices.
    #[error("weights for {found} vertices, but there are {expected}")]
    VertexCount {
        /// How many vertices there are.
        expected: usize,
        /// How many have weights.
        found: usize,
    },
    /// There are motions for another number of joints.
    #[error("{found} motions for weights on {expected} joints")]
    JointCount {
        /// How many joints the weights are for.
        expected: usize,
        /// How many motions there are.
        found: usize,
    },
    /// There is no vertex to measure.
    #[error("a mesh without vertices has no height")]
    NoVertices,
    /// A pose does not fit the skeleton.
    #[error(transparent)]
    Pose(#[from] PoseError),
    /// The motion of a joint is not finite, or not a unit motor.
    #[error("the motion of joint {joint} is not finite or not a unit motor")]
    BadMotion {
        /// The joint.
        joint: usize,
    },
    /// Normals or tangents are asked for, but the binding has none.
    #[error("normals or tangents are asked for, but the vertices were bound without them")]
    NoDirections,
    /// The palettes of a mixture are not one of the linear blend and one of a blend of motors.
    #[error(
        "the first palette of a mixture must be of the linear blend, the second of a blend of motors"
    )]
    NotBoth,
    /// More joints or pairs of joints than the indices can count.
    #[error("there are more than 65,536 joints, or too many pairs of them")]
    TooLarge,
}

/// What the binding checks itself cannot occur again; weights are checked by
/// [`SkinWeights`](crate::weights::SkinWeights).
impl From<BatchError> for SkinError {
    fn from(error: BatchError) -> Self {
        match error {
            BatchError::Length(LengthMismatch { expected, found }) => {
                Self::VertexCount { expected, found }
            }
            BatchError::BadMotion { joint } => Self::BadMotion { joint },
            BatchError::NoDirections => Self::NoDirections,
            _ => Self::TooLarge,
        }
    }
}

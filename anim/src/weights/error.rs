//! Why weights cannot be computed, and why positions, weights and motions do not fit together.

use ga_mesh::MeshError;
use ga_runtime::batch::{BatchError, LengthMismatch};

use crate::skeleton::SkeletonError;

/// Numbers that are not weights, or from which weights cannot be computed, and why positions,
/// weights and motions do not fit together. Vertices, joints, bones and points are counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
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
    Skeleton(#[from] SkeletonError),
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
    /// A vertex has no joint with a weight above 0.
    #[error("vertex {vertex} is moved by no joint")]
    Unweighted {
        /// The vertex.
        vertex: usize,
    },
    /// A weight is negative, infinite or not a number, or the weights of a vertex overflow.
    #[error("vertex {vertex}: {weight} is not a weight for joint {joint}")]
    BadWeight {
        /// The vertex.
        vertex: usize,
        /// The joint.
        joint: u32,
        /// The weight.
        weight: f64,
    },
    /// A weight is for a joint that does not exist.
    #[error("vertex {vertex} is moved by joint {joint}, but there are {joints} joints")]
    JointOutOfRange {
        /// The vertex.
        vertex: usize,
        /// The joint.
        joint: u32,
        /// How many joints there are.
        joints: usize,
    },
    /// A vertex has two weights for one joint.
    #[error("vertex {vertex} has two weights for joint {joint}")]
    DuplicateJoint {
        /// The vertex.
        vertex: usize,
        /// The joint.
        joint: u32,
    },
    /// More influences than 32-bit indices can tell apart.
    #[error("more than 2^32 - 1 influences")]
    TooManyInfluences,
    /// There is no bone.
    #[error("there are no bones to follow")]
    NoBones,
    /// No bone may move a point.
    #[error("a point must follow at least 1 bone")]
    NoInfluences,
    /// The exponent is 0, negative, infinite or not a number.
    #[error("{exponent} is not an exponent for a weight that decreases with distance")]
    BadExponent {
        /// The exponent.
        exponent: f64,
    },
    /// An end of a bone has a coordinate that is infinite or not a number.
    #[error("bone {bone} has an end that is not finite: {ends:?}")]
    BadBone {
        /// The bone.
        bone: usize,
        /// Its head and its tail.
        ends: [[f64; 3]; 2],
    },
    /// A point has a coordinate that is infinite or not a number, or lies too far away to measure.
    #[error("point {point} has no finite distance to the bones: {coordinates:?}")]
    BadPoint {
        /// The point.
        point: usize,
        /// Its coordinates.
        coordinates: [f64; 3],
    },
    /// The triangles are not those of a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// There are no triangles.
    #[error("a mesh without triangles has neither an inside nor a surface")]
    NoTriangles,
    /// The number of cells is 0 or too large.
    #[error("{resolution} cells along the mesh; there must be from 1 to 256")]
    BadResolution {
        /// The number of cells.
        resolution: usize,
    },
    /// The share is not between 0 and 1.
    #[error("the share of the neighbours is {share}; it must be from 0 to 1")]
    BadShare {
        /// The share.
        share: f64,
    },
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

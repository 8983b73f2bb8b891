//! Why rigs cannot be read.

use crate::skeleton::SkeletonError;
use crate::weights::WeightsError;

/// A file that does not contain a rig, or not the weights for this rig and mesh.
#[derive(Debug, thiserror::Error)]
pub enum RigError {
    /// The file is not JSON, or not of this form; the message names line and column.
    #[error("{0}")]
    Json(serde_json::Error),
    /// A bone is in the file twice.
    #[error("bone {bone:?} is in the file twice")]
    DuplicateBone {
        /// The bone.
        bone: String,
    },
    /// A bone's parent is not in the file.
    #[error("bone {bone:?} has the parent {parent:?}, which is not in the file")]
    UnknownParent {
        /// The bone.
        bone: String,
        /// Its parent.
        parent: String,
    },
    /// A bone is above itself.
    #[error("bone {bone:?} is its own ancestor")]
    Cycle {
        /// The bone.
        bone: String,
    },
    /// The bones do not form a skeleton.
    #[error(transparent)]
    Skeleton(#[from] SkeletonError),
    /// Weights are given for a bone that the skeleton does not have.
    #[error("the weights are for bone {bone:?}, which the skeleton does not have")]
    UnknownBone {
        /// The bone.
        bone: String,
    },
    /// A weight is given for a vertex that the mesh does not have.
    #[error(
        "bone {bone:?} has a weight for vertex {vertex}, but the mesh has {vertices} vertices, counted from 0"
    )]
    VertexOutOfRange {
        /// The bone.
        bone: String,
        /// The vertex, from 0.
        vertex: u64,
        /// How many vertices the mesh has.
        vertices: usize,
    },
    /// The weights of a vertex are not valid.
    #[error(transparent)]
    Weights(#[from] WeightsError),
}

//! Rigs for the MakeHuman base mesh: bones and painted weights, as JSON.
//!
//! The rig file is an object of bones by name; of each bone `head.default_position`,
//! `tail.default_position` and `parent` (a name, or empty for a root) are read. Its positions are
//! Blender's: z up, the person looking along −y, in units that are ten of the mesh's units long.
//! The joints have the mesh's coordinates (y up, looking along z, decimetres), in which such a
//! position (x, y, z) is (10x, 10z, −10y). The weights file has a member `weights`, an object of
//! bones by name, each a list of (vertex, weight).
//!
//! Source: the files of MPFB, the MakeHuman plug-in for Blender.

pub(crate) mod bones;
mod painted;

use std::path::Path;

use ga_files::ReadError;

use crate::file_error::MotionFileError;
use crate::skeleton::Skeleton;
use crate::weights::SkinWeights;

/// The length in metres of one unit of the MakeHuman base mesh and its rigs, a decimetre; see
/// [`Mesh::scaled`](ga_mesh::Mesh::scaled) and [`Skeleton::scaled`].
pub const METRES_PER_UNIT: f64 = 0.1;

/// Reads the skeleton in a rig file.
///
/// # Errors
///
/// [`ReadError::Io`], or [`ReadError::Contents`] as [`decode`] gives.
pub fn read(path: impl AsRef<Path>) -> Result<Skeleton, ReadError<MotionFileError>> {
    ga_files::read(path, decode)
}

/// Reads a skeleton from the bytes of a rig file.
///
/// The joints come depth first, parents before children and siblings in the order of their names.
///
/// # Errors
///
/// [`MotionFileError::Json`], [`MotionFileError::DuplicateBone`],
/// [`MotionFileError::UnknownParent`], [`MotionFileError::Cycle`] and
/// [`MotionFileError::Skeleton`].
///
/// # Examples
///
/// ```
/// let json = br#"{
///     "foot": {
///         "head": {"default_position": [0, 0, 0.1]},
///         "tail": {"default_position": [0, -0.2, 0]},
///         "parent": "leg"
///     },
///     "leg": {
///         "head": {"default_position": [0, 0, 0.9]},
///         "tail": {"default_position": [0, 0, 0.1]},
///         "parent": ""
///     }
/// }"#;
/// let skeleton = ga_anim::rig::decode(json)?;
/// let foot = &skeleton.joints()[1];
/// assert_eq!((foot.name.as_str(), foot.parent), ("foot", Some(0)));
/// assert_eq!(foot.tail, [0.0, 0.0, 2.0]);
/// # Ok::<(), ga_anim::MotionFileError>(())
/// ```
pub fn decode(bytes: &[u8]) -> Result<Skeleton, MotionFileError> {
    bones::parse(bytes)
}

/// Reads the weights in a file, for a mesh of `vertex_count` vertices.
///
/// # Errors
///
/// [`ReadError::Io`], or [`ReadError::Contents`] as [`decode_weights`] gives.
pub fn read_weights(
    path: impl AsRef<Path>,
    skeleton: &Skeleton,
    vertex_count: usize,
) -> Result<SkinWeights, ReadError<MotionFileError>> {
    ga_files::read(path, |bytes| decode_weights(bytes, skeleton, vertex_count))
}

/// Reads weights from the bytes of a file, for a mesh of `vertex_count` vertices.
///
/// The influences of a vertex come in the order of the bones' names, so that of two equal weights
/// [`SkinWeights::strongest`] keeps the one whose bone comes first by name.
///
/// # Errors
///
/// [`MotionFileError::Json`], [`MotionFileError::DuplicateBone`], [`MotionFileError::UnknownBone`]
/// for a bone that the skeleton does not have, [`MotionFileError::VertexOutOfRange`] for a vertex
/// that the mesh does not have, and [`MotionFileError::Skin`], also for a vertex that no bone
/// moves.
pub fn decode_weights(
    bytes: &[u8],
    skeleton: &Skeleton,
    vertex_count: usize,
) -> Result<SkinWeights, MotionFileError> {
    painted::parse(bytes, skeleton, vertex_count)
}

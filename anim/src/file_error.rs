//! What can be wrong with files of rigs and of motion.

use ga_mesh::FormatError;
use ga_mesh::MeshError;
use ga_mesh::gltf::Element;

use crate::bvh::problem::BvhProblem;
use crate::clip::ClipError;
use crate::recording::RecordingError;
use crate::skeleton::SkeletonError;
use crate::weights::error::SkinError;

/// What is wrong with a file of a rig or of motion, or with what should be written to one: BVH,
/// glTF, compressed clips and the JSON of rigs. Elements are counted from 0 and lines from 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionFileError {
    /// The name of the file has no ending that stands for a format.
    #[error("a motion is a file of the kind .bvh, .glb, .gltf or .clip")]
    Ending,
    /// The file is not a compressed clip.
    #[error(transparent)]
    Clip(#[from] ClipError),
    /// The file is not JSON, or not of this form; the message names line and column.
    #[error("{0}")]
    Json(String),
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
    Skin(#[from] SkinError),
    /// The document is not valid.
    #[error(transparent)]
    Document(#[from] FormatError),
    /// There is no animation of this number.
    #[error("there is no animation {animation}: the file has {count}")]
    NoAnimation {
        /// The number, from 0.
        animation: usize,
        /// How many animations there are.
        count: usize,
    },
    /// A time is not a number.
    #[error("{0} is not a time in seconds")]
    Time(f64),
    /// An animation moves a node whose frame is a matrix, which glTF does not allow.
    #[error("{element}: moves node {node}, whose frame is a matrix")]
    AnimatedMatrix {
        /// The channel of the animation.
        element: Element,
        /// The node.
        node: usize,
    },
    /// A rotation is the zero quaternion: a key, or what a cubic spline has between two keys.
    #[error("{element}: the rotation at {seconds} s is zero")]
    NoRotation {
        /// The channel of the animation.
        element: Element,
        /// The time.
        seconds: f64,
    },
    /// The frame of a node in the world is beyond double precision.
    #[error("node {node}: its frame in the world at {seconds} s is not finite")]
    FrameNotFinite {
        /// The node.
        node: usize,
        /// The time.
        seconds: f64,
    },
    /// The place of a vertex is beyond double precision.
    #[error("node {node}, primitive {primitive}: vertex {vertex} is not at a finite place")]
    VertexNotFinite {
        /// The node of the mesh.
        node: usize,
        /// The primitive of the mesh.
        primitive: usize,
        /// The vertex of the primitive.
        vertex: usize,
    },
    /// The weights of the joints do not define how a vertex moves.
    #[error("node {node}, primitive {primitive}: {problem}")]
    Weights {
        /// The node of the mesh.
        node: usize,
        /// The primitive of the mesh.
        primitive: usize,
        /// What is wrong.
        problem: SkinError,
    },
    /// The transform of a joint is beyond double precision.
    #[error("skin {skin}: the transform of joint {joint} (node {node}) is not finite")]
    JointNotFinite {
        /// The skin.
        skin: usize,
        /// The joint of the skin.
        joint: usize,
        /// Its node.
        node: usize,
    },
    /// The transform of a joint has no rotation, since it maps space to a line or a point. Only
    /// blends of motors need one.
    #[error(
        "skin {skin}: the transform of joint {joint} (node {node}) is singular, so it has no \
         rotation; the linear blend needs none"
    )]
    Singular {
        /// The skin.
        skin: usize,
        /// The joint of the skin.
        joint: usize,
        /// Its node.
        node: usize,
    },
    /// Nodes place the same meshes so often that the result is out of proportion to the file.
    #[error("the nodes place {needed} vertices and corners of faces, more than the limit {limit}")]
    TooLarge {
        /// How many vertices and corners the nodes place.
        needed: u64,
        /// How many are allowed.
        limit: u64,
    },
    /// Positions are for another number of vertices.
    #[error("{found} positions for {expected} vertices")]
    VertexCount {
        /// How many vertices there are.
        expected: usize,
        /// How many positions there are.
        found: usize,
    },
    /// There is no such node.
    #[error("there is no node {node}: the document has {count}")]
    NoNode {
        /// The number of the node.
        node: usize,
        /// How many nodes there are.
        count: usize,
    },
    /// No node has a mesh.
    #[error("no node has a mesh")]
    NoMesh,
    /// No node has a skin.
    #[error("no node has a skin")]
    NoSkin,
    /// The vertices and faces do not form a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The frame of a node is sheared, mirrored, flat or scaled non-uniformly.
    #[error(
        "node {node}: its frame in the world is scaled non-uniformly, so that no joint below can \
         rotate"
    )]
    NonUniformScale {
        /// The node.
        node: usize,
    },
    /// The factor of a length is not positive and finite.
    #[error("joint {joint:?}: a length cannot be {factor} times what it was")]
    Length {
        /// The name of the joint.
        joint: String,
        /// The factor.
        factor: f64,
    },
    /// The frames do not form a recording: the length of a unit is out of range, or the animation
    /// moves no joint.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// The matrix of a node shears or is singular.
    #[error("node {node}: its matrix is not a translation, a rotation and factors along axes")]
    Shears {
        /// The node.
        node: usize,
    },
    /// A rate is 0, negative, infinite or not a number.
    #[error("{0} is not a number of frames per second")]
    Rate(f64),
    /// At this rate the recording is out of proportion to the file.
    #[error(
        "{rate} frames per second over {seconds} s and {joints} joints are more than {limit} \
         transforms"
    )]
    RecordingTooLarge {
        /// The frames per second.
        rate: f64,
        /// The duration of the animation.
        seconds: f64,
        /// How many joints there are.
        joints: usize,
        /// The greatest number of transforms.
        limit: usize,
    },
    /// A line of a BVH file is wrong.
    #[error("line {line}: {problem}")]
    Bvh {
        /// The line, from 1; for what is missing, the last line.
        line: usize,
        /// What is wrong.
        problem: BvhProblem,
    },
}

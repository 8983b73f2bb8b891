use ga_mesh::FormatError;
use ga_mesh::gltf::Element;

use crate::skin::SkinError;
use crate::weights::WeightsError;

/// Why a document cannot be played, or not at this time. Elements are counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlayError {
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
        problem: WeightsError,
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
    /// The joints cannot be blended.
    #[error(transparent)]
    Skin(#[from] SkinError),
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
}

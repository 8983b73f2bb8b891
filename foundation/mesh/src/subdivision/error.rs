//! Why a mesh cannot be subdivided.

use crate::MeshError;

/// A mesh that cannot be subdivided, or sharpness that does not fit it. Vertices and faces are
/// counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SubdivisionError {
    /// There is no face.
    #[error("a mesh without faces cannot be subdivided")]
    Empty,
    /// A face refers to a vertex that does not exist, or the mesh is too large.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Loop's scheme was to split a face with more than three corners.
    #[error("face {face} has {corners} corners; Loop's scheme takes triangles alone")]
    NotATriangle {
        /// The face.
        face: usize,
        /// How many corners it has.
        corners: usize,
    },
    /// A face has the same vertex at two of its corners.
    #[error("face {face} has vertex {vertex} at two of its corners")]
    DegenerateFace {
        /// The face.
        face: usize,
        /// The vertex.
        vertex: u32,
    },
    /// More than two faces meet at an edge.
    #[error("{faces} faces meet at the edge between vertices {a} and {b}; at most 2 may")]
    NonManifoldEdge {
        /// Its lower vertex.
        a: u32,
        /// Its higher vertex.
        b: u32,
        /// How many faces.
        faces: usize,
    },
    /// A crease lies between vertices that no face joins.
    #[error("no edge joins vertices {a} and {b}, between which crease {crease} should lie")]
    NoEdge {
        /// Which of the creases, from 0.
        crease: usize,
        /// Its first vertex.
        a: u32,
        /// Its second vertex.
        b: u32,
    },
    /// A sharp corner lies at a vertex that does not exist.
    #[error("corner {corner} lies at vertex {vertex}, but there are {vertices} vertices")]
    NoVertex {
        /// Which of the corners, from 0.
        corner: usize,
        /// Its vertex.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A sharpness is negative or not a number.
    #[error("{sharpness} is not a sharpness, which is at least 0 ({kind} {index})")]
    Sharpness {
        /// `"crease"` or `"corner"`.
        kind: &'static str,
        /// Which of these, from 0.
        index: usize,
        /// The sharpness.
        sharpness: f64,
    },
    /// The refined mesh would have more elements than 32-bit indices can number.
    #[error("the refined mesh would have {count} {what}, more than 32-bit indices can number")]
    TooLarge {
        /// What there would be too much of.
        what: &'static str,
        /// How many there would be.
        count: u64,
    },
    /// The list of values is not as long as the list of corners or vertices.
    #[error("{found} {what} were given for {expected}")]
    Length {
        /// What the list holds.
        what: &'static str,
        /// How many there must be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
}

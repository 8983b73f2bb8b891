//! Why data do not form a mesh.

/// Data that do not form a mesh. Vertices, faces and corners are counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// A face has fewer than three corners.
    #[error("face {face} has {corners} corners; a polygon has at least 3")]
    FaceTooShort {
        /// The face.
        face: usize,
        /// How many corners it has.
        corners: usize,
    },
    /// A face refers to a vertex that does not exist.
    #[error("face {face} refers to vertex {index}, but there are {vertices} vertices")]
    IndexOutOfRange {
        /// The face.
        face: usize,
        /// The vertex it refers to.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A coordinate of a vertex is infinite or not a number.
    #[error("vertex {vertex} has a coordinate that is not finite: {coordinates:?}")]
    NotFinite {
        /// The vertex.
        vertex: usize,
        /// Its coordinates.
        coordinates: [f64; 3],
    },
    /// A texture coordinate is infinite or not a number.
    #[error("texture coordinate {index} is not finite: {coordinates:?}")]
    TextureNotFinite {
        /// The texture coordinate.
        index: usize,
        /// Its value.
        coordinates: [f64; 2],
    },
    /// The list of texture corners is not as long as the list of face corners.
    #[error("{found} texture corners for {expected} corners of faces")]
    TextureLength {
        /// Corners of faces.
        expected: usize,
        /// Corners with texture.
        found: usize,
    },
    /// A corner refers to a texture coordinate that does not exist.
    #[error("corner {corner} refers to texture coordinate {index}, but there are {coordinates}")]
    TextureIndexOutOfRange {
        /// The corner.
        corner: usize,
        /// The texture coordinate it refers to.
        index: u32,
        /// How many there are.
        coordinates: usize,
    },
    /// A group refers to a face that does not exist.
    #[error("group {group:?} refers to face {face}, but there are {faces} faces")]
    GroupOutOfRange {
        /// The group.
        group: String,
        /// The face it refers to.
        face: u32,
        /// How many faces there are.
        faces: usize,
    },
    /// More vertices or corners than 32-bit indices can number.
    #[error("{count} {what} are more than 32-bit indices can number")]
    TooLarge {
        /// What there is too much of.
        what: &'static str,
        /// How many there are.
        count: usize,
    },
}

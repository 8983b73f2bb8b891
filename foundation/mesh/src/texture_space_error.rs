//! Why a mesh has no atlas, or maps cannot be baked.

use crate::MeshError;

/// The longest side of a texture, in texels.
pub const MAX_SIZE: u32 = 16_384;

/// A mesh, or options, from which no atlas can be made or no maps baked. Vertices and faces are
/// counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TextureSpaceError {
    /// There is no face.
    #[error("the mesh has no faces")]
    NoFaces,
    /// Every face is degenerate.
    #[error("all {faces} faces are degenerate: there is nothing to flatten")]
    NoArea {
        /// How many faces there are.
        faces: usize,
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
    #[error("vertex {vertex} has a coordinate that is not finite")]
    NotFinite {
        /// The vertex.
        vertex: usize,
    },
    /// The side of the texture is not between 1 and [`MAX_SIZE`] texels.
    #[error("a texture of {size} texels a side; it must be from 1 to {max}", max = MAX_SIZE)]
    Size {
        /// The side, in texels.
        size: u32,
    },
    /// The charts do not fit into the texture at any scale, since each needs its margin.
    #[error(
        "{charts} charts with margins of {margin_texels} texels do not fit into {size} × {size} \
         texels"
    )]
    DoesNotFit {
        /// How many charts there are.
        charts: usize,
        /// The margin of each, in texels.
        margin_texels: u32,
        /// The side of the texture, in texels.
        size: u32,
    },
    /// The list of coordinates does not have an entry for each face.
    #[error("{found} triangles with texture coordinates for {expected} faces")]
    Coordinates {
        /// How many faces there are.
        expected: usize,
        /// How many entries there are.
        found: usize,
    },
    /// A texture coordinate is not a number or lies outside of the unit square.
    #[error("face {face} has texture coordinates outside of the unit square")]
    OutsideSquare {
        /// The face.
        face: usize,
    },
    /// More faces or vertices than 32-bit indices can number.
    #[error("{count} {what} are more than 32-bit indices can number")]
    TooLarge {
        /// What there is too much of.
        what: &'static str,
        /// How many there are.
        count: usize,
    },
    /// A surface has no triangles, or the coarse one none with texture coordinates.
    #[error("the {surface} surface has no triangles to bake")]
    NoTriangles {
        /// Which surface, "coarse" or "fine".
        surface: &'static str,
    },
    /// The side of the maps is not from 1 to [`MAX_SIZE`] texels.
    #[error("maps of {size} × {size} texels; the side is from 1 to 16384 texels")]
    MapSize {
        /// The side.
        size: u32,
    },
    /// A number of the options is infinite, NaN or out of range.
    #[error("the {what} is {value}, which is not allowed")]
    Number {
        /// Which number.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A corner of the coarse surface has a texture coordinate outside of the unit square.
    #[error("triangle {triangle} has the texture coordinate {coordinate:?} outside of the square")]
    CornerOutsideSquare {
        /// The triangle.
        triangle: usize,
        /// The coordinate.
        coordinate: [f64; 2],
    },
    /// A list does not have an element for each triangle.
    #[error("{found} {what} for {expected} triangles")]
    Length {
        /// What the list holds.
        what: &'static str,
        /// How many triangles there are.
        expected: usize,
        /// How many elements there are.
        found: usize,
    },
    /// The triangles are not those of a surface, or have no tangents.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

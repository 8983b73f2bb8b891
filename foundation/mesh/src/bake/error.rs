//! Why maps cannot be baked.

use crate::MeshError;
use crate::tangents::TangentError;

/// Why maps cannot be baked.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BakeError {
    /// A surface has no triangles, or the coarse one none with texture coordinates.
    #[error("the {surface} surface has no triangles to bake")]
    NoTriangles {
        /// Which surface, "coarse" or "fine".
        surface: &'static str,
    },
    /// The side of the maps is not from 1 to [`MAX_SIZE`](crate::atlas::MAX_SIZE) texels.
    #[error("maps of {size} × {size} texels; the side is from 1 to 16384 texels")]
    Size {
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
    OutsideSquare {
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
    /// The tangents of the coarse surface cannot be computed.
    #[error(transparent)]
    Tangents(#[from] TangentError),
    /// The triangles are not those of a surface.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

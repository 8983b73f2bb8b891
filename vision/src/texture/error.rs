//! Why a mesh cannot be textured from views.

use ga_image::file::FormatError;
use ga_mesh::MeshError;
use ga_mesh::TextureSpaceError;

/// Why a mesh cannot be textured from views, or a textured mesh is not a model. Views are named as
/// their [`View`](super::View) is.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TextureError {
    /// There are no views.
    #[error("there are no views")]
    NoViews,
    /// The mesh has no triangles, or none with an area.
    #[error("the mesh has no triangles to be textured")]
    NoTriangles,
    /// A picture does not have the size for which its camera is given.
    #[error(
        "view {view}: the picture has {} × {} pixels and its camera is for {} × {}",
        picture[0], picture[1], camera[0], camera[1]
    )]
    PictureSize {
        /// The name of the view.
        view: String,
        /// Width and height of the picture.
        picture: [usize; 2],
        /// Width and height for which the camera is given.
        camera: [usize; 2],
    },
    /// A picture has no pixels.
    #[error("view {view}: the picture has no pixels")]
    NoPixels {
        /// The name of the view.
        view: String,
    },
    /// A camera is inside the mesh.
    #[error("view {view}: the camera's centre {centre:?} is inside the mesh")]
    CameraInside {
        /// The name of the view.
        view: String,
        /// The centre in the world.
        centre: [f64; 3],
    },
    /// A camera sees no part of the mesh from outside.
    #[error("view {view}: the camera does not see the mesh")]
    NoOverlap {
        /// The name of the view.
        view: String,
    },
    /// Charts of the mesh's own atlas are smaller than a texel.
    #[error(
        "a texture of {size} × {size} texels is too small for the atlas: {lost} of {charts} charts \
         have no texel of their own"
    )]
    TooSmall {
        /// The side of the texture in texels.
        size: u32,
        /// How many charts have no texel.
        lost: usize,
        /// How many charts there are.
        charts: usize,
    },
    /// Charts of the mesh's own atlas lie under others, as where two halves of a character share
    /// their place in the texture. A new atlas ([`Options::unwrap`](super::Options::unwrap)) has
    /// none.
    #[error(
        "{hidden} of {charts} charts of the mesh's own texture coordinates lie under others; new \
         coordinates are needed"
    )]
    Overlapping {
        /// How many charts have no texel.
        hidden: usize,
        /// How many charts there are.
        charts: usize,
    },
    /// There is no atlas, such as for a texture that is too small for its charts, or the mesh's own
    /// texture coordinates cannot be used.
    #[error(transparent)]
    TextureSpace(#[from] TextureSpaceError),
    /// The mesh is not valid.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The texture has no form in PNG.
    #[error(transparent)]
    Encode(#[from] FormatError),
}

//! Why maps cannot be made.

use ga_image::file::FormatError as PictureError;
use ga_mesh::{FormatError, MeshError, TextureSpaceError};

/// Two meshes of which no maps can be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MapsError {
    /// The coarse mesh has no place in a texture.
    #[error("no texture: {0}")]
    Atlas(#[source] TextureSpaceError),
    /// The coarse mesh has no surface.
    #[error("nothing to bake: {0}")]
    Coarse(#[source] TextureSpaceError),
    /// The fine mesh has no surface.
    #[error("nothing to bake: {0}")]
    Fine(#[source] TextureSpaceError),
    /// The texels of the coarse mesh cannot be projected onto the fine one.
    #[error(transparent)]
    Projection(TextureSpaceError),
    /// The occlusion by the fine mesh cannot be computed.
    #[error(transparent)]
    Occlusion(TextureSpaceError),
    /// A map of colours is asked for without the colours of the fine mesh.
    #[error("there are no colours of the fine mesh")]
    NoColours,
    /// The coarse mesh cannot have normals, tangents or materials.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The coarse mesh does not fit into glTF.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// A map does not fit into PNG.
    #[error(transparent)]
    Picture(#[from] PictureError),
}

impl MapsError {
    /// Whether the fine mesh is wrong, and not the coarse one.
    #[must_use]
    pub fn is_of_fine(&self) -> bool {
        matches!(self, Self::Fine(_) | Self::Occlusion(_) | Self::NoColours)
    }
}

//! What a file with a motion consists of.

use ga_mesh::gltf::Document;

use super::format::Format;
use crate::bvh::Bvh;
use crate::clip::compressed::CompressedClip;

/// What is in a file with a motion.
#[derive(Clone, Debug)]
pub enum Contents {
    /// A recording as BVH.
    Bvh(Bvh),
    /// A document of glTF.
    Gltf(Box<Document>),
    /// A compressed clip.
    Clip(Box<CompressedClip>),
}

impl Contents {
    /// The format of the file.
    #[must_use]
    pub fn format(&self) -> Format {
        match self {
            Self::Bvh(_) => Format::Bvh,
            Self::Gltf(_) => Format::Gltf,
            Self::Clip(_) => Format::Clip,
        }
    }
}

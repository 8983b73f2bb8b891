//! Between documents and meshes.

mod from_mesh;
mod material;
mod place;
mod to_mesh;

use std::path::Path;

use ga_files::ReadError;

use super::{Document, GltfError, WriteGltfError};
use crate::Mesh;

pub use to_mesh::Vertices;

impl Document {
    /// The meshes of the nodes in a scene, in the rising order of the nodes, as one mesh in the
    /// world. The scene is the default one, or else the first; without scenes all nodes count.
    ///
    /// Each node's mesh is an object of its name. A mesh with morph targets has the shape that its
    /// weights give, one with a skin the place that the joints' nodes give (the frame of its own
    /// node is then ignored). Primitives of points and lines become points and polylines.
    /// Vertices keep their order; the corners of faces refer to their attributes. Where only some
    /// primitives have colours, vertices of the others are white.
    ///
    /// # Errors
    ///
    /// As [`Document::validate`]; [`Problem::Mesh`](super::Problem::Mesh) where a transform takes a
    /// vertex beyond double precision; [`Problem::TooLarge`](super::Problem::TooLarge) where nodes
    /// place more than 16 million vertices and corners of faces, and their meshes more than a
    /// thousand times each on average.
    pub fn to_mesh(&self, vertices: Vertices) -> Result<Mesh, GltfError> {
        to_mesh::mesh(self, vertices)
    }

    /// A mesh as a document: a node for each object, and one for faces without an object; in it a
    /// primitive for each material and set of attributes; one for all polylines of two vertices,
    /// one for each longer polyline, and one for points. Where more than 256 polylines are longer,
    /// all become edges in one primitive.
    ///
    /// A mesh with normals and a texture of normals but no tangents gets them from
    /// [`mikktspace`](crate::tangents::mikktspace). Faces without the texture coordinates that a
    /// texture of their material uses get a copy of the material without it. A vertex is split
    /// where its corners have different attributes. Polygons become triangles as by
    /// [`Faces::triangles`](crate::Faces::triangles). Vertices that nothing uses are left out, as
    /// are tangents where there are no normals, groups, and terms of Phong's model.
    ///
    /// # Errors
    ///
    /// [`Problem::NotFinite`](super::Problem::NotFinite) and the like where a number does not fit
    /// into single precision.
    pub fn from_mesh(mesh: &Mesh) -> Result<Self, GltfError> {
        let document = from_mesh::document(mesh);
        document.validate()?;
        Ok(document)
    }
}

/// Reads the mesh of a `.glb` or `.gltf` file; see [`Document::to_mesh`], with every vertex of the
/// file kept. Paths of textures stay relative to the folder of the file.
///
/// # Errors
///
/// As [`read`](super::read()) and [`Document::to_mesh`].
pub fn read_mesh(path: impl AsRef<Path>) -> Result<Mesh, ReadError<GltfError>> {
    let path = path.as_ref();
    let document = super::read(path)?;
    document
        .to_mesh(Vertices::Kept)
        .map_err(|problem| ReadError::Contents {
            path: path.to_path_buf(),
            problem,
        })
}

/// Writes a mesh as a `.glb` or `.gltf` file; see [`Document::from_mesh`] and
/// [`write`](super::write()).
///
/// # Errors
///
/// As [`Document::from_mesh`] and [`write`](super::write()).
pub fn write_mesh(path: impl AsRef<Path>, mesh: &Mesh) -> Result<(), WriteGltfError> {
    let path = path.as_ref();
    super::write(path, &for_path(path, mesh)?)
}

/// The names and contents of the files that [`write_mesh`] writes, that of the path first.
pub(crate) fn mesh_files(
    path: &Path,
    mesh: &Mesh,
) -> Result<Vec<(String, Vec<u8>)>, WriteGltfError> {
    super::writer::files(path, &for_path(path, mesh)?)
}

fn for_path(path: &Path, mesh: &Mesh) -> Result<Document, WriteGltfError> {
    Document::from_mesh(mesh).map_err(|problem| WriteGltfError::Document {
        path: path.to_path_buf(),
        problem,
    })
}

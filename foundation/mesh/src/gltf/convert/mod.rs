//! Between documents and meshes.

mod from_mesh;
mod material;
mod omissions;
mod place;
mod relocated;
mod to_mesh;

use std::path::Path;

use ga_files::ReadError;

use super::{Document, Element, Problem};
use crate::{FileError, FormatError, Mesh, MeshError};

pub use from_mesh::Target;
pub use place::Placed;
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
    pub fn to_mesh(&self, vertices: Vertices) -> Result<Mesh, FormatError> {
        to_mesh::mesh(self, vertices)
    }

    /// Primitives of the meshes of nodes as one mesh, as [`to_mesh`](Self::to_mesh) makes it, with
    /// their vertices in other places: each is given by its node, its number among the primitives
    /// of the node's mesh, and its places. Those of one node follow each other.
    ///
    /// # Errors
    ///
    /// [`Problem::Missing`](super::Problem::Missing) for a primitive that is not in the document,
    /// and [`Problem::Mesh`](super::Problem::Mesh) where it has another number of vertices, or one
    /// is not at a finite place.
    ///
    /// ```
    /// use ga_mesh::gltf::{Document, Mesh, Node, Placed, Primitive, Vertices};
    ///
    /// let triangle = Primitive { positions: vec![[0.0; 3]; 3], ..Primitive::default() };
    /// let document = Document {
    ///     nodes: vec![Node { mesh: Some(0), ..Node::default() }],
    ///     meshes: vec![Mesh { primitives: vec![triangle], ..Mesh::default() }],
    ///     ..Document::default()
    /// };
    /// let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let placed = Placed { positions, ..Placed::default() };
    /// let mesh = document.placed_mesh([(0, 0, placed)], Vertices::Kept)?;
    /// assert_eq!(mesh.positions()[1].coordinates(), [1.0, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn placed_mesh(
        &self,
        placed: impl IntoIterator<Item = (usize, usize, Placed)>,
        vertices: Vertices,
    ) -> Result<Mesh, FormatError> {
        to_mesh::placed_mesh(self, placed, vertices)
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
    pub fn from_mesh(mesh: &Mesh) -> Result<Self, FormatError> {
        Self::from_mesh_with_targets(mesh, &[])
    }

    /// A mesh with morph targets as a document; see [`Document::from_mesh`]. All weights are 0, so
    /// that the document shows the mesh, until a node or an animation has others. Where the mesh
    /// has normals, a target changes them by the difference between the vertex normals of the mesh
    /// that it moves and those of the mesh at rest. The names of the targets are `targetNames` in
    /// the extra data of each mesh, where most programs look for them.
    ///
    /// # Errors
    ///
    /// As [`Document::from_mesh`]; [`MeshError::VertexCount`](crate::MeshError::VertexCount) in
    /// [`Problem::Mesh`](super::Problem::Mesh) where a target has another number of vertices.
    ///
    /// ```
    /// use ga_mesh::gltf::{Document, Target};
    /// use ga_mesh::{Faces, Mesh};
    /// use ga_runtime::vga3::Vector;
    ///
    /// let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let mesh = Mesh::new(corners, Faces::from_polygons([[0, 1, 2]])?)?;
    /// let displacements = [Vector::ZERO, Vector::ZERO, Vector::new(0.0, 0.5, 0.0)];
    /// let longer = Target { name: "longer", displacements: &displacements };
    /// let document = Document::from_mesh_with_targets(&mesh, &[longer])?;
    /// let target = &document.meshes[0].primitives[0].targets[0];
    /// assert_eq!(target.positions[2], [0.0, 0.5, 0.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_mesh_with_targets(
        mesh: &Mesh,
        targets: &[Target<'_>],
    ) -> Result<Self, FormatError> {
        let expected = mesh.vertex_count();
        let counts = targets.iter().map(|target| target.displacements.len());
        if let Some(found) = counts.into_iter().find(|&found| found != expected) {
            let problem = MeshError::VertexCount { expected, found };
            let problem = Problem::Mesh(problem.into());
            return Err(FormatError::gltf(Element::File, problem));
        }
        let document = from_mesh::document(mesh, targets);
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
pub fn read_mesh(path: impl AsRef<Path>) -> Result<Mesh, ReadError<FormatError>> {
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
pub fn write_mesh(path: impl AsRef<Path>, mesh: &Mesh) -> Result<(), FileError> {
    let path = path.as_ref();
    super::write(path, &for_path(path, mesh)?)
}

/// The names and contents of the files that [`write_mesh`] writes, that of the path first.
pub(crate) fn mesh_files(path: &Path, mesh: &Mesh) -> Result<Vec<(String, Vec<u8>)>, FileError> {
    super::writer::path_files(path, &for_path(path, mesh)?)
}

fn for_path(path: &Path, mesh: &Mesh) -> Result<Document, FileError> {
    Document::from_mesh(mesh).map_err(|problem| FileError::Contents {
        path: path.to_path_buf(),
        problem,
    })
}

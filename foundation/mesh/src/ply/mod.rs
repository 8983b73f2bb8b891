//! PLY, the polygon format of Stanford: as text or binary in either byte order.
//!
//! | element | property | what it is |
//! | --- | --- | --- |
//! | `vertex` | `x y z` | the position, required |
//! | | `nx ny nz` | the normal, made a unit vector; a zero vector stands for none |
//! | | `red green blue alpha` | the colour in sRGB; see below |
//! | | `s t`, `u v`, `texture_u texture_v` | the texture coordinate |
//! | `face` | list `vertex_indices` or `vertex_index` | the polygon |
//! | | list `texcoord` | a texture coordinate for each corner, or nothing |
//! | `tristrips` | list `vertex_indices` or `vertex_index` | triangles in strips, which −1 ends |
//! | `edge` | `vertex1 vertex2` | a polyline of two vertices |
//!
//! Colours of integer types are parts of the greatest value of the type; others are from 0 to 1.
//! Where one of them is above 1 and all are whole numbers from 0 to 255, a
//! [tolerant](ga_files::Reading) reading divides them by 255, with a [`Warning`]; the same holds
//! for opacities. Other numbers are an error.
//!
//! Other elements and properties are read over and dropped: materials and pictures
//! (`comment TextureFile` included), colours of faces, confidence and quality. A file may have
//! vertices alone, as scans do: they are then the points of the mesh. Every number must be finite
//! and every index in range. Before anything is read, the counts in the header are compared with
//! the length of the file, so that a false one costs no memory; elements without properties take no
//! space, so that any count of them is skipped.
//!
//! What PLY has no place for is left out when a mesh is written: groups, objects, materials,
//! tangents, points, further sets of texture coordinates, and normals that differ between the faces
//! at a vertex. Texture coordinates that differ there become `texcoord` lists. Numbers are written
//! as `float` where that loses nothing, else as `double`; colours as bytes likewise. Polylines
//! become edges.
//!
//! The reader is not one from crates.io, since the one that is kept up, `ply-rs-bw`, refuses
//! numbers such as `.5`, does not compare counts with the file, and describes errors in several
//! lines.
//!
//! Source: Turk, *The PLY Polygon File Format*, 1994.

mod body;
mod header;
mod problem;
mod read;
mod warning;
mod write;

use std::path::Path;

use ga_files::{ReadError, Reading, WriteError};

use crate::{FormatError, Mesh};

pub use header::Encoding;
pub use problem::{Place, PlyProblem};
pub use warning::Warning;
pub use write::encode;

/// Reads the mesh in a file tolerantly.
///
/// # Errors
///
/// [`ReadError::Io`], or [`ReadError::Contents`] as [`decode`] gives.
pub fn read(path: impl AsRef<Path>) -> Result<Mesh, ReadError<FormatError>> {
    ga_files::read(path, decode)
}

/// Reads the mesh in a file, and says what was decided where it is not clear. A strict reading
/// refuses what deviates from the format.
///
/// # Errors
///
/// As [`read`].
pub fn read_with_warnings(
    path: impl AsRef<Path>,
    reading: Reading,
) -> Result<(Mesh, Vec<Warning>), ReadError<FormatError>> {
    ga_files::read(path, |bytes| read::mesh(bytes, reading))
}

/// Reads a mesh from the bytes of a file tolerantly.
///
/// # Errors
///
/// [`FormatError`], for the first fault; indices out of range are found after all other errors.
///
/// # Examples
///
/// ```
/// let text = b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
///     property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
///     0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
/// let mesh = ga_mesh::ply::decode(text)?;
/// assert_eq!(mesh.triangles(), [[0, 1, 2]]);
/// # Ok::<(), ga_mesh::FormatError>(())
/// ```
pub fn decode(bytes: &[u8]) -> Result<Mesh, FormatError> {
    read::mesh(bytes, Reading::Tolerant).map(|(mesh, _)| mesh)
}

/// Writes a mesh to a file, whole or not at all.
///
/// # Errors
///
/// [`WriteError`]; an earlier file of that name then stays as it was.
pub fn write(path: impl AsRef<Path>, mesh: &Mesh, encoding: Encoding) -> Result<(), WriteError> {
    ga_files::write(path, &encode(mesh, encoding))
}

//! Polygon meshes: vertices in the order of their file, faces with any number of corners.
//!
//! A [`Mesh`] is a list of conformal points and a list of polygons that refer to them by index.
//! Polygons are kept as they were read, quadrilaterals included; [`Mesh::triangles`] splits them.
//! No function here splits or merges vertices, so that weights, morph targets and other data that
//! are numbered by vertex stay valid.
//!
//! | module or type | what it is |
//! | --- | --- |
//! | [`Mesh`], [`Faces`], [`Polylines`] | the data |
//! | [`CornerAttribute`], [`Tangent`], [`Group`] | attributes of corners, named sets of faces |
//! | [`Material`], [`Texture`] | the appearance of faces |
//! | [`bounds`] | the box around points |
//! | [`Part`] | the faces of one group as a mesh of their own |
//! | [`atlas`], [`MeshAtlas`] | cuts a surface into charts and places them in a texture |
//! | [`bake`] | maps of a fine surface for a coarse one: normals, displacement, colour, occlusion |
//! | [`query`] | nearest points, rays, overlaps |
//! | [`geodesic`] | distances along the surface |
//! | [`subdivision`] | Loop and Catmull–Clark surfaces with creases, stencils and limits |
//! | [`normals`], [`tangents`] | smooth normals, tangents for normal maps |
//! | [`obj`] | reads and writes Wavefront OBJ |
//! | [`ply`] | reads and writes PLY |
//! | [`mod@format`] | reads and writes files by the ending of their names |
//! | [`Omission`] | what a format cannot hold |
//! | [`Summary`] | what a mesh consists of, in numbers |
//! | [`topology`] | edges, rings, components; a report on what is irregular |
//! | [`gltf`] | reads and writes glTF with materials, skins and animations |
//!
//! # Conventions
//!
//! Coordinates are right-handed. Readers keep the unit of the file; [`Mesh::scaled`] converts it.
//! Indices count from 0. Seen from outside, the corners of a face run counter-clockwise.
//!
//! ```
//! let mesh = ga_mesh::obj::decode(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")?;
//! let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
//! let normals = ga_mesh::normals::vertex_normals(&positions, &mesh.triangles());
//! assert_eq!(normals, [[0.0, 0.0, 1.0]; 4]);
//! # Ok::<(), ga_mesh::FormatError>(())
//! ```

pub mod atlas;
mod attribute;
pub mod bake;
mod colour_range;
mod colour_space;
mod error;
mod faces;
mod file_error;
pub mod format;
mod format_error;
pub mod geodesic;
pub mod gltf;
mod lists;
mod material;
mod mesh;
mod mesh_atlas;
pub mod normals;
pub mod obj;
mod omission;
mod places;
pub mod ply;
mod polygon;
mod polylines;
pub mod query;
mod relocation;
pub mod subdivision;
mod summary;
pub mod tangents;
mod texture_space_error;
pub mod topology;
mod warning;
mod words;

pub use attribute::{CornerAttribute, Normals, Rgba, Tangent, Tangents, TextureCoordinates};
pub use error::MeshError;
pub use faces::{Faces, Polygons};
pub use file_error::FileError;
pub use format_error::FormatError;
pub use material::{AlphaMode, Filter, Image, Material, Minification, Phong, Texture, Wrap};
pub use mesh::{Group, Mesh, Part, Position};
pub use mesh_atlas::MeshAtlas;
pub use omission::Omission;
pub use places::bounds;
pub use polylines::Polylines;
pub use summary::{Bounds, Fault, NamedFaces, Summary};
pub use texture_space_error::TextureSpaceError;
pub use warning::Warning;

//! Which vertices, edges and faces of a mesh meet.
//!
//! | type | what it is |
//! | --- | --- |
//! | [`Edges`] | the edges of a mesh: the faces at each edge, the edge at each side of a face |
//! | [`Neighbours`] | the vertices that an edge joins each vertex to |
//! | [`VertexCorners`] | the corners of faces at each vertex |
//! | [`VertexRings`], [`Fan`] | the faces and edges around each vertex, in order |
//! | [`Components`] | the connected parts |
//! | [`Report`] | whether the mesh is a regular surface, and where it is not |
//!
//! The tables are lists of indices, filled by counting sort. They accept any mesh, also one with
//! edges of three faces or with faces that name a vertex twice, so that a report can name such
//! elements.
//!
//! The *corner* c of a mesh is position c of [`Faces::corners`](crate::Faces::corners). The *side*
//! c of a face runs from the vertex at corner c to the vertex at the face's next corner.

mod components;
mod corners;
mod edges;
mod neighbours;
mod outline;
mod report;
mod rings;
mod sides;
mod union;

pub use components::Components;
pub use corners::VertexCorners;
pub use edges::Edges;
pub use neighbours::Neighbours;
pub use report::Report;
pub(crate) use rings::non_manifold_vertices;
pub use rings::{Fan, VertexRings};
pub(crate) use union::DisjointSets;

//! Pictures for [`ga_mesh::bake`]: the colours of a fine mesh, and maps as files hold them.
//!
//! [`MeshColours`] are what [`Bake::colour`](ga_mesh::bake::Bake::colour) takes. Normals and shares
//! become codes of 8 bits, linear light becomes sRGB, and heights become codes of 16 bits over a
//! [`HeightRange`].

mod colour;
mod picture;

pub use colour::MeshColours;
pub use picture::{HeightRange, colour_picture, height_picture, normal_picture, share_picture};

//! Pictures for [`ga_mesh::bake`]: the colours of a fine mesh, and maps as files hold them.
//!
//! [`Maps`] are all maps of a fine mesh for a coarse one, with the files that show them.
//! [`MeshColours`] are what [`Bake::colour`](ga_mesh::bake::Bake::colour) takes. Normals and shares
//! become codes of 8 bits, linear light becomes sRGB, and heights become codes of 16 bits over a
//! [`HeightRange`].

mod colour;
mod error;
mod maps;
mod picture;

pub use colour::MeshColours;
pub use error::MapsError;
pub use maps::{MapKind, Maps, MapsOptions, MapsReport};
pub use picture::{HeightRange, colour_picture, height_picture, normal_picture, share_picture};

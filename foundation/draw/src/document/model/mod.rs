//! A model of triangles that turns under the pointer.

mod check;
mod data;
mod part;
mod parts;
mod scale;
mod sight;
#[cfg(test)]
mod tests;
mod view;

pub use check::ModelError;
pub use view::{ModelCoordinates, ModelTexture, ModelView};

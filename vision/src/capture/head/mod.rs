//! The mesh of a head that follows captured points.

mod area;
mod document;
mod fit;
mod placement;
mod surface;

pub use area::KeyArea;
pub use fit::KeyFit;
pub use surface::{HeadMotion, HeadSurface};

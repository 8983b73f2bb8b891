//! Draws conformal geometric algebra.

mod camera;
mod escape;
mod extent;
mod file;
mod label;
mod page;
mod picture;
mod scene;
mod shape;
mod stroke;
mod style;
mod surface;
mod svg;
mod vector3;
mod view;

pub use file::{ElementError, SceneError};
pub use scene::Scene;
pub use shape::{Drawable, NotDrawable, Shape, Trajectory};
pub use style::{Colour, NotAColour, PALETTE, Style};
pub use view::{Projection, Up, View};

//! A motion that plays under the mouse, beside the films that it comes from.

mod check;
mod data;
mod model;
mod part;
mod still;
#[cfg(test)]
mod tests;

pub use check::{FilmProblem, MotionError};
pub use model::{Bone, Encoding, Motion, MotionCamera, MotionFilm, MotionPicture, Side};

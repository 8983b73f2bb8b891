//! Filters: each pixel becomes a weighted sum of its neighbourhood.

mod border;
mod gaussian;
mod gradient;
mod separable;
mod tent;

pub use border::Border;
pub use gaussian::Gaussian;
pub use gradient::Gradient;
pub(crate) use gradient::SlopeRows;
pub(crate) use separable::Continued;

//! Filters: each pixel becomes a weighted mean of its neighbourhood.

mod border;
mod gaussian;
mod separable;
mod tent;

pub use border::Border;
pub use gaussian::{Gaussian, SigmaError};
pub(crate) use separable::{Continued, to_floats};

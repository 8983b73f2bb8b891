//! The declarations of the algebras.

mod conformal;
mod projective;

pub use conformal::cga3;
pub use projective::pga3;

//! The declarations of the algebras.

mod conformal;
#[cfg(feature = "pga3")]
mod projective;

pub use conformal::cga3;
#[cfg(feature = "pga3")]
pub use projective::pga3;

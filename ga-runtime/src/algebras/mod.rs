//! The declarations of the algebras.

mod conformal;
#[cfg(feature = "cga2")]
mod conformal_plane;
#[cfg(feature = "vga3")]
mod euclidean;
#[cfg(feature = "vga2")]
mod euclidean_plane;
#[cfg(feature = "pga3")]
mod projective;
#[cfg(feature = "pga2")]
mod projective_plane;
#[cfg(feature = "sta")]
mod spacetime;

pub use conformal::cga3;
#[cfg(feature = "cga2")]
pub use conformal_plane::cga2;
#[cfg(feature = "vga3")]
pub use euclidean::vga3;
#[cfg(feature = "vga2")]
pub use euclidean_plane::vga2;
#[cfg(feature = "pga3")]
pub use projective::pga3;
#[cfg(feature = "pga2")]
pub use projective_plane::pga2;
#[cfg(feature = "sta")]
pub use spacetime::sta;

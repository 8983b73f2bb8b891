//! The declarations of the algebras, each in the file of its name.

#[cfg(feature = "cga2")]
pub(crate) mod cga2;
pub(crate) mod cga3;
#[cfg(feature = "pga2")]
pub(crate) mod pga2;
#[cfg(feature = "pga3")]
pub(crate) mod pga3;
#[cfg(feature = "sta")]
pub(crate) mod sta;
#[cfg(feature = "vga2")]
pub(crate) mod vga2;
pub(crate) mod vga3;

//! Conformal geometric algebra that costs nothing.
#![cfg_attr(not(feature = "std"), no_std)]
extern crate alloc;
// The macros of this crate name it by its own path, here as everywhere.
extern crate self as ga_runtime;

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;
mod algebras;
pub mod dense;
mod element;
mod geometry;
mod macros;
pub mod products;
pub mod scalar;
#[cfg(feature = "testing")]
pub mod testing;

pub use algebras::{cga3, pga3};
pub use element::Element;

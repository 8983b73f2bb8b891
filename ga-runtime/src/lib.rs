#![doc = include_str!("../docs/guide.md")]
#![cfg_attr(not(feature = "std"), no_std)]
extern crate alloc;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!(
    "ga-runtime needs a source of elementary functions: enable its feature `std` (the default), or \
     `libm` for builds without the standard library"
);

// Before the algebras, so that on the pages of the types the constructors come first.
pub mod geometry;

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;
mod algebras;
pub mod batch;
#[doc = include_str!("../docs/conventions.md")]
#[doc = ""]
#[doc = include_str!("../docs/limits.svg")]
pub mod conventions {}
pub mod dense;
mod element;
mod instruction_set;
pub mod interop;
pub mod linear;
mod macros;
pub mod products;
pub mod scalar;
#[cfg(feature = "testing")]
pub mod testing;
mod unsafe_code;

#[doc = include_str!("../docs/translation.md")]
pub mod translation {}

// All of each file is the module and, hidden, the macro of an algebra. By its name, the macro would
// stand among the re-exports of this crate.
#[cfg(feature = "cga2")]
pub use algebras::cga2::*;
pub use algebras::cga3::*;
#[cfg(feature = "pga2")]
pub use algebras::pga2::*;
#[cfg(feature = "pga3")]
pub use algebras::pga3::*;
#[cfg(feature = "sta")]
pub use algebras::sta::*;
#[cfg(feature = "vga2")]
pub use algebras::vga2::*;
pub use algebras::vga3::*;
// After the algebras, so that rustc names their types by the paths of the algebras.
#[doc(hidden)]
#[path = "prelude.rs"]
pub mod __prelude;
#[doc(inline)]
pub use __prelude as prelude;
// Never there: rustc lists them in notes on unresolved imports, and names the feature, which it
// does not for what a `*` would have imported.
#[cfg(all(feature = "cga2", not(feature = "cga2")))]
pub mod cga2 {}
#[cfg(all(feature = "pga2", not(feature = "pga2")))]
pub mod pga2 {}
#[cfg(all(feature = "pga3", not(feature = "pga3")))]
pub mod pga3 {}
#[cfg(all(feature = "sta", not(feature = "sta")))]
pub mod sta {}
#[cfg(all(feature = "vga2", not(feature = "vga2")))]
pub mod vga2 {}
pub use element::{Coefficients, Element, NotMember, ParseElementError};

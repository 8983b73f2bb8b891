//! All unsafe code of the workspace, in one folder, so that it can be reviewed as a whole. There
//! are three kinds:
//!
//! - A loop compiled for AVX2 or AVX-512 is called after a check that the processor has these
//!   instructions. A call on another processor would be undefined behaviour; the functions of this
//!   folder are the only callers. The product of two motors is compiled for SSE, on targets that
//!   have it.
//! - The contents of a vector register are read as an array of as many numbers.
//! - bytemuck's traits `Zeroable` and `Pod` are implemented for the declared types. They state that
//!   a type has no padding and that any bits are a valid value; the layout is checked by assertions
//!   when the crate is compiled.

#![allow(unsafe_code)]

pub(crate) mod instructions;
#[cfg(feature = "bytemuck-1")]
mod plain_memory;
#[cfg(target_arch = "x86_64")]
pub(crate) mod registers;
mod work;

pub use work::Work;
pub(crate) use work::run;

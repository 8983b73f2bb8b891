//! Reading and writing of whole files, for every crate that has a file format.
//!
//! - [`read`] reads a file and hands its bytes to a parser; a [`ReadError`] names the file and says
//!   what the parser found wrong.
//! - [`write`](write()) replaces a file in one step: a reader never sees a half-written file.
//! - [`write_together`] writes several files, whatever their folders, all of them or none.
//! - [`Staged`] does so for files that are not in memory at the same time.
//! - [`write_all`] writes several files into a folder, all of them or none.

mod read;
mod write;
mod write_all;

pub use read::{ReadError, read};
pub use write::{Staged, WriteError, write, write_together};
pub use write_all::write_all;

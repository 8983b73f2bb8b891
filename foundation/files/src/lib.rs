//! Reading and writing of whole files, for every crate that has a file format.
//!
//! - [`read`] reads a file and hands its bytes to a parser; a [`ReadError`] names the file and says
//!   what the parser found wrong.
//! - [`write`](write()) replaces a file in one step: a reader never sees a half-written file.
//! - [`write_together`] writes several files, whatever their folders, all of them or none.
//! - [`Staged`] does so for files that are not in memory at the same time.
//! - [`write_all`] writes several files into a folder, all of them or none.
//! - [`check`] says before the work whether a file can be written, and [`is_stream`] whether its
//!   bytes go to a device or a pipe.
//! - [`name`] and [`stem`] are the name of a file without its folders.
//! - [`expand`] takes names and patterns of files, and [`natural_order`] sorts by numbers in names.
//! - [`frames`] finds which pictures of several cameras belong together, by the same numbers.
//! - [`Outputs`] sees to it that no output takes the place of an input or of another output.
//! - [`table`] reads and writes rows of cells, as CSV.
//! - [`text`] finds the encoding of text and the ends of its lines.
//! - [`Reading`] is strict or tolerant; [`Deviations`] are what a tolerant one warns of.
//! - [`TemporaryFolder`] is a folder for the time of the work.
//! - [`remove_temporaries`] is for a program that ends at a signal.

mod error;
mod frames;
mod list;
mod name;
mod outputs;
mod read;
mod reading;
pub mod table;
mod target;
mod temporary;
pub mod text;
mod write;
mod write_all;

pub use error::WriteError;
pub use frames::{Frames, FramesBy, FramesError, frames};
pub use list::{ListError, expand, natural_order};
pub use name::{name, stem};
pub use outputs::{OutputError, Outputs};
pub use read::{ReadError, read};
pub use reading::{Deviation, Deviations, Reading, Tolerated};
pub use target::{check, is_same_file, is_standard_output, is_stream};
pub use temporary::{TemporaryFolder, remove_temporaries};
pub use write::{Staged, WriteSeek, write, write_together};
pub use write_all::write_all;

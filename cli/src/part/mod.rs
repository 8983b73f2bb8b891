//! Parts of the work of a command: `--frames A..B` makes one, and `nullcone merge` joins them to
//! what the command makes of all frames in one process.
//!
//! - [`Frames`]: which frames a part has; [`PartArguments`]: the options of commands that measure.
//! - [`About`]: what a part is of; [`Part`]: that and what was found, as a file of JSON.
//! - [`FilmPart`]: the part of a film, which is described beside it.
//! - [`Parts`]: parts that belong together, in the order of their frames; [`Outputs`]: what is made
//!   of them.

mod about;
mod arguments;
mod file;
mod film;
mod frames;
mod outputs;
mod parts;
mod written;

pub(crate) use about::About;
pub(crate) use arguments::PartArguments;
pub(crate) use file::Part;
pub(crate) use film::{FilmPart, beside};
pub(crate) use frames::Frames;
pub(crate) use outputs::Outputs;
pub(crate) use parts::Parts;
pub(crate) use written::PartWritten;

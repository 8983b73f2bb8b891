//! What a reader of mesh files warns of.

use std::fmt;
use std::path::PathBuf;

/// Something in a mesh file, or in a file beside it, that deviates from the format, is missing, or
/// is left out; the mesh was read nevertheless.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// What it is, as one word for programs.
    pub kind: &'static str,
    /// The file beside the mesh file that it is in, as a library of materials; `None` for the mesh
    /// file itself.
    pub file: Option<PathBuf>,
    /// The line of the file, from 1, where it is about one.
    pub line: Option<usize>,
    /// The sentence for people, which names the line too.
    pub message: String,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

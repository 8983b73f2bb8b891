//! What can go wrong when a file is written.

use std::io;
use std::path::PathBuf;

/// A file that could not be written. An earlier file of its name is unchanged.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {}: {source}", path.display())]
pub struct WriteError {
    /// The file that was to be written.
    pub path: PathBuf,
    /// What the operating system said.
    pub source: io::Error,
}

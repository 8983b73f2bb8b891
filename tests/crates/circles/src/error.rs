//! What keeps a crate from being read.

use std::io;
use std::path::PathBuf;

/// Why the files of a crate could not be compared.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file cannot be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A file is not Rust.
    #[error("{}: {source}", path.display())]
    Parse {
        /// The file.
        path: PathBuf,
        /// What the parser says.
        source: syn::Error,
    },
    /// A module has no file.
    #[error("{}: the module `{module}` has no file", path.display())]
    NoFile {
        /// The file that declares the module.
        path: PathBuf,
        /// The module's name.
        module: String,
    },
}

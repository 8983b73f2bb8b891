use std::io;
use std::path::{Path, PathBuf};

/// A file could not be read, or does not hold what it should; `E` says what is wrong with the
/// contents.
#[derive(Debug, thiserror::Error)]
pub enum ReadError<E> {
    /// The operating system could not read the file.
    #[error("cannot read {}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: io::Error,
    },
    /// The contents are wrong.
    #[error("{}: {problem}", path.display())]
    Contents {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where in the file.
        problem: E,
    },
}

/// Reads a file whole and hands its bytes to `parse`.
pub(crate) fn read_with<T, E>(
    path: &Path,
    parse: impl FnOnce(&[u8]) -> Result<T, E>,
) -> Result<T, ReadError<E>> {
    let bytes = std::fs::read(path).map_err(|source| ReadError::Io {
        path: path.to_path_buf(),
        source,
    })?;
    parse(&bytes).map_err(|problem| ReadError::Contents {
        path: path.to_path_buf(),
        problem,
    })
}

//! Reading.

use std::io;
use std::path::{Path, PathBuf};

/// A file that could not be read, or whose contents are not what they should be; `E` says what is
/// wrong with them.
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

impl<E> ReadError<E> {
    /// The error of the same file with its problem as a part of a larger family.
    #[must_use]
    pub fn map<F>(self, into: impl FnOnce(E) -> F) -> ReadError<F> {
        match self {
            Self::Io { path, source } => ReadError::Io { path, source },
            Self::Contents { path, problem } => ReadError::Contents {
                path,
                problem: into(problem),
            },
        }
    }
}

/// Reads a whole file and hands its bytes to `parse`.
///
/// # Errors
///
/// [`ReadError::Io`] when the file cannot be read, and [`ReadError::Contents`] with the error of
/// `parse`.
///
/// # Examples
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("number.txt");
/// std::fs::write(&path, b"1.5 metres")?;
/// let number = ga_files::read(&path, |bytes| String::from_utf8_lossy(bytes).parse::<f64>());
/// let message = number.unwrap_err().to_string();
/// assert!(message.ends_with("number.txt: invalid float literal"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read<T, E>(
    path: impl AsRef<Path>,
    parse: impl FnOnce(&[u8]) -> Result<T, E>,
) -> Result<T, ReadError<E>> {
    let path = path.as_ref();
    let bytes = std::fs::read(path).map_err(|source| ReadError::Io {
        path: path.to_path_buf(),
        source,
    })?;
    parse(&bytes).map_err(|problem| ReadError::Contents {
        path: path.to_path_buf(),
        problem,
    })
}

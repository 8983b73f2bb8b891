//! Writing what an encoder made.

use std::path::{Path, PathBuf};

use ga_files::WriteError;

use crate::format_error::FormatError;

/// A picture that could not be written to a file.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The picture has no form in the format.
    #[error("{}: {problem}", path.display())]
    Contents {
        /// The file.
        path: PathBuf,
        /// Why.
        problem: FormatError,
    },
    /// The name of the file has no ending that stands for a format in which pictures are written.
    #[error("{}: the ending is not png, ppm, pgm, pnm or pfm", path.display())]
    Unknown {
        /// The file.
        path: PathBuf,
    },
    /// The file could not be written.
    #[error(transparent)]
    Write(#[from] WriteError),
}

/// Writes what an encoder made.
pub(crate) fn save(path: &Path, encoded: Result<Vec<u8>, FormatError>) -> Result<(), FileError> {
    let bytes = encoded.map_err(|problem| FileError::Contents {
        path: path.to_path_buf(),
        problem,
    })?;
    Ok(ga_files::write(path, &bytes)?)
}

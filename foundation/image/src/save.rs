//! Writing what an encoder made.

use std::path::{Path, PathBuf};

use ga_files::WriteError;

use crate::error::EncodeError;

/// A picture that could not be written to a file.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    /// The picture has no form in the format.
    #[error("{}: {problem}", path.display())]
    Encode {
        /// The file.
        path: PathBuf,
        /// Why.
        problem: EncodeError,
    },
    /// The name of the file has no ending that stands for a format in which pictures are written.
    #[error("{}: the ending is not png, ppm, pgm, pnm or pfm", path.display())]
    Ending {
        /// The file.
        path: PathBuf,
    },
    /// The file could not be written.
    #[error(transparent)]
    Write(#[from] WriteError),
}

/// Writes what an encoder made.
pub(crate) fn save(path: &Path, encoded: Result<Vec<u8>, EncodeError>) -> Result<(), SaveError> {
    let bytes = encoded.map_err(|problem| SaveError::Encode {
        path: path.to_path_buf(),
        problem,
    })?;
    Ok(ga_files::write(path, &bytes)?)
}

//! What is said of the part of a film, in a file beside it.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

/// The part of a film.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct FilmPart {
    /// The name of the film, in the folder of the part.
    film: String,
    pub(crate) bytes: usize,
}

impl FilmPart {
    pub(crate) fn new(film: &Path, bytes: usize) -> Self {
        Self {
            film: ga_files::name(film),
            bytes,
        }
    }

    /// Where the film lies whose part is in a file.
    pub(crate) fn path(&self, part: &Path) -> PathBuf {
        part.with_file_name(&self.film)
    }
}

/// The file of the part that is a film: it lies beside it.
pub(crate) fn beside(film: &Path) -> PathBuf {
    let mut name = film.as_os_str().to_owned();
    name.push(".json");
    name.into()
}

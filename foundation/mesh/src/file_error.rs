//! Why a mesh file cannot be read or written.

use std::path::PathBuf;

use ga_files::{ReadError, WriteError};

use crate::{FormatError, MeshError};

/// A mesh file that could not be read or written. Files that were there before are unchanged.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The name of the file has no ending that stands for a format.
    #[error("{}: the name of a mesh file must end in {}", path.display(), listed(endings))]
    Unknown {
        /// The file.
        path: PathBuf,
        /// The endings of all formats, without the point.
        endings: Vec<&'static str>,
    },
    /// The file could not be read, or its contents are wrong.
    #[error(transparent)]
    Read(#[from] ReadError<FormatError>),
    /// What was to be written does not fit the format.
    #[error("cannot write {}: {problem}", path.display())]
    Contents {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        problem: FormatError,
    },
    /// The operating system could not write a file.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// No relative path leads to a picture, which lies on another drive or in a folder whose name
    /// is not Unicode.
    #[error("no relative path leads from the output to the picture {}", path.display())]
    Picture {
        /// The picture.
        path: PathBuf,
    },
    /// The data do not form a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// Endings as in `.obj, .glb or .gltf`.
fn listed(endings: &[&str]) -> String {
    match endings {
        [others @ .., last] if !others.is_empty() => format!(".{} or .{last}", others.join(", .")),
        endings => endings.concat(),
    }
}

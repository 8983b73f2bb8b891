//! Meshes as they are written.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use ga_mesh::Mesh;
use ga_mesh::format::{self, Options};

use crate::format::Format;
use crate::standard_output::is_standard_output;

/// The paths and contents of the files of a mesh, that at `out` first.
///
/// # Errors
///
/// The mesh does not fit the format, or needs files beside the first, and that goes to standard
/// output, a device or a pipe.
pub(crate) fn files(
    out: &Path,
    format: Format,
    mesh: &Mesh,
    options: &Options,
) -> Result<Vec<(PathBuf, Vec<u8>)>> {
    if !is_standard_output(out) && !ga_files::is_stream(out) {
        return Ok(format::encode_files(out, mesh, options)?);
    }
    let ending = format.endings().first().copied().unwrap_or_default();
    let mut files = format::encode_files(format!("model.{ending}"), mesh, options)?;
    if let Some((path, _)) = files.get(1) {
        bail!(
            "{}: the mesh needs several files, such as {}, and they need a folder",
            out.display(),
            path.display()
        );
    }
    for (path, _) in &mut files {
        *path = out.to_path_buf();
    }
    Ok(files)
}

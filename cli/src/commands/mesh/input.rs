//! Reading meshes.

use std::path::Path;

use anyhow::Result;
use ga_mesh::{Mesh, format};

/// Reads a mesh, and says on standard error what its file refers to that is not there.
pub(super) fn read(file: &Path, quiet: bool) -> Result<(Mesh, Vec<String>)> {
    let (mesh, warnings) = format::read(file)?;
    if !quiet {
        for warning in &warnings {
            eprintln!("warning: {}: {warning}", file.display());
        }
    }
    Ok((mesh, warnings))
}

//! Reading meshes.

use std::path::Path;

use anyhow::Result;
use ga_mesh::format::{self, Loaded};

/// Reads a mesh, and says on standard error what its file refers to that is not there.
pub(super) fn read(file: &Path, quiet: bool) -> Result<Loaded> {
    let loaded = format::read(file)?;
    if !quiet {
        for warning in &loaded.warnings {
            eprintln!("warning: {}: {warning}", file.display());
        }
    }
    Ok(loaded)
}

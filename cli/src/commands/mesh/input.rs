//! Reading meshes.

use std::path::Path;

use anyhow::Result;
use ga_mesh::Mesh;
use ga_mesh::format::{self, Loaded};

use crate::frame::Warning;

/// Reads a mesh, with warnings of what its file refers to that is not there.
pub(super) fn read(file: &Path) -> Result<(Mesh, Vec<Warning>)> {
    let (mesh, warnings) = format::read(file)?;
    let warnings = warnings.into_iter();
    let warnings = warnings.map(|text| Warning::new("missing_part", text).in_file(file));
    Ok((mesh, warnings.collect()))
}

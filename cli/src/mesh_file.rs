//! Meshes as they are read and written.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use ga_mesh::format::{self, Options};
use ga_mesh::{Image, Mesh, obj};

use crate::format::Format;
use crate::frame::{Warning, keep_for_failure};
use crate::standard_output::is_standard_output;

/// Reads a mesh, with warnings of what its file refers to that is not there.
pub(crate) fn read(file: &Path) -> Result<(Mesh, Vec<Warning>)> {
    let (mesh, warnings) = format::read(file)?;
    let warnings = missing_parts(file, warnings);
    keep_for_failure(&warnings);
    Ok((mesh, warnings))
}

/// Warnings of what the file of a mesh refers to that is not there.
pub(crate) fn missing_parts(
    file: &Path,
    sentences: impl IntoIterator<Item = String>,
) -> Vec<Warning> {
    let sentences = sentences.into_iter();
    let warnings = sentences.map(|text| Warning::new("missing_part", text).in_file(file));
    warnings.collect()
}

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

/// Fails where one of some outputs would replace, with other contents, a library of materials or a
/// picture that a mesh which is read refers to.
pub(crate) fn check_parts(
    option: &str,
    meshes: &[&PathBuf],
    outputs: &[(PathBuf, Vec<u8>)],
) -> Result<()> {
    for (path, contents) in outputs {
        // Most outputs are new, and then no mesh needs to be read again.
        if !path.exists() || std::fs::read(path).is_ok_and(|found| found == *contents) {
            continue;
        }
        for mesh in meshes {
            let mut parts = parts(mesh)?.into_iter();
            if parts.any(|part| ga_files::is_same_file(part, path)) {
                bail!(
                    "{option} {}: it is a part of the input {}, which would be lost",
                    path.display(),
                    mesh.display()
                );
            }
        }
    }
    Ok(())
}

/// The libraries of materials and the pictures that the file of a mesh refers to.
fn parts(file: &Path) -> Result<Vec<PathBuf>> {
    let folder = file.parent().unwrap_or(Path::new(""));
    let mut parts = Vec::new();
    let mesh = if Format::Obj.fits(file) {
        let mut library = |name: &str| {
            let path = folder.join(name);
            let bytes = std::fs::read(&path)?;
            parts.push(path);
            Ok(bytes)
        };
        ga_files::read(file, |bytes| {
            obj::decode_with_libraries(bytes, &mut library)
        })?
        .0
    } else {
        format::read(file)?.0
    };
    for texture in mesh.materials().iter().flat_map(|m| m.textures()) {
        if let Image::File(path) = &texture.image {
            parts.push(folder.join(path));
        }
    }
    Ok(parts)
}

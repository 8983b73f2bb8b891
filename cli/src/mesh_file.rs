//! Meshes as they are read and written.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use ga_mesh::Mesh;
use ga_mesh::format::{self, Options};
use serde::Serialize;

use crate::format::{Format, endings};
use crate::frame::{Warning, keep_for_failure};
use crate::output::Staging;
use crate::reading::reading;
use crate::standard_output::is_standard_output;

/// Reads a mesh, with warnings of what in its file deviates from the format, and of what it refers
/// to that is not there.
pub(crate) fn read(file: &Path) -> Result<(Mesh, Vec<Warning>)> {
    let (mesh, warnings) = format::read(file, reading())?;
    Ok((mesh, warnings_of(file, warnings)))
}

/// The warnings of a file that was read, which are also kept for the case that the command fails.
pub(crate) fn warnings_of(file: &Path, found: Vec<ga_mesh::Warning>) -> Vec<Warning> {
    let warnings = found.into_iter().map(|found| Warning {
        line: found.line,
        ..Warning::new(found.kind, &found).in_file(found.file.as_deref().unwrap_or(file))
    });
    let warnings: Vec<Warning> = warnings.collect();
    keep_for_failure(&warnings);
    warnings
}

/// The formats of meshes that fit, by their endings, of which the first goes to standard output.
pub(crate) fn formats(fits: impl Fn(format::Format) -> bool) -> Vec<Format> {
    let mut formats = format::Format::ALL.to_vec();
    formats.retain(|format| fits(*format));
    formats.sort_by_key(|format| format.endings());
    formats.into_iter().map(Format::Mesh).collect()
}

/// All formats of meshes, with the one first that goes to standard output.
pub(crate) fn all_formats(first: format::Format) -> Vec<Format> {
    let mut formats = formats(|_| true);
    formats.sort_by_key(|format| *format != Format::Mesh(first));
    formats
}

/// The endings of all files that are read, as in `.obj, .ply or .glb`.
pub(crate) fn read_endings() -> String {
    endings(&format::Format::ALL.map(Format::Mesh))
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

/// What is reported of a mesh that was written.
#[derive(Debug, Serialize)]
pub(crate) struct Written {
    pub(crate) vertices: usize,
    pub(crate) faces: usize,
    pub(crate) files: Vec<String>,
}

/// Writes the [files](files()) of a mesh.
pub(crate) fn write(
    mesh: &Mesh,
    files: &[(PathBuf, Vec<u8>)],
    outputs: &Staging,
) -> Result<Written> {
    write_counted([mesh.vertex_count(), mesh.faces().len()], files, outputs)
}

/// Writes files with so many vertices and faces.
pub(crate) fn write_counted(
    [vertices, faces]: [usize; 2],
    files: &[(PathBuf, Vec<u8>)],
    outputs: &Staging,
) -> Result<Written> {
    outputs.write_all(files)?;
    let paths = files.iter().map(|(path, _)| path.display().to_string());
    Ok(Written {
        vertices,
        faces,
        files: paths.collect(),
    })
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
    files_at(out, format, |path| {
        Ok(format::encode_files(path, mesh, options)?)
    })
}

/// As [`files`](files()), as a function gives them for a path.
pub(crate) fn files_at(
    out: &Path,
    format: Format,
    files: impl FnOnce(&Path) -> Result<Vec<(PathBuf, Vec<u8>)>>,
) -> Result<Vec<(PathBuf, Vec<u8>)>> {
    if !is_standard_output(out) && !ga_files::is_stream(out) {
        return files(out);
    }
    let ending = format.endings().first().copied().unwrap_or_default();
    let mut files = files(Path::new(&format!("model.{ending}")))?;
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

/// Fails where one of some outputs would replace, with other contents, a library of materials, a
/// picture or a buffer that a mesh which is read refers to.
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
            let mut parts = format::parts(mesh, reading())?.into_iter();
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

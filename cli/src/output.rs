//! Files in a folder, all of them or none.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

/// A file to be written.
pub(crate) struct File {
    pub(crate) name: &'static str,
    pub(crate) contents: Vec<u8>,
}

/// Fails early where a folder cannot take these files.
pub(crate) fn check_place(folder: &Path, names: &[&str]) -> Result<()> {
    if let Some(existing) = folder.ancestors().find(|path| path.exists()) {
        ensure!(
            existing.is_dir(),
            "cannot make the folder {}: {} is a file",
            folder.display(),
            existing.display()
        );
    }
    for name in names {
        let place = folder.join(name);
        ensure!(
            !place.is_dir(),
            "cannot write {}: a folder of that name is in its place",
            place.display()
        );
    }
    Ok(())
}

/// Writes the files into a folder, in place of any of the same names, making the folder and those
/// above it.
///
/// All files are complete in a hidden folder beside their final names before the first of them is
/// moved there. When one cannot be written, the folder stays as it was, and folders that were
/// created are removed.
pub(crate) fn write_all(folder: &Path, files: &[File]) -> Result<()> {
    let made = missing_folders(folder);
    write_staged(folder, files).inspect_err(|_| {
        for folder in made {
            // This removes empty folders only, so that files of other programs stay.
            let _ = fs::remove_dir(folder);
        }
    })
}

/// The folder and those above it that do not exist, deepest first.
fn missing_folders(folder: &Path) -> Vec<PathBuf> {
    let above = folder
        .ancestors()
        .take_while(|path| !path.as_os_str().is_empty() && path.symlink_metadata().is_err());
    above.map(Path::to_path_buf).collect()
}

fn write_staged(folder: &Path, files: &[File]) -> Result<()> {
    fs::create_dir_all(folder)
        .with_context(|| format!("cannot make the folder {}", folder.display()))?;
    let stage = tempfile::Builder::new()
        .prefix(".nullcone-")
        .tempdir_in(folder)
        .with_context(|| format!("cannot write into the folder {}", folder.display()))?;
    for file in files {
        ga_files::write(stage.path().join(file.name), &file.contents)
            .with_context(|| format!("cannot write {}", folder.join(file.name).display()))?;
    }
    for file in files {
        let place = folder.join(file.name);
        fs::rename(stage.path().join(file.name), &place)
            .with_context(|| format!("cannot write {}", place.display()))?;
    }
    Ok(())
}

//! Writing of several files into a folder, all of them or none.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::{WriteError, write};

/// Writes files, each a name and its contents, into a folder, in place of any of the same names.
/// Creates the folder and those above it where they are missing.
///
/// All files are complete in a hidden folder inside `folder` before the first of them is moved to
/// its name. Where one cannot be completed, the files of the folder stay as they were, and folders
/// that were created are removed.
///
/// # Errors
///
/// [`WriteError`] with the file or folder that cannot be written. Where a file cannot be moved to
/// its name, because a folder has that name, those before it have been moved.
///
/// # Examples
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let out = folder.path().join("new/out");
/// ga_files::write_all(&out, [("a.obj", &b"v 0 0 0\n"[..]), ("b.json", b"{}")])?;
/// assert_eq!(std::fs::read(out.join("b.json"))?, b"{}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_all<'a>(
    folder: impl AsRef<Path>,
    files: impl IntoIterator<Item = (&'a str, &'a [u8])>,
) -> Result<(), WriteError> {
    let folder = folder.as_ref();
    let missing = missing_folders(folder);
    write_staged(folder, files).inspect_err(|_| {
        for folder in missing {
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

fn write_staged<'a>(
    folder: &Path,
    files: impl IntoIterator<Item = (&'a str, &'a [u8])>,
) -> Result<(), WriteError> {
    let error = |path: &Path, source: io::Error| WriteError {
        path: path.to_path_buf(),
        source,
    };
    fs::create_dir_all(folder).map_err(|source| error(folder, source))?;
    let stage = tempfile::Builder::new()
        .prefix(".nullcone-")
        .tempdir_in(folder)
        .map_err(|source| error(folder, source))?;
    let mut names = Vec::new();
    for (name, contents) in files {
        write(stage.path().join(name), contents)
            .map_err(|failed| error(&folder.join(name), failed.source))?;
        names.push(name);
    }
    for name in names {
        let place = folder.join(name);
        fs::rename(stage.path().join(name), &place).map_err(|source| error(&place, source))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn replaces_files_and_leaves_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a"), b"earlier").unwrap();
        fs::write(folder.path().join("other"), b"kept").unwrap();
        write_all(folder.path(), [("a", &b"first"[..]), ("b", b"second")]).unwrap();
        let contents = |name: &str| fs::read(folder.path().join(name)).unwrap();
        assert_eq!(contents("a"), b"first");
        assert_eq!(contents("b"), b"second");
        assert_eq!(contents("other"), b"kept");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3);
    }

    /// No file can have a name that contains a null byte.
    #[test]
    fn when_the_last_file_fails_the_earlier_ones_stay_as_they_were() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a"), b"kept").unwrap();
        let files = [("a", &b"new"[..]), ("b\0", b"new")];
        let error = write_all(folder.path(), files).unwrap_err();
        assert_eq!(error.path, folder.path().join("b\0"));
        assert_eq!(fs::read(folder.path().join("a")).unwrap(), b"kept");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn when_a_file_fails_created_folders_are_removed() {
        let folder = tempfile::tempdir().unwrap();
        let files = [("a", &b"new"[..]), ("b\0", b"new")];
        write_all(folder.path().join("new/out"), files).unwrap_err();
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn a_file_in_place_of_the_folder_is_an_error_that_names_the_folder() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, b"kept").unwrap();
        let error = write_all(&file, [("a", &b"new"[..])]).unwrap_err();
        assert_eq!(error.path, file);
        assert_eq!(fs::read(&file).unwrap(), b"kept");
    }
}

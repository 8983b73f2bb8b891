//! Atomic writing: the bytes go to a temporary file beside the target, which takes the target's
//! name once it is complete. A failed write leaves the folder as it was.

use std::collections::HashMap;
use std::fs::Permissions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, TempPath};

/// A file that could not be written. An earlier file of its name is unchanged.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {}: {source}", path.display())]
pub struct WriteError {
    /// The file that was to be written.
    pub path: PathBuf,
    /// What the operating system said.
    pub source: io::Error,
}

/// Writes `contents` to `path`, in place of any file there, and creates missing parent folders.
/// Another process sees either the earlier file or the complete new one.
///
/// # Errors
///
/// [`WriteError`] when a folder or the file cannot be created, the disk is full, or `path` is a
/// folder. The temporary file and folders that were created are then removed, and an earlier file
/// at `path` is unchanged.
///
/// # Examples
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("out/model.glb");
/// ga_files::write(&path, b"glTF")?;
/// assert_eq!(std::fs::read(&path)?, b"glTF");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(path: impl AsRef<Path>, contents: &[u8]) -> Result<(), WriteError> {
    write_together([(path, contents)])
}

/// Writes files of any folders, each a path and its contents, in place of any there, and creates
/// missing parent folders. All of them are complete beside their places before the first takes its
/// name, so that where one cannot be completed, all earlier files stay as they were, and folders
/// that were created are removed.
///
/// # Errors
///
/// [`WriteError`] with the file that cannot be written. A folder in the place of a file, and two
/// files of one path with different contents, are found before any file takes its name.
///
/// # Examples
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let [table, plot] = ["table.csv", "plots/plot.svg"].map(|name| folder.path().join(name));
/// ga_files::write_together([(&table, &b"t,x\n"[..]), (&plot, b"<svg/>")])?;
/// assert_eq!(std::fs::read(&plot)?, b"<svg/>");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_together<'a, P: AsRef<Path> + 'a>(
    files: impl IntoIterator<Item = (P, &'a [u8])>,
) -> Result<(), WriteError> {
    let mut staged = Staged::default();
    for (path, contents) in files {
        staged.add(path, contents)?;
    }
    staged.finish()
}

/// Files that are written one after the other, of which none takes its name before all are
/// complete: as [`write_together`], for files that are not in memory at the same time.
///
/// Where it is dropped without [`finish`](Self::finish), all earlier files stay as they were, and
/// folders that were created are removed.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// let mut files = ga_files::Staged::default();
/// for number in 0..3 {
///     files.add(folder.path().join(format!("frames/{number}.txt")), b"contents")?;
/// }
/// assert!(!folder.path().join("frames/0.txt").exists());
/// files.finish()?;
/// assert!(folder.path().join("frames/0.txt").exists());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Default)]
pub struct Staged {
    ready: Vec<Ready>,
    /// By the path with its folder resolved, however it was written.
    numbers: HashMap<PathBuf, usize>,
    created: Vec<PathBuf>,
}

/// A file that is complete beside its place.
#[derive(Debug)]
struct Ready {
    path: PathBuf,
    temporary: TempPath,
}

impl Staged {
    /// Writes a file beside its place, and creates missing parent folders.
    ///
    /// # Errors
    ///
    /// [`WriteError`] with the path: a file that cannot be written, a folder in its place, and a
    /// path that was added with other contents.
    pub fn add(&mut self, path: impl AsRef<Path>, contents: &[u8]) -> Result<(), WriteError> {
        let path = path.as_ref().to_path_buf();
        match self.staged(&path, contents) {
            Ok(()) => Ok(()),
            Err(source) => Err(WriteError { path, source }),
        }
    }

    fn staged(&mut self, path: &Path, contents: &[u8]) -> io::Result<()> {
        let (place, temporary) = staged(path, contents, &mut self.created)?;
        if let Some(&number) = self.numbers.get(&place) {
            if std::fs::read(&self.ready[number].temporary)? == contents {
                return Ok(());
            }
            let reason = "another output has the same path";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, reason));
        }
        self.numbers.insert(place, self.ready.len());
        self.ready.push(Ready {
            path: path.to_path_buf(),
            temporary,
        });
        Ok(())
    }

    /// Gives all files their names.
    ///
    /// # Errors
    ///
    /// [`WriteError`] with the file that cannot take its name.
    pub fn finish(mut self) -> Result<(), WriteError> {
        for Ready { path, temporary } in self.ready.drain(..) {
            if let Err(error) = temporary.persist(&path) {
                let source = error.error;
                return Err(WriteError { path, source });
            }
        }
        self.created.clear();
        Ok(())
    }
}

impl Drop for Staged {
    fn drop(&mut self) {
        // Temporary files are removed first, so that folders are empty.
        self.ready.clear();
        remove_empty(&self.created);
    }
}

/// Creates a folder and those above it that are missing, and adds these to a list, each after the
/// one that contains it.
pub(crate) fn create_folder(folder: &Path, created: &mut Vec<PathBuf>) -> io::Result<()> {
    let is_missing =
        |path: &&Path| !path.as_os_str().is_empty() && path.symlink_metadata().is_err();
    let missing: Vec<&Path> = folder.ancestors().take_while(is_missing).collect();
    created.extend(missing.into_iter().rev().map(Path::to_path_buf));
    std::fs::create_dir_all(folder)
}

/// Removes folders that [`create_folder`] has created, but for those with files of other programs.
pub(crate) fn remove_empty(created: &[PathBuf]) {
    for folder in created.iter().rev() {
        // This fails for a folder that is not empty.
        let _ = std::fs::remove_dir(folder);
    }
}

/// The place of a file, and its contents in a complete temporary file in the same folder.
fn staged(
    path: &Path,
    contents: &[u8],
    created: &mut Vec<PathBuf>,
) -> io::Result<(PathBuf, TempPath)> {
    if path.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    create_folder(folder, created)?;
    // A name that no file can have is found before any file takes its name.
    if let Err(error) = path.symlink_metadata()
        && error.kind() != io::ErrorKind::NotFound
    {
        return Err(error);
    }
    let name = path.file_name().ok_or(io::ErrorKind::InvalidInput)?;
    let place = folder.canonicalize()?.join(name);
    let mut builder = Builder::new();
    if let Some(permissions) = ordinary_permissions() {
        builder.permissions(permissions);
    }
    let mut file = builder.prefix(".nullcone-").tempfile_in(folder)?;
    file.write_all(contents)?;
    // Without this a power cut after the rename can leave the new name on an empty file.
    file.as_file().sync_all()?;
    // Closed, since many files may wait for their names.
    Ok((place, file.into_temp_path()))
}

/// Temporary files are private to their owner by default; an output file follows the umask like any
/// other file.
#[cfg(unix)]
fn ordinary_permissions() -> Option<Permissions> {
    use std::os::unix::fs::PermissionsExt;
    Some(Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn ordinary_permissions() -> Option<Permissions> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> = std::fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn replaces_a_file_and_leaves_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.bin");
        write(&path, b"first, and longer").unwrap();
        write(&path, b"second").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"second");
        assert_eq!(names(folder.path()), ["a.bin"]);
    }

    #[test]
    fn a_failed_write_names_the_file_and_leaves_the_folder_as_it_was() {
        let folder = tempfile::tempdir().unwrap();
        let taken = folder.path().join("taken");
        std::fs::create_dir(&taken).unwrap();
        std::fs::write(taken.join("inside"), b"kept").unwrap();
        let error = write(&taken, b"x").unwrap_err();
        assert_eq!(error.path, taken);
        assert!(
            error
                .to_string()
                .starts_with(&format!("cannot write {}: ", taken.display()))
        );
        assert_eq!(names(folder.path()), ["taken"]);
        assert_eq!(names(&taken), ["inside"]);
    }

    #[test]
    fn when_one_of_several_fails_the_others_stay_as_they_were() {
        let folder = tempfile::tempdir().unwrap();
        let [first, second] = ["a", "b"].map(|name| folder.path().join(name));
        std::fs::write(&first, b"kept").unwrap();
        std::fs::create_dir(&second).unwrap();
        let error = write_together([(&first, &b"new"[..]), (&second, b"new")]).unwrap_err();
        assert_eq!(error.path, second);
        assert_eq!(std::fs::read(&first).unwrap(), b"kept");
        assert_eq!(names(folder.path()), ["a", "b"]);
    }

    #[test]
    fn when_one_of_several_fails_created_folders_are_removed() {
        let folder = tempfile::tempdir().unwrap();
        let [first, second] = ["new/deep/a", "taken"].map(|name| folder.path().join(name));
        std::fs::create_dir(&second).unwrap();
        write_together([(&first, &b"new"[..]), (&second, b"new")]).unwrap_err();
        assert_eq!(names(folder.path()), ["taken"]);
    }

    #[test]
    fn files_that_are_not_finished_leave_nothing() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("kept"), b"kept").unwrap();
        let mut files = Staged::default();
        files.add(folder.path().join("new/deep/a"), b"a").unwrap();
        files.add(folder.path().join("kept"), b"other").unwrap();
        drop(files);
        assert_eq!(names(folder.path()), ["kept"]);
        let kept = std::fs::read(folder.path().join("kept")).unwrap();
        assert_eq!(kept, b"kept");
    }

    /// More than the files that a process may have open by default.
    #[test]
    fn many_files_are_not_open_at_the_same_time() {
        let folder = tempfile::tempdir().unwrap();
        let path = |number: usize| folder.path().join(format!("{number}.txt"));
        let mut files = Staged::default();
        for number in 0..1100 {
            files
                .add(path(number), number.to_string().as_bytes())
                .unwrap();
        }
        files.finish().unwrap();
        assert_eq!(names(folder.path()).len(), 1100);
        assert_eq!(std::fs::read(path(1099)).unwrap(), b"1099");
    }

    #[test]
    fn two_files_of_one_path_are_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let [first, same] = ["a", "./a"].map(|name| folder.path().join(name));
        std::fs::write(&first, b"kept").unwrap();
        let files = [(&first, &b"picture"[..]), (&same, b"camera")];
        let error = write_together(files).unwrap_err();
        assert!(
            error
                .to_string()
                .ends_with("another output has the same path")
        );
        assert_eq!(std::fs::read(&first).unwrap(), b"kept");
        assert_eq!(names(folder.path()), ["a"]);
        write_together([(&first, &b"new"[..]), (&same, b"new")]).unwrap();
        assert_eq!(std::fs::read(&first).unwrap(), b"new");
    }

    #[test]
    fn a_file_in_place_of_a_folder_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("file"), b"kept").unwrap();
        assert!(write(folder.path().join("file/below"), b"x").is_err());
        assert_eq!(std::fs::read(folder.path().join("file")).unwrap(), b"kept");
    }

    #[cfg(unix)]
    #[test]
    fn the_file_has_the_permissions_of_any_new_file() {
        let folder = tempfile::tempdir().unwrap();
        let (ours, plain) = (folder.path().join("ours"), folder.path().join("plain"));
        write(&ours, b"x").unwrap();
        std::fs::write(&plain, b"x").unwrap();
        let permissions = |path: &Path| std::fs::metadata(path).unwrap().permissions();
        assert_eq!(permissions(&ours), permissions(&plain));
    }
}

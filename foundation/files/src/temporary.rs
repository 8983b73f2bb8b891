//! What is on disk only until the work is done: temporary files, and folders that were created.
//!
//! Both are listed while they exist, so that a program that is interrupted can remove them.

use std::fs::{File, Metadata, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::{Builder, TempPath};

/// What would be left if the program ended now.
#[derive(Debug)]
pub(crate) struct Leftovers {
    files: Vec<PathBuf>,
    /// Each after the one that contains it.
    folders: Vec<PathBuf>,
    /// Folders with all that is in them.
    trees: Vec<PathBuf>,
}

static LEFTOVERS: Mutex<Leftovers> = Mutex::new(Leftovers {
    files: Vec::new(),
    folders: Vec::new(),
    trees: Vec::new(),
});

/// While the guard lives, [`remove_temporaries`] waits.
pub(crate) fn leftovers() -> MutexGuard<'static, Leftovers> {
    LEFTOVERS.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Leftovers {
    fn forget(&mut self, file: &Path) {
        self.files.retain(|other| other != file);
    }
}

/// Removes all temporary files, and the folders that were created for them, where a program ends
/// before its work is done, such as at a signal. Files that are taking their names are completed
/// before that.
///
/// Afterwards no thread of the program can write a file: those that try wait for the end of the
/// program.
pub fn remove_temporaries() {
    let leftovers = leftovers();
    // What cannot be removed is left: the program ends, and cannot report it.
    for file in &leftovers.files {
        let _ = std::fs::remove_file(file);
    }
    for tree in &leftovers.trees {
        let _ = std::fs::remove_dir_all(tree);
    }
    for folder in leftovers.folders.iter().rev() {
        let _ = std::fs::remove_dir(folder);
    }
    std::mem::forget(leftovers);
}

/// A folder for the work of a program, which is removed with all that is in it.
///
/// ```
/// let work = ga_files::TemporaryFolder::beside("out/result")?;
/// std::fs::write(work.path().join("part"), b"part")?;
/// let path = work.path().to_path_buf();
/// drop(work);
/// assert!(!path.exists());
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct TemporaryFolder {
    path: PathBuf,
    // Dropped after the folder in them was removed.
    _above: CreatedFolders,
}

impl TemporaryFolder {
    /// A new folder in that of a path, which is created where it is missing and is removed as well
    /// where it is empty in the end.
    ///
    /// # Errors
    ///
    /// No folder can be created there.
    pub fn beside(path: impl AsRef<Path>) -> io::Result<Self> {
        let parent = path.as_ref().parent().unwrap_or(Path::new(""));
        let mut above = CreatedFolders::default();
        let folder = match parent.as_os_str().is_empty() {
            true => Path::new("."),
            false => {
                above.create(parent)?;
                parent
            }
        };
        let folder = folder.canonicalize()?;
        let mut leftovers = leftovers();
        let made = Builder::new().prefix(".nullcone-").tempdir_in(folder)?;
        let path = made.keep();
        leftovers.trees.push(path.clone());
        Ok(Self {
            path,
            _above: above,
        })
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl Drop for TemporaryFolder {
    fn drop(&mut self) {
        let mut leftovers = leftovers();
        // What cannot be removed is left, as there is nobody to tell.
        let _ = std::fs::remove_dir_all(&self.path);
        leftovers.trees.retain(|other| *other != self.path);
    }
}

/// A file that is removed unless it takes the name of another.
#[derive(Debug)]
pub(crate) struct Temporary {
    path: Option<TempPath>,
}

impl Temporary {
    /// A new file in a folder. Without an earlier file its mode follows the umask; otherwise it
    /// has the mode and the owner of that file, or there is an error of the kind
    /// [`PermissionDenied`](io::ErrorKind::PermissionDenied).
    pub(crate) fn new(folder: &Path, earlier: Option<&Metadata>) -> io::Result<(Self, File)> {
        let named = Builder::new()
            .prefix(".nullcone-")
            .make_in(folder, |path| {
                let mut leftovers = leftovers();
                let file = create(path, earlier)?;
                leftovers.files.push(path.to_path_buf());
                Ok(file)
            })?;
        let (file, path) = named.into_parts();
        let temporary = Self { path: Some(path) };
        if let Some(earlier) = earlier {
            keep_access(&file, temporary.path().unwrap_or(folder), earlier)?;
        }
        Ok((temporary, file))
    }

    /// A file that lies elsewhere, moved into a folder; `None` where that is on another file
    /// system.
    pub(crate) fn moved(from: &Path, folder: &Path) -> io::Result<Option<Self>> {
        let (empty, _) = Self::new(folder, None)?;
        match std::fs::rename(from, empty.path().unwrap_or(folder)) {
            Ok(()) => Ok(Some(empty)),
            Err(error) if error.kind() == io::ErrorKind::CrossesDevices => Ok(None),
            Err(error) => Err(error),
        }
    }

    pub(crate) fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Takes the name of a file, in place of any there.
    pub(crate) fn persist(&mut self, place: &Path, leftovers: &mut Leftovers) -> io::Result<()> {
        let Some(path) = self.path.take() else {
            return Ok(());
        };
        leftovers.forget(&path);
        path.persist(place).map_err(|error| error.error)
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if let Some(path) = self.path.take() {
            leftovers().forget(&path);
        }
    }
}

#[cfg(unix)]
fn create(path: &Path, earlier: Option<&Metadata>) -> io::Result<File> {
    use std::os::unix::fs::OpenOptionsExt;
    // A replacement is private until it has the owner of the earlier file.
    let mode = if earlier.is_some() { 0o600 } else { 0o666 };
    let mut options = OpenOptions::new();
    options.write(true).create_new(true).mode(mode).open(path)
}

#[cfg(not(unix))]
fn create(path: &Path, _: Option<&Metadata>) -> io::Result<File> {
    OpenOptions::new().write(true).create_new(true).open(path)
}

/// Gives a file the owner and the mode of an earlier one.
#[cfg(unix)]
fn keep_access(file: &File, path: &Path, earlier: &Metadata) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt, chown};
    let owner = |metadata: &Metadata| (metadata.uid(), metadata.gid());
    let (user, group) = owner(earlier);
    if owner(&file.metadata()?) != (user, group) {
        chown(path, Some(user), Some(group))
            .map_err(|error| io::Error::new(io::ErrorKind::PermissionDenied, error))?;
    }
    // After the owner: a change of owner takes bits of the mode away.
    file.set_permissions(earlier.permissions())
}

#[cfg(not(unix))]
fn keep_access(file: &File, _: &Path, earlier: &Metadata) -> io::Result<()> {
    file.set_permissions(earlier.permissions())
}

/// Folders that were created, and are removed where they are empty unless they are kept.
#[derive(Debug, Default)]
pub(crate) struct CreatedFolders(Vec<PathBuf>);

impl CreatedFolders {
    /// Creates a folder and those above it that are missing.
    pub(crate) fn create(&mut self, folder: &Path) -> io::Result<()> {
        let is_missing =
            |path: &&Path| !path.as_os_str().is_empty() && path.symlink_metadata().is_err();
        let missing: Vec<&Path> = folder.ancestors().take_while(is_missing).collect();
        let missing = missing.into_iter().rev().map(Path::to_path_buf);
        let mut leftovers = leftovers();
        let before = self.0.len();
        self.0.extend(missing);
        leftovers.folders.extend_from_slice(&self.0[before..]);
        std::fs::create_dir_all(folder)
    }

    pub(crate) fn keep(&mut self) {
        let mut leftovers = leftovers();
        for folder in self.0.drain(..) {
            let place = leftovers.folders.iter().position(|other| *other == folder);
            if let Some(place) = place {
                leftovers.folders.remove(place);
            }
        }
    }
}

impl Drop for CreatedFolders {
    fn drop(&mut self) {
        for folder in self.0.iter().rev() {
            // This fails for a folder that is not empty.
            let _ = std::fs::remove_dir(folder);
        }
        self.keep();
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;

    fn is_listed(path: &Path) -> bool {
        let leftovers = leftovers();
        let Leftovers {
            files,
            folders,
            trees,
        } = &*leftovers;
        let mut all = files.iter().chain(folders).chain(trees);
        all.any(|other| other == path)
    }

    #[test]
    fn files_are_listed_until_they_have_their_name_or_are_removed() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("place");
        for takes_its_name in [true, false] {
            let (mut temporary, _) = Temporary::new(folder.path(), None).unwrap();
            let path = temporary.path().unwrap().to_path_buf();
            assert!(is_listed(&path));
            if takes_its_name {
                temporary.persist(&place, &mut leftovers()).unwrap();
            }
            drop(temporary);
            assert!(!is_listed(&path) && !path.exists() && place.exists());
        }
    }

    #[test]
    fn folders_are_listed_until_they_are_kept_or_removed() {
        let folder = tempfile::tempdir().unwrap();
        let [above, below] = ["above", "above/below"].map(|name| folder.path().join(name));
        for is_kept in [false, true] {
            let mut created = CreatedFolders::default();
            created.create(&below).unwrap();
            assert!(is_listed(&above) && is_listed(&below) && below.exists());
            if is_kept {
                created.keep();
            }
            drop(created);
            assert!(!is_listed(&above) && !is_listed(&below));
            assert_eq!([above.exists(), below.exists()], [is_kept; 2]);
        }
    }
}

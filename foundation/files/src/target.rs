//! What is at the path of a file that is to be written.

use crate::error::WriteError;
use std::fs::{Metadata, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

/// How the contents get to a path.
#[derive(Debug)]
pub(crate) enum Target {
    /// They go to the standard output of the program.
    StandardOutput,
    /// They are appended to what is not a file: a device, a pipe or an open descriptor.
    Stream,
    /// They take the place of those of a file that keeps its identity, as it has several names.
    InPlace(PathBuf),
    /// A new file takes this name, and the mode and the owner of the earlier file.
    Replace {
        path: PathBuf,
        earlier: Option<Metadata>,
    },
}

impl Target {
    /// What is at a path; links lead to what they stand for.
    ///
    /// # Errors
    ///
    /// The path is that of a folder, or of a file that may not be written. A file without any
    /// permission to write is read-only for everybody.
    pub(crate) fn of(path: &Path) -> io::Result<Self> {
        if is_standard_output(path) {
            return Ok(Self::StandardOutput);
        }
        let metadata = match path.metadata() {
            Ok(metadata) => metadata,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                let path = end_of_links(path);
                let earlier = None;
                return Ok(Self::Replace { path, earlier });
            }
            Err(error) => return Err(error),
        };
        if metadata.is_dir() {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        if !metadata.is_file() || is_descriptor(path) {
            return Ok(Self::Stream);
        }
        if metadata.permissions().readonly() {
            let reason = "the file is read-only";
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, reason));
        }
        // Fails for a file of somebody else, which a rename would replace.
        OpenOptions::new().write(true).open(path)?;
        let path = path.canonicalize()?;
        Ok(match names(&metadata) {
            0 | 1 => Self::Replace {
                path,
                earlier: Some(metadata),
            },
            _ => Self::InPlace(path),
        })
    }
}

/// Fails where a file could not be written at a path: a folder is there, or a file that may not be
/// written. To be asked before work whose result goes there.
///
/// # Errors
///
/// [`WriteError`].
pub fn check(path: impl AsRef<Path>) -> Result<(), WriteError> {
    let path = path.as_ref();
    let found = Target::of(path).map(|_| ());
    found.map_err(|source| WriteError {
        path: path.to_path_buf(),
        source,
    })
}

/// Whether what is written to a path goes to a device, a pipe or an open descriptor, which has no
/// name that would say anything about its contents.
pub fn is_stream(path: impl AsRef<Path>) -> bool {
    let found = Target::of(path.as_ref());
    matches!(found, Ok(Target::StandardOutput | Target::Stream))
}

/// Whether a path stands for the standard output of the program.
pub fn is_standard_output(path: impl AsRef<Path>) -> bool {
    let names = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];
    cfg!(unix) && names.iter().any(|name| path.as_ref() == Path::new(name))
}

/// Whether two paths lead to one existing file, by links of any kind.
pub fn is_same_file(first: impl AsRef<Path>, second: impl AsRef<Path>) -> bool {
    let (first, second) = (first.as_ref(), second.as_ref());
    match (first.canonicalize(), second.canonicalize()) {
        (Ok(a), Ok(b)) if a == b => true,
        (Ok(a), Ok(b)) => match (a.metadata(), b.metadata()) {
            (Ok(a), Ok(b)) => are_one(&a, &b),
            _ => false,
        },
        _ => false,
    }
}

/// Whether a path is that of an open descriptor.
fn is_descriptor(path: &Path) -> bool {
    let folders = ["/dev/fd", "/proc/self/fd"];
    cfg!(unix)
        && (path == Path::new("/dev/stderr") || folders.iter().any(|name| path.starts_with(name)))
}

/// Where a file is created whose name may be a link to a name that does not exist yet.
fn end_of_links(path: &Path) -> PathBuf {
    // As many as Linux follows.
    const MOST: usize = 40;
    let mut path = path.to_path_buf();
    for _ in 0..MOST {
        let Ok(next) = std::fs::read_link(&path) else {
            break;
        };
        path = path.parent().unwrap_or(Path::new("")).join(next);
    }
    path
}

#[cfg(unix)]
fn names(metadata: &Metadata) -> u64 {
    std::os::unix::fs::MetadataExt::nlink(metadata)
}

#[cfg(not(unix))]
fn names(_: &Metadata) -> u64 {
    1
}

#[cfg(unix)]
fn are_one(first: &Metadata, second: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |metadata: &Metadata| (metadata.dev(), metadata.ino());
    identity(first) == identity(second)
}

#[cfg(not(unix))]
fn are_one(_: &Metadata, _: &Metadata) -> bool {
    false
}

//! The names of files without their folders, as text.

use std::ffi::OsStr;
use std::path::Path;

/// The name of a file without its folders, which differ from machine to machine. What is not
/// Unicode is replaced by �.
///
/// ```
/// use std::path::Path;
/// assert_eq!(ga_files::name(Path::new("a/walk.bvh")), "walk.bvh");
/// ```
#[must_use]
pub fn name(path: &Path) -> String {
    text(path, path.file_name())
}

/// The name of a file without its folders and its ending.
///
/// ```
/// use std::path::Path;
/// assert_eq!(ga_files::stem(Path::new("a/walk.1.bvh")), "walk.1");
/// ```
#[must_use]
pub fn stem(path: &Path) -> String {
    text(path, path.file_stem())
}

/// A part of a path, or the whole where it has no such part, as `..` has none.
fn text(path: &Path, part: Option<&OsStr>) -> String {
    let part = part.unwrap_or(path.as_os_str());
    part.to_string_lossy().into_owned()
}

//! Paths of pictures that lead to the same files from another folder.

use std::path::{Component, Path, PathBuf};

use crate::FileError;

/// From the folder of one file to that of another.
pub(crate) struct Way {
    from: PathBuf,
    to: PathBuf,
}

impl Way {
    /// From the folder of one file to that of another; `None` where the current folder, to which
    /// paths are relative, is not known.
    pub(crate) fn new(from: &Path, to: &Path) -> Option<Self> {
        let folder = |file: &Path| {
            let folder = std::path::absolute(file).ok()?;
            folder.parent().map(Path::to_path_buf)
        };
        Some(Self {
            from: folder(from)?,
            to: folder(to)?,
        })
    }

    /// The path to a picture from the other folder. An absolute path becomes relative.
    ///
    /// # Errors
    ///
    /// [`FileError::Picture`] for a picture on another drive.
    pub(crate) fn of(&self, path: &str) -> Result<String, FileError> {
        if self.from == self.to && !Path::new(path).has_root() {
            return Ok(path.to_owned());
        }
        let picture = self.from.join(path);
        let relative = relative_path(&self.to, &picture);
        relative.ok_or(FileError::Picture { path: picture })
    }
}

/// The path from a folder to a file, both absolute, with `/` between folders.
fn relative_path(folder: &Path, file: &Path) -> Option<String> {
    let (mut folder, mut file) = (normal(folder), normal(file));
    let shared = folder.iter().zip(&file).take_while(|(a, b)| a == b).count();
    // Nothing in common, as on two drives.
    if shared == 0 {
        return None;
    }
    let mut steps = vec![".."; folder.split_off(shared).len()];
    let rest = file.split_off(shared);
    for component in &rest {
        steps.push(component.as_os_str().to_str()?);
    }
    Some(steps.join("/"))
}

/// The components of an absolute path, `.` and `..` resolved.
fn normal(path: &Path) -> Vec<Component<'_>> {
    let mut components = Vec::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir => {
                components.pop();
            }
            other => components.push(other),
        }
    }
    components
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn paths_lead_from_folder_to_file() {
        let relative = |folder: &str, file: &str| relative_path(folder.as_ref(), file.as_ref());
        assert_eq!(relative("/a/b", "/a/b/c.png").unwrap(), "c.png");
        assert_eq!(relative("/a/b", "/a/x/../d/c.png").unwrap(), "../d/c.png");
        assert_eq!(relative("/a/b/c", "/d.png").unwrap(), "../../../d.png");
    }
}

//! What is to be made of parts.

use std::path::PathBuf;

use anyhow::{Result, bail};

use crate::files::Files;
use crate::format::Format;
use crate::standard_output::is_dash;

/// Files of different formats, and a folder.
#[derive(Default)]
pub(crate) struct Outputs {
    files: Vec<(PathBuf, Format)>,
    folder: Option<PathBuf>,
}

impl Outputs {
    /// The files of `--out`, and the folder, which is a name without an ending, where the whole has
    /// one.
    ///
    /// # Errors
    ///
    /// A file cannot be written or has none of the formats; two have the same.
    pub(crate) fn new(
        paths: &[PathBuf],
        formats: &[Format],
        has_folder: bool,
        files: &mut Files,
    ) -> Result<Self> {
        let mut all = Self::default();
        for path in paths {
            if has_folder && path.extension().is_none() && all.folder.is_none() && !is_dash(path) {
                files.write_folder("--out", path, [""; 0])?;
                all.folder = Some(path.clone());
                continue;
            }
            let format = files.write("--out", path, formats)?;
            let other = all.files.iter().find(|(_, other)| *other == format);
            if let Some((other, _)) = other {
                let [path, other] = [path, other].map(|path| path.display());
                bail!("--out {path}: {other} has the same contents");
            }
            all.files.push((path.clone(), format));
        }
        Ok(all)
    }

    /// The file of a format, where one is asked for.
    pub(crate) fn of(&self, format: Format) -> Option<PathBuf> {
        let found = self.files.iter().find(|(_, other)| *other == format);
        found.map(|(path, _)| path.clone())
    }

    /// The folder, where one is asked for.
    pub(crate) fn folder(&self) -> Option<PathBuf> {
        self.folder.clone()
    }
}

//! The folder in which the demonstration works until all of it is done.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use ga_files::TemporaryFolder;

use crate::output::Staging;
use crate::pipeline::FILM;
use crate::report::Written;
use crate::standard_output::is_standard_output;

/// A temporary folder beside that of the results, as the current folder of the program.
pub(super) struct Work {
    folder: TemporaryFolder,
    out: PathBuf,
    before: PathBuf,
}

impl Work {
    /// Enters a folder for results that will be in `out`.
    pub(super) fn enter(out: &Path) -> Result<Self> {
        let before = std::env::current_dir().context("there is no current folder")?;
        let out = before.join(out);
        let failed = || format!("cannot make the folder {}", out.display());
        let folder = TemporaryFolder::beside(&out).with_context(failed)?;
        std::env::set_current_dir(folder.path()).with_context(failed)?;
        Ok(Self {
            folder,
            out,
            before,
        })
    }

    /// Moves all files to where they get their names, and says what they are; the film of the
    /// figure has a place of its own.
    pub(super) fn publish(self, outputs: &Staging, film: Option<&Path>) -> Result<Vec<Written>> {
        let mut written = Vec::new();
        for path in files(self.folder.path())? {
            let name = path.strip_prefix(self.folder.path()).unwrap_or(&path);
            let bytes = std::fs::metadata(&path)?.len() as usize;
            let is_film = name.file_stem().is_some_and(|stem| stem == FILM);
            let (to, shown) = match film.filter(|_| is_film) {
                Some(film) if is_standard_output(film) => (film.to_owned(), film),
                Some(film) => (self.before.join(film), film),
                None => (self.out.join(name), name),
            };
            outputs.move_file(&to, &path)?;
            written.push(Written {
                file: shown.display().to_string(),
                bytes,
            });
        }
        Ok(written)
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        // The folder that is left was there before; it may have been removed since.
        let _ = std::env::set_current_dir(&self.before);
    }
}

/// All files below a folder, in the order of their names.
fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = std::fs::read_dir(folder).with_context(|| folder.display().to_string())?;
    let mut entries: Vec<PathBuf> = entries
        .map(|entry| Ok(entry?.path()))
        .collect::<Result<_>>()?;
    entries.sort();
    let mut all = Vec::new();
    for path in entries {
        if path.is_dir() {
            all.extend(files(&path)?);
        } else {
            all.push(path);
        }
    }
    Ok(all)
}

//! What a command writes: text to standard output, and files.

use std::cell::RefCell;
use std::io::{ErrorKind, Write};
use std::path::Path;

use anyhow::{Context, Result};
use ga_files::{Staged, WriteSeek};
use serde::Serialize;

use crate::standard_output::{self, is_standard_output};

/// Prints text to standard error. One that is closed or full is not an error: there is no other
/// place to say so.
pub(crate) fn print_error(text: &str) {
    let _ = std::io::stderr().lock().write_all(text.as_bytes());
}

/// Prints text to standard output. A reader that has closed the pipe, as `head` does, is not an
/// error.
pub(crate) fn print(text: &str) -> Result<()> {
    if standard_output::is_taken() {
        print_error(text);
        return Ok(());
    }
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(error).context("cannot write to standard output")
        }
        _ => Ok(()),
    }
}

/// Prints one JSON object to standard output.
pub(crate) fn print_json(object: &impl Serialize) -> Result<()> {
    print(&(serde_json::to_string_pretty(object)? + "\n"))
}

/// Files that are written one after the other, of which none takes its name before
/// [`finish`](Self::finish): where that is not reached, all earlier files stay as they were. `-` is
/// standard output.
#[derive(Debug, Default)]
pub(crate) struct Staging(RefCell<Staged>);

impl Staging {
    /// Adds a file.
    pub(crate) fn write(&self, path: impl AsRef<Path>, contents: impl AsRef<[u8]>) -> Result<()> {
        let path = path.as_ref();
        self.write_with(path, |file| {
            let written = file.write_all(contents.as_ref());
            written.with_context(|| format!("cannot write {}", path.display()))
        })
    }

    /// Adds files, each a path and its contents.
    pub(crate) fn write_all(&self, files: &[(impl AsRef<Path>, impl AsRef<[u8]>)]) -> Result<()> {
        let mut files = files.iter();
        files.try_for_each(|(path, contents)| self.write(path, contents))
    }

    /// Adds a file whose contents a function writes, which adds no other file meanwhile.
    pub(crate) fn write_with(
        &self,
        path: &Path,
        write: impl FnOnce(&mut dyn WriteSeek) -> Result<()>,
    ) -> Result<()> {
        let mut staged = self.0.borrow_mut();
        if is_standard_output(path) {
            staged.add_to_standard_output(path, write)
        } else {
            staged.add_with(path, write)
        }
    }

    /// Moves a file that is complete elsewhere to its place.
    pub(crate) fn move_file(&self, path: &Path, from: &Path) -> Result<()> {
        if is_standard_output(path) {
            return self.write_with(path, |to| {
                std::io::copy(&mut std::fs::File::open(from)?, to)?;
                Ok(())
            });
        }
        Ok(self.0.borrow_mut().add_file(path, from)?)
    }

    /// Gives all files their names.
    pub(crate) fn finish(&self) -> Result<()> {
        Ok(self.0.take().finish()?)
    }
}

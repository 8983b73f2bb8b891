//! What a command writes: text to standard output, and files.

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

/// Writes a file; `-` is standard output.
pub(crate) fn write(path: &Path, contents: &[u8]) -> Result<()> {
    write_together([(path, contents)])
}

/// Writes files, each a path and its contents, all of them or none; `-` is standard output.
pub(crate) fn write_together<P: AsRef<Path>, C: AsRef<[u8]>>(
    files: impl IntoIterator<Item = (P, C)>,
) -> Result<()> {
    let mut staged = Staged::default();
    for (path, contents) in files {
        stage(&mut staged, path.as_ref(), contents.as_ref())?;
    }
    Ok(staged.finish()?)
}

/// Adds a file to those that are written together; `-` is standard output.
pub(crate) fn stage(staged: &mut Staged, path: &Path, contents: &[u8]) -> Result<()> {
    stage_with(staged, path, |file| {
        let written = file.write_all(contents);
        written.with_context(|| format!("cannot write {}", path.display()))
    })
}

/// As [`stage`], for contents that a function writes.
pub(crate) fn stage_with(
    staged: &mut Staged,
    path: &Path,
    write: impl FnOnce(&mut dyn WriteSeek) -> Result<()>,
) -> Result<()> {
    if is_standard_output(path) {
        staged.add_to_standard_output(path, write)
    } else {
        staged.add_with(path, write)
    }
}

//! What a command writes: text to standard output, files into a folder.

use std::io::{ErrorKind, Write};
use std::path::Path;

use anyhow::{Context, Result, ensure};
use serde::Serialize;

/// A file to be written.
pub(crate) struct File {
    pub(crate) name: &'static str,
    pub(crate) contents: Vec<u8>,
}

/// Prints text to standard output. A reader that has closed the pipe, as `head` does, is not an
/// error.
pub(crate) fn print(text: &str) -> Result<()> {
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

/// Writes those texts for which there is a place, all of them or none.
pub(crate) fn write_texts<const N: usize>(texts: [(Option<&Path>, &str); N]) -> Result<()> {
    let files = texts.into_iter();
    let files = files.filter_map(|(path, text)| Some((path?, text.as_bytes())));
    Ok(ga_files::write_together(files)?)
}

/// A part as per cent, without the digits that only rounding makes: 0.57 is 57.
pub(crate) fn percent(part: f64) -> f64 {
    (part * 1e8).round() / 1e6
}

/// Fails early where a folder cannot take these files.
pub(crate) fn check_place(folder: &Path, names: &[&str]) -> Result<()> {
    if let Some(existing) = folder.ancestors().find(|path| path.exists()) {
        ensure!(
            existing.is_dir(),
            "cannot make the folder {}: {} is a file",
            folder.display(),
            existing.display()
        );
    }
    for name in names {
        let place = folder.join(name);
        ensure!(
            !place.is_dir(),
            "cannot write {}: a folder of that name is in its place",
            place.display()
        );
    }
    Ok(())
}

/// Writes the files into a folder, all of them or none.
pub(crate) fn write_all(folder: &Path, files: &[File]) -> Result<()> {
    let files = files.iter().map(|file| (file.name, &file.contents[..]));
    Ok(ga_files::write_all(folder, files)?)
}

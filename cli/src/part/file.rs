//! Parts as files of JSON.

use std::path::Path;

use anyhow::{Context as _, Result, bail, ensure};
use serde::de::{DeserializeOwned, IgnoredAny};
use serde::{Deserialize, Serialize};

use super::About;
use crate::output::Staging;

/// The version of the files. It changes with their meaning.
const VERSION: u32 = 1;

/// A part: what it is of, and what was found.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Part<C> {
    nullcone_part: u32,
    pub(crate) about: About,
    pub(crate) contents: C,
}

/// What every version of the files has.
#[derive(Deserialize)]
struct Version {
    nullcone_part: u32,
}

impl<C: Serialize + DeserializeOwned + PartialEq> Part<C> {
    pub(crate) fn new(about: About, contents: C) -> Self {
        Self {
            nullcone_part: VERSION,
            about,
            contents,
        }
    }

    /// Writes the file of the part.
    ///
    /// # Errors
    ///
    /// The file could not be written, or would not say exactly what was found: JSON has no
    /// infinite numbers, and those that may be infinite are written in words.
    pub(crate) fn write(&self, path: &Path, outputs: &Staging) -> Result<()> {
        let mut text = serde_json::to_vec(self)?;
        let read: Self = serde_json::from_slice(&text)
            .with_context(|| format!("{}: a number has no text", path.display()))?;
        ensure!(
            read.contents == self.contents,
            "{}: the part would not be what was found",
            path.display()
        );
        text.push(b'\n');
        outputs.write(path, text)
    }
}

/// Reads what a part is of.
pub(super) fn about(path: &Path) -> Result<About> {
    let bytes = bytes(path)?;
    let Ok(Version { nullcone_part }) = serde_json::from_slice(&bytes) else {
        bail!(
            "{}: it is not a part, as --frames of a command writes it",
            path.display()
        );
    };
    ensure!(
        nullcone_part == VERSION,
        "{}: it is a part of version {nullcone_part}, and this program reads version {VERSION}",
        path.display()
    );
    let part: Part<IgnoredAny> = parsed(path, &bytes)?;
    let [first, end] = part.about.frames;
    ensure!(
        first < end,
        "{}: the part is damaged: it has no frames",
        path.display()
    );
    Ok(part.about)
}

/// Reads what was found in a part.
pub(super) fn contents<C: DeserializeOwned>(path: &Path) -> Result<C> {
    let part: Part<C> = parsed(path, &bytes(path)?)?;
    Ok(part.contents)
}

fn bytes(path: &Path) -> Result<Vec<u8>> {
    std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))
}

fn parsed<P: DeserializeOwned>(path: &Path, bytes: &[u8]) -> Result<P> {
    serde_json::from_slice(bytes)
        .with_context(|| format!("{}: the part is damaged", path.display()))
}

//! Films as they are written.

use std::io::{self, BufWriter, Write};

use anyhow::{Context as _, Result};
use ga_image::film;

use crate::format::Format;

/// The formats of films.
pub(crate) const FORMATS: [Format; 2] = [Format::Png, Format::Y4m];

/// How a film of one of the [`FORMATS`] is encoded.
pub(crate) fn encoding(format: Format) -> film::Format {
    match format {
        Format::Y4m => film::Format::Y4m,
        _ => film::Format::Png,
    }
}

/// Calls a function that writes a film in pieces of any size, and returns how many bytes these are.
pub(crate) fn write(
    file: &mut dyn Write,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<usize> {
    let mut buffer = BufWriter::new(Counted { file, bytes: 0 });
    write(&mut buffer)?;
    buffer.flush().context("the film cannot be written")?;
    Ok(buffer.get_ref().bytes)
}

/// A file whose bytes are counted.
struct Counted<'a> {
    file: &'a mut dyn Write,
    bytes: usize,
}

impl Write for Counted<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes)?;
        self.bytes += written;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

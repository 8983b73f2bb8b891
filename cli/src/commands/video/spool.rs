//! Pictures that may be needed at the end, kept on disk.

use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};

use anyhow::{Context, Result};
use ga_image::plane::Plane;
use ga_image::png;

/// Pictures as PNG in a temporary file, which the operating system removes when the program ends.
pub(super) struct Spool {
    file: File,
    entries: Vec<Entry>,
    end: u64,
}

/// A picture in the file: the number of its frame, its first byte and how many they are.
struct Entry {
    index: usize,
    start: u64,
    length: usize,
}

impl Spool {
    pub(super) fn new() -> Result<Self> {
        Ok(Self {
            file: tempfile::tempfile().context("cannot create a temporary file")?,
            entries: Vec::new(),
            end: 0,
        })
    }

    /// Adds the picture of a frame.
    pub(super) fn keep(&mut self, index: usize, picture: &Plane<[u8; 3]>) -> Result<()> {
        let bytes = png::encode(picture).context("cannot encode a key frame")?;
        let written = self.file.write_all(&bytes);
        written.context("cannot write to a temporary file")?;
        self.entries.push(Entry {
            index,
            start: self.end,
            length: bytes.len(),
        });
        self.end += bytes.len() as u64;
        Ok(())
    }

    /// The PNG of a frame, if it was added.
    pub(super) fn png(&mut self, index: usize) -> Result<Option<Vec<u8>>> {
        let Ok(entry) = self.entries.binary_search_by_key(&index, |e| e.index) else {
            return Ok(None);
        };
        let Entry { start, length, .. } = self.entries[entry];
        let mut bytes = vec![0; length];
        let read = self.file.seek(SeekFrom::Start(start));
        let read = read.and_then(|_| self.file.read_exact(&mut bytes));
        read.context("cannot read from a temporary file")?;
        Ok(Some(bytes))
    }

    /// The picture of a frame, if it was added.
    pub(super) fn picture(&mut self, index: usize) -> Result<Option<Plane<[u8; 3]>>> {
        let Some(bytes) = self.png(index)? else {
            return Ok(None);
        };
        let picture = png::decode(&bytes).context("cannot read a picture that was kept")?;
        Ok(Some(picture.to_rgb()))
    }
}

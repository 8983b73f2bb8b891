//! Pictures that may be needed at the end, kept on disk.

use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};

use anyhow::{Context, Result};
use ga_image::plane::Plane;

/// Pictures in a temporary file, which the operating system removes when the program ends.
pub(super) struct Spool {
    file: File,
    /// The number of the frame, columns, rows, and the place in the file.
    entries: Vec<(usize, [usize; 2], u64)>,
    end: u64,
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
        let bytes = picture.values().as_flattened();
        let written = self.file.write_all(bytes);
        written.context("cannot write to a temporary file")?;
        self.entries
            .push((index, [picture.width(), picture.height()], self.end));
        self.end += bytes.len() as u64;
        Ok(())
    }

    /// The picture of a frame, if it was added.
    pub(super) fn picture(&mut self, index: usize) -> Result<Option<Plane<[u8; 3]>>> {
        let Ok(entry) = self.entries.binary_search_by_key(&index, |entry| entry.0) else {
            return Ok(None);
        };
        let (_, [width, height], at) = self.entries[entry];
        let mut bytes = vec![0; 3 * width * height];
        let read = self.file.seek(SeekFrom::Start(at));
        let read = read.and_then(|_| self.file.read_exact(&mut bytes));
        read.context("cannot read from a temporary file")?;
        let pixels = bytes.as_chunks::<3>().0.to_vec();
        Ok(Some(Plane::from_values(width, height, pixels)?))
    }
}

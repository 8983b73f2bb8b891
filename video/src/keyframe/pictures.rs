//! Pictures that may be needed at the end, kept on disk.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};

use ga_image::plane::Plane;
use ga_image::png;

use super::error::KeyFrameError;

/// Pictures of frames as PNG in a temporary file, which the operating system removes when the
/// program ends.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_video::keyframe::Pictures;
///
/// let mut pictures = Pictures::new()?;
/// let red = Plane::filled(4, 3, [255_u8, 0, 0]);
/// pictures.keep(7, &red)?;
/// assert_eq!(pictures.picture(7)?, Some(red.clone()));
/// assert_eq!(pictures.png(8)?, None);
/// // Between two frames that are kept others may be read.
/// let blue = Plane::filled(4, 3, [0, 0, 255]);
/// pictures.keep(9, &blue)?;
/// assert_eq!([pictures.picture(7)?, pictures.picture(9)?], [Some(red), Some(blue.clone())]);
/// assert!(pictures.keep(9, &blue).is_err());
/// # Ok::<(), ga_video::keyframe::KeyFrameError>(())
/// ```
#[derive(Debug)]
pub struct Pictures {
    file: File,
    entries: Vec<Entry>,
    end: u64,
}

/// A picture in the file: the number of its frame, its first byte and how many they are.
#[derive(Debug)]
struct Entry {
    frame: usize,
    start: u64,
    length: usize,
}

impl Pictures {
    /// No pictures yet.
    ///
    /// # Errors
    ///
    /// [`KeyFrameError::Temporary`].
    pub fn new() -> Result<Self, KeyFrameError> {
        Ok(Self {
            file: tempfile::tempfile().map_err(|error| failed("create", error))?,
            entries: Vec::new(),
            end: 0,
        })
    }

    /// Adds the picture of a frame, which is later than all before.
    ///
    /// # Errors
    ///
    /// [`KeyFrameError::Order`] for a frame that is not later, [`KeyFrameError::Temporary`],
    /// [`KeyFrameError::Picture`].
    pub fn keep(&mut self, frame: usize, picture: &Plane<[u8; 3]>) -> Result<(), KeyFrameError> {
        if let Some(last) = self.entries.last().filter(|last| last.frame >= frame) {
            let after = last.frame;
            return Err(KeyFrameError::Order { frame, after });
        }
        let bytes = png::encode(picture);
        let bytes = bytes.map_err(|problem| KeyFrameError::Picture { frame, problem })?;
        let written = self.file.seek(SeekFrom::Start(self.end));
        let written = written.and_then(|_| self.file.write_all(&bytes));
        written.map_err(|error| failed("write to", error))?;
        self.entries.push(Entry {
            frame,
            start: self.end,
            length: bytes.len(),
        });
        self.end += bytes.len() as u64;
        Ok(())
    }

    /// The PNG of a frame, if it was added.
    ///
    /// # Errors
    ///
    /// [`KeyFrameError::Temporary`].
    pub fn png(&mut self, frame: usize) -> Result<Option<Vec<u8>>, KeyFrameError> {
        let Ok(entry) = self.entries.binary_search_by_key(&frame, |e| e.frame) else {
            return Ok(None);
        };
        let Entry { start, length, .. } = self.entries[entry];
        let mut bytes = vec![0; length];
        let read = self.file.seek(SeekFrom::Start(start));
        let read = read.and_then(|_| self.file.read_exact(&mut bytes));
        read.map_err(|error| failed("read from", error))?;
        Ok(Some(bytes))
    }

    /// The picture of a frame, if it was added.
    ///
    /// # Errors
    ///
    /// [`KeyFrameError::Temporary`], [`KeyFrameError::Picture`].
    pub fn picture(&mut self, frame: usize) -> Result<Option<Plane<[u8; 3]>>, KeyFrameError> {
        let Some(bytes) = self.png(frame)? else {
            return Ok(None);
        };
        let picture = png::decode(&bytes);
        let picture = picture.map_err(|problem| KeyFrameError::Picture { frame, problem })?;
        Ok(Some(picture.to_rgb()))
    }
}

fn failed(task: &'static str, source: io::Error) -> KeyFrameError {
    KeyFrameError::Temporary { task, source }
}

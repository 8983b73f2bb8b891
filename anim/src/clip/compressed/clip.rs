//! A compressed clip in memory.

use std::path::Path;

use ga_files::{ReadError, WriteError};

use super::file::{self, Parsed};
use super::layout::JointLayout;
use super::options::Options;
use super::tables::Tables;
use crate::clip::ClipError;
use crate::transform::Transform;

/// A clip whose errors stay within a bound on every frame, in few bytes.
///
/// Reading one unpacks the trends of its channels to floats and the residuals to whole bytes, which
/// takes a few times as much memory as the file. [`Sampler`](super::Sampler) decodes its frames.
#[derive(Clone, Debug, PartialEq)]
pub struct CompressedClip {
    bytes: Vec<u8>,
    header: Parsed,
    tables: Tables,
}

impl CompressedClip {
    /// Reads a clip from the bytes of a file.
    ///
    /// # Errors
    ///
    /// [`ClipError::NotAClip`], [`ClipError::Version`], [`ClipError::Truncated`],
    /// [`ClipError::TooLong`], [`ClipError::Checksum`], [`ClipError::Invalid`] and
    /// [`ClipError::Header`].
    pub fn decode(bytes: Vec<u8>) -> Result<Self, ClipError> {
        let (header, segments) = file::parse(&bytes)?;
        let tracks: Vec<(bool, f64)> = header
            .tracks
            .iter()
            .map(|track| (track.changes, track.constant))
            .collect();
        let tables = Tables::new(&header.layouts, &tracks, header.frames, &segments);
        Ok(Self {
            bytes,
            header,
            tables,
        })
    }

    /// Reads the clip in a file.
    ///
    /// # Errors
    ///
    /// [`ReadError::Io`], or [`ReadError::Contents`] as [`decode`](Self::decode) gives.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ReadError<ClipError>> {
        ga_files::read(path, |bytes| Self::decode(bytes.to_vec()))
    }

    /// Writes the clip to a file, whole or not at all.
    ///
    /// # Errors
    ///
    /// [`WriteError`] where the file cannot be written.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        ga_files::write(path, &self.bytes)
    }

    /// The bytes of the file.
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// How many of the bytes are the names of joints.
    #[must_use]
    pub fn name_bytes(&self) -> usize {
        self.header.names.iter().map(String::len).sum()
    }

    /// How many frames there are; never 0.
    #[must_use]
    pub fn frame_count(&self) -> usize {
        self.header.frames
    }

    /// The time from one frame to the next, in seconds.
    #[must_use]
    pub fn frame_time(&self) -> f64 {
        self.header.frame_time
    }

    /// The time of the last frame, in seconds.
    #[must_use]
    pub fn duration(&self) -> f64 {
        (self.header.frames - 1) as f64 * self.header.frame_time
    }

    /// The names of the joints.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.header.names
    }

    /// The parent of each joint, which comes before it.
    #[must_use]
    pub fn parents(&self) -> &[Option<usize>] {
        &self.header.parents
    }

    /// The transform of each joint relative to its parent at rest.
    #[must_use]
    pub fn rest(&self) -> &[Transform<f32>] {
        &self.header.rest
    }

    /// The names of the scalar tracks.
    pub fn track_names(&self) -> impl ExactSizeIterator<Item = &str> {
        self.header.tracks.iter().map(|track| track.name.as_str())
    }

    /// The bounds that hold on every frame.
    #[must_use]
    pub fn options(&self) -> &Options {
        &self.header.options
    }

    /// How many numbers change from frame to frame.
    #[must_use]
    pub fn channel_count(&self) -> usize {
        self.tables.channels
    }

    pub(super) fn layouts(&self) -> &[JointLayout] {
        &self.header.layouts
    }

    pub(super) fn tables(&self) -> &Tables {
        &self.tables
    }
}

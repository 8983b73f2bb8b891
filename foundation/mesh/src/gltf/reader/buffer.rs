//! Buffers, and the parts of them that accessors and images refer to.

use std::borrow::Cow;
use std::path::Path;

use super::super::json;
use super::super::problem::{Element, Problem};
use super::super::uri::{self, Uri};
use crate::FormatError;

/// The bytes of every buffer.
pub(super) struct Buffers<'a> {
    buffers: Vec<Option<Cow<'a, [u8]>>>,
}

impl<'a> Buffers<'a> {
    /// The buffers of a file: the first may be the binary chunk, others are files or data in URIs.
    pub(super) fn load(
        root: &json::Root,
        binary: Option<&'a [u8]>,
        files: &mut Files,
    ) -> Result<Self, FormatError> {
        let mut buffers = Vec::with_capacity(root.buffers.len());
        for (index, buffer) in root.buffers.iter().enumerate() {
            let fault = |problem| FormatError::gltf(Element::Buffer(index), problem);
            let length = buffer.byte_length;
            let mut bytes = match (&buffer.uri, binary) {
                (Some(uri), _) => Cow::Owned(load(uri, length, files).map_err(fault)?),
                (None, Some(binary)) if index == 0 => Cow::Borrowed(binary),
                // Compressed bytes stand in place of these.
                (None, _) if buffer.extensions.meshopt.is_some() => {
                    buffers.push(None);
                    continue;
                }
                (None, _) => return Err(fault(Problem::Missing("a URI"))),
            };
            let found = bytes.len() as u64;
            if found < length {
                let needed = length;
                return Err(fault(Problem::TooShort { needed, found }));
            }
            // At most the length of a slice.
            let length = length as usize;
            match &mut bytes {
                Cow::Borrowed(bytes) => *bytes = &bytes[..length],
                Cow::Owned(bytes) => bytes.truncate(length),
            }
            buffers.push(Some(bytes));
        }
        Ok(Self { buffers })
    }

    /// Buffers whose bytes are known.
    pub(super) fn of(buffers: &'a [Option<Vec<u8>>]) -> Self {
        let bytes = |bytes: &'a Option<Vec<u8>>| Some(Cow::Borrowed(&bytes.as_ref()?[..]));
        Self {
            buffers: buffers.iter().map(bytes).collect(),
        }
    }

    /// The bytes of every buffer.
    pub(super) fn into_bytes(self) -> Vec<Option<Vec<u8>>> {
        let buffers = self.buffers.into_iter();
        buffers.map(|bytes| bytes.map(Cow::into_owned)).collect()
    }

    /// How many bytes there are.
    pub(super) fn size(&self) -> u64 {
        self.buffers.iter().flatten().map(|b| b.len() as u64).sum()
    }

    /// The bytes of a buffer view, and how far apart the items in it begin if it says so.
    pub(super) fn view(
        &self,
        root: &json::Root,
        index: usize,
    ) -> Result<(&[u8], Option<u64>), FormatError> {
        let element = || Element::BufferView(index);
        let view = root
            .buffer_views
            .get(index)
            .ok_or_else(|| FormatError::dangling("buffer view", index, root.buffer_views.len()))?;
        let buffer = self.buffers.get(view.buffer).ok_or_else(|| {
            FormatError::dangling("buffer", view.buffer, self.buffers.len()).within(element())
        })?;
        let buffer = buffer.as_ref().ok_or_else(|| {
            FormatError::gltf(Element::Buffer(view.buffer), Problem::Missing("a URI"))
        })?;
        let (start, found) = (view.byte_offset, buffer.len() as u64);
        let needed = start.saturating_add(view.byte_length);
        if needed > found {
            let problem = Problem::TooShort { needed, found };
            return Err(FormatError::gltf(element(), problem));
        }
        // Both are at most the length of a slice.
        Ok((&buffer[start as usize..needed as usize], view.byte_stride))
    }
}

/// The first `length` bytes of what a URI names, or all if there are fewer.
fn load(uri: &str, length: u64, files: &mut Files) -> Result<Vec<u8>, Problem> {
    match uri::parse(uri) {
        Some(Uri::Data { bytes, .. }) => Ok(bytes),
        Some(Uri::File(path)) => files(&path, length),
        None => Err(uri_problem(uri)),
    }
}

/// A URI that cannot be used, without the data that it may hold.
pub(super) fn uri_problem(uri: &str) -> Problem {
    const SHOWN: usize = 60;
    let mut shown: String = uri.chars().take(SHOWN).collect();
    if shown.len() < uri.len() {
        shown.push('…');
    }
    Problem::Uri(shown)
}

/// Reads the file of a path relative to the glTF file, up to a number of bytes.
pub(super) type Files<'f> = dyn FnMut(&Path, u64) -> Result<Vec<u8>, Problem> + 'f;

//! The container of GLB files: a header, a chunk of JSON and, if there is any, a chunk of bytes.

use super::problem::{Element, Problem};
use crate::FormatError;

const MAGIC: &[u8; 4] = b"glTF";
const JSON: [u8; 4] = *b"JSON";
const BINARY: [u8; 4] = *b"BIN\0";
const HEADER: usize = 12;
const CHUNK_HEADER: usize = 8;

/// Whether a file begins as a GLB file does.
pub(super) fn is_glb(file: &[u8]) -> bool {
    file.starts_with(MAGIC)
}

/// The JSON and the bytes of a GLB file. Chunks of other kinds are skipped, as are bytes behind
/// the stated length.
pub(super) fn split(file: &[u8]) -> Result<(&[u8], Option<&[u8]>), FormatError> {
    let too_short = |element, needed: usize, found: usize| {
        let (needed, found) = (needed as u64, found as u64);
        FormatError::gltf(element, Problem::TooShort { needed, found })
    };
    let header = file
        .first_chunk::<HEADER>()
        .ok_or_else(|| too_short(Element::File, HEADER, file.len()))?;
    let version = word(&header[4..]);
    if version != 2 {
        let problem = Problem::Version(version.to_string());
        return Err(FormatError::gltf(Element::File, problem));
    }
    let length = word(&header[8..]) as usize;
    let mut rest = match file.get(HEADER..length) {
        Some(rest) => rest,
        None if length < HEADER => return Err(too_short(Element::File, HEADER, length)),
        None => return Err(too_short(Element::File, length, file.len())),
    };
    let mut json = None;
    let mut index = 0;
    loop {
        let element = Element::Chunk(index);
        let Some(header) = rest.first_chunk::<CHUNK_HEADER>() else {
            match json {
                // Nothing but padding follows.
                Some(json) if rest.is_empty() => return Ok((json, None)),
                _ => return Err(too_short(element, CHUNK_HEADER, rest.len())),
            }
        };
        let (length, kind) = (
            word(header) as usize,
            [header[4], header[5], header[6], header[7]],
        );
        rest = &rest[CHUNK_HEADER..];
        let Some(chunk) = rest.get(..length) else {
            return Err(too_short(element, length, rest.len()));
        };
        rest = &rest[length..];
        match (json, kind) {
            (None, JSON) => json = Some(chunk),
            (Some(json), BINARY) => return Ok((json, Some(chunk))),
            (Some(_), JSON) | (None, _) => {
                return Err(FormatError::gltf(element, Problem::ChunkKind(kind)));
            }
            (Some(_), _) => {}
        }
        index += 1;
    }
}

/// A GLB file of this JSON and these bytes, whose number is a multiple of four.
pub(super) fn join(mut json: Vec<u8>, binary: &[u8]) -> Result<Vec<u8>, FormatError> {
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunks = [(JSON, &json[..]), (BINARY, binary)];
    let chunks = || chunks.iter().filter(|(_, bytes)| !bytes.is_empty());
    let length = HEADER
        + chunks()
            .map(|(_, bytes)| CHUNK_HEADER + bytes.len())
            .sum::<usize>();
    let stated = u32::try_from(length).map_err(|_| {
        let (needed, limit) = (length as u64, u64::from(u32::MAX));
        FormatError::gltf(Element::File, Problem::TooLarge { needed, limit })
    })?;
    let mut file = Vec::with_capacity(length);
    file.extend_from_slice(MAGIC);
    file.extend_from_slice(&2u32.to_le_bytes());
    file.extend_from_slice(&stated.to_le_bytes());
    for (kind, bytes) in chunks() {
        // Each chunk is shorter than the file, whose length fits into 32 bits.
        file.extend_from_slice(&(bytes.len() as u32).to_le_bytes());
        file.extend_from_slice(kind);
        file.extend_from_slice(bytes);
    }
    Ok(file)
}

/// The first four bytes as a number.
fn word(bytes: &[u8]) -> u32 {
    u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])
}

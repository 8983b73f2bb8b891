//! The GLB container: a header, a chunk of JSON and a chunk of bytes.

use serde_json::{Value, json};

use super::GltfError;
use super::buffer::Buffer;

/// The bytes of the file for a document that lacks only what describes the buffer.
pub(super) fn glb(mut document: Value, buffer: Buffer) -> Result<Vec<u8>, GltfError> {
    document["buffers"] = json!([{ "byteLength": buffer.bytes.len() }]);
    document["bufferViews"] = Value::Array(buffer.views);
    document["accessors"] = Value::Array(buffer.accessors);
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');

    let length = HEADER + 2 * CHUNK_HEADER + text.len() + buffer.bytes.len();
    let length = u32::try_from(length).map_err(|_| GltfError::TooLarge)?;
    let mut file = Vec::with_capacity(length as usize);
    file.extend_from_slice(b"glTF");
    file.extend_from_slice(&2u32.to_le_bytes());
    file.extend_from_slice(&length.to_le_bytes());
    for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &buffer.bytes)] {
        // Both chunks are shorter than the file, whose length fits.
        file.extend_from_slice(&(chunk.len() as u32).to_le_bytes());
        file.extend_from_slice(kind);
        file.extend_from_slice(chunk);
    }
    Ok(file)
}

const HEADER: usize = 12;
const CHUNK_HEADER: usize = 8;

//! The text of a file.

use super::error::CameraFileError;

/// The text, without a byte order mark. A null byte is in none, but in numbers and in UTF-16.
pub(super) fn text(bytes: &[u8]) -> Result<&str, CameraFileError> {
    let refuse = |end: usize| CameraFileError::NotText {
        line: 1 + bytes[..end].iter().filter(|byte| **byte == b'\n').count(),
    };
    let text = std::str::from_utf8(bytes).map_err(|error| refuse(error.valid_up_to()))?;
    if let Some(end) = bytes.iter().position(|byte| *byte == 0) {
        return Err(refuse(end));
    }
    Ok(text.strip_prefix('\u{feff}').unwrap_or(text))
}

//! The text of a file.

use super::error::CameraFileError;

/// The text, without a byte order mark.
pub(super) fn text(bytes: &[u8]) -> Result<&str, CameraFileError> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let before = &bytes[..error.valid_up_to()];
        CameraFileError::NotText {
            line: 1 + before.iter().filter(|byte| **byte == b'\n').count(),
        }
    })?;
    Ok(text.strip_prefix('\u{feff}').unwrap_or(text))
}

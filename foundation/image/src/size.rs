//! Sizes that a file can hold and that a format can count.

use crate::format::Format;
use crate::format_error::FormatError;

/// That a file of `length` bytes can hold so many pixels, where one byte holds at most
/// `pixels_per_byte`. It is asked before memory for the pixels is taken. Returns their number.
pub(crate) fn check_claim(
    format: Format,
    [width, height]: [usize; 2],
    length: usize,
    pixels_per_byte: f64,
) -> Result<usize, FormatError> {
    let claim = width as f64 * height as f64;
    match width.checked_mul(height) {
        Some(pixels) if claim <= length as f64 * pixels_per_byte => Ok(pixels),
        _ => Err(FormatError::Claim {
            format,
            width,
            height,
            length,
        }),
    }
}

/// Columns and rows as `u32`, both at least 1.
pub(crate) fn size_for(
    format: Format,
    [width, height]: [usize; 2],
) -> Result<[u32; 2], FormatError> {
    match [u32::try_from(width), u32::try_from(height)] {
        [Ok(columns), Ok(rows)] if columns > 0 && rows > 0 => Ok([columns, rows]),
        _ => Err(FormatError::Size {
            format,
            width,
            height,
        }),
    }
}

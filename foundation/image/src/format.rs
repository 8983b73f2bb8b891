//! Formats of picture files.

use std::fmt;

/// A format of picture files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Portable Network Graphics.
    Png,
    /// JPEG. It is read; [`write()`](crate::file::write()) does not write it, since colours change.
    Jpeg,
    /// Portable grey map and portable pixel map, PGM and PPM.
    Pnm,
    /// Portable float map.
    Pfm,
    /// Tagged Image File Format. It is read.
    Tiff,
    /// Windows bitmap. It is read.
    Bmp,
    /// WebP. It is read.
    WebP,
    /// YUV4MPEG2, a film without compression.
    Y4m,
}

/// A format, its name, and the endings of names of such files. The first ending of several is the
/// usual one.
const TABLE: [(Format, &str, &[&str]); 8] = [
    (Format::Png, "PNG", &["png"]),
    (Format::Jpeg, "JPEG", &["jpg", "jpeg"]),
    (Format::Pnm, "PNM", &["pgm", "ppm", "pnm"]),
    (Format::Pfm, "PFM", &["pfm"]),
    (Format::Tiff, "TIFF", &["tif", "tiff"]),
    (Format::Bmp, "BMP", &["bmp"]),
    (Format::WebP, "WebP", &["webp"]),
    (Format::Y4m, "Y4M", &["y4m"]),
];

impl Format {
    /// How many bytes at the beginning of a file tell its format.
    pub(crate) const SIGNATURE: usize = 18;

    /// All formats that are read.
    pub fn all() -> impl Iterator<Item = Self> {
        TABLE.into_iter().map(|(format, ..)| format)
    }

    /// The names of all formats, as for a message: `PNG, JPEG, …`.
    #[must_use]
    pub fn names() -> String {
        TABLE.map(|(_, name, _)| name).join(", ")
    }

    /// The endings of the names of such files, in small letters, the usual one first.
    #[must_use]
    pub fn endings(self) -> &'static [&'static str] {
        self.row().1
    }

    /// The format whose signature is at the beginning of `bytes`.
    ///
    /// ```
    /// use ga_image::file::Format;
    ///
    /// assert_eq!(Format::detect(b"II*\0\x08\0\0\0"), Some(Format::Tiff));
    /// assert_eq!(Format::detect(b"BM is how many words begin"), None);
    /// ```
    #[must_use]
    pub fn detect(bytes: &[u8]) -> Option<Self> {
        match bytes {
            [0x89, b'P', b'N', b'G', ..] => Some(Self::Png),
            [0xff, 0xd8, 0xff, ..] => Some(Self::Jpeg),
            [b'P', b'2' | b'3' | b'5' | b'6', ..] => Some(Self::Pnm),
            [b'P', b'F' | b'f', ..] => Some(Self::Pfm),
            // 43 is that of files with offsets of 64 bits.
            [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => Some(Self::Tiff),
            [
                b'R',
                b'I',
                b'F',
                b'F',
                _,
                _,
                _,
                _,
                b'W',
                b'E',
                b'B',
                b'P',
                ..,
            ] => Some(Self::WebP),
            [b'B', b'M', rest @ ..] => is_bitmap(rest).then_some(Self::Bmp),
            _ => bytes.starts_with(b"YUV4MPEG2 ").then_some(Self::Y4m),
        }
    }

    fn row(self) -> (&'static str, &'static [&'static str]) {
        let row = TABLE.iter().find(|(format, ..)| *format == self);
        row.map_or(("", &[]), |(_, name, endings)| (name, endings))
    }
}

/// Whether what follows `BM` is the rest of the header of a bitmap file, and then the length of one
/// of the headers that follow it.
fn is_bitmap(rest: &[u8]) -> bool {
    let length = rest.get(12..).and_then(<[u8]>::first_chunk);
    let length = length.map(|bytes| u32::from_le_bytes(*bytes));
    matches!(length, Some(12 | 16 | 40 | 52 | 56 | 64 | 108 | 124))
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.row().0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_format_is_in_the_table() {
        for format in Format::all() {
            // A format that is added must be added here.
            match format {
                Format::Png | Format::Jpeg | Format::Pnm | Format::Pfm => {}
                Format::Tiff | Format::Bmp | Format::WebP | Format::Y4m => {}
            }
            assert!(!format.to_string().is_empty() && !format.endings().is_empty());
        }
        assert_eq!(Format::names(), "PNG, JPEG, PNM, PFM, TIFF, BMP, WebP, Y4M");
    }
}

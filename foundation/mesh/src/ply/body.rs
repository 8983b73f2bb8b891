//! The numbers after the header.

use super::header::{Element, Header, Scalar};
use super::{Encoding, Place, PlyProblem};
use crate::FormatError;
use crate::words::{WordError, Words, number};

/// Reads the elements of a file one after the other.
pub(super) struct Body<'a> {
    encoding: Encoding,
    bytes: &'a [u8],
    /// Where the next line or number begins.
    position: usize,
    /// How many lines of text have been read.
    lines: usize,
    /// The rest of the line of an element of text.
    words: Words<'a>,
    /// The element being read, for errors.
    index: usize,
    begin: usize,
}

impl<'a> Body<'a> {
    pub(super) fn new(header: &Header, bytes: &'a [u8]) -> Self {
        Self {
            encoding: header.encoding,
            bytes,
            position: header.length,
            lines: header.lines,
            words: Words::new(b""),
            index: 0,
            begin: 0,
        }
    }

    /// Compares the number of elements with the bytes that are left.
    pub(super) fn check_count(&self, element: &Element) -> Result<usize, FormatError> {
        let size = element.least_size(self.encoding);
        let left = self.bytes.len() - self.position;
        let needed = element.count.saturating_mul(size as u64);
        // The last line of text may lack its end.
        let room = left as u64 + u64::from(self.encoding == Encoding::Ascii);
        if element.count > 0 && needed > room {
            return Err(FormatError::Ply {
                place: Place::Line(element.line),
                problem: PlyProblem::TooMany {
                    element: element.name.clone(),
                    count: element.count,
                    needed,
                    left,
                },
            });
        }
        Ok(element.count as usize)
    }

    /// Reads all elements of a kind: `read` takes the numbers of one.
    pub(super) fn each(
        &mut self,
        element: &Element,
        mut read: impl FnMut(&mut Self) -> Result<(), PlyProblem>,
    ) -> Result<(), FormatError> {
        let count = self.check_count(element)?;
        for index in 0..count {
            self.index = index;
            let result = self
                .open()
                .and_then(|()| read(self))
                .and_then(|()| self.close());
            result.map_err(|problem| FormatError::Ply {
                place: self.place(element),
                problem,
            })?;
        }
        Ok(())
    }

    pub(super) fn place(&self, element: &Element) -> Place {
        match self.encoding {
            Encoding::Ascii => Place::Line(self.lines),
            _ => Place::Element {
                kind: element.name.as_str().into(),
                index: self.index,
                byte: self.begin,
            },
        }
    }

    /// Goes to the next element: in text to the next line that is not blank.
    fn open(&mut self) -> Result<(), PlyProblem> {
        self.begin = self.position;
        while self.encoding == Encoding::Ascii {
            let rest = &self.bytes[self.position..];
            if rest.is_empty() {
                return Err(PlyProblem::EndOfFile);
            }
            let end = memchr::memchr(b'\n', rest).unwrap_or(rest.len());
            self.position += (end + 1).min(rest.len());
            self.lines += 1;
            self.words = Words::new(&rest[..end]);
            if self.words.clone().next().is_some() {
                break;
            }
        }
        Ok(())
    }

    fn close(&mut self) -> Result<(), PlyProblem> {
        if self.encoding == Encoding::Ascii
            && let Some(word) = self.words.next()
        {
            let word = String::from_utf8_lossy(word).into_owned();
            return Err(PlyProblem::WordAfterElement { word });
        }
        Ok(())
    }

    /// The next number.
    #[inline]
    pub(super) fn number(&mut self, scalar: Scalar) -> Result<f64, PlyProblem> {
        if self.encoding == Encoding::Ascii {
            return number(&mut self.words)?.ok_or(PlyProblem::EndOfLine);
        }
        let rest = &self.bytes[self.position..];
        let bytes = rest.get(..scalar.size()).ok_or(PlyProblem::EndOfFile)?;
        self.position += bytes.len();
        let mut low_first = [0; 8];
        low_first[..bytes.len()].copy_from_slice(bytes);
        if self.encoding == Encoding::BigEndian {
            low_first[..bytes.len()].reverse();
        }
        let [a, b, c, d, ..] = low_first;
        Ok(match scalar {
            Scalar::I8 => f64::from(i8::from_le_bytes([a])),
            Scalar::U8 => f64::from(a),
            Scalar::I16 => f64::from(i16::from_le_bytes([a, b])),
            Scalar::U16 => f64::from(u16::from_le_bytes([a, b])),
            Scalar::I32 => f64::from(i32::from_le_bytes([a, b, c, d])),
            Scalar::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
            Scalar::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
            Scalar::F64 => f64::from_le_bytes(low_first),
        })
    }

    /// The length of a list of numbers of this type that follows.
    pub(super) fn length(&mut self, length: Scalar, of: Scalar) -> Result<usize, PlyProblem> {
        let length = self.number(length)?;
        let least = match self.encoding {
            Encoding::Ascii => 1,
            _ => of.size(),
        };
        let room = (self.bytes.len() / least) as f64;
        if length.fract() != 0.0 || !(0.0..=room).contains(&length) {
            return Err(PlyProblem::ListLength { length });
        }
        Ok(length as usize)
    }
}

impl From<WordError> for PlyProblem {
    fn from(error: WordError) -> Self {
        match error {
            WordError::Encoding => PlyProblem::NotText,
            WordError::Word(word) => PlyProblem::NotANumber { word },
            WordError::Infinite(word) => PlyProblem::NotFinite { word },
        }
    }
}

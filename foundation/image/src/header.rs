//! The headers of PNM and PFM: words in ASCII, divided by white space.

use crate::format::Format;
use crate::format_error::FormatError;

/// Reads the words of a header, then what follows it.
pub(crate) struct Header<'a> {
    format: Format,
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Header<'a> {
    pub(crate) fn new(format: Format, bytes: &'a [u8]) -> Self {
        Self {
            format,
            bytes,
            at: 0,
        }
    }

    /// The letter or digit after the P with which the file begins.
    pub(crate) fn magic(&mut self) -> Result<u8, FormatError> {
        let begins = self.bytes.first().is_none_or(|byte| *byte == b'P');
        match self.word()? {
            [b'P', kind] if begins => Ok(*kind),
            _ => {
                self.at = 0;
                Err(self.error("the file does not begin with P and one letter or digit"))
            }
        }
    }

    /// The next word, as a whole number that is not negative.
    pub(crate) fn number(&mut self) -> Result<usize, FormatError> {
        let word = self.text()?;
        // `parse` would accept a sign.
        if !word.bytes().all(|byte| byte.is_ascii_digit()) {
            return Err(self.error("a whole number is expected"));
        }
        word.parse()
            .map_err(|_| self.error("the number is too large"))
    }

    /// The next word, as a number.
    pub(crate) fn float(&mut self) -> Result<f64, FormatError> {
        let word = self.text()?;
        word.parse().map_err(|_| self.error("a number is expected"))
    }

    /// The length of the whole file.
    pub(crate) fn length(&self) -> usize {
        self.bytes.len()
    }

    /// What follows the one white space after the last word.
    pub(crate) fn data(&self) -> Result<&'a [u8], FormatError> {
        match &self.bytes[self.at..] {
            [space, data @ ..] if space.is_ascii_whitespace() => Ok(data),
            _ => Err(self.error("white space is expected after the header")),
        }
    }

    /// What follows the line end after the last word, where that should be `length` bytes.
    ///
    /// Where the last word is followed by CR LF, the LF may be the first byte of the data. It is
    /// part of the line end where lines before have one, and otherwise where the length asks for
    /// that.
    pub(crate) fn data_of(&self, length: usize) -> Result<&'a [u8], FormatError> {
        let data = self.data()?;
        let (header, rest) = self.bytes.split_at(self.at);
        Ok(match rest {
            [b'\r', b'\n', rest @ ..] if header.contains(&b'\n') || rest.len() == length => rest,
            _ => data,
        })
    }

    pub(crate) fn error(&self, problem: &'static str) -> FormatError {
        FormatError::Syntax {
            format: self.format,
            offset: self.at,
            problem,
        }
    }

    fn text(&mut self) -> Result<&'a str, FormatError> {
        let word = self.word()?;
        str::from_utf8(word).map_err(|_| self.error("a number is expected"))
    }

    fn word(&mut self) -> Result<&'a [u8], FormatError> {
        self.skip_space();
        let rest = &self.bytes[self.at..];
        let length = rest
            .iter()
            .position(|byte| byte.is_ascii_whitespace() || *byte == b'#')
            .unwrap_or(rest.len());
        if length == 0 {
            return Err(self.error("the file ends where a number is expected"));
        }
        self.at += length;
        Ok(&rest[..length])
    }

    /// Skips white space, and comments from `#` to the end of the line.
    fn skip_space(&mut self) {
        let mut comment = false;
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|byte| {
            comment = (comment || *byte == b'#') && *byte != b'\n' && *byte != b'\r';
            !comment && !byte.is_ascii_whitespace()
        });
        self.at += length.unwrap_or(rest.len());
    }
}

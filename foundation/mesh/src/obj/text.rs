//! The text of OBJ and MTL files.

use std::borrow::Cow;

use ga_files::text::{self, Encoding};

use super::lines::Lines;
use crate::words::Words;

/// A text that is UTF-8 outside of comments, and what is not UTF-8 there in the file.
pub(super) struct Text<'a> {
    pub(super) text: Cow<'a, [u8]>,
    pub(super) foreign: Option<Foreign>,
}

/// Lines with something that is not UTF-8 outside of comments, which may be in any encoding.
pub(super) struct Foreign {
    pub(super) first_line: usize,
    pub(super) count: usize,
    pub(super) encoding: Encoding,
}

/// The text of a file; the error is the line in which it is none.
pub(super) fn decode(bytes: &[u8]) -> Result<Text<'_>, usize> {
    let (text, encoding) =
        text::decode(bytes).map_err(|text::NotText(place)| text::line_of(bytes, place))?;
    let mut foreign = None;
    if encoding != Encoding::Utf8 {
        let is_foreign = |word: &[u8]| std::str::from_utf8(word).is_err();
        let mut lines = Lines::new(bytes).filter(|(_, text)| Words::new(text).any(is_foreign));
        foreign = lines.next().map(|(first_line, _)| Foreign {
            first_line,
            count: 1 + lines.count(),
            encoding,
        });
    }
    let text = match (&foreign, text) {
        (Some(_), Cow::Owned(text)) => Cow::Owned(text.into_bytes()),
        // Names are UTF-8 although some comment is not.
        _ => Cow::Borrowed(text::without_mark(bytes)),
    };
    Ok(Text { text, foreign })
}

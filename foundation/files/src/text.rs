//! The encoding of text, and the ends of its lines.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

use encoding_rs::{SHIFT_JIS, WINDOWS_1252};

/// The encoding of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8, of which ASCII is a part.
    Utf8,
    /// Shift-JIS as Windows has it, for Japanese.
    ShiftJis,
    /// Latin-1 with the letters that Windows adds (Windows-1252), for the languages of western
    /// Europe. Any bytes are such a text.
    Latin1,
}

impl fmt::Display for Encoding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Utf8 => "UTF-8",
            Self::ShiftJis => "Shift-JIS",
            Self::Latin1 => "Latin-1",
        })
    }
}

/// Bytes that are no text: the place of the first one that is not UTF-8 or is null.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("byte {0} is not text")]
pub struct NotText(pub usize);

/// A text in any encoding as UTF-8, without a byte order mark, and its encoding.
///
/// Text that is not UTF-8 is Shift-JIS where all of it is valid as such and most of what is not
/// ASCII is kana or a common kanji, whose first byte stands for no letter of Latin-1; otherwise it
/// is Latin-1. Line ends stay where they are.
///
/// # Errors
///
/// [`NotText`] where there is a null byte.
///
/// # Examples
///
/// ```
/// use ga_files::text::{Encoding, decode};
///
/// assert_eq!(decode(b"R\xfccken")?, ("Rücken".into(), Encoding::Latin1));
/// assert_eq!(decode(b"\x8d\xb6\x91\xab")?, ("左足".into(), Encoding::ShiftJis));
/// # Ok::<(), ga_files::text::NotText>(())
/// ```
pub fn decode(bytes: &[u8]) -> Result<(Cow<'_, str>, Encoding), NotText> {
    let text = without_mark(bytes);
    let null = memchr::memchr(0, text);
    let utf8 = std::str::from_utf8(text);
    let place = match (utf8, null) {
        (Ok(text), None) => return Ok((text.into(), Encoding::Utf8)),
        (Err(_), None) => None,
        (Ok(_), null) => null,
        (Err(error), Some(null)) => Some(null.min(error.valid_up_to())),
    };
    if let Some(place) = place {
        return Err(NotText(bytes.len() - text.len() + place));
    }
    if let Some(text) = shift_jis(text) {
        return Ok((text, Encoding::ShiftJis));
    }
    let (text, _) = WINDOWS_1252.decode_without_bom_handling(text);
    Ok((text, Encoding::Latin1))
}

/// A text without the byte order mark of UTF-8 at its beginning.
#[must_use]
pub fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}

/// The text where it is Shift-JIS.
fn shift_jis(bytes: &[u8]) -> Option<Cow<'_, str>> {
    let text = SHIFT_JIS.decode_without_bom_handling_and_without_replacement(bytes)?;
    let is_private = |c: char| ('\u{e000}'..='\u{f8ff}').contains(&c);
    if text.chars().any(is_private) {
        return None;
    }
    let (mut japanese, mut other) = (0, 0);
    let mut rest = bytes;
    // How many half-width kana stand before `rest`.
    let mut kana = 0;
    loop {
        let (first, length) = match rest {
            [] => (0, 0),
            [0x81..=0x9f | 0xe0..=0xfc, _, ..] => (rest[0], 2),
            [first, ..] => (*first, 1),
        };
        if matches!((first, length), (0xa1..=0xdf, 1)) {
            kana += 1;
        } else {
            // One or two are rather letters of Latin-1 between others.
            match kana {
                1 | 2 => other += 1,
                _ => japanese += kana,
            }
            kana = 0;
            if length == 2 {
                // Letters and marks of Windows-1252, as in Šipka, œil and Bob’s, say nothing before
                // a letter.
                let is_unclear = matches!(first, 0x8a | 0x8c | 0x8e | 0x91..=0x97 | 0x9a..=0x9f)
                    && rest[1].is_ascii_alphabetic();
                japanese += usize::from(first < 0xa0 && !is_unclear);
                other += usize::from(first >= 0xa0);
            }
        }
        if length == 0 {
            break;
        }
        rest = &rest[length..];
    }
    (japanese > other).then_some(text)
}

/// Where the first line of a text ends, and the next begins: LF, CR LF, or CR alone. Of several CR
/// before LF the line is ended by all.
///
/// # Examples
///
/// ```
/// use ga_files::text::line_end;
///
/// assert_eq!(line_end(b"ab\r\ncd"), Some(2..4));
/// assert_eq!(line_end(b"ab\rcd\n"), Some(2..3));
/// assert_eq!(line_end(b"ab"), None);
/// ```
#[must_use]
pub fn line_end(text: &[u8]) -> Option<Range<usize>> {
    let start = memchr::memchr2(b'\n', b'\r', text)?;
    if text[start] == b'\n' {
        return Some(start..start + 1);
    }
    let returns = text[start..].iter().take_while(|&&byte| byte == b'\r');
    let after = start + returns.count();
    match text.get(after) {
        Some(b'\n') => Some(start..after + 1),
        _ => Some(start..start + 1),
    }
}

/// The number of the line, from 1, in which the byte at `place` is.
#[must_use]
pub fn line_of(text: &[u8], place: usize) -> usize {
    let (mut line, mut rest) = (1, &text[..place.min(text.len())]);
    while let Some(end) = line_end(rest) {
        line += 1;
        rest = &rest[end.end..];
    }
    line
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;

    fn found(bytes: &[u8]) -> (String, Encoding) {
        let (text, encoding) = decode(bytes).unwrap();
        (text.into_owned(), encoding)
    }

    #[test]
    fn names_of_western_europe_are_latin_1() {
        for name in [
            "Rücken",
            "Körper",
            "Käse",
            "Señal",
            "Måns",
            "Fuß",
            "Hüfte",
            "Kopf_Ö",
            "épaule",
            "Épaule_gauche",
            "tête",
            "mâchoire",
            "Øre",
            "Höft",
            "Arm_ä",
            "ä",
            "é",
            "ÿ",
            "Straße",
            "niño",
            "cabeça",
            "mão",
            "pé",
            "Größe",
            "Übergang",
            "garçon",
            "œil",
            "côté",
            "Ärmel",
            "Šipka",
            "Bob’s_hip",
            "OBJEÇÃO",
            "GRÖSSE",
        ] {
            let (bytes, _, has_errors) = WINDOWS_1252.encode(name);
            assert!(!has_errors);
            assert_eq!(found(&bytes), (name.to_owned(), Encoding::Latin1));
        }
    }

    #[test]
    fn names_of_japanese_programs_are_shift_jis() {
        for name in [
            "センター",
            "上半身",
            "左足",
            "右ひじ",
            "首",
            "頭",
            "腰",
            "左目",
            "全ての親",
            "グルーブ",
            "体",
            "髪",
            "ｾﾝﾀｰ",
            "ﾎﾞｰﾝ",
            "ソ",
            "表",
            "能",
            "ボーン01",
            "足IK",
            "左足ＩＫ",
            "操作中心",
            "スカート_01_02",
        ] {
            let (bytes, _, has_errors) = SHIFT_JIS.encode(name);
            assert!(!has_errors);
            assert_eq!(found(&bytes), (name.to_owned(), Encoding::ShiftJis));
        }
    }

    #[test]
    fn utf_8_stays_as_it_is_and_null_bytes_are_no_text() {
        assert_eq!(found(b"\xef\xbb\xbfRu"), ("Ru".to_owned(), Encoding::Utf8));
        let text = "左足 Rücken";
        assert_eq!(found(text.as_bytes()), (text.to_owned(), Encoding::Utf8));
        assert_eq!(decode(b"ab\0"), Err(NotText(2)));
        assert_eq!(decode(b"\x89PNG\0"), Err(NotText(0)));
        assert_eq!(decode(b"\xef\xbb\xbf\0"), Err(NotText(3)));
    }

    #[test]
    fn lines_end_in_every_way() {
        let text = b"a\nb\r\nc\rd\r\r\ne\r\rf";
        let (mut rest, mut lines) = (&text[..], Vec::new());
        while let Some(end) = line_end(rest) {
            lines.push(&rest[..end.start]);
            rest = &rest[end.end..];
        }
        lines.push(rest);
        assert_eq!(lines, [&b"a"[..], b"b", b"c", b"d", b"e", b"", b"f"]);
        assert_eq!(line_of(text, text.len()), 7);
        assert_eq!(line_of(text, 0), 1);
    }
}

//! The header of a film.

use std::str::FromStr;

use super::{Film, Sampling};
use crate::format::Format;
use crate::format_error::FormatError;
use crate::ycbcr::Range;

/// What the first line of a film says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Header {
    /// Columns and rows.
    pub size: [usize; 2],
    /// Bits of each number: 8, or 10 as two bytes, the low one first.
    pub bit_depth: u32,
    /// Rate, sampling and colours. The header does not say the weights of luma; BT.601 stands
    /// there.
    pub film: Film,
    /// Whether the header states a rate of frames. Where it does not, or says that it is not known
    /// (`F0:0`), 25 frames in a second stand in [`film`](Self::film).
    pub has_rate: bool,
    /// Whether the rows of a frame belong to two moments.
    pub interlacing: Interlacing,
}

/// Whether a film is interlaced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interlacing {
    /// All rows of a frame are of one moment, or the header does not say.
    #[default]
    Progressive,
    /// Rows 0, 2, 4 … are of an earlier moment than rows 1, 3, 5 …
    TopFirst,
    /// Rows 1, 3, 5 … are of an earlier moment than rows 0, 2, 4 …
    BottomFirst,
    /// Each frame says it for itself.
    Mixed,
}

/// The bytes that begin a film.
pub(super) const MAGIC: &str = "YUV4MPEG2";

/// Reads the first line, without its end.
pub(super) fn parse(line: &[u8]) -> Result<Header, FormatError> {
    let text = str::from_utf8(line)
        .ok()
        .and_then(|line| line.strip_prefix(MAGIC))
        .filter(|words| words.is_empty() || words.starts_with(' '));
    let Some(words) = text else {
        return Err(syntax(0, "the first line does not begin with YUV4MPEG2"));
    };
    let mut header = Header::default();
    let mut offset = MAGIC.len();
    let (mut sampling_said, mut sampling_of_comment) = (false, None);
    for word in words.split(|c: char| c.is_ascii_whitespace()) {
        header.read_word(word, offset)?;
        sampling_said |= word.starts_with('C');
        // As mjpegtools before 1.9 had it.
        sampling_of_comment = word.strip_prefix("XYSCSS=").or(sampling_of_comment);
        offset += word.len() + 1;
    }
    if let Some(value) = sampling_of_comment.filter(|_| !sampling_said) {
        (header.film.sampling, header.bit_depth) = sampling(&value.to_ascii_lowercase())?;
    }
    if header.size.contains(&0) {
        return Err(syntax(
            line.len(),
            "the header states no width or no height",
        ));
    }
    Ok(header)
}

pub(super) fn syntax(offset: usize, problem: &'static str) -> FormatError {
    FormatError::Syntax {
        format: Format::Y4m,
        offset,
        problem,
    }
}

impl Default for Header {
    /// Without pixels; what else holds where a header does not say it.
    fn default() -> Self {
        Self {
            size: [0, 0],
            bit_depth: 8,
            film: Film::default(),
            has_rate: false,
            interlacing: Interlacing::default(),
        }
    }
}

impl Header {
    fn read_word(&mut self, word: &str, offset: usize) -> Result<(), FormatError> {
        let mut letters = word.chars();
        let (name, value) = (letters.next(), letters.as_str());
        match name {
            Some('W') => self.size[0] = number(value, offset)?,
            Some('H') => self.size[1] = number(value, offset)?,
            Some('F') => {
                if let Some(rate) = ratio(
                    value,
                    offset,
                    "the rate of frames is not a ratio of positive numbers",
                )? {
                    self.film.frames_per_second = rate;
                    self.has_rate = true;
                }
            }
            Some('A') => {
                // `A0:0` says that the shape is not known.
                if let Some(aspect) = ratio(
                    value,
                    offset,
                    "the shape of a pixel is not a ratio of positive numbers",
                )? {
                    self.film.pixel_aspect = aspect;
                }
            }
            Some('C') => (self.film.sampling, self.bit_depth) = sampling(value)?,
            Some('I') => {
                self.interlacing = match value {
                    "t" => Interlacing::TopFirst,
                    "b" => Interlacing::BottomFirst,
                    "m" => Interlacing::Mixed,
                    _ => Interlacing::Progressive,
                }
            }
            Some('X') if value == "COLORRANGE=FULL" => self.film.colours.range = Range::Full,
            Some('X') if value == "COLORRANGE=LIMITED" => {
                self.film.colours.range = Range::Limited;
            }
            _ => {}
        }
        Ok(())
    }
}

fn sampling(value: &str) -> Result<(Sampling, u32), FormatError> {
    Ok(match value {
        "420" | "420jpeg" | "420mpeg2" | "420paldv" => (Sampling::Quarter, 8),
        "422" => (Sampling::Half, 8),
        "444" => (Sampling::Full, 8),
        "mono" => (Sampling::Grey, 8),
        "420p10" => (Sampling::Quarter, 10),
        "422p10" => (Sampling::Half, 10),
        "444p10" => (Sampling::Full, 10),
        "mono10" => (Sampling::Grey, 10),
        _ => {
            return Err(FormatError::Unsupported {
                format: Format::Y4m,
                what: format!("the sampling {value}"),
            });
        }
    })
}

/// A ratio of positive numbers, or `None` where it is said to be unknown.
fn ratio(
    value: &str,
    offset: usize,
    problem: &'static str,
) -> Result<Option<[u32; 2]>, FormatError> {
    let numbers = value
        .split_once(':')
        .ok_or_else(|| syntax(offset, problem))?;
    match [number(numbers.0, offset)?, number(numbers.1, offset)?] {
        [0, 0] => Ok(None),
        [0, _] | [_, 0] => Err(syntax(offset, problem)),
        ratio => Ok(Some(ratio)),
    }
}

fn number<N: FromStr>(word: &str, offset: usize) -> Result<N, FormatError> {
    // `parse` would accept a sign.
    let digits = Some(word).filter(|word| word.bytes().all(|byte| byte.is_ascii_digit()));
    digits.and_then(|word| word.parse().ok()).ok_or_else(|| {
        syntax(
            offset,
            "a number of the header is not a number, or too large",
        )
    })
}

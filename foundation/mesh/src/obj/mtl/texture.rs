//! Pictures of materials, with their options.

use super::MtlProblem;
use super::remarks::Remarks;
use crate::words::{WordError, Words, number, text};
use crate::{Texture, Wrap};

/// A picture, and what its options say that is not about its place.
pub(super) struct Picture {
    pub(super) texture: Texture,
    /// The factor of bumps, `-bm`.
    pub(super) bump: f64,
    /// The channel, `-imfchan`.
    pub(super) channel: Option<String>,
}

/// The picture that a line names; `None` where it names none.
pub(super) fn picture(
    statement: &str,
    words: &mut Words<'_>,
    remarks: &mut Remarks,
) -> Result<Option<Picture>, MtlProblem> {
    let mut picture = Picture {
        texture: Texture::file(""),
        bump: 1.0,
        channel: None,
    };
    while let Some(rest) = words.rest() {
        if rest[0] != b'-' {
            let path = words.clone().joined()?.replace('\\', "/");
            picture.texture.image = crate::Image::File(path);
            return Ok(Some(picture));
        }
        let option = words.next().map_or(Ok(""), text)?.to_owned();
        let has_value = match option.as_str() {
            "-o" => assign(&mut picture.texture.offset, place(words, 0.0)?),
            "-s" => assign(&mut picture.texture.scale, place(words, 1.0)?),
            "-t" | "-mm" => place(words, 0.0)?.is_some(),
            "-bm" => assign(&mut picture.bump, number_before_path(words)?),
            "-clamp" => match value(words) {
                Some(b"on") => assign(&mut picture.texture.wrap, Some([Wrap::ClampToEdge; 2])),
                other => other.is_some(),
            },
            "-imfchan" => match value(words) {
                Some(channel) => {
                    picture.channel = Some(text(channel)?.to_owned());
                    true
                }
                None => false,
            },
            "-blendu" | "-blendv" | "-boost" | "-cc" | "-texres" | "-type" => {
                value(words).is_some()
            }
            _ => {
                // The last word is the path.
                let mut ahead = words.clone();
                if ahead.next().is_some() && ahead.rest().is_some() {
                    *words = ahead;
                }
                remarks.note(MtlProblem::UnknownOption {
                    statement: statement.to_owned(),
                    option,
                });
                continue;
            }
        };
        if !has_value {
            remarks.tolerate(MtlProblem::OptionValue {
                statement: statement.to_owned(),
                option,
            })?;
        }
    }
    remarks.note(MtlProblem::NoPicture {
        statement: statement.to_owned(),
    });
    Ok(None)
}

/// Puts a value that is there into its place, and says whether it is there.
fn assign<T>(slot: &mut T, value: Option<T>) -> bool {
    let is_there = value.is_some();
    if let Some(value) = value {
        *slot = value;
    }
    is_there
}

/// The value of an option; `None` where the next word is the path of the picture, since it is the
/// last and no value of an option.
fn value<'a>(words: &mut Words<'a>) -> Option<&'a [u8]> {
    let mut ahead = words.clone();
    let word = ahead.next()?;
    let is_value = matches!(
        word,
        b"on" | b"off" | [b'r' | b'g' | b'b' | b'm' | b'l' | b'z']
    );
    if ahead.rest().is_none() && !is_value {
        return None;
    }
    *words = ahead;
    Some(word)
}

/// The number of an option; `None` where the next word is the path of the picture.
fn number_before_path(words: &mut Words<'_>) -> Result<Option<f64>, MtlProblem> {
    let mut ahead = words.clone();
    match number(&mut ahead) {
        Err(WordError::Word(_)) if ahead.rest().is_none() => Ok(None),
        found => {
            let found = found?;
            *words = ahead;
            Ok(found)
        }
    }
}

/// One to three numbers, of which the first two count; `None` where there is none.
fn place(words: &mut Words<'_>, default: f64) -> Result<Option<[f64; 2]>, MtlProblem> {
    let Some(first) = number_before_path(words)? else {
        return Ok(None);
    };
    let mut place = [first, default];
    for index in 1..3 {
        let mut ahead = words.clone();
        // The next word may be the path of the picture.
        match number(&mut ahead) {
            Ok(Some(value)) if ahead.rest().is_some() => {
                if let Some(slot) = place.get_mut(index) {
                    *slot = value;
                }
                *words = ahead;
            }
            _ => break,
        }
    }
    Ok(Some(place))
}

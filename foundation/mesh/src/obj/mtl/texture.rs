//! Pictures of materials, with their options.

use super::MtlProblem;
use crate::words::{Words, number, text};
use crate::{Texture, Wrap};

/// A picture, and what its options say that is not about its place.
pub(super) struct Picture {
    pub(super) texture: Texture,
    /// The factor of bumps, `-bm`.
    pub(super) bump: f64,
    /// The channel, `-imfchan`.
    pub(super) channel: Option<String>,
}

/// The picture that a line names; `None` where it names none. What is ignored is added to
/// `ignored`.
pub(super) fn picture(
    statement: &str,
    words: &mut Words<'_>,
    ignored: &mut Vec<MtlProblem>,
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
        let no_value = || MtlProblem::OptionValue {
            statement: statement.to_owned(),
            option: option.clone(),
        };
        match option.as_str() {
            "-o" => picture.texture.offset = place(words, 0.0)?.ok_or_else(no_value)?,
            "-s" => picture.texture.scale = place(words, 1.0)?.ok_or_else(no_value)?,
            "-t" => {
                place(words, 0.0)?.ok_or_else(no_value)?;
            }
            "-mm" => {
                place(words, 0.0)?.ok_or_else(no_value)?;
            }
            "-bm" => picture.bump = number(words)?.ok_or_else(no_value)?,
            "-clamp" => {
                if words.next().ok_or_else(no_value)? == b"on" {
                    picture.texture.wrap = [Wrap::ClampToEdge; 2];
                }
            }
            "-imfchan" => {
                picture.channel = Some(text(words.next().ok_or_else(no_value)?)?.to_owned());
            }
            "-blendu" | "-blendv" | "-boost" | "-cc" | "-texres" | "-type" => {
                words.next().ok_or_else(no_value)?;
            }
            _ => {
                // The last word is the path.
                let mut ahead = words.clone();
                if ahead.next().is_some() && ahead.rest().is_some() {
                    *words = ahead;
                }
                ignored.push(MtlProblem::UnknownOption {
                    statement: statement.to_owned(),
                    option,
                });
            }
        }
    }
    ignored.push(MtlProblem::NoPicture {
        statement: statement.to_owned(),
    });
    Ok(None)
}

/// One to three numbers, of which the first two count; `None` where there is none.
fn place(words: &mut Words<'_>, default: f64) -> Result<Option<[f64; 2]>, MtlProblem> {
    let Some(first) = number(words)? else {
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

//! Colours.

use std::str::FromStr;

use serde::Serialize;

/// A colour by its red, green and blue parts, each from 0 to 255.
///
/// ```
/// use ga_draw::Colour;
/// let blue: Colour = "#0072b2".parse()?;
/// assert_eq!(blue, Colour([0, 0x72, 0xb2]));
/// assert_eq!(blue.to_string(), "#0072b2");
/// assert!("blue".parse::<Colour>().is_err());
/// # Ok::<(), ga_draw::NotAColour>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Colour(pub [u8; 3]);

/// The colours of elements for which no colour is given, one after the other.
///
/// The first seven follow Okabe and Ito's set, which people with any kind of colour vision can tell
/// apart (Color Universal Design, 2008). Five more follow, so that no colour is repeated within
/// twelve elements. Each has a contrast of at least 3 : 1 to a light and to a dark background (Web
/// Content Accessibility Guidelines 2.1, criterion 1.4.11); some are darker than Okabe and Ito's
/// for that reason.
pub const PALETTE: [Colour; 12] = [
    Colour([0x00, 0x72, 0xb2]),
    Colour([0xd5, 0x5e, 0x00]),
    Colour([0x00, 0x94, 0x6c]),
    Colour([0xc0, 0x67, 0x98]),
    Colour([0xa9, 0x78, 0x00]),
    Colour([0x3a, 0x8f, 0xc4]),
    Colour([0x7a, 0x7a, 0x7a]),
    Colour([0x82, 0x50, 0xdf]),
    Colour([0xcf, 0x22, 0x36]),
    Colour([0x5c, 0x8a, 0x12]),
    Colour([0xc0, 0x3c, 0xc8]),
    Colour([0x93, 0x60, 0x49]),
];

/// A text that is not a colour: it is not `#` and six hexadecimal digits.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is not a colour: it must be # and six hexadecimal digits, as in #0072b2")]
pub struct NotAColour(pub String);

impl FromStr for Colour {
    type Err = NotAColour;

    fn from_str(text: &str) -> Result<Self, NotAColour> {
        let wrong = || NotAColour(text.to_owned());
        let digits = text.strip_prefix('#').ok_or_else(wrong)?;
        if digits.len() != 6 || !digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
            return Err(wrong());
        }
        let number = u32::from_str_radix(digits, 16).map_err(|_| wrong())?;
        let [_, red, green, blue] = number.to_be_bytes();
        Ok(Self([red, green, blue]))
    }
}

impl std::fmt::Display for Colour {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [red, green, blue] = self.0;
        write!(f, "#{red:02x}{green:02x}{blue:02x}")
    }
}

impl Serialize for Colour {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

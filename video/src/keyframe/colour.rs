//! The colour of a frame without a picture.

use std::fmt::{self, Display, Formatter};

use ga_image::plane::Plane;
use ga_image::ycbcr::YCbCr;
use serde::{Serialize, Serializer};

use crate::Planes;

/// Black has no channel above this number: that of a black level at 7.5 IRE, and its noise.
const BLACK: u8 = 20;

/// White has no channel below this number.
const WHITE: u8 = 235;

/// The places at which the colour of a frame is taken: columns, rows.
const PLACES: [usize; 2] = [16, 9];

/// What a picture fades from or to.
///
/// ```
/// use ga_video::keyframe::colour::Colour;
///
/// assert_eq!(Colour::of([16, 16, 16]), Colour::Black);
/// assert_eq!(Colour::of([70, 0, 0]).to_string(), "#460000");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// Black, with no channel above 20.
    Black,
    /// White, with no channel below 235.
    White,
    /// Another colour, as red, green and blue.
    Other([u8; 3]),
}

impl Colour {
    /// The colour of red, green and blue.
    #[must_use]
    pub fn of(rgb: [u8; 3]) -> Self {
        if rgb.iter().all(|channel| *channel <= BLACK) {
            Self::Black
        } else if rgb.iter().all(|channel| *channel >= WHITE) {
            Self::White
        } else {
            Self::Other(rgb)
        }
    }
}

impl Display for Colour {
    /// `black`, `white`, or `#rrggbb`.
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Black => formatter.write_str("black"),
            Self::White => formatter.write_str("white"),
            Self::Other([r, g, b]) => write!(formatter, "#{r:02x}{g:02x}{b:02x}"),
        }
    }
}

impl Serialize for Colour {
    /// As it is shown.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// The median of luma and of both colour differences over 16 × 9 places of a frame, as red, green
/// and blue: where most of a frame has one colour, this colour, in spite of noise and captions.
#[must_use]
pub fn usual_colour(planes: &Planes<u8>, colours: YCbCr) -> [u8; 3] {
    let [columns, rows] = PLACES;
    let middle = |plane: &Plane<u8>| {
        let place =
            |index: usize, count: usize, length: usize| (2 * index + 1) * length / (2 * count);
        let values = (0..columns * rows).filter_map(|index| {
            let x = place(index % columns, columns, plane.width());
            plane.get(x, place(index / columns, rows, plane.height()))
        });
        let mut values: Vec<u8> = values.collect();
        let half = values.len() / 2;
        // A grey video has no colour differences.
        match values.is_empty() {
            true => 128,
            false => *values.select_nth_unstable(half).1,
        }
    };
    colours.to_rgb(planes.as_array().map(middle))
}

//! Lettering on pictures, in Noto Sans Mono.

use ga_image::plane::Plane;
use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};

const HEIGHT: RasterHeight = RasterHeight::Size16;

/// The height of a line in pixels.
pub const LINE_HEIGHT: u32 = HEIGHT.val() as u32;

/// The colours of sheets and of the letters on them.
pub(crate) const PAPER: [u8; 3] = [250, 250, 252];
pub(crate) const INK: [u8; 3] = [44, 52, 64];

/// How bold letters are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// For running text.
    Regular,
    /// For titles.
    Bold,
}

/// Columns that a line of text takes.
#[must_use]
pub fn width(text: &str, weight: Weight) -> u32 {
    let letters = u32::try_from(text.chars().count()).unwrap_or(u32::MAX);
    letters.saturating_mul(advance(weight))
}

/// Writes a line with its top left corner at `x`, `y`, cut off after `width` pixels and where the
/// picture ends. Letters that the font does not have become question marks.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_render::text::{self, Weight};
///
/// let mut picture = Plane::filled(100, text::LINE_HEIGHT as usize, [0; 3]);
/// let width = text::width("depth", Weight::Bold);
/// text::write(&mut picture, [0, 0], width, "depth", Weight::Bold, [255; 3]);
/// assert!(picture.values().contains(&[255; 3]));
/// ```
pub fn write(
    picture: &mut Plane<[u8; 3]>,
    [x, y]: [u32; 2],
    width: u32,
    text: &str,
    weight: Weight,
    colour: [u8; 3],
) {
    let advance = advance(weight);
    let weight = weight.of_font();
    let letters = text.chars().take((width / advance) as usize);
    for (index, letter) in letters.enumerate() {
        let raster = get_raster(letter, weight, HEIGHT).or_else(|| get_raster('?', weight, HEIGHT));
        let Some(raster) = raster else { continue };
        let left = x + index as u32 * advance;
        let mut view = picture.view_mut();
        let rows = view.rows_mut().skip(y as usize);
        for (pixels, line) in rows.zip(raster.rows()) {
            for (pixel, &ink) in pixels.iter_mut().skip(left as usize).zip(line.iter()) {
                *pixel = std::array::from_fn(|i| blend(pixel[i], colour[i], ink));
            }
        }
    }
}

/// Columns from one letter to the next.
fn advance(weight: Weight) -> u32 {
    get_raster_width(weight.of_font(), HEIGHT) as u32
}

impl Weight {
    fn of_font(self) -> FontWeight {
        match self {
            Self::Regular => FontWeight::Regular,
            Self::Bold => FontWeight::Bold,
        }
    }
}

/// A colour over another one, of which it covers a share from 0 to 255.
pub(crate) fn blend(below: u8, ink: u8, share: u8) -> u8 {
    let (below, ink, share) = (u32::from(below), u32::from(ink), u32::from(share));
    // A mean of two bytes is a byte.
    ((below * (255 - share) + ink * share + 127) / 255) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHITE: [u8; 3] = [255; 3];

    fn written(text: &str, width: u32) -> Plane<[u8; 3]> {
        let mut picture = Plane::filled(120, 24, WHITE);
        write(&mut picture, [4, 4], width, text, Weight::Bold, [0; 3]);
        picture
    }

    #[test]
    fn letters_leave_ink_where_they_stand_and_nowhere_else() {
        let picture = written("|", 100);
        let inked = |x: usize, y: usize| picture.get(x, y) != Some(WHITE);
        let columns: Vec<usize> = (0..120).filter(|&x| (0..24).any(|y| inked(x, y))).collect();
        let rows: Vec<usize> = (0..24).filter(|&y| (0..120).any(|x| inked(x, y))).collect();
        assert!(
            (1..=4).contains(&columns.len()) && columns[0] > 4 && columns[0] < 10,
            "{columns:?}"
        );
        assert!(rows.len() > 10 && rows[0] >= 4, "{rows:?}");
    }

    #[test]
    fn text_stops_where_its_room_ends() {
        let advance = get_raster_width(FontWeight::Bold, HEIGHT) as u32;
        assert_eq!(written("abcdef", 3 * advance), written("abc", 100));
        assert_ne!(written("abcdef", 100), written("abc", 100));
        assert_eq!(written("abc", advance - 1), written("", 100));
    }

    #[test]
    fn letters_beyond_the_image_or_the_font_are_no_trouble() {
        assert_eq!(written("a\u{4e2d}b", 100), written("a?b", 100));
        write(
            &mut Plane::filled(5, 5, [0; 3]),
            [3, 3],
            100,
            "wide",
            Weight::Regular,
            WHITE,
        );
    }
}

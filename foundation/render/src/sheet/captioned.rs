//! Pictures of any origin side by side.

use ga_image::plane::{Plane, PlaneError};
use ga_image::resample::{Method, resize};

use crate::text::{self, INK, PAPER, Weight};

/// Columns of the sheet, the width of a picture, and the space around it.
const COLUMNS: usize = 4;
const WIDTH: usize = 320;
const SPACE: usize = 12;
/// The height of the title, and of the two lines under a picture.
const TITLE: usize = 40;
const CAPTION: usize = 44;

/// A picture in the size of a sheet, and two lines of text below it.
#[derive(Clone, Debug)]
pub struct Captioned {
    picture: Plane<[u8; 3]>,
    lines: [String; 2],
}

impl Captioned {
    /// Brings a picture to the size of a sheet, 320 columns.
    ///
    /// # Errors
    ///
    /// [`PlaneError`] where the picture has no pixels.
    pub fn new(picture: &Plane<[u8; 3]>, lines: [String; 2]) -> Result<Self, PlaneError> {
        let height = (WIDTH * picture.height())
            .div_ceil(picture.width().max(1))
            .clamp(1, 640);
        let method = match picture.width() < WIDTH {
            true => Method::Bilinear,
            false => Method::Area,
        };
        let picture = resize(picture, WIDTH, height, method)?;
        Ok(Self { picture, lines })
    }
}

/// Pictures of one size in rows of four under a title.
///
/// ```
/// use ga_image::plane::{Plane, PlaneError};
/// use ga_render::sheet::{Captioned, captioned_sheet};
///
/// let picture = Plane::filled(64, 32, [200; 3]);
/// let lines = || ["frame 0, 0 s".to_owned(), "the first one".to_owned()];
/// let pictures = (0..5).map(|_| Captioned::new(&picture, lines()));
/// let sheet = captioned_sheet("Two rows", &pictures.collect::<Result<Vec<_>, _>>()?);
/// assert_eq!([sheet.width(), sheet.height()], [12 + 4 * 332, 40 + 2 * (160 + 44) + 12]);
/// # Ok::<(), PlaneError>(())
/// ```
#[must_use]
pub fn captioned_sheet(title: &str, pictures: &[Captioned]) -> Plane<[u8; 3]> {
    let picture_height = pictures.first().map_or(0, |first| first.picture.height());
    let columns = pictures.len().clamp(1, COLUMNS);
    let rows = pictures.len().div_ceil(columns);
    let width = SPACE + columns * (WIDTH + SPACE);
    let height = TITLE + rows * (picture_height + CAPTION) + SPACE;
    let mut sheet = Plane::filled(width, height, PAPER);
    let room = (width - 2 * SPACE) as u32;
    let place = [SPACE as u32, 12];
    text::write(&mut sheet, place, room, title, Weight::Bold, INK);
    for (position, Captioned { picture, lines }) in pictures.iter().enumerate() {
        let left = SPACE + position % columns * (WIDTH + SPACE);
        let top = TITLE + position / columns * (picture_height + CAPTION);
        sheet.view_mut().put(picture, [left, top]);
        let mut place = [left as u32, (top + picture_height + 4) as u32];
        for (line, weight) in lines.iter().zip([Weight::Bold, Weight::Regular]) {
            text::write(&mut sheet, place, WIDTH as u32, line, weight, INK);
            place[1] += text::LINE_HEIGHT + 2;
        }
    }
    sheet
}

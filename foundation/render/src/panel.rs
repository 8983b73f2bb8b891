//! Pictures of numbers beside each other, with captions and scales of colours.

use ga_image::plane::Plane;

use crate::text::{self, INK, LINE_HEIGHT, PAPER, Weight};

/// Around everything, in pixels.
const MARGIN: u32 = 10;

/// The height of the bar of colours, and the side of the squares that show the marks.
const BAR: u32 = 14;

/// The columns that a scale needs at least, for its bar, its numbers and the marks.
const SCALE_WIDTH: u32 = 300;

/// A mark that stands for pixels without a number, as the colour at a column and a row, and what it
/// means.
pub type Mark = (fn([usize; 2]) -> [u8; 3], &'static str);

/// One picture of several beside each other.
pub struct Panel {
    /// What stands above it.
    pub caption: String,
    /// Numbers in colours.
    pub picture: Plane<[u8; 3]>,
    /// The colours of the scale, from 0 to 1.
    pub colours: Box<dyn Fn(f64) -> [u8; 3]>,
    /// What the lower and the upper end of the scale are called, such as `4 px or more`.
    pub ends: [String; 2],
    /// What pixels without a number look like.
    pub marks: Vec<Mark>,
}

impl Panel {
    fn size(&self) -> [u32; 2] {
        [self.picture.width(), self.picture.height()].map(|side| side as u32)
    }

    /// Columns that the panel takes, without margins.
    fn width(&self) -> u32 {
        self.size()[0].max(SCALE_WIDTH)
    }
}

/// The panels beside each other, each with its caption above and its scale below.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_render::panel::{Panel, beside};
///
/// let colours = |share: f64| [(255.0 * share) as u8; 3];
/// let picture = Plane::from_fn(400, 100, |column, _| colours(column as f64 / 399.0));
/// let sheet = beside(&[Panel {
///     caption: "a ramp".into(),
///     picture,
///     colours: Box::new(colours),
///     ends: ["0".into(), "1".into()],
///     marks: Vec::new(),
/// }]);
/// assert_eq!(sheet.width(), 420);
/// ```
#[must_use]
pub fn beside(panels: &[Panel]) -> Plane<[u8; 3]> {
    let width = panels.iter().map(|panel| panel.width() + MARGIN);
    let rows = panels.iter().map(|panel| panel.size()[1]).max();
    let scale_lines = panels
        .iter()
        .map(|panel| 1 + panel.marks.len() as u32)
        .max();
    let below = scale_lines.unwrap_or(0) * (LINE_HEIGHT + 4) + BAR;
    let height = 3 * MARGIN + LINE_HEIGHT + rows.unwrap_or(0) + below;
    let width = width.sum::<u32>() + MARGIN;
    let mut sheet = Plane::filled(width as usize, height as usize, PAPER);
    let mut left = MARGIN;
    for panel in panels {
        draw(&mut sheet, left, panel);
        left += panel.width() + MARGIN;
    }
    sheet
}

fn draw(sheet: &mut Plane<[u8; 3]>, left: u32, panel: &Panel) {
    let width = panel.width();
    let line = |sheet: &mut Plane<[u8; 3]>, [x, y]: [u32; 2], room: u32, words: &str, weight| {
        text::write(sheet, [x, y], room, words, weight, INK);
    };
    line(sheet, [left, MARGIN], width, &panel.caption, Weight::Bold);
    let mut top = MARGIN + LINE_HEIGHT + 4;
    put(sheet, [left, top], &panel.picture);
    top += panel.size()[1] + MARGIN;

    let bar = Plane::from_fn(width as usize, BAR as usize, |column, _| {
        let share = column as f64 / f64::from(width - 1);
        (panel.colours)(share)
    });
    put(sheet, [left, top], &bar);
    top += BAR + 4;
    line(sheet, [left, top], width, &panel.ends[0], Weight::Regular);
    let room = text::width(&panel.ends[1], Weight::Regular).min(width);
    line(
        sheet,
        [left + width - room, top],
        room,
        &panel.ends[1],
        Weight::Regular,
    );
    for (mark, meaning) in &panel.marks {
        top += LINE_HEIGHT + 4;
        let square = Plane::from_fn(BAR as usize, BAR as usize, |column, row| {
            mark([column, row])
        });
        put(sheet, [left, top], &square);
        let indent = BAR + 6;
        line(
            sheet,
            [left + indent, top],
            width - indent,
            meaning,
            Weight::Regular,
        );
    }
}

fn put(sheet: &mut Plane<[u8; 3]>, place: [u32; 2], picture: &Plane<[u8; 3]>) {
    sheet
        .view_mut()
        .put(picture, place.map(|pixel| pixel as usize));
}

//! Pictures, frames around them and captions.

use ga_image::plane::Plane;

use super::layout::{BORDER, CAPTION, Size};
use super::{Caption, Kind, Options};
use crate::Rendering;
use crate::text::{self, INK, PAPER, Weight};

const KEY: [u8; 3] = [210, 84, 12];
const IN_BETWEEN: [u8; 3] = [86, 110, 142];
const IN_BETWEEN_BORDER: [u8; 3] = [196, 204, 214];

/// On a depth picture.
const LABEL: [u8; 3] = [150, 158, 168];
const INSET: u32 = 6;

/// Vertical distance of the lines of a caption.
const LINE: u32 = 18;

pub(super) fn sheet(
    captions: &[Caption],
    pictures: &[Rendering],
    rows: &[Vec<usize>],
    size: &Size,
    depth_range: Option<(f64, f64)>,
    options: &Options,
) -> Plane<[u8; 3]> {
    let mut sheet = Plane::filled(size.width as usize, size.height as usize, PAPER);
    let title_width = size.width - 2 * size.title()[0];
    text::write(
        &mut sheet,
        size.title(),
        title_width,
        &options.title,
        Weight::Bold,
        INK,
    );
    let (near, far) = depth_range.unwrap_or((0.0, 1.0));
    for (row, indices) in rows.iter().enumerate() {
        for (column, &index) in indices.iter().enumerate() {
            let (Some(caption), Some(picture)) = (captions.get(index), pictures.get(index)) else {
                continue;
            };
            let kind = caption.kind;
            place(&mut sheet, &picture.colour, size.picture(column, row), kind);
            write_caption(
                &mut sheet,
                caption,
                size.caption(column, row),
                options.style.width,
            );
            if options.depth {
                let depth = picture.depth.to_plane(near, far).map(|grey| [grey; 3]);
                let corner = size.depth(column, row);
                place(&mut sheet, &depth, corner, kind);
                if (row, column) == (0, 0) {
                    // At the bottom, where the figure leaves the corner free.
                    let below = options.style.height.saturating_sub(INSET + LINE);
                    let inside = [corner[0] + INSET, corner[1] + below];
                    let width = options.style.width.saturating_sub(2 * INSET);
                    text::write(
                        &mut sheet,
                        inside,
                        width,
                        "depth, near is white",
                        Weight::Regular,
                        LABEL,
                    );
                }
            }
        }
    }
    sheet
}

/// Puts a picture on the sheet with a frame around it.
fn place(sheet: &mut Plane<[u8; 3]>, picture: &Plane<[u8; 3]>, [x, y]: [u32; 2], kind: Kind) {
    let border = match kind {
        Kind::Key => KEY,
        Kind::InBetween { .. } => IN_BETWEEN_BORDER,
    };
    let [width, height] =
        [picture.width(), picture.height()].map(|size| size + 2 * BORDER as usize);
    let frame = Plane::filled(width, height, border);
    let corner = |border: u32| [x - border, y - border].map(|place| place as usize);
    let mut sheet = sheet.view_mut();
    sheet.put(&frame, corner(BORDER));
    sheet.put(picture, corner(0));
}

fn write_caption(sheet: &mut Plane<[u8; 3]>, caption: &Caption, [x, y]: [u32; 2], width: u32) {
    let moment = format!("frame {} · t = {:.2} s", caption.number, caption.time);
    let (part, weight, colour) = match caption.kind {
        Kind::Key => ("key".to_owned(), Weight::Bold, KEY),
        Kind::InBetween { step, steps } => (
            format!("in-between {step}/{steps}"),
            Weight::Regular,
            IN_BETWEEN,
        ),
    };
    let top = y + (CAPTION - 2 * LINE) / 2;
    text::write(sheet, [x, top], width, &part, weight, colour);
    text::write(sheet, [x, top + LINE], width, &moment, Weight::Regular, INK);
}

//! Pictures, frames around them and captions.

use image::{Rgb, RgbImage, imageops};

use super::layout::{BORDER, CAPTION, Size};
use super::{Frame, Kind, Options};
use crate::Rendering;
use crate::text::{self, Weight};

const PAPER: Rgb<u8> = Rgb([250, 250, 252]);
const INK: Rgb<u8> = Rgb([44, 52, 64]);
const KEY: Rgb<u8> = Rgb([210, 84, 12]);
const IN_BETWEEN: Rgb<u8> = Rgb([86, 110, 142]);
const IN_BETWEEN_BORDER: Rgb<u8> = Rgb([196, 204, 214]);

/// On a depth picture.
const LABEL: Rgb<u8> = Rgb([150, 158, 168]);
const INSET: u32 = 6;

/// Vertical distance of the lines of a caption.
const LINE: u32 = 18;

pub(super) fn sheet(
    frames: &[Frame],
    pictures: &[Rendering],
    rows: &[Vec<usize>],
    size: &Size,
    depth_range: Option<(f64, f64)>,
    options: &Options,
) -> RgbImage {
    let mut sheet = RgbImage::from_pixel(size.width, size.height, PAPER);
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
            let kind = frames[index].kind;
            place(
                &mut sheet,
                &pictures[index].colour,
                size.picture(column, row),
                kind,
            );
            caption(
                &mut sheet,
                &frames[index],
                size.caption(column, row),
                options.style.width,
            );
            if options.depth {
                let depth = pictures[index].depth.to_image(near, far);
                let depth = RgbImage::from_fn(depth.width(), depth.height(), |x, y| {
                    Rgb([depth.get_pixel(x, y).0[0]; 3])
                });
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
fn place(sheet: &mut RgbImage, picture: &RgbImage, [x, y]: [u32; 2], kind: Kind) {
    let border = match kind {
        Kind::Key => KEY,
        Kind::InBetween { .. } => IN_BETWEEN_BORDER,
    };
    let (width, height) = (picture.width() + 2 * BORDER, picture.height() + 2 * BORDER);
    let frame = RgbImage::from_pixel(width, height, border);
    imageops::replace(sheet, &frame, i64::from(x - BORDER), i64::from(y - BORDER));
    imageops::replace(sheet, picture, i64::from(x), i64::from(y));
}

fn caption(sheet: &mut RgbImage, frame: &Frame, [x, y]: [u32; 2], width: u32) {
    let moment = format!("frame {} · t = {:.2} s", frame.number, frame.time);
    let (part, weight, colour) = match frame.kind {
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

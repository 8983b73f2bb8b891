//! Key frames side by side.

use anyhow::{Context, Result};
use ga_image::plane::Plane;
use ga_image::resample::{Method, resize};
use ga_render::text::{self, Weight};
use image::{Rgb, RgbImage};

use super::report::Report;
use super::spool::Spool;

const PAPER: Rgb<u8> = Rgb([250, 250, 252]);
const INK: Rgb<u8> = Rgb([44, 52, 64]);

/// Columns of the sheet, the width of a picture, and the space around it.
const COLUMNS: usize = 4;
const WIDTH: usize = 320;
const SPACE: usize = 12;
/// The height of the title, and of the two lines under a picture.
const TITLE: usize = 40;
const CAPTION: usize = 44;
/// More pictures would make a sheet that viewers refuse.
const MOST: usize = 400;

/// The key frames in rows, each with its number, time, reason and score.
pub(super) fn draw(report: &Report, spool: &mut Spool, title: &str) -> Result<Plane<[u8; 3]>> {
    let mut pictures = Vec::new();
    for key in report.key_frames.iter().take(MOST) {
        let Some(picture) = spool.picture(key.index)? else {
            continue;
        };
        let height = (WIDTH * picture.height())
            .div_ceil(picture.width().max(1))
            .clamp(1, 640);
        let method = match picture.width() < WIDTH {
            true => Method::Bilinear,
            false => Method::Area,
        };
        pictures.push((key, resize(&picture, WIDTH, height, method)?));
    }
    let picture_height = pictures.first().map_or(0, |(_, picture)| picture.height());
    let columns = pictures.len().clamp(1, COLUMNS);
    let rows = pictures.len().div_ceil(columns);
    let width = SPACE + columns * (WIDTH + SPACE);
    let height = TITLE + rows * (picture_height + CAPTION) + SPACE;
    let mut sheet = RgbImage::from_pixel(width as u32, height as u32, PAPER);
    let heading = format!("{title}: {} key frames", report.key_frames.len());
    let place = [SPACE as u32, 12];
    let room = (width - 2 * SPACE) as u32;
    text::write(&mut sheet, place, room, &heading, Weight::Bold, INK);
    for (position, (key, picture)) in pictures.iter().enumerate() {
        let left = SPACE + position % columns * (WIDTH + SPACE);
        let top = TITLE + position / columns * (picture_height + CAPTION);
        for (row, pixels) in picture.rows().enumerate() {
            for (column, pixel) in pixels.iter().enumerate() {
                sheet.put_pixel((left + column) as u32, (top + row) as u32, Rgb(*pixel));
            }
        }
        let below = (top + picture_height + 4) as u32;
        let first = format!("frame {}, {:.3} s", key.index, key.time);
        let second = format!("{}, score {:.3}", key.reason, key.score);
        let room = WIDTH as u32;
        text::write(
            &mut sheet,
            [left as u32, below],
            room,
            &first,
            Weight::Bold,
            INK,
        );
        let next = below + text::LINE_HEIGHT + 2;
        text::write(
            &mut sheet,
            [left as u32, next],
            room,
            &second,
            Weight::Regular,
            INK,
        );
    }
    let pixels = sheet.into_raw().as_chunks::<3>().0.to_vec();
    Plane::from_values(width, height, pixels).context("cannot make the contact sheet")
}

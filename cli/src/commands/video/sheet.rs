//! Key frames side by side.

use anyhow::Result;
use ga_image::plane::Plane;
use ga_image::resample::{Method, resize};
use ga_render::text::{self, Weight};

use super::report::{KeyFrameReport, Report};
use super::spool::Spool;

const PAPER: [u8; 3] = [250, 250, 252];
const INK: [u8; 3] = [44, 52, 64];

/// Columns of the sheet, the width of a picture, and the space around it.
const COLUMNS: usize = 4;
const WIDTH: usize = 320;
const SPACE: usize = 12;
/// The height of the title, and of the two lines under a picture.
const TITLE: usize = 40;
const CAPTION: usize = 44;
/// More pictures would make a sheet that viewers refuse.
const MOST: usize = 200;

/// The key frames in rows, each with its number, time, reason and score.
pub(super) fn draw(report: &Report, spool: &mut Spool, title: &str) -> Result<Plane<[u8; 3]>> {
    let keys = &report.key_frames[..report.key_frames.len().min(MOST)];
    let mut small = |key: &KeyFrameReport| {
        let picture = spool.picture(key.index)?;
        picture.map(|picture| reduced(&picture)).transpose()
    };
    let first = keys.first().map(&mut small).transpose()?.flatten();
    let picture_height = first.map_or(0, |picture| picture.height());
    let columns = keys.len().clamp(1, COLUMNS);
    let rows = keys.len().div_ceil(columns);
    let width = SPACE + columns * (WIDTH + SPACE);
    let height = TITLE + rows * (picture_height + CAPTION) + SPACE;
    let mut sheet = Plane::filled(width, height, PAPER);
    let heading = format!("{title}: {} key frames", report.key_frames.len());
    let place = [SPACE as u32, 12];
    let room = (width - 2 * SPACE) as u32;
    text::write(&mut sheet, place, room, &heading, Weight::Bold, INK);
    for (position, key) in keys.iter().enumerate() {
        let Some(picture) = small(key)? else {
            continue;
        };
        let left = SPACE + position % columns * (WIDTH + SPACE);
        let top = TITLE + position / columns * (picture_height + CAPTION);
        sheet.view_mut().put(&picture, [left, top]);
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
    Ok(sheet)
}

/// A picture with the width of the sheet's pictures.
fn reduced(picture: &Plane<[u8; 3]>) -> Result<Plane<[u8; 3]>> {
    let height = (WIDTH * picture.height())
        .div_ceil(picture.width().max(1))
        .clamp(1, 640);
    let method = match picture.width() < WIDTH {
        true => Method::Bilinear,
        false => Method::Area,
    };
    Ok(resize(picture, WIDTH, height, method)?)
}

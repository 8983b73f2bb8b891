//! Pictures of the points of boards.

use crate::calibration::SeenPoint;
use crate::found_board::FoundBoard;
use ga_image::plane::Plane;
use ga_image::sample::Sample;

/// The half length of the cross at a corner, in pixels.
const CROSS: isize = 4;
const RED: [u8; 3] = [255, 60, 40];
const GREEN: [u8; 3] = [60, 220, 60];
const BLUE: [u8; 3] = [90, 150, 255];

/// Two views beside each other, with a line between corners that follow each other and a cross at
/// each: red at the first corner, green in the first row, and blue in the others. Where one view is
/// lower, what is below it is black.
pub fn pair_picture<T: Sample>(views: &[Plane<T>; 2], boards: &[FoundBoard; 2]) -> Plane<[u8; 3]> {
    let width = views[0].width();
    let height = views[0].height().max(views[1].height());
    let mut picture = Plane::from_fn(width + views[1].width(), height, |column, row| {
        let value = match column < width {
            true => views[0].get(column, row),
            false => views[1].get(column - width, row),
        };
        [value.map_or(0, |value| u8::from_unit(value.to_unit())); 3]
    });
    for (left, board) in [0, width].into_iter().zip(boards) {
        let points = board.view().points().iter();
        let points: Vec<SeenPoint> = points
            .map(
                |SeenPoint {
                     point,
                     pixel: [u, v],
                 }| SeenPoint {
                    point: *point,
                    pixel: [u + left as f64, *v],
                },
            )
            .collect();
        for pair in points
            .windows(2)
            .filter(|pair| pair[0].point + 1 == pair[1].point)
        {
            line(&mut picture, pair[0].pixel, pair[1].pixel);
        }
        for SeenPoint { point, pixel } in points {
            let colour = match point {
                0 => RED,
                _ if point < board.columns() => GREEN,
                _ => BLUE,
            };
            cross(&mut picture, pixel, colour);
        }
    }
    picture
}

fn cross(picture: &mut Plane<[u8; 3]>, [u, v]: [f64; 2], colour: [u8; 3]) {
    for offset in -CROSS..=CROSS {
        let offset = offset as f64;
        set(picture, [u + offset, v], colour);
        set(picture, [u, v + offset], colour);
    }
}

fn line(picture: &mut Plane<[u8; 3]>, from: [f64; 2], to: [f64; 2]) {
    const YELLOW: [u8; 3] = [230, 200, 60];
    let steps = (to[0] - from[0]).abs().max((to[1] - from[1]).abs()).ceil();
    for step in 0..=steps as usize {
        let part = step as f64 / steps.max(1.0);
        set(
            picture,
            [0, 1].map(|k| from[k] + part * (to[k] - from[k])),
            YELLOW,
        );
    }
}

/// Colours the pixel at a place, where there is one.
fn set(picture: &mut Plane<[u8; 3]>, place: [f64; 2], colour: [u8; 3]) {
    let [column, row] = place.map(|x| x.round());
    let (width, height) = (picture.width() as f64, picture.height() as f64);
    if (0.0..width).contains(&column) && (0.0..height).contains(&row) {
        picture.row_mut(row as usize)[column as usize] = colour;
    }
}

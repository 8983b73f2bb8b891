//! Pictures, cameras and contact sheets.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod buffers;
mod errors;
mod light;
mod materials;
mod models;
mod pictures;
mod pinhole;
mod scenes;
mod sheet;
mod strokes;
mod transparent;
mod view;
mod viewpoint;

use ga_image::plane::Plane;
use ga_render::{Style, View};

const FIELD_OF_VIEW: f64 = 0.8;

fn small() -> Style {
    Style {
        width: 90,
        height: 120,
        ..Style::default()
    }
}

/// From +z, looking at the origin.
fn front(distance: f64) -> View {
    View::look_at(
        [0.0, 0.0, distance],
        [0.0; 3],
        [0.0, 1.0, 0.0],
        FIELD_OF_VIEW,
        0.01,
    )
    .unwrap()
}

/// Reading pixels at places that a picture has.
trait Pixels {
    type Pixel;

    /// The pixel at a column and a row.
    fn pixel(&self, column: u32, row: u32) -> Self::Pixel;
}

impl<T: Copy> Pixels for Plane<T> {
    type Pixel = T;

    fn pixel(&self, column: u32, row: u32) -> T {
        self.get(column as usize, row as usize).unwrap()
    }
}

/// The columns, rows and values of all pixels.
fn enumerated<T: Copy>(plane: &Plane<T>) -> impl Iterator<Item = (u32, u32, T)> {
    let rows = (0..).zip(plane.rows());
    rows.flat_map(|(row, pixels)| {
        (0..)
            .zip(pixels)
            .map(move |(column, pixel)| (column, row, *pixel))
    })
}

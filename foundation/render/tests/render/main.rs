//! Pictures, cameras and contact sheets.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod buffers;
mod camera;
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

use ga_render::{Camera, Style};

const FIELD_OF_VIEW: f64 = 0.8;

fn small() -> Style {
    Style {
        width: 90,
        height: 120,
        ..Style::default()
    }
}

/// From +z, looking at the origin.
fn front(distance: f64) -> Camera {
    Camera::look_at(
        [0.0, 0.0, distance],
        [0.0; 3],
        [0.0, 1.0, 0.0],
        FIELD_OF_VIEW,
        0.01,
    )
    .unwrap()
}

//! The studio in which the films of the demonstration are made: a room, two cameras, a board, and a
//! person with dots on the skin. All of it is known, which is the truth that results are measured
//! by.

mod board;
mod film;
mod room;

use anyhow::{Context as _, Result};
use ga_camera::rig::StereoRig;
use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};

pub(super) use board::{SQUARE, board_pictures};
pub(super) use film::{FRAMES_PER_SECOND, Filmed, Stage};
pub(super) use room::{Disc, Room};

/// Columns and rows of all pictures.
pub(super) const SIZE: [usize; 2] = [960, 720];
/// The focal length in pixels.
pub(super) const FOCAL: f64 = 1000.0;
/// How far the cameras are from each other, in metres.
pub(super) const BASELINE: f64 = 0.18;
/// How far the person is, in metres.
const DISTANCE: f64 = 3.4;
/// The cameras stand at this height and look at the middle of the person.
const HEIGHT: f64 = 1.25;
const MIDDLE: f64 = 0.88;
/// The direction from which they look, from that in which the person walks, in radians.
const AZIMUTH: f64 = 0.4;
/// By how much the right camera is rolled and raised, which viewers of stereoscopic films feel.
const ROLL: f64 = 0.012;
const PITCH: f64 = 0.004;

/// The rig, around a place on the floor, with y up.
pub(super) fn rig(place: Point<f64>) -> Result<StereoRig> {
    let [x, y, z] = place.coordinates();
    let (sin, cos) = AZIMUTH.sin_cos();
    let target = Point::new(x, y + MIDDLE, z);
    let eye = Point::new(x + DISTANCE * sin, y + HEIGHT, z + DISTANCE * cos);
    let principal = SIZE.map(|side| 0.5 * (side as f64 - 1.0));
    let intrinsics = Intrinsics::new([FOCAL; 2], principal)?;
    let middle = Camera::look_at(intrinsics, eye, target, [0.0, 1.0, 0.0]);
    let middle = middle.context("the cameras of the demonstration look along the vertical")?;
    let aside = |metres: f64| Motor::from(Translator::from_displacement([metres, 0.0, 0.0]));
    let rotation = |axis: [f64; 3], angle: f64| {
        Motor::from(Rotor::from_axis_angle(axis, angle).unwrap_or_default())
    };
    let tilt = rotation([0.0, 0.0, 1.0], ROLL) * rotation([1.0, 0.0, 0.0], PITCH);
    let camera = |motion: Motor<f64>| Camera {
        world_to_camera: motion * middle.world_to_camera,
        ..middle
    };
    Ok(StereoRig {
        left: camera(aside(0.5 * BASELINE)),
        right: camera(tilt * aside(-0.5 * BASELINE)),
    })
}

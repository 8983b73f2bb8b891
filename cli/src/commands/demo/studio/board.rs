//! Pictures of a chessboard that somebody holds before both cameras.

use anyhow::{Context as _, Result};
use ga_camera::rig::StereoRig;
use ga_image::plane::Plane;
use ga_render::texture::{Filter, Mipmap, Sampler, Wrap};
use ga_render::{Appearance, Attribute, MaterialChoice, Object, Scene, render};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use rayon::prelude::*;

use super::film::{SENSORS, style, view};
use super::room::Room;

/// How many pairs of pictures there are.
const BOARDS: usize = 10;
/// The sides of squares in metres.
pub(in crate::commands::demo) const SQUARE: f64 = 0.06;
/// Inner corners.
const COLUMNS: usize = 9;
const ROWS: usize = 6;
/// Texels along the side of a square, which makes edges sharp to a tenth of a millimetre.
const TEXELS: usize = 32;
/// The numbers of noise begin behind those of films.
const NOISE: u64 = 1 << 32;

/// The pictures of both cameras.
pub(in crate::commands::demo) fn board_pictures(
    rig: &StereoRig,
    room: &Room,
    seed: u64,
) -> Result<Vec<[Plane<[u8; 3]>; 2]>> {
    // A white border of one square is around the squares.
    let [columns, rows] = [COLUMNS + 3, ROWS + 3];
    let picture = Plane::from_fn(columns * TEXELS, rows * TEXELS, |column, row| {
        let [x, y] = [column / TEXELS, row / TEXELS];
        let is_border = x == 0 || y == 0 || x + 1 == columns || y + 1 == rows;
        let grey: u8 = if is_border || (x + y) % 2 == 1 {
            235
        } else {
            25
        };
        [grey; 3]
    });
    let sampler = Sampler {
        wrap: [Wrap::ClampToEdge; 2],
        filter: Filter::Trilinear,
    };
    let paint = Mipmap::colour(&picture, sampler).context("the board has no picture")?;
    let [x, y] = [columns, rows].map(|count| 0.5 * SQUARE * count as f64);
    let positions = [[-x, -y, 0.0], [x, -y, 0.0], [x, y, 0.0], [-x, y, 0.0]];
    let coordinates = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    let triangles = [[0, 1, 2], [0, 2, 3]];
    let to_world = rig.left.world_to_camera.reverse();
    let pictures = (0..BOARDS).into_par_iter().map(|number| {
        let transform = to_world * pose(number);
        let [walls, disc] = room.materials();
        let board = Appearance {
            base_colour_map: Some(&paint),
            base_colour: [1.0; 3].into(),
            ..walls
        };
        let materials = [walls, disc, board];
        let [first, second] = room.objects(0);
        let scene = Scene {
            objects: vec![
                first,
                second,
                Object {
                    texture_coordinates: Some(Attribute::of_vertices(&coordinates)),
                    material: MaterialChoice::One(2),
                    transform,
                    ..Object::new(&positions, &triangles)
                },
            ],
            materials: &materials,
            ..Scene::default()
        };
        let number = NOISE + 2 * number as u64;
        let draw = |side: usize, camera| {
            let drawn =
                render(&scene, &view(camera)?, &style()).context("a picture of the board")?;
            anyhow::Ok(SENSORS[side].store(&drawn.colour, seed, number + side as u64))
        };
        Ok([draw(0, &rig.left)?, draw(1, &rig.right)?])
    });
    pictures.collect()
}

/// From the board to the frame of the left camera: nearer and farther, in all parts of the picture,
/// tilted to all sides.
fn pose(number: usize) -> Motor<f64> {
    let step = number as f64;
    // The golden angle spreads directions.
    let direction = 2.399_963 * step;
    let (sin, cos) = direction.sin_cos();
    let distance = 1.35 + 0.25 * (step % 4.0);
    let spread = 0.16 * distance * (step / BOARDS as f64).sqrt();
    let place = Point::new(0.12 + 1.2 * spread * cos, spread * sin, distance).coordinates();
    let tilt = 0.35 + 0.2 * (step % 3.0) / 2.0;
    let tilted = Rotor::from_axis_angle([sin, -cos, 0.0], tilt).unwrap_or_default();
    let rolled =
        Rotor::from_axis_angle([0.0, 0.0, 1.0], 0.12 * ((step % 5.0) - 2.0)).unwrap_or_default();
    Translator::from_displacement(place) * Motor::from(tilted * rolled)
}

//! The room: a floor and a wall with a grain that a matcher can follow, and a bright disc on the
//! wall.

use anyhow::{Context as _, Result};
use ga_image::grain::grain;
use ga_image::plane::Plane;
use ga_render::texture::{Mipmap, Sampler};
use ga_render::{Appearance, Attribute, MaterialChoice, Object};
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::Standpoint;

/// How far the wall is from the cameras, in metres. This and all other lengths are those of a
/// studio of the usual size.
const WALL: f64 = 4.4;
/// Half the width of floor and wall, and the height of the wall.
const HALF_WIDTH: f64 = 6.0;
const WALL_HEIGHT: f64 = 4.0;
/// The texture is as large as this, and then repeats.
const GRAIN_METRES: f64 = 12.0;
const GRAIN_SIZE: usize = 2048;
/// The finest grain has this many texels, and each of the coarser layers twice as many.
const FINEST: usize = 2;
const LAYERS: u32 = 6;
/// The grey of walls in sRGB: the mean and how far it goes to both sides.
const GREY: f32 = 118.0;
const CONTRAST: f32 = 196.0;
/// The edge of the disc has so many corners.
const CORNERS: usize = 240;
/// It lies so far before the wall, to be seen.
const BEFORE_WALL: f64 = 0.002;

/// A disc in space.
#[derive(Clone, Copy, Debug)]
pub(in crate::commands::demo) struct Disc {
    pub(in crate::commands::demo) centre: Point<f64>,
    /// In metres.
    pub(in crate::commands::demo) radius: f64,
}

/// The room as triangles.
#[derive(Debug)]
pub(in crate::commands::demo) struct Room {
    positions: Vec<[f64; 3]>,
    coordinates: Vec<[f64; 2]>,
    triangles: Vec<[u32; 3]>,
    disc_positions: Vec<[f64; 3]>,
    disc_triangles: Vec<[u32; 3]>,
    grain: Mipmap,
    pub(in crate::commands::demo) disc: Disc,
}

impl Room {
    /// The room that the cameras look into, whose floor the person stands on.
    pub(in crate::commands::demo) fn new(standpoint: &Standpoint, seed: u64) -> Result<Self> {
        let rig = standpoint.rig()?;
        let floor = standpoint.place.coordinates()[1];
        let [wall, half_width, wall_height, grain] =
            [WALL, HALF_WIDTH, WALL_HEIGHT, GRAIN_METRES].map(|length| length * standpoint.scale);
        let eye = Vector::from(rig.left.centre());
        let back = rig.left.world_to_camera.reverse();
        let ahead = Vector::from(back.transform(Point::new(0.0, 0.0, 1.0))) - eye;
        let ahead = Vector::new(ahead.e1, 0.0, ahead.e3);
        let ahead = ahead * ahead.length().recip();
        // y up: the right of who looks ahead.
        let right = Vector::new(-ahead.e3, 0.0, ahead.e1);
        let foot = Vector::new(eye.e1, floor, eye.e3) + ahead * wall;
        let place = |across: f64, up: f64, before: f64| {
            (foot + right * across + Vector::Y * up - ahead * before).coordinates()
        };
        let corners = [[-1.0, 0.0], [1.0, 0.0], [1.0, 1.0], [-1.0, 1.0]];
        let upright = corners.map(|[x, y]| place(half_width * x, wall_height * y, 0.0));
        let near = corners.map(|[x, y]| place(half_width * x, 0.0, wall * (1.0 - y)));
        let at = |[x, y]: [f64; 2], height: f64, offset: f64| {
            [offset + half_width * x, height * y].map(|metres| metres / grain)
        };
        let coordinates = corners.map(|corner| at(corner, wall_height, 0.0));
        let of_floor = corners.map(|corner| at(corner, wall, 1.3 * standpoint.scale));
        let quads = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];

        let [across, radius] = [-1.15, 0.22].map(|length| length * standpoint.scale);
        let up = standpoint.height(1.75);
        let disc = Disc {
            centre: Point::from(place(across, up, BEFORE_WALL)),
            radius,
        };
        let rim = (0..CORNERS).map(|corner| {
            let (sin, cos) = (std::f64::consts::TAU * corner as f64 / CORNERS as f64).sin_cos();
            place(across + radius * cos, up + radius * sin, BEFORE_WALL)
        });
        let count = CORNERS as u32;
        Ok(Self {
            positions: [upright, near].concat(),
            coordinates: [coordinates, of_floor].concat(),
            triangles: quads.to_vec(),
            disc_positions: rim.collect(),
            disc_triangles: (1..count - 1).map(|k| [0, k, k + 1]).collect(),
            grain: Mipmap::colour(&painted(seed), Sampler::default())
                .context("the wall of the demonstration has no texture")?,
            disc,
        })
    }

    /// The materials: that of walls, and that of the disc.
    pub(in crate::commands::demo) fn materials(&self) -> [Appearance<'_>; 2] {
        let matt = Appearance {
            reflectance: 0.0,
            roughness: 1.0,
            double_sided: true,
            unlit: true,
            ..Appearance::default()
        };
        [
            Appearance {
                base_colour_map: Some(&self.grain),
                base_colour: [1.0; 3].into(),
                ..matt
            },
            Appearance {
                base_colour: [0.95; 3].into(),
                ..matt
            },
        ]
    }

    /// What is in the room, with [`materials`](Self::materials) from a number on.
    pub(in crate::commands::demo) fn objects(&self, first: u32) -> [Object<'_>; 2] {
        [
            Object {
                texture_coordinates: Some(Attribute::of_vertices(&self.coordinates)),
                material: MaterialChoice::One(first),
                ..Object::new(&self.positions, &self.triangles)
            },
            Object {
                material: MaterialChoice::One(first + 1),
                ..Object::new(&self.disc_positions, &self.disc_triangles)
            },
        ]
    }
}

/// The grain as a picture.
fn painted(seed: u64) -> Plane<[u8; 3]> {
    grain(GRAIN_SIZE, FINEST, LAYERS, seed).map(|value| {
        let grey = GREY + CONTRAST * (2.0 * value - 1.0);
        [grey.round().clamp(20.0, 215.0) as u8; 3]
    })
}

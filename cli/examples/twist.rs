//! The candy-wrapper test of skinning: a cylinder with two joints, of which the upper one is
//! rotated about the axis. Linear blend of matrices above, blend of motors below, at 0°, 60°, 120°
//! and 180°.
//!
//! `cargo run --release -p nullcone --example twist -- docs/pictures/twist.png`

use std::error::Error;
use std::f64::consts::{PI, TAU};

use ga_anim::pose::Pose;
use ga_anim::skeleton::{Joint, Skeleton};
use ga_anim::skin::{self, Method};
use ga_anim::weights::SkinWeights;
use ga_image::plane::Plane;
use ga_image::png;
use ga_render::texture::{Mipmap, Sampler};
use ga_render::{
    Appearance, Attribute, MaterialChoice, Object, Scene, Style, View, ViewDirection, render,
};
use ga_runtime::cga3::{Motor, Point, Rotor};

/// The angles of the upper joint.
const ANGLES: [f64; 4] = [0.0, PI / 3.0, 2.0 * PI / 3.0, PI];

/// Radius and height of the cylinder, whose axis is y, and the lengths between columns and rows.
const RADIUS: f64 = 0.4;
const HEIGHT: f64 = 3.0;
const ACROSS: f64 = 1.35;
const DOWN: f64 = 3.6;

/// Faces around the cylinder and along it.
const AROUND: u32 = 96;
const ALONG: u32 = 120;

fn main() -> Result<(), Box<dyn Error>> {
    let out = std::env::args_os().nth(1).ok_or("no picture is named")?;
    let cylinder = Cylinder::new();
    let joint = |name: &str, parent, from: f64, to: f64| Joint {
        name: name.into(),
        parent,
        head: [0.0, from, 0.0],
        tail: [0.0, to, 0.0],
    };
    let skeleton = Skeleton::new(vec![
        joint("lower", None, 0.0, HEIGHT / 2.0),
        joint("upper", Some(0), HEIGHT / 2.0, HEIGHT),
    ])?;
    let weights = SkinWeights::new(2, cylinder.positions.iter().map(|p| influences(*p)))?;

    let mut meshes = Vec::new();
    for (row, method) in [Method::Linear, Method::Motor].into_iter().enumerate() {
        for (column, &angle) in ANGLES.iter().enumerate() {
            let rotor = Rotor::from_axis_angle([0.0, 1.0, 0.0], angle).ok_or("no axis")?;
            let pose = Pose::from_rotors(&skeleton, Motor::default(), &[Rotor::default(), rotor])?;
            let motions = pose.motions(&skeleton)?;
            let moved = skin::skin(&cylinder.positions, &weights, &motions, method)?;
            let offset = [ACROSS * column as f64, -DOWN * row as f64, 0.0];
            let place = |p: &Point<f64>| {
                let c = p.coordinates();
                [0, 1, 2].map(|axis| c[axis] + offset[axis])
            };
            meshes.push(moved.iter().map(place).collect::<Vec<[f64; 3]>>());
        }
    }
    png::write(out, &picture(&cylinder, &meshes)?)?;
    Ok(())
}

/// The share of the upper joint rises linearly along the middle three quarters of the cylinder.
fn influences(position: Point<f64>) -> Vec<(u32, f64)> {
    let [_, y, _] = position.coordinates();
    let share = ((y / HEIGHT - 0.125) / 0.75).clamp(0.0, 1.0);
    let both = [(0, 1.0 - share), (1, share)];
    both.into_iter()
        .filter(|&(_, weight)| weight > 0.0)
        .collect()
}

struct Cylinder {
    positions: Vec<Point<f64>>,
    coordinates: Vec<[f64; 2]>,
    triangles: Vec<[u32; 3]>,
}

impl Cylinder {
    /// Open at both ends; its first and its last column of vertices coincide.
    fn new() -> Self {
        let (mut positions, mut coordinates, mut triangles) = (vec![], vec![], vec![]);
        for row in 0..=ALONG {
            for column in 0..=AROUND {
                let [u, v] = [
                    f64::from(column) / f64::from(AROUND),
                    f64::from(row) / f64::from(ALONG),
                ];
                let (sine, cosine) = (TAU * u).sin_cos();
                positions.push(Point::new(RADIUS * sine, HEIGHT * v, RADIUS * cosine));
                coordinates.push([u, v]);
            }
        }
        for row in 0..ALONG {
            for column in 0..AROUND {
                let a = row * (AROUND + 1) + column;
                let (b, c, d) = (a + 1, a + AROUND + 2, a + AROUND + 1);
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        Self {
            positions,
            coordinates,
            triangles,
        }
    }
}

fn picture(
    cylinder: &Cylinder,
    meshes: &[Vec<[f64; 3]>],
) -> Result<Plane<[u8; 3]>, Box<dyn Error>> {
    // Eight stripes along the axis, and rings.
    let stripes = Plane::from_fn(512, 512, |column, row| {
        let (stripe, ring) = (column / 32 % 2, row % 64 < 4);
        match (stripe, ring) {
            (_, true) => [70u8, 70, 80],
            (0, _) => [214, 92, 52],
            _ => [240, 226, 200],
        }
    });
    let stripes = Mipmap::colour(&stripes, Sampler::default())?;
    let materials = [Appearance {
        base_colour_map: Some(&stripes),
        roughness: 0.7,
        ..Appearance::default()
    }];
    let objects = meshes.iter().map(|positions| Object {
        texture_coordinates: Some(Attribute::of_vertices(&cylinder.coordinates)),
        material: MaterialChoice::One(0),
        ..Object::new(positions, &cylinder.triangles)
    });
    let scene = Scene {
        objects: objects.collect(),
        materials: &materials,
        ..Scene::default()
    };
    let style = Style {
        width: 720,
        height: 900,
        supersampling: 4,
        self_shadow: 0.0,
        ambient_occlusion: 0.5,
        depth_contrast: 0.0,
        ..Style::default()
    };
    let view = ViewDirection {
        azimuth: 0.0,
        elevation: 0.12,
    };
    let points = meshes.iter().flatten().copied();
    let camera = View::fit(points, view, 0.2, style.aspect(), 0.06)?;
    Ok(render(&scene, &camera, &style)?.colour)
}

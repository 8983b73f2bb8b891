//! Draws the person at rest, with its painted skin and without: from the front, from the side, the
//! face and a hand.
//!
//! `cargo run --release -p ga-mannequin --example portrait -- FOLDER`

use std::error::Error;
use std::path::PathBuf;

use ga_image::colour::LinearColour;
use ga_image::png;
use ga_mannequin::Human;
use ga_render::texture::{Mipmap, Sampler};
use ga_render::{
    Appearance, Attribute, Ground, MaterialChoice, Object, Scene, Style, View, render,
};

/// Name, position of the camera, what it looks at, vertical field of view in radians, size.
type Portrait = (&'static str, [f64; 3], [f64; 3], f64, [u32; 2]);

const PORTRAITS: [Portrait; 5] = [
    ("front", [0.0, 1.1, 5.0], [0.0, 0.87, 0.0], 0.40, [420, 620]),
    ("side", [5.0, 1.1, 0.3], [0.0, 0.87, 0.0], 0.40, [420, 620]),
    (
        "face",
        [0.12, 1.66, 1.2],
        [0.0, 1.63, 0.0],
        0.26,
        [520, 520],
    ),
    (
        "profile",
        [1.1, 1.65, 0.5],
        [0.0, 1.63, 0.0],
        0.26,
        [520, 520],
    ),
    (
        "hand",
        [0.9, 0.95, 0.7],
        [0.62, 0.90, 0.0],
        0.30,
        [520, 520],
    ),
];

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os()
        .nth(1)
        .map_or("out".into(), PathBuf::from);
    let human = Human::new();
    let texture = human.texture(1024);
    png::write(folder.join("texture.png"), &texture)?;

    let positions: Vec<[f64; 3]> = human.mesh.coordinates().collect();
    let triangles = human.mesh.triangles();
    let coordinates = human.mesh.texture_coordinates().ok_or("no coordinates")?;
    let corners: Vec<Option<[u32; 3]>> = coordinates
        .corners
        .chunks_exact(3)
        .map(|corners| Some([corners[0]?, corners[1]?, corners[2]?]))
        .collect();
    let map = Mipmap::colour(&texture, Sampler::default())?;
    let painted = Appearance {
        base_colour: LinearColour::WHITE,
        base_colour_map: Some(&map),
        roughness: 0.8,
        ..Appearance::default()
    };
    for (suffix, material) in [
        ("", MaterialChoice::One(0)),
        ("-plain", MaterialChoice::Style),
    ] {
        let object = Object {
            texture_coordinates: Some(Attribute::of_corners(&coordinates.values, &corners)),
            material,
            ..Object::new(&positions, &triangles)
        };
        let scene = Scene {
            objects: vec![object],
            materials: &[painted],
            ground: Some(Ground {
                height: 0.0,
                grid: 0.5,
            }),
            ..Scene::default()
        };
        for (name, eye, target, field, [width, height]) in PORTRAITS {
            let camera = View::look_at(eye, target, [0.0, 1.0, 0.0], field, 0.1)?;
            let style = Style {
                width,
                height,
                ..Style::default()
            };
            let picture = render(&scene, &camera, &style)?;
            png::write(folder.join(format!("{name}{suffix}.png")), &picture.colour)?;
        }
    }
    Ok(())
}

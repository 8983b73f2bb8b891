//! Figures in motion: the moments that are shown, what is drawn over them, what two cameras find,
//! and the files of a model.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod animated_scene;
mod figure;
mod gltf;
mod model;
mod overlay;
mod pictures;
mod read;
mod report;
mod storyboard;
mod two_views;

use ga_anim::character::Character;
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_anim::skeleton::{Joint, Skeleton};
use ga_anim::weights::SkinWeights;
use ga_character::Figure;
use ga_image::plane::Plane;
use ga_mesh::{Faces, Mesh, TextureCoordinates};
use ga_runtime::cga3::{Motor, Translator};

/// A square in the plane z = 0 of two triangles, from (−1, 0) to (1, 2), whose lower corners move
/// with the joint `below` at the origin and whose upper ones with `above` at the height 1.
fn character() -> Character {
    let corners = vec![
        [-1.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 2.0, 0.0],
        [-1.0, 2.0, 0.0],
    ];
    let faces = Faces::from_uniform(vec![[0, 1, 2], [0, 2, 3]]).unwrap();
    let joint = |name: &str, parent, height: f64| Joint {
        name: name.to_owned(),
        parent,
        head: [0.0, height, 0.0],
        tail: [0.0, height + 1.0, 0.0],
    };
    let joints = vec![joint("below", None, 0.0), joint("above", Some(0), 1.0)];
    let weights = [[(0, 1.0)], [(0, 1.0)], [(1, 1.0)], [(1, 1.0)]];
    Character {
        mesh: Mesh::new(corners, faces).unwrap(),
        skeleton: Skeleton::new(joints).unwrap(),
        weights: SkinWeights::new(2, weights).unwrap(),
    }
}

/// The square with texture coordinates and a picture of two pixels. The triangles do not share
/// texture coordinates, so that the corners 0 and 2 are there twice in glTF.
fn painted() -> Figure {
    let mut character = character();
    let coordinates = TextureCoordinates {
        values: vec![
            [0.0, 0.0],
            [1.0, 0.0],
            [1.0, 1.0],
            [0.25, 0.0],
            [0.75, 1.0],
            [0.25, 0.5],
        ],
        corners: (0..6).map(Some).collect(),
    };
    character.mesh = character
        .mesh
        .with_texture_coordinates(vec![coordinates])
        .unwrap();
    let mut figure = Figure::new("square", character);
    figure.paint = Plane::from_values(2, 1, vec![[255, 0, 0], [0, 0, 255]]).ok();
    figure
}

fn moved(displacement: [f64; 3]) -> Motor<f64> {
    Motor::from(Translator::from_displacement(displacement))
}

/// The whole figure at each of these places, in frames that are this many seconds apart.
fn journey(frame_time: f64, places: &[[f64; 3]]) -> Clip {
    let poses = places.iter().map(|&place| Pose {
        root: moved(place),
        ..Pose::rest(2)
    });
    Clip::new(frame_time, poses.collect()).unwrap()
}

fn assert_near(found: [f64; 3], expected: [f64; 3], tolerance: f64) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance, "{found} {expected}");
    }
}

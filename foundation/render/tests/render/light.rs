//! Shadows and occlusion, against what geometry says.

use crate::{Pixels, enumerated};
use ga_image::colour::LinearColour;
use ga_image::plane::Plane;
use ga_render::texture::{Filter, Mipmap, Sampler, Wrap};
use ga_render::{
    Appearance, Attribute, Ground, MaterialChoice, Object, Scene, Style, View, render,
};

use crate::pictures::sphere;
use crate::scenes::{CORNERS, UNIT_SQUARE, code, one_light, square};

fn above(height: f64, distance: f64) -> View {
    let eye = [0.0, height, distance];
    View::look_at(eye, [0.0; 3], [0.0, 1.0, 0.0], 0.5, 0.1).unwrap()
}

/// A horizontal square of half side `half` at this height.
fn plate(half: f64, height: f64) -> [[f64; 3]; 4] {
    square(0.0).map(|[x, y, _]| [half * x, height, -half * y])
}

#[test]
fn a_plate_shadows_the_floor_below_it() {
    let (floor, plate) = (plate(4.0, 0.0), plate(0.5, 1.0));
    let scene = Scene {
        objects: vec![
            Object::new(&floor, &UNIT_SQUARE),
            Object::new(&plate, &UNIT_SQUARE),
        ],
        ..Scene::default()
    };
    // From the right: the shadow moves left by the height.
    let style = Style {
        self_shadow: 1.0,
        surface: LinearColour::WHITE,
        ..one_light(300, [1.0, 1.0, 0.0], LinearColour::WHITE)
    };
    let camera = above(9.0, 9.0);
    let picture = render(&scene, &camera, &style).unwrap().colour;
    let at = |x: f64, z: f64| {
        let [column, row, _] = camera.project([x, 0.0, z], 300, 300).unwrap();
        picture.pixel(column as u32, row as u32)[0]
    };
    // The light falls at 45°.
    let lit = code(0.5f64.sqrt()).round() as u8;
    for [x, z] in [[-1.0, 0.0], [-1.45, 0.45], [-0.55, -0.45], [-1.45, -0.45]] {
        assert_eq!(at(x, z), 0, "({x}, {z})");
    }
    for [x, z] in [
        [-1.55, 0.0],
        [-1.0, 0.55],
        [-0.9, 0.6],
        [1.5, 1.0],
        [-3.0, -1.0],
    ] {
        assert_eq!(at(x, z), lit, "({x}, {z})");
    }
    let half = Style {
        self_shadow: 0.5,
        ..style
    };
    let picture = render(&scene, &camera, &half).unwrap().colour;
    let [column, row, _] = camera.project([-1.0, 0.0, 0.0], 300, 300).unwrap();
    let lit = code(0.5 * 0.5f64.sqrt()).round() as u8;
    assert_eq!(picture.pixel(column as u32, row as u32)[0], lit);
}

/// The plate covers x from −0.5 to 0.5; its left half is cut out. The light falls from the right at
/// 45°, so that the shadow is that of the right half, moved left by the height 1.
#[test]
fn parts_that_are_cut_out_cast_no_shadow() {
    let (floor, plate) = (plate(4.0, 0.0), plate(0.5, 1.0));
    let halves = Plane::from_fn(2, 1, |column, _| [255u8, 255, 255, [0, 255][column]]);
    let sampler = Sampler {
        wrap: [Wrap::ClampToEdge; 2],
        filter: Filter::Nearest,
    };
    let halves = Mipmap::colour(&halves, sampler).unwrap();
    let materials = [Appearance {
        base_colour_map: Some(&halves),
        cutoff: Some(0.5),
        ..Appearance::default()
    }];
    let plate = Object {
        texture_coordinates: Some(Attribute::of_vertices(&CORNERS)),
        material: MaterialChoice::One(0),
        ..Object::new(&plate, &UNIT_SQUARE)
    };
    let on_floor = Scene {
        objects: vec![Object::new(&floor, &UNIT_SQUARE), plate.clone()],
        materials: &materials,
        ..Scene::default()
    };
    let on_ground = Scene {
        objects: vec![plate],
        materials: &materials,
        ground: Some(Ground {
            height: 0.0,
            grid: 100.0,
        }),
        ..Scene::default()
    };
    let style = Style {
        self_shadow: 1.0,
        shadow: 1.0,
        occlusion: 0.0,
        surface: LinearColour::WHITE,
        ground: LinearColour::WHITE,
        ..one_light(300, [1.0, 1.0, 0.0], LinearColour::WHITE)
    };
    let camera = above(9.0, 9.0);
    for scene in [on_floor, on_ground] {
        let picture = render(&scene, &camera, &style).unwrap().colour;
        let at = |x: f64| {
            let [column, row, _] = camera.project([x, 0.0, 0.2], 300, 300).unwrap();
            picture.pixel(column as u32, row as u32)[0]
        };
        // As far to the right there is no shadow.
        let (dark, cut, lit) = (at(-0.75), at(-1.25), at(1.25));
        assert!(cut.abs_diff(lit) <= 2, "{dark} {cut} {lit}");
        assert!(lit > 150 && dark < lit - 80, "{dark} {cut} {lit}");
    }
}

#[test]
fn a_convex_body_has_no_shadow_on_its_lit_side() {
    let (positions, triangles) = sphere(1.0, [0.0; 3]);
    let scene = Scene::new(&positions, &triangles);
    let light = [0.6, 0.64, 0.48];
    let with = |self_shadow| {
        let style = Style {
            self_shadow,
            ..one_light(200, light, LinearColour::WHITE)
        };
        render(&scene, &above(0.0, 5.0), &style).unwrap()
    };
    let (plain, shadowed) = (with(0.0), with(1.0));
    let mut lit = 0;
    for (column, row, pixel) in enumerated(&plain.colour) {
        let Some(depth) = plain.depth.get(column, row) else {
            continue;
        };
        let slope = 0.25f64.tan() / 100.0 * depth;
        let normal = [
            (f64::from(column) - 99.5) * slope,
            (99.5 - f64::from(row)) * slope,
            5.0 - depth,
        ];
        let facing: f64 = (0..3).map(|i| normal[i] * light[i]).sum();
        if facing > 0.15 {
            assert_eq!(pixel, shadowed.colour.pixel(column, row), "{normal:?}");
            lit += 1;
        }
    }
    assert!(lit > 2_000, "{lit}");
}

/// Above a floor, directions that obey the cosine law lie over a uniform disc, so the share of them
/// with more than `x` towards a wall is that of a segment of the disc,
/// `(acos x − x √(1 − x²)) / π`. A point in such a direction at a distance from 0 to the radius,
/// all alike, is behind the wall if it goes farther than the wall is away.
fn free(from_wall: f64, radius: f64) -> f64 {
    let steps = 4000;
    let blocked: f64 = (0..steps)
        .map(|step| {
            let distance = radius * (f64::from(step) + 0.5) / f64::from(steps);
            let x = (from_wall / distance).min(1.0);
            (x.acos() - x * (1.0 - x * x).sqrt()) / std::f64::consts::PI
        })
        .sum();
    1.0 - blocked / f64::from(steps)
}

/// Beside a wall, a part of the sky is hidden, half of it in the corner; on a plane, nothing is.
#[test]
fn walls_keep_light_from_all_around_away() {
    let floor = plate(4.0, 0.0);
    let wall = square(0.0).map(|[x, y, _]| [4.0 * x, 4.0 + 4.0 * y, 0.0]);
    let mut style = one_light(500, [0.0, 1.0, 0.0], LinearColour::BLACK);
    style.surface = LinearColour::WHITE;
    style.lighting.sky = LinearColour::WHITE * 0.5;
    style.lighting.bounce = LinearColour::WHITE * 0.5;
    style.ambient_occlusion = 1.0;
    let camera = above(7.0, 7.0);
    let scene = Scene {
        objects: vec![
            Object::new(&floor, &UNIT_SQUARE),
            Object::new(&wall, &UNIT_SQUARE),
        ],
        ..Scene::default()
    };
    let picture = render(&scene, &camera, &style).unwrap().colour;
    let at = |place: fn(f64, f64) -> [f64; 3], away: f64| {
        let lights = (-20..20).map(|step| {
            let point = place(f64::from(step) * 0.05, away);
            let [column, row, _] = camera.project(point, 500, 500).unwrap();
            let code = picture.pixel(column as u32, row as u32);
            // The share of 0.5.
            LinearColour::from_srgb([code[0]; 3]).red / 0.5
        });
        lights.sum::<f64>() / 40.0
    };
    // The diagonal of a box of 8 × 8 × 8.
    let radius = 0.06 * 192f64.sqrt();
    assert!((free(1e-9, radius) - 0.5).abs() < 1e-6);
    for away in [0.05, 0.1, 0.2, 0.4, 0.6, 0.9, 1.5] {
        let expected = free(away, radius);
        for place in [|x, away| [x, 0.0, away], |x, away| [x, away, 0.0]] {
            let found = at(place, away);
            assert!(
                (found - expected).abs() < 0.04,
                "{away}: {found} {expected}"
            );
        }
    }
}

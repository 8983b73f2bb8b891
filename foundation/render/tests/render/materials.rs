//! Textures, normal maps and reflection, against colours worked out by hand.

use crate::{Pixels, enumerated};
use ga_image::colour::LinearColour;
use ga_image::plane::Plane;
use ga_render::texture::{Filter, Mipmap, Sampler, TextureError, Wrap};
use ga_render::{
    Appearance, Attribute, Light, Lighting, MaterialChoice, Normals, Object, Scene, Shading, Style,
    View, render,
};
use ga_runtime::cga3::{Motor, Rotor};
use proptest::prelude::*;

use crate::scenes::{CORNERS, UNIT_SQUARE, code, one_light, square};

/// Sees exactly the square from (−1, −1) to (1, 1) at height 0, facing it.
fn straight() -> View {
    let angle = 2.0 * (1f64 / 20.0).atan();
    View::look_at([0.0, 0.0, 20.0], [0.0; 3], [0.0, 1.0, 0.0], angle, 1.0).unwrap()
}

fn sampler(filter: Filter, wrap: Wrap) -> Sampler {
    Sampler {
        wrap: [wrap; 2],
        filter,
    }
}

/// Red counts columns and green rows from the top, in steps of 16.
fn numbered(size: u32) -> Plane<[u8; 4]> {
    Plane::from_fn(size as usize, size as usize, |column, row| {
        [16 * column as u8, 16 * row as u8, 77, 255]
    })
}

fn unlit(style: Style) -> Style {
    Style {
        shading: Shading::Unlit,
        ..style
    }
}

fn painted<'a>(
    positions: &'a [[f64; 3]],
    coordinates: &'a [[f64; 2]],
    materials: &'a [Appearance<'a>],
) -> Scene<'a> {
    let object = Object {
        texture_coordinates: Some(Attribute::of_vertices(coordinates)),
        material: MaterialChoice::One(0),
        ..Object::new(positions, &UNIT_SQUARE)
    };
    Scene {
        objects: vec![object],
        materials,
        ..Scene::default()
    }
}

fn style(size: u32) -> Style {
    one_light(size, [0.0, 0.001, 1.0], LinearColour::WHITE)
}

#[test]
fn each_pixel_shows_the_texel_under_it() {
    for filter in [Filter::Nearest, Filter::Bilinear, Filter::Trilinear] {
        let texture = Mipmap::colour(&numbered(8), sampler(filter, Wrap::Repeat)).unwrap();
        let materials = [Appearance {
            base_colour_map: Some(&texture),
            ..Appearance::default()
        }];
        let positions = square(0.0);
        let scene = painted(&positions, &CORNERS, &materials);
        let picture = render(&scene, &straight(), &unlit(style(8)))
            .unwrap()
            .colour;
        for (column, row, pixel) in enumerated(&picture) {
            let expected = [16 * column as u8, 16 * row as u8, 77];
            assert_eq!(pixel, expected, "{filter:?} ({column}, {row})");
        }
    }
}

#[test]
fn textures_go_on_beyond_their_edges() {
    let wide = CORNERS.map(|[u, v]| [3.0 * u - 1.0, 3.0 * v - 1.0]);
    let texel = |wrap, place: i32| match wrap {
        Wrap::Repeat => place.rem_euclid(4),
        Wrap::MirroredRepeat => [3, 2, 1, 0, 0, 1, 2, 3, 3, 2, 1, 0][(place + 4) as usize],
        Wrap::ClampToEdge => place.clamp(0, 3),
    };
    for wrap in [Wrap::Repeat, Wrap::MirroredRepeat, Wrap::ClampToEdge] {
        for filter in [Filter::Nearest, Filter::Bilinear] {
            let texture = Mipmap::colour(&numbered(4), sampler(filter, wrap)).unwrap();
            let materials = [Appearance {
                base_colour_map: Some(&texture),
                ..Appearance::default()
            }];
            let positions = square(0.0);
            let scene = painted(&positions, &wide, &materials);
            let picture = render(&scene, &straight(), &unlit(style(12)))
                .unwrap()
                .colour;
            for (column, row, pixel) in enumerated(&picture) {
                let [i, j] = [column, row].map(|place| texel(wrap, place as i32 - 4));
                let expected = [16 * i as u8, 16 * j as u8, 77];
                assert_eq!(pixel, expected, "{wrap:?} {filter:?} ({column}, {row})");
            }
        }
    }
}

#[test]
fn a_checkerboard_far_away_is_half_bright() {
    let board = Plane::from_fn(256, 256, |column, row| {
        [[0u8, 0, 0, 255], [255; 4]][(column + row) % 2]
    });
    let texture = Mipmap::colour(&board, Sampler::default()).unwrap();
    let materials = [Appearance {
        base_colour_map: Some(&texture),
        ..Appearance::default()
    }];
    let positions = square(0.0);
    let scene = painted(&positions, &CORNERS, &materials);
    let picture = render(&scene, &straight(), &unlit(style(16)))
        .unwrap()
        .colour;
    // Sixteen texels to a pixel: half the light is sRGB code 188.
    assert!(picture.values().iter().all(|pixel| *pixel == [188; 3]));
}

proptest! {
    /// Between the middles of texels, a texture is the bilinear function through them.
    #[test]
    fn bilinear_textures_are_bilinear(u in 0.13f64..0.87, v in 0.13f64..0.87) {
        let pixels: Vec<[f64; 4]> = (0..16)
            .map(|i| [f64::from(i % 4) / 4.0, f64::from(i / 4) / 8.0, f64::from((i % 4) * (i / 4)) / 16.0, 1.0])
            .collect();
        let texture = Mipmap::numbers(4, 4, &pixels, sampler(Filter::Bilinear, Wrap::ClampToEdge)).unwrap();
        // Column and row, counted from the middle of the first texel.
        let (x, y) = (4.0 * u - 0.5, 4.0 * (1.0 - v) - 0.5);
        let expected = [x / 4.0, y / 8.0, x * y / 16.0, 1.0];
        for (found, expected) in texture.at([u, v], 1.0).into_iter().zip(expected) {
            prop_assert!((found - expected).abs() < 2e-5);
        }
        prop_assert_eq!(texture.at([u + 5.0, v - 3.0], 1.0), texture.at([1.0, 0.0], 1.0));
    }
}

#[test]
fn textures_need_pixels() {
    let sampler = Sampler::default();
    assert!(matches!(
        Mipmap::colour(&Plane::filled(0, 3, [0u8; 4]), sampler),
        Err(TextureError::Empty {
            width: 0,
            height: 3
        })
    ));
    assert!(matches!(
        Mipmap::numbers(2, 2, &[[0.0; 4]; 3], sampler),
        Err(TextureError::Length {
            width: 2,
            height: 2,
            found: 3
        })
    ));
}

/// The middle pixel of a picture.
fn middle(scene: &Scene, camera: &View, style: &Style) -> [u8; 3] {
    let picture = render(scene, camera, style).unwrap().colour;
    picture.pixel(style.width / 2, style.height / 2)
}

#[test]
fn a_lit_surface_follows_lambert() {
    let direction = [0.3, 0.7, 0.5];
    let length = direction.iter().map(|c: &f64| c * c).sum::<f64>().sqrt();
    let mut style = one_light(9, direction, LinearColour::new(0.9, 0.7, 0.5));
    style.lighting.sky = LinearColour::new(0.1, 0.2, 0.3);
    style.lighting.bounce = LinearColour::new(0.3, 0.2, 0.1);
    style.surface = LinearColour::new(0.6, 0.5, 0.4);
    for angle in [-1.1f64, -0.4, 0.0, 0.5, 1.2] {
        let positions = square(0.0);
        let object = Object {
            transform: Motor::from(Rotor::from_axis_angle([1.0, 0.0, 0.0], angle).unwrap()),
            ..Object::new(&positions, &UNIT_SQUARE)
        };
        let scene = Scene {
            objects: vec![object],
            ..Scene::default()
        };
        let normal = [0.0, -angle.sin(), angle.cos()];
        let facing = (normal[1] * direction[1] + normal[2] * direction[2]) / length;
        let sky = 0.5 + 0.5 * normal[1];
        let light = |key: f64, above: f64, below: f64| {
            key * facing.max(0.0) + above * sky + below * (1.0 - sky)
        };
        let expected = [
            code(0.6 * light(0.9, 0.1, 0.3)),
            code(0.5 * light(0.7, 0.2, 0.2)),
            code(0.4 * light(0.5, 0.3, 0.1)),
        ];
        let found = middle(&scene, &straight(), &style);
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                (f64::from(found) - expected).abs() < 0.51,
                "{angle}: {found} {expected}"
            );
        }
    }
}

/// Light, view and normal along one line: D = 1/(π α²), V = ¼ and F = F₀.
#[test]
fn highlights_have_the_height_of_the_formula() {
    let positions = square(0.0);
    for (metallic, roughness, reflectance) in [(0.0, 0.7, 0.04), (1.0, 0.8, 0.0), (0.5, 1.0, 0.1)] {
        let base = 0.3;
        let materials = [Appearance {
            base_colour: LinearColour::WHITE * base,
            metallic,
            roughness,
            reflectance,
            ..Appearance::default()
        }];
        let scene = painted(&positions, &CORNERS, &materials);
        // Along the viewing direction, but for what keeps the light above the horizon.
        let style = one_light(9, [0.0, 1e-6, 1.0], LinearColour::WHITE);
        let straight_on = (1.0 - metallic) * reflectance + metallic * base;
        let expected = (1.0 - metallic) * base + straight_on / (4.0 * f64::powi(roughness, 4));
        let found = f64::from(middle(&scene, &straight(), &style)[0]);
        assert!(
            (found - code(expected)).abs() < 0.6,
            "{found} {}",
            code(expected)
        );
    }
}

/// With light from all around and a white surface, as much comes back.
#[test]
fn a_metal_mirrors_its_surroundings() {
    let positions = square(0.0);
    let materials = [Appearance {
        base_colour: LinearColour::new(0.9, 0.6, 0.3),
        metallic: 1.0,
        roughness: 0.0,
        emission: LinearColour::new(0.0, 0.0, 0.2),
        ..Appearance::default()
    }];
    let mut style = one_light(9, [0.0, 1.0, 0.0], LinearColour::BLACK);
    style.lighting.sky = LinearColour::WHITE * 0.5;
    style.lighting.bounce = LinearColour::WHITE * 0.5;
    let scene = painted(&positions, &CORNERS, &materials);
    let found = middle(&scene, &straight(), &style).map(f64::from);
    let expected = [code(0.45), code(0.3), code(0.35)];
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() < 0.6, "{found} {expected}");
    }
}

/// The normal (x, y, z) as a texture of one pixel.
fn normals(normal: [f64; 3]) -> Mipmap {
    let [x, y, z] = normal.map(|c| (c + 1.0) / 2.0);
    Mipmap::numbers(1, 1, &[[x, y, z, 1.0]], Sampler::default()).unwrap()
}

#[test]
fn a_normal_map_shades_as_a_tilted_plane() {
    let style = Style {
        gloss: 0.04,
        ..one_light(33, [0.5, 0.6, 0.8], LinearColour::WHITE)
    };
    let positions = square(0.0);
    let tangents = [[1.0, 0.0, 0.0, 1.0]; 4];
    for (axis, angle) in [
        ([0.0, 1.0, 0.0], 0.5),
        ([1.0, 0.0, 0.0], -0.4),
        ([1.0, 1.0, 0.0], 0.6),
    ] {
        let rotor = Rotor::from_axis_angle(axis, angle).unwrap();
        let mut plain = Object::new(&positions, &UNIT_SQUARE);
        plain.transform = rotor.into();
        let tilted = Scene {
            objects: vec![plain],
            ..Scene::default()
        };
        let expected = middle(&tilted, &straight(), &style);

        let normal = rotor.to_matrix().map(|row| row[2]);
        let map = normals(normal);
        let materials = [Appearance {
            base_colour: style.surface,
            reflectance: style.gloss,
            normal_map: Some(&map),
            ..Appearance::default()
        }];
        for given in [true, false] {
            let mut scene = painted(&positions, &CORNERS, &materials);
            scene.objects[0].tangents = given.then_some(Attribute::of_vertices(&tangents));
            assert_eq!(
                middle(&scene, &straight(), &style),
                expected,
                "{axis:?} {given}"
            );
        }
        // The same surface with its picture mirrored, and rotated by a right angle.
        let [x, y, z] = normal;
        let mirrored = CORNERS.map(|[u, v]| [1.0 - u, v]);
        let turned = CORNERS.map(|[u, v]| [v, 1.0 - u]);
        for (coordinates, normal, tangent) in [
            (mirrored, [-x, y, z], [-1.0, 0.0, 0.0, -1.0]),
            (turned, [y, -x, z], [0.0, 1.0, 0.0, 1.0]),
        ] {
            let map = normals(normal);
            let materials = [Appearance {
                normal_map: Some(&map),
                ..materials[0]
            }];
            let tangents = [tangent; 4];
            for given in [true, false] {
                let mut scene = painted(&positions, &coordinates, &materials);
                scene.objects[0].tangents = given.then_some(Attribute::of_vertices(&tangents));
                assert_eq!(
                    middle(&scene, &straight(), &style),
                    expected,
                    "{axis:?} {given}"
                );
            }
        }
        // With a scale of 0 the map says nothing.
        let flat = [Appearance {
            normal_scale: 0.0,
            ..materials[0]
        }];
        let scene = painted(&positions, &CORNERS, &flat);
        let unmapped = Scene::new(&positions, &UNIT_SQUARE);
        assert_eq!(
            middle(&scene, &straight(), &style),
            middle(&unmapped, &straight(), &style)
        );
    }
}

#[test]
fn normals_may_be_smooth_flat_or_given() {
    // A roof: its ridge runs through the middle of the picture.
    let positions = [
        [-1.0, -1.0, -1.0],
        [0.0, -1.0, 0.0],
        [1.0, -1.0, -1.0],
        [1.0, 1.0, -1.0],
        [0.0, 1.0, 0.0],
        [-1.0, 1.0, -1.0],
    ];
    let triangles = [[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4]];
    let style = Style {
        surface: LinearColour::WHITE,
        ..one_light(9, [0.0, 1e-6, 1.0], LinearColour::WHITE * 0.8)
    };
    let shade = |normals| {
        let mut object = Object::new(&positions, &triangles);
        object.normals = normals;
        let scene = Scene {
            objects: vec![object],
            ..Scene::default()
        };
        f64::from(middle(&scene, &straight(), &style)[0])
    };
    let given = [[0.0, 0.0, 3.0]; 6];
    let slope = 0.5f64.sqrt();
    let tilted = [[slope, 0.0, slope]; 1];
    let corners = [Some([0; 3]), None, Some([0; 3]), Some([0; 3])];
    assert!((shade(Normals::Smooth) - code(0.8)).abs() < 2.0);
    assert!((shade(Normals::Flat) - code(0.8 * slope)).abs() < 0.6);
    assert!((shade(Normals::Given(Attribute::of_vertices(&given))) - code(0.8)).abs() < 0.6);
    let of_corners = Normals::Given(Attribute::of_corners(&tilted, &corners));
    assert!((shade(of_corners) - code(0.8 * slope)).abs() < 0.6);
}

#[test]
fn colours_of_vertices_are_factors() {
    let positions = square(0.0);
    let colours = [
        [1.0, 0.0, 0.5, 1.0],
        [0.0, 0.0, 0.5, 1.0],
        [0.0, 1.0, 0.5, 1.0],
        [1.0, 1.0, 0.5, 1.0],
    ];
    let mut object = Object::new(&positions, &UNIT_SQUARE);
    object.colours = Some(Attribute::of_vertices(&colours));
    let scene = Scene {
        objects: vec![object],
        ..Scene::default()
    };
    let style = Style {
        surface: LinearColour::new(1.0, 0.5, 0.8),
        ..unlit(style(16))
    };
    let picture = render(&scene, &straight(), &style).unwrap().colour;
    for (column, row, pixel) in enumerated(&picture) {
        let [u, v] = [
            (f64::from(column) + 0.5) / 16.0,
            1.0 - (f64::from(row) + 0.5) / 16.0,
        ];
        let expected = [code(1.0 - u), code(0.5 * v), code(0.4)];
        for (found, expected) in pixel.into_iter().zip(expected) {
            assert!((f64::from(found) - expected).abs() < 0.51);
        }
    }
}

#[test]
fn what_is_cut_out_is_not_there() {
    let holes = Plane::from_fn(8, 8, |column, row| {
        [200u8, 100, 50, [255, 0][(column + row) % 2]]
    });
    let texture = Mipmap::colour(&holes, sampler(Filter::Nearest, Wrap::Repeat)).unwrap();
    let front = square(0.0);
    let back = square(-0.001);
    for (cutoff, shown) in [(Some(0.5), 0), (None, 200)] {
        let materials = [Appearance {
            base_colour_map: Some(&texture),
            cutoff,
            ..Appearance::default()
        }];
        let mut scene = painted(&front, &CORNERS, &materials);
        scene.objects.push(Object::new(&back, &UNIT_SQUARE));
        let style = Style {
            surface: LinearColour::BLACK,
            ..unlit(style(8))
        };
        let picture = render(&scene, &straight(), &style).unwrap().colour;
        for (column, row, pixel) in enumerated(&picture) {
            let expected = [200, shown][((column + row) % 2) as usize];
            assert_eq!(pixel[0], expected);
        }
    }
}

#[test]
fn faces_have_their_own_materials() {
    let positions = square(0.0);
    let red = Appearance {
        base_colour: LinearColour::new(1.0, 0.0, 0.0),
        unlit: true,
        ..Appearance::default()
    };
    let mut object = Object::new(&positions, &UNIT_SQUARE);
    let choice = [None, Some(1)];
    object.material = MaterialChoice::PerTriangle(&choice);
    let scene = Scene {
        objects: vec![object],
        materials: &[Appearance::default(), red],
        ..Scene::default()
    };
    let style = Style {
        surface: LinearColour::new(0.0, 0.0, 1.0),
        ..unlit(style(8))
    };
    let picture = render(&scene, &straight(), &style).unwrap().colour;
    assert_eq!(picture.pixel(6, 6), [0, 0, 255]);
    assert_eq!(picture.pixel(1, 1), [255, 0, 0]);
}

#[test]
fn an_unlit_material_is_not_lit() {
    let positions = square(0.0);
    let materials = [Appearance {
        base_colour: LinearColour::WHITE * 0.5,
        unlit: true,
        ..Appearance::default()
    }];
    let style = Style {
        lighting: Lighting {
            key: Light {
                direction: [0.0, 1.0, 0.0],
                colour: LinearColour::WHITE * 9.0,
            },
            ..Style::default().lighting
        },
        ..style(9)
    };
    let scene = painted(&positions, &CORNERS, &materials);
    assert_eq!(middle(&scene, &straight(), &style), [188; 3]);
}

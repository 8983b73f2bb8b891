//! Models from meshes: where textures are placed, and what is drawn in place of what is missing.

use crate::Pixels;
use std::f64::consts::FRAC_PI_2;

use ga_image::colour::LinearColour;
use ga_image::plane::Plane;
use ga_mesh::gltf::{Document, TextureTransform, Vertices};
use ga_mesh::{
    AlphaMode, CornerAttribute, Faces, Filter, Image, Material, Mesh, Texture, TextureCoordinates,
};
use ga_render::model::Model;
use ga_render::{Buffers, Scene, Shading, Style, View, render};

/// The square from (−1, −1) to (1, 1) that faces +z, with texture coordinates from 0 to 1.
fn square(material: Material) -> Mesh {
    let positions = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let positions: Vec<[f64; 3]> = positions.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    let faces = Faces::from_polygons([[0u32, 1, 2, 3]]).unwrap();
    let coordinates = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let coordinates: TextureCoordinates = CornerAttribute::of_vertices(coordinates, &faces);
    Mesh::new(positions, faces)
        .unwrap()
        .with_texture_coordinates(vec![coordinates])
        .unwrap()
        .with_materials(vec![material], vec![Some(0)])
        .unwrap()
}

/// For the middle of each of 8 × 8 pixels the texture coordinates of the mesh, and where the
/// texture of the base colour is read.
fn seen(mesh: &Mesh) -> Vec<([f64; 2], [f64; 2])> {
    let model = Model::from_mesh(mesh, None).unwrap();
    let angle = 2.0 * (1f64 / 20.0).atan();
    let camera = View::look_at([0.0, 0.0, 20.0], [0.0; 3], [0.0, 1.0, 0.0], angle, 1.0).unwrap();
    let materials = model.materials();
    let scene = model.scene(&materials);
    let buffers = Buffers::new(&scene, &camera, 8, 8).unwrap();
    let coordinates = buffers.texture_coordinates();
    let mut seen = Vec::new();
    for row in 0..8 {
        for column in 0..8 {
            let [u, v, mask] = coordinates.get(column, row).unwrap();
            assert_eq!(mask, 1.0);
            let own = [column as f64 + 0.5, 7.5 - row as f64].map(|c| c / 8.0);
            let placement = materials[0].placements.base_colour;
            seen.push((own, placement.place([u, v].map(f64::from))));
        }
    }
    seen
}

#[test]
fn textures_are_scaled_before_they_are_rotated() {
    let material = Material {
        base_colour_texture: Some(Texture {
            scale: [3.0, 0.5],
            rotation: FRAC_PI_2,
            offset: [0.25, -1.0],
            ..Texture::file("none.png")
        }),
        ..Material::named("wood")
    };
    for ([u, v], found) in seen(&square(material)) {
        // A quarter of a circle counter-clockwise takes (3 u, v / 2) to (−v / 2, 3 u).
        let expected = [0.25 - 0.5 * v, 3.0 * u - 1.0];
        let error = (0..2).map(|i| (found[i] - expected[i]).abs());
        assert!(error.fold(0.0, f64::max) < 1e-5, "{found:?} {expected:?}");
    }
}

/// The example in the specification of `KHR_texture_transform`: "only the lower left quadrant of
/// the source image, rotated clockwise 90°".
#[test]
fn the_example_of_the_specification_shows_the_lower_left_quadrant() {
    let mesh = square(Material {
        base_colour_texture: Some(Texture::file("none.png")),
        ..Material::named("quadrant")
    });
    let mut document = Document::from_mesh(&mesh).unwrap();
    let info = document.materials[0].base_colour_texture.as_mut().unwrap();
    info.transform = Some(TextureTransform {
        offset: [0.0, 1.0],
        rotation: FRAC_PI_2 as f32,
        scale: [0.5, 0.5],
        texcoord: None,
    });
    let mesh = document.to_mesh(Vertices::default()).unwrap();
    for ([u, v], found) in seen(&mesh) {
        // Rotated clockwise, the left edge of the quadrant is the upper edge of the square: what
        // is seen at the upper left corner is the lower left corner of the picture.
        let expected = [0.5 * (1.0 - v), 0.5 * u];
        let error = (0..2).map(|i| (found[i] - expected[i]).abs());
        assert!(error.fold(0.0, f64::max) < 1e-5, "{found:?} {expected:?}");
    }
}

#[test]
fn a_third_set_of_texture_coordinates_has_a_warning() {
    let warnings = |set: u32| {
        let texture = Texture {
            set,
            ..Texture::file("none.png")
        };
        let mesh = square(Material {
            base_colour_texture: Some(Texture::file("none.png")),
            normal_texture: Some(texture),
            ..Material::named("wood")
        });
        let model = Model::from_mesh(&mesh, None).unwrap();
        let mut own = model.warnings().to_vec();
        own.retain(|text| text.contains("third"));
        own
    };
    assert!(warnings(0).is_empty() && warnings(1).is_empty());
    let own = warnings(2);
    assert_eq!(own.len(), 1);
    assert!(own[0].contains("\"wood\"") && own[0].contains("normals"));
}

/// The message names the material, whatever is wrong with its picture.
#[test]
fn a_picture_that_makes_no_texture_names_its_material() {
    for bytes in [&b"P5 0 0 255\n"[..], b"no picture"] {
        let picture = Image::Embedded {
            media_type: "image/x-portable-graymap".to_owned(),
            bytes: bytes.into(),
        };
        let mesh = square(Material {
            base_colour_texture: Some(Texture::new(picture)),
            ..Material::named("wood")
        });
        let error = Model::from_mesh(&mesh, None).unwrap_err().to_string();
        assert!(
            error.starts_with("the picture of material \"wood\": "),
            "{error}"
        );
    }
}

/// A picture of 4 × 4 pixels, red for the columns and green for the rows from the top.
fn numbered() -> Image {
    let picture = Plane::from_fn(4, 4, |column, row| [60 * column as u8, 60 * row as u8, 0]);
    Image::Embedded {
        media_type: "image/png".to_owned(),
        bytes: ga_image::png::encode(&picture).unwrap().into(),
    }
}

/// The base colour is placed by the first set of coordinates, the emission by the second with a
/// scale of its own.
#[test]
fn each_texture_has_its_own_place() {
    let nearest = |texture: Texture| Texture {
        magnification: Some(Filter::Nearest),
        ..texture
    };
    let mesh = square(Material {
        base_colour_texture: Some(nearest(Texture::new(numbered()))),
        emissive: [1.0; 3],
        emissive_texture: Some(nearest(Texture {
            set: 1,
            scale: [2.0, 1.0],
            ..Texture::new(numbered())
        })),
        ..Material::named("two")
    });
    let first = mesh.texture_coordinates().unwrap().clone();
    let mut second = first.clone();
    for [u, v] in &mut second.values {
        [*u, *v] = [*v, *u];
    }
    let mesh = mesh.with_texture_coordinates(vec![first, second]).unwrap();
    let mut model = Model::from_mesh(&mesh, None).unwrap();
    let angle = 2.0 * (1f64 / 20.0).atan();
    let camera = View::look_at([0.0, 0.0, 20.0], [0.0; 3], [0.0, 1.0, 0.0], angle, 1.0).unwrap();
    let picture = |model: &Model, emission: bool| {
        let mut materials = model.materials();
        if emission {
            materials[0].base_colour = LinearColour::BLACK;
            materials[0].reflectance = 0.0;
        }
        let style = Style {
            width: 8,
            height: 8,
            supersampling: 1,
            shading: if emission {
                Shading::Lit
            } else {
                Shading::Unlit
            },
            depth_contrast: 0.0,
            ..Style::default()
        };
        render(&model.scene(&materials), &camera, &style)
            .unwrap()
            .colour
    };
    let base = picture(&model, false);
    let emission = picture(&model, true);
    for row in 0..8u32 {
        for column in 0..8u32 {
            let texel = |u: f64, v: f64| {
                let place = |t: f64| ((4.0 * t).floor() as i64).rem_euclid(4) as u8;
                [60 * place(u), 60 * (3 - place(v)), 0]
            };
            let [u, v] = [f64::from(column) + 0.5, 7.5 - f64::from(row)].map(|c| c / 8.0);
            assert_eq!(base.pixel(column, row), texel(u, v));
            assert_eq!(emission.pixel(column, row), texel(2.0 * v, u));
        }
    }
    // Without a second set, the colour of the emission is that of no texture.
    let one = mesh.texture_coordinates().unwrap().clone();
    model = Model::from_mesh(&mesh.with_texture_coordinates(vec![one]).unwrap(), None).unwrap();
    assert_eq!(picture(&model, true).pixel(2, 2), [255; 3]);
}

#[test]
fn lines_and_points_of_a_mesh_are_drawn() {
    let text = b"v -0.5 0 0 1 0 0\nv 0.5 0 0 1 0 0\nv 0 0.6 0 0 0 1\nl 1 2\np 3\n";
    let mesh = ga_mesh::obj::decode(text).unwrap();
    let model = Model::from_mesh(&mesh, None).unwrap();
    assert!(!model.is_empty() && model.points().count() == 3);
    let (lines, dots) = (model.lines(3.0), model.dots(7.0));
    let materials = model.materials();
    let scene = Scene {
        lines: &lines,
        dots: &dots,
        ..model.scene(&materials)
    };
    let angle = 2.0 * (1f64 / 20.0).atan();
    let camera = View::look_at([0.0, 0.0, 20.0], [0.0; 3], [0.0, 1.0, 0.0], angle, 1.0).unwrap();
    let style = Style {
        width: 80,
        height: 80,
        ..Style::default()
    };
    let picture = render(&scene, &camera, &style).unwrap().colour;
    assert_eq!(picture.pixel(40, 40), [255, 0, 0]);
    assert_eq!(picture.pixel(40, 16), [0, 0, 255]);
    let around = picture.pixel(70, 40);
    assert!(around[0] > 150 && around[1] > 150, "{around:?}");
    assert!(Model::default().is_empty());
}

#[test]
fn sides_and_transparency_are_those_of_the_material() {
    let mesh = square(Material {
        alpha_mode: AlphaMode::Blend,
        ..Material::named("glass")
    });
    let model = Model::from_mesh(&mesh, None).unwrap();
    let [material] = model.materials()[..] else {
        unreachable!()
    };
    assert!(material.transparent && !material.double_sided);
    assert!(model.warnings().is_empty());
    let model = model.with_both_sides();
    assert!(model.materials()[0].double_sided);
}

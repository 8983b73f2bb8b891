//! Models from meshes: where textures are placed, and what is drawn in place of what is missing.

use std::f64::consts::FRAC_PI_2;

use ga_mesh::gltf::{Document, TextureTransform, Vertices};
use ga_mesh::{CornerAttribute, Faces, Material, Mesh, Texture, TextureCoordinates};
use ga_render::model::Model;
use ga_render::{Buffers, Camera};

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

/// The texture coordinates that the middle of each of 8 × 8 pixels shows, with those of the mesh.
fn seen(mesh: &Mesh) -> Vec<([f64; 2], [f64; 2])> {
    let model = Model::from_mesh(mesh, None).unwrap();
    let angle = 2.0 * (1f64 / 20.0).atan();
    let camera = Camera::look_at([0.0, 0.0, 20.0], [0.0; 3], [0.0, 1.0, 0.0], angle, 1.0).unwrap();
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
            seen.push((own, [u, v].map(f64::from)));
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
fn a_texture_with_another_place_than_the_base_colour_has_a_warning() {
    let at = |scale: f64| Texture {
        scale: [scale; 2],
        ..Texture::file("none.png")
    };
    let warnings = |normal: f64| {
        let mesh = square(Material {
            base_colour_texture: Some(at(2.0)),
            normal_texture: Some(at(normal)),
            ..Material::named("wood")
        });
        let model = Model::from_mesh(&mesh, None).unwrap();
        let own = model
            .warnings()
            .iter()
            .filter(|text| text.contains("of its own"));
        own.cloned().collect::<Vec<_>>()
    };
    assert!(warnings(2.0).is_empty());
    let own = warnings(3.0);
    assert_eq!(own.len(), 1);
    assert!(
        own[0].contains("\"wood\"") && own[0].contains("normals"),
        "{}",
        own[0]
    );
}

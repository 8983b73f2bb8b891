//! The Khronos validator on files of many shapes.

use std::path::Path;
use std::process::Command;

use ga_mesh::gltf::{read, write};

use ga_mesh::{CornerAttribute, Faces, Image, Material, Mesh, Polylines, Texture, format};

use super::documents::example;
use super::samples::samples;
use super::source::strip;

/// Needs Node.js and `npm ci` in `.ci/gltf-validator`; skipped without them.
#[test]
fn the_khronos_validator_finds_nothing() {
    let tool = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../.ci/gltf-validator");
    if nullcone_shared_data::present(&tool.join("node_modules/gltf-validator")).is_none() {
        return;
    }
    let mut several_roots = strip(4, 20, 3, 5);
    several_roots.joints[2].parent = None;
    let mut unused_vertex = strip(4, 20, 3, 5);
    unused_vertex.normals[0] = [0.0; 3];
    unused_vertex.triangles.push([3, 3, 4]);
    unused_vertex.animations[0].tracks.truncate(1);
    unused_vertex.animations[0].tracks[0].keys = vec![unused_vertex.joints[0].rest; 5];
    let folder = tempfile::tempdir().unwrap();
    let mut validate = Command::new("node");
    validate.arg(tool.join("validate.mjs"));
    let sources = [
        strip(1, 3, 1, 1),
        strip(9, 40, 9, 60),
        strip(300, 70_000, 6, 2),
        several_roots,
        unused_vertex,
    ];
    for (index, source) in sources.iter().enumerate() {
        let path = folder.path().join(format!("{index}.glb"));
        std::fs::write(&path, source.write().unwrap()).unwrap();
        validate.arg(path);
    }
    for seed in 0..40 {
        let document = example(seed);
        let path = folder.path().join(format!("document {seed}.glb"));
        write(&path, &document).unwrap();
        validate.arg(path);
        if seed % 4 == 0 {
            let path = folder.path().join(format!("document {seed}.gltf"));
            write(&path, &document).unwrap();
            validate.arg(path);
        }
    }
    let options = format::Options::default();
    for (name, mesh) in meshes() {
        for extension in ["glb", "gltf"] {
            let path = folder.path().join(format!("mesh {name}.{extension}"));
            format::write(&path, &mesh, &options).unwrap();
            validate.arg(path);
        }
    }
    for path in samples() {
        let mut document = read(&path).unwrap();
        if document.read_images(path.parent().unwrap()).is_err() {
            // Its picture is not among the samples.
            document.images[0] = example(0).images[0].clone();
        }
        let conformed = document.conformed().unwrap();
        let name = path.file_stem().unwrap().to_str().unwrap();
        for extension in ["glb", "gltf"] {
            let path = folder.path().join(format!("{name}.{extension}"));
            write(&path, &conformed).unwrap();
            validate.arg(path);
        }
    }
    let output = validate.output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout);
    println!("{text}");
    assert!(output.status.success(), "{text}");
}

/// Two triangles with one textured material, of which only the first has texture coordinates; edges
/// with a longer polyline and points; and points alone.
fn meshes() -> [(&'static str, Mesh); 3] {
    let [picture] = <[_; 1]>::try_from(example(0).images[..1].to_vec()).unwrap();
    let ga_mesh::gltf::ImageSource::Bytes { media_type, bytes } = picture.source else {
        panic!("the example has its picture in it")
    };
    let image = Image::Embedded {
        media_type,
        bytes: bytes.into(),
    };
    let paint = Material {
        base_colour_texture: Some(Texture::new(image)),
        ..Material::named("paint")
    };
    let corners = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    let faces = Faces::from_polygons([[0, 1, 2], [1, 3, 2]]).unwrap();
    let textured = Mesh::new(corners.clone(), faces)
        .and_then(|mesh| mesh.with_materials(vec![paint], vec![Some(0); 2]))
        .and_then(|mesh| {
            mesh.with_texture_coordinates(vec![CornerAttribute {
                values: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
                corners: vec![Some(0), Some(1), Some(2), None, None, None],
            }])
        });
    let plain = Mesh::new(corners, Faces::default()).unwrap();
    let lines = Polylines::from_lines([&[0, 1][..], &[2, 3], &[0, 3, 1]]).unwrap();
    let lines = plain.clone().with_polylines(lines);
    let lines = lines.and_then(|mesh| mesh.with_points(vec![3, 1]));
    [
        ("textured", textured.unwrap()),
        ("lines", lines.unwrap()),
        ("points", plain.with_points(vec![0, 1, 2, 3]).unwrap()),
    ]
}

//! The Khronos validator on files of many shapes.

use std::path::Path;
use std::process::Command;

use ga_mesh::gltf::{read, write};

use super::documents::example;
use super::samples::samples;
use super::source::strip;

/// Needs Node.js and `npm ci` in `.ci/gltf-validator`; skipped without them.
#[test]
fn the_khronos_validator_finds_nothing() {
    let tool = Path::new(env!("CARGO_MANIFEST_DIR")).join("../.ci/gltf-validator");
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
    for path in samples() {
        let mut document = read(&path).unwrap();
        if document.load_images(path.parent().unwrap()).is_err() {
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

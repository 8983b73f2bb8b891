//! Primitives that are compressed, beside what Google's decoder makes of them.

use std::path::Path;

use ga_mesh::FormatError;
use ga_mesh::gltf::{self, Problem};
use serde_json::Value;

fn data(name: &str) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    std::fs::read(folder.join(name)).unwrap()
}

#[test]
fn compressed_geometry_is_that_of_another_decoder() {
    let document = gltf::decode(&data("draco.glb")).unwrap();
    let primitive = &document.meshes[0].primitives[0];
    let expected: Value = serde_json::from_slice(&data("draco.json")).unwrap();
    let positions: Vec<[f32; 3]> = serde_json::from_value(expected["POSITION"].clone()).unwrap();
    let joints: Vec<[u16; 4]> = serde_json::from_value(expected["JOINTS_0"].clone()).unwrap();
    let weights: Vec<[f32; 4]> = serde_json::from_value(expected["WEIGHTS_0"].clone()).unwrap();
    let indices: Vec<u32> = serde_json::from_value(expected["indices"].clone()).unwrap();
    assert_eq!(primitive.positions, positions);
    assert_eq!(primitive.joints, [joints]);
    assert_eq!(primitive.weights, [weights]);
    assert_eq!(primitive.indices, Some(indices));
}

/// Every byte of the file is damaged in several ways: an error or a document, never a panic.
#[test]
fn damaged_geometry_is_an_error_or_another_document() {
    let file = data("draco.glb");
    for at in 0..file.len() {
        for mask in [0x01, 0x04, 0x10, 0x80, 0xff] {
            let mut damaged = file.clone();
            damaged[at] ^= mask;
            if let Ok(document) = gltf::decode(&damaged) {
                gltf::encode(&document).unwrap();
            }
        }
    }
}

#[test]
fn other_compression_names_what_removes_it() {
    for name in ["EXT_meshopt_compression", "KHR_meshopt_compression"] {
        let file = format!(
            r#"{{"asset": {{"version": "2.0"}}, "extensionsUsed": ["{name}"],
            "extensionsRequired": ["{name}"]}}"#
        );
        let error = gltf::decode(file.as_bytes()).unwrap_err();
        let message = error.to_string();
        assert!(message.contains(name), "{message}");
        assert!(
            message.contains("npx @gltf-transform/cli copy"),
            "{message}"
        );
        let FormatError::Gltf { problem, .. } = error else {
            panic!("{message}")
        };
        assert_eq!(problem, Problem::UnknownExtension(name.to_owned()));
    }
}

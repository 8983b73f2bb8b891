//! Accessors of every kind, beside values worked out from the specification.

use ga_mesh::FormatError;
use ga_mesh::gltf::{Components, Document, Keys, Shape, decode};
use serde_json::{Value, json};

/// A document from JSON and the bytes of its only buffer, in which every accessor begins.
fn document(json: Value, bytes: &[u8]) -> Result<Document, FormatError> {
    let digits: String = bytes.iter().map(|byte| format!("%{byte:02x}")).collect();
    let mut json = json;
    json["asset"] = json!({"version": "2.0"});
    json["buffers"] = json!([{"byteLength": bytes.len(), "uri": format!("data:,{digits}")}]);
    decode(&serde_json::to_vec(&json).unwrap())
}

fn floats(numbers: &[f32]) -> Vec<u8> {
    numbers
        .iter()
        .flat_map(|number| number.to_le_bytes())
        .collect()
}

/// The positions 0 to 3 on a line with 1 and 3 replaced: over a buffer, and over zeros.
#[test]
fn sparse_accessors_replace_what_they_list() {
    let mut bytes = floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 3.0, 0.0, 0.0]);
    bytes.extend([1, 0, 3, 0]);
    bytes.extend(floats(&[10.0, 11.0, 12.0, 30.0, 31.0, 32.0]));
    for base in [true, false] {
        let mut accessor = json!({
            "componentType": 5126, "type": "VEC3", "count": 4,
            "sparse": {
                "count": 2,
                "indices": {"bufferView": 1, "byteOffset": 0, "componentType": 5123},
                "values": {"bufferView": 1, "byteOffset": 4},
            },
        });
        if base {
            accessor["bufferView"] = json!(0);
        }
        let json = json!({
            "accessors": [accessor],
            "bufferViews": [
                {"buffer": 0, "byteLength": 48},
                {"buffer": 0, "byteOffset": 48, "byteLength": 28},
            ],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        });
        let document = document(json, &bytes).unwrap();
        let x = |vertex: u8| if base { f32::from(vertex) } else { 0.0 };
        let expected = [
            [x(0), 0.0, 0.0],
            [10.0, 11.0, 12.0],
            [x(2), 0.0, 0.0],
            [30.0, 31.0, 32.0],
        ];
        assert_eq!(document.meshes[0].primitives[0].positions, expected);
    }
}

/// Section 3.11: c / 127, c / 255, c / 32767, c / 65535, and no less than −1.
#[test]
fn normalised_integers_are_fractions_of_the_greatest() {
    let cases: [(u32, Vec<u8>, [f32; 4]); 4] = [
        (
            5120,
            vec![127, 0x80, 0x81, 64],
            [1.0, -1.0, -1.0, 64.0 / 127.0],
        ),
        (5121, vec![255, 0, 51, 128], [1.0, 0.0, 0.2, 128.0 / 255.0]),
        (
            5122,
            vec![0xff, 0x7f, 0x00, 0x80, 0, 0, 1, 0],
            [1.0, -1.0, 0.0, 1.0 / 32767.0],
        ),
        (
            5123,
            vec![0xff, 0xff, 0, 0, 0, 0x80, 1, 0],
            [1.0, 0.0, 32768.0 / 65535.0, 1.0 / 65535.0],
        ),
    ];
    for (component, bytes, expected) in cases {
        let mut all = floats(&[0.0]);
        all.extend(&bytes);
        let json = json!({
            "accessors": [
                {"bufferView": 0, "componentType": 5126, "type": "SCALAR", "count": 1},
                {"bufferView": 0, "byteOffset": 4, "componentType": component, "normalized": true,
                 "type": "VEC4", "count": 1},
            ],
            "bufferViews": [{"buffer": 0, "byteLength": all.len()}],
            "nodes": [{}],
            "animations": [{
                "samplers": [{"input": 0, "output": 1}],
                "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}],
            }],
        });
        let document = document(json, &all).unwrap();
        assert_eq!(
            document.animations[0].channels[0].keys,
            Keys::Rotation(vec![expected])
        );
    }
}

/// Positions and normals in one view, 24 bytes apart, and colours without alpha, 4 bytes apart.
#[test]
fn interleaved_attributes_are_taken_apart() {
    let mut bytes = floats(&[1.0, 2.0, 3.0, 0.0, 0.0, 1.0, 4.0, 5.0, 6.0, 0.0, 1.0, 0.0]);
    bytes.extend([255, 0, 51, 99, 0, 255, 102]);
    let json = json!({
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 2},
            {"bufferView": 0, "byteOffset": 12, "componentType": 5126, "type": "VEC3", "count": 2},
            {"bufferView": 1, "componentType": 5121, "normalized": true, "type": "VEC3",
             "count": 2},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 48, "byteStride": 24},
            {"buffer": 0, "byteOffset": 48, "byteLength": 7, "byteStride": 4},
        ],
        "meshes": [{"primitives": [{
            "attributes": {"POSITION": 0, "NORMAL": 1, "COLOR_0": 2},
            "mode": 1,
        }]}],
    });
    let document = document(json, &bytes).unwrap();
    let primitive = &document.meshes[0].primitives[0];
    assert_eq!(primitive.positions, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
    assert_eq!(primitive.normals, [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]);
    assert_eq!(
        primitive.colours,
        [[[1.0, 0.0, 0.2, 1.0], [0.0, 1.0, 0.4, 1.0]]]
    );
}

/// The columns of a 3 × 3 matrix of bytes begin at multiples of four.
#[test]
fn columns_of_small_matrices_are_padded() {
    let bytes = [1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0];
    let json = json!({
        "accessors": [{"bufferView": 0, "componentType": 5121, "type": "MAT3", "count": 1}],
        "bufferViews": [{"buffer": 0, "byteLength": 12}],
        "meshes": [{"primitives": [{"attributes": {"_MATRIX": 0}}]}],
    });
    let document = document(json, &bytes).unwrap();
    let attribute = &document.meshes[0].primitives[0].custom[0];
    assert_eq!(
        (attribute.name.as_str(), attribute.shape),
        ("_MATRIX", Shape::Mat3)
    );
    assert_eq!(attribute.components, Components::U8((1..=9).collect()));
}

/// By `KHR_mesh_quantization` texture coordinates of morph targets may be integers that stand for
/// themselves, else only such as stand for fractions.
#[test]
fn texture_coordinates_of_targets_may_be_integers_by_the_extension() {
    let mut bytes = [0.0_f32; 3].map(f32::to_le_bytes).concat();
    bytes.extend([5, 0xfd, 0, 0]);
    let read = |extensions: Value, normalized: bool| {
        let json = json!({
            "extensionsUsed": extensions,
            "extensionsRequired": extensions,
            "accessors": [
                {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 1},
                {"bufferView": 1, "componentType": 5120, "normalized": normalized,
                 "type": "VEC2", "count": 1},
            ],
            "bufferViews": [
                {"buffer": 0, "byteLength": 12},
                {"buffer": 0, "byteOffset": 12, "byteLength": 4, "byteStride": 4},
            ],
            "meshes": [{"primitives": [{
                "attributes": {"POSITION": 0, "TEXCOORD_0": 1},
                "targets": [{"POSITION": 0, "TEXCOORD_0": 1}],
                "mode": 0,
            }]}],
        });
        document(json, &bytes).map(|document| {
            let target = &document.meshes[0].primitives[0].targets[0];
            target.texcoords[0].clone()
        })
    };
    let quantization = json!(["KHR_mesh_quantization"]);
    assert_eq!(read(quantization.clone(), false).unwrap(), [[5.0, -3.0]]);
    let fractions = [[5.0 / 127.0, -3.0 / 127.0]];
    assert_eq!(read(quantization, true).unwrap(), fractions);
    assert!(read(json!([]), false).is_err());
}

/// By `KHR_mesh_quantization` positions may be integers, else they may not.
#[test]
fn integers_as_positions_need_the_extension() {
    let bytes = [1, 0, 0xfe, 0xff, 3, 0, 0, 0];
    let read = |extensions: Value, normalized: bool| {
        let json = json!({
            "extensionsUsed": extensions,
            "extensionsRequired": extensions,
            "accessors": [{"bufferView": 0, "componentType": 5122, "normalized": normalized,
                           "type": "VEC3", "count": 1}],
            "bufferViews": [{"buffer": 0, "byteLength": 8, "byteStride": 8}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]}],
        });
        document(json, &bytes).map(|document| document.meshes[0].primitives[0].positions.clone())
    };
    let quantization = json!(["KHR_mesh_quantization"]);
    assert_eq!(
        read(quantization.clone(), false).unwrap(),
        [[1.0, -2.0, 3.0]]
    );
    let unit = 1.0 / 32767.0;
    assert_eq!(
        read(quantization, true).unwrap(),
        [[unit, -2.0 / 32767.0, 3.0 / 32767.0]]
    );
    let error = read(json!([]), false).unwrap_err().to_string();
    let expected = "mesh 0, primitive 0, attribute POSITION: accessor 0: is VEC3 of SHORT, but must \
                    be VEC3 of FLOAT";
    assert_eq!(error, expected);
}

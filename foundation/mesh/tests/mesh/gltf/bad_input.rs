//! Files that are not what they should be: each error names the element.

use ga_files::ReadError;
use ga_mesh::gltf::{Element, GltfError, Problem, parse, read, write};
use serde_json::{Value, json};

use super::documents::example;

/// Two triangles with a skin, a morph target and an animation, in 512 bytes of data.
///
/// | bytes | accessor | what |
/// | --- | --- | --- |
/// | 0–48 | 0 | positions of four vertices |
/// | 48–64 | 1 | joints 0 and 1 |
/// | 64–128 | 2 | weights 1 and 0 |
/// | 128–140 | 3 | indices, 16 bits |
/// | 140–148 | 4 | times 0 and 1 |
/// | 148–180 | 5 | two rotations |
fn model() -> (Value, Vec<u8>) {
    let mut bytes = Vec::new();
    let floats = |bytes: &mut Vec<u8>, numbers: &[f32]| {
        bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    };
    floats(
        &mut bytes,
        &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0],
    );
    bytes.extend([0, 1, 0, 0].repeat(4));
    floats(&mut bytes, &[1.0, 0.0, 0.0, 0.0].repeat(4));
    bytes.extend(
        [0u16, 1, 2, 0, 2, 3]
            .iter()
            .flat_map(|index| index.to_le_bytes()),
    );
    floats(
        &mut bytes,
        &[0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0],
    );
    let accessor = |offset: usize, component: u32, shape: &str, count: usize| {
        json!({
            "bufferView": 0, "byteOffset": offset,
            "componentType": component, "type": shape, "count": count,
        })
    };
    let json = json!({
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0, 2]}],
        "nodes": [{"children": [1]}, {}, {"mesh": 0, "skin": 0}],
        "meshes": [{"primitives": [{
            "attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2},
            "indices": 3,
            "targets": [{"POSITION": 0}],
        }]}],
        "skins": [{"joints": [0, 1]}],
        "animations": [{
            "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}],
            "samplers": [{"input": 4, "output": 5}],
        }],
        "accessors": [
            accessor(0, 5126, "VEC3", 4),
            accessor(48, 5121, "VEC4", 4),
            accessor(64, 5126, "VEC4", 4),
            accessor(128, 5123, "SCALAR", 6),
            accessor(140, 5126, "SCALAR", 2),
            accessor(148, 5126, "VEC4", 2),
        ],
        "bufferViews": [{"buffer": 0, "byteLength": 180}],
        "buffers": [{"byteLength": 180}],
    });
    (json, bytes)
}

fn glb(json: &Value, bytes: &[u8]) -> Vec<u8> {
    let mut text = serde_json::to_vec(json).unwrap();
    text.resize(text.len().next_multiple_of(4), b' ');
    let length = 28 + text.len() + bytes.len();
    let mut file = b"glTF\x02\0\0\0".to_vec();
    file.extend((length as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &text[..]), (b"BIN\0", bytes)] {
        file.extend((chunk.len() as u32).to_le_bytes());
        file.extend(kind);
        file.extend(chunk);
    }
    file
}

/// The message of the model with one value of its JSON replaced.
fn message(pointer: &str, value: Value) -> String {
    let (mut json, bytes) = model();
    let (parent, key) = pointer.rsplit_once('/').unwrap();
    match json.pointer_mut(parent).unwrap() {
        Value::Array(list) => list[key.parse::<usize>().unwrap()] = value,
        Value::Object(map) => {
            map.insert(key.to_owned(), value);
        }
        _ => panic!("{pointer} is not in the JSON"),
    }
    match parse(&glb(&json, &bytes)) {
        Ok(_) => "none".to_owned(),
        Err(error) => error.to_string(),
    }
}

/// The message of the model with other bytes from a place on.
fn message_of_bytes(at: usize, replaced: &[u8]) -> String {
    let (json, mut bytes) = model();
    bytes[at..at + replaced.len()].copy_from_slice(replaced);
    parse(&glb(&json, &bytes)).unwrap_err().to_string()
}

#[test]
fn the_model_is_good() {
    assert_eq!(message("/extras", json!(1)), "none");
}

#[test]
fn references_and_lengths_are_checked() {
    // In pointers and messages # stands for the primitive, @ for an attribute of it.
    let check = |pointer: &str, value: Value, expected: &str| {
        let pointer = pointer.replace('#', "/meshes/0/primitives/0");
        let expected = expected.replace('@', "#, attribute");
        let expected = expected.replace('#', "mesh 0, primitive 0");
        assert_eq!(
            message(&pointer, value.clone()),
            expected,
            "{pointer} {value}"
        );
    };
    let sparse = |count: usize, component: u32| {
        json!({
            "count": count,
            "indices": {"bufferView": 0, "componentType": component},
            "values": {"bufferView": 0},
        })
    };
    check(
        "/asset/version",
        json!("1.0"),
        "file: version 1.0 of glTF is not supported",
    );
    check(
        "/asset/minVersion",
        json!("2.1"),
        "file: version 2.1 of glTF is not supported",
    );
    check(
        "/extensionsRequired",
        json!(["KHR_mesh_quantization", "KHR_draco_mesh_compression"]),
        "file: requires the extension KHR_draco_mesh_compression, which is not supported",
    );
    check(
        "#/attributes/POSITION",
        json!(6),
        "@ POSITION: refers to accessor 6, but there are 6",
    );
    check(
        "#/attributes/POSITION",
        json!(4_294_967_296u64),
        "@ POSITION: refers to accessor 4294967296, but there are 6",
    );
    check(
        "#/attributes/NORMAL",
        json!(3),
        "@ NORMAL: accessor 3: is SCALAR of UNSIGNED_SHORT, but must be VEC3 of FLOAT",
    );
    check(
        "#/attributes/TEXCOORD_1",
        json!(0),
        "@ TEXCOORD_1: lacks the set with the number before it",
    );
    check(
        "#/attributes/COLOUR",
        json!(0),
        "@ COLOUR: the name cannot be COLOUR",
    );
    check(
        "#/targets/0",
        json!({"NORMAL": 5}),
        "#, morph target 0, attribute NORMAL: accessor 5: is VEC4 of FLOAT, but must \
         be VEC3 of FLOAT",
    );
    check(
        "#/targets/0",
        json!({}),
        "#: lacks attributes of a morph target",
    );
    check("#/mode", json!(7), "#: mode cannot be 7");
    check(
        "#/material",
        json!(0),
        "#: refers to material 0, but there are 0",
    );
    check(
        "/meshes/0/weights",
        json!([1.0, 2.0]),
        "mesh 0: has 2 weights of morph targets, not 1",
    );
    check(
        "/meshes/0/primitives",
        json!([]),
        "mesh 0: lacks primitives",
    );
    check(
        "/accessors/0/bufferView",
        json!(1),
        "@ POSITION: accessor 0: refers to buffer view 1, but there are 1",
    );
    check(
        "/accessors/0/count",
        json!(1_000_000_000),
        "@ POSITION: accessor 0: needs 12000000000 bytes, but has 180",
    );
    check(
        "/accessors/0/count",
        json!(u64::MAX),
        "@ POSITION: accessor 0: needs 18446744073709551615 bytes, but has 180",
    );
    check(
        "/accessors/0/count",
        json!(3),
        "@ WEIGHTS_0: has 4 items, not 3",
    );
    check(
        "/accessors/0/count",
        json!(0),
        "@ POSITION: accessor 0: count cannot be 0",
    );
    check(
        "/accessors/0/byteOffset",
        json!(133),
        "@ POSITION: accessor 0: needs 181 bytes, but has 180",
    );
    check(
        "/accessors/0/type",
        json!("VEC5"),
        "@ POSITION: accessor 0: type cannot be VEC5",
    );
    check(
        "/accessors/0/componentType",
        json!(5124),
        "@ POSITION: accessor 0: componentType cannot be 5124",
    );
    check(
        "/accessors/0/sparse",
        sparse(1, 5126),
        "@ POSITION: accessor 0: type of sparse indices cannot be FLOAT",
    );
    check(
        "/accessors/0/sparse",
        sparse(2, 5121),
        "@ POSITION: accessor 0: sparse index 1 is 0, which is not greater than the \
         index before it or not less than the count 4",
    );
    check(
        "/accessors/0/sparse",
        sparse(5, 5121),
        "@ POSITION: accessor 0: sparse count cannot be 5",
    );
    check("/accessors/4/normalized", json!(true), "none");
    check(
        "/bufferViews/0/byteStride",
        json!(8),
        "@ POSITION: accessor 0: byteStride cannot be 8",
    );
    check(
        "/bufferViews/0/byteLength",
        json!(181),
        "@ POSITION: accessor 0: buffer view 0: needs 181 bytes, but has 180",
    );
    check(
        "/bufferViews/0/buffer",
        json!(1),
        "@ POSITION: accessor 0: buffer view 0: refers to buffer 1, but there are 1",
    );
    check(
        "/buffers/0/byteLength",
        json!(184),
        "buffer 0: needs 184 bytes, but has 180",
    );
    check(
        "/buffers/0/uri",
        json!("http://example.org/a.bin"),
        "buffer 0: the URI \"http://example.org/a.bin\" does not name a file and holds \
         no data",
    );
    check(
        "/buffers/0/uri",
        json!("/etc/passwd"),
        "buffer 0: the URI \"/etc/passwd\" does not name a file and holds no data",
    );
    check(
        "/buffers/0/uri",
        json!("data:;base64,%%"),
        "buffer 0: the URI \"data:;base64,%%\" does not name a file and holds no data",
    );
    check(
        "/nodes/1/children",
        json!([0]),
        "node 0: is an ancestor of itself",
    );
    check(
        "/nodes/1/children",
        json!([1]),
        "node 1: is a child of node 0 and of node 1",
    );
    check(
        "/nodes/1/children",
        json!([9]),
        "node 1: refers to node 9, but there are 3",
    );
    check(
        "/nodes/1/matrix",
        json!([1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]),
        "node 1: the last row of the matrix cannot be [1.0, 0.0, 0.0, 1.0]",
    );
    check(
        "/nodes/1/rotation",
        json!([0, 0, 0, 0]),
        "node 1: rotation cannot be zero",
    );
    check(
        "/nodes/1/skin",
        json!(0),
        "node 1: lacks the mesh of its skin or weights",
    );
    check(
        "/nodes/1/camera",
        json!(0),
        "node 1: refers to camera 0, but there are 0",
    );
    check(
        "/nodes/2/mesh",
        json!(1),
        "node 2: refers to mesh 1, but there are 1",
    );
    check(
        "/nodes/2/skin",
        json!(1),
        "node 2: refers to skin 1, but there are 1",
    );
    check(
        "/nodes/2/weights",
        json!([1, 2]),
        "node 2: has 2 weights of morph targets, not 1",
    );
    check(
        "/scenes/0/nodes",
        json!([1]),
        "scene 0: a node at its top cannot be 1",
    );
    check(
        "/scenes/0/nodes",
        json!([0, 0]),
        "scene 0: has node 0 twice",
    );
    check(
        "/scene",
        json!(1),
        "file: refers to scene 1, but there are 1",
    );
    check("/skins/0/joints", json!([]), "skin 0: lacks joints");
    check(
        "/skins/0/joints",
        json!([0]),
        "node 2: @ JOINTS_0: vertex 0 is moved by joint 1, but the skin has 1 joints",
    );
    check(
        "/skins/0/joints",
        json!([0, 0]),
        "skin 0: has joint 0 twice",
    );
    check(
        "/skins/0/skeleton",
        json!(3),
        "skin 0: refers to node 3, but there are 3",
    );
    check(
        "/skins/0/inverseBindMatrices",
        json!(2),
        "skin 0: accessor 2: is VEC4 of FLOAT, but must be MAT4 of FLOAT",
    );
    check(
        "/animations/0/channels/0/sampler",
        json!(1),
        "animation 0, channel 0: refers to sampler 1, but there are 1",
    );
    check(
        "/animations/0/channels/0/target/node",
        json!(3),
        "animation 0, channel 0: refers to node 3, but there are 3",
    );
    check(
        "/animations/0/channels/0/target/path",
        json!("colour"),
        "animation 0, channel 0: path cannot be colour",
    );
    check(
        "/animations/0/channels/0/target/path",
        json!("scale"),
        "animation 0, channel 0: accessor 5: is VEC4 of FLOAT, but must be VEC3 of FLOAT",
    );
    check(
        "/animations/0/samplers/0/interpolation",
        json!("CUBIC"),
        "animation 0, channel 0: interpolation cannot be CUBIC",
    );
    check(
        "/animations/0/samplers/0/interpolation",
        json!("CUBICSPLINE"),
        "animation 0, channel 0: has 2 values of keys, not 6",
    );
    check(
        "/animations/0/channels/0/target",
        json!({"path": "pointer"}),
        "none",
    );
    check(
        "/materials",
        json!([{"normalTexture": {"index": 0}}]),
        "material 0: refers to texture 0, but there are 0",
    );
    check(
        "/materials",
        json!([{"alphaMode": "GLASS"}]),
        "material 0: alphaMode cannot be GLASS",
    );
    check(
        "/materials",
        json!([{"pbrMetallicRoughness": {"metallicFactor": 1.5}}]),
        "material 0: a factor cannot be 1.5",
    );
    check(
        "/textures",
        json!([{"source": 0}]),
        "texture 0: refers to image 0, but there are 0",
    );
    check(
        "/samplers",
        json!([{"wrapS": 1}]),
        "sampler 0: wrapS cannot be 1",
    );
    check(
        "/images",
        json!([{}]),
        "image 0: lacks a URI and a buffer view",
    );
    check(
        "/images",
        json!([{"bufferView": 3}]),
        "image 0: refers to buffer view 3, but there are 1",
    );
    check(
        "/cameras",
        json!([{"type": "perspective"}]),
        "camera 0: lacks perspective",
    );
    check(
        "/cameras",
        json!([{"type": "perspective", "perspective": {"yfov": 0, "znear": 1}}]),
        "camera 0: yfov cannot be 0",
    );
}

/// The place in the text is named, since no element is known yet.
#[test]
fn numbers_beyond_single_precision_are_errors() {
    for value in [json!([1e39, 0, 0]), json!([0, -1e300, 0])] {
        let message = message("/nodes/1/translation", value);
        let start = "JSON: number out of range at line 1 column ";
        assert!(message.starts_with(start), "{message}");
    }
}

#[test]
fn numbers_are_checked() {
    let nan = f32::NAN.to_le_bytes();
    let attribute = "mesh 0, primitive 0, attribute";
    assert_eq!(
        message_of_bytes(12, &nan),
        format!("{attribute} POSITION: accessor 0: item 1 has a number that is not finite")
    );
    let expected = "vertex 2 is moved by joint 7, but the skin has 2 joints";
    assert_eq!(
        message_of_bytes(56, &[7]),
        format!("node 2: {attribute} JOINTS_0: {expected}")
    );
    let expected = "the weights of vertex 3 are all zero, or one is negative: their sum is 0";
    assert_eq!(
        message_of_bytes(112, &[0; 4]),
        format!("node 2: {attribute} WEIGHTS_0: {expected}")
    );
    assert_eq!(
        message_of_bytes(138, &[4]),
        "mesh 0, primitive 0, indices: index 5 names vertex 4, but there are 4 vertices"
    );
    assert_eq!(
        message_of_bytes(144, &[0; 4]),
        "animation 0, channel 0: the time of key 1, 0 s, is negative or not after the time \
         before it"
    );
    assert_eq!(
        message_of_bytes(140, &(-0.5f32).to_le_bytes()),
        "animation 0, channel 0: the time of key 0, -0.5 s, is negative or not after the time \
         before it"
    );
    assert_eq!(
        message_of_bytes(164, &nan),
        "animation 0, channel 0: accessor 5: item 1 has a number that is not finite"
    );
}

/// Nothing in the file stands behind these zeros.
#[test]
fn zeros_from_nothing_are_limited() {
    let zeros = |count: u64| json!({"componentType": 5126, "type": "MAT4", "count": count});
    let message = message("/accessors/0", zeros(1_000_000_000));
    let start = "mesh 0, primitive 0, attribute POSITION: accessor 0: needs 64000000000 bytes, more \
                 than the limit of ";
    assert!(message.starts_with(start), "{message}");
}

#[test]
fn the_container_is_checked() {
    let (json, bytes) = model();
    let file = glb(&json, &bytes);
    let message = |file: &[u8]| parse(file).unwrap_err().to_string();
    assert_eq!(message(b"glTF"), "file: needs 12 bytes, but has 4");
    assert_eq!(
        message(&file[..100]),
        format!("file: needs {} bytes, but has 100", file.len())
    );
    let with = |at: usize, replaced: &[u8]| {
        let mut file = file.clone();
        file[at..at + replaced.len()].copy_from_slice(replaced);
        message(&file)
    };
    assert_eq!(with(4, &[1]), "file: version 1 of glTF is not supported");
    assert_eq!(with(8, &[8, 0, 0, 0]), "file: needs 12 bytes, but has 8");
    assert_eq!(
        with(12, &[0xff; 4]),
        format!(
            "chunk 0: needs 4294967295 bytes, but has {}",
            file.len() - 20
        )
    );
    assert_eq!(
        with(16, b"BIN\0"),
        "chunk 0: a chunk of kind \"BIN\\x00\" is not allowed here"
    );
    assert_eq!(
        message(b""),
        "JSON: EOF while parsing a value at line 1 column 0"
    );
    // An unknown chunk is skipped, and bytes behind the end are ignored.
    let text = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    let mut longer = file[..20 + text].to_vec();
    longer.extend(b"\x04\0\0\0XTRA....");
    longer.extend(&file[20 + text..]);
    let length = longer.len() as u32;
    longer[8..12].copy_from_slice(&length.to_le_bytes());
    longer.extend(b"trailing");
    assert_eq!(parse(&longer).unwrap(), parse(&file).unwrap());
}

#[test]
fn missing_files_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.gltf");
    write(&path, &example(3)).unwrap();
    let buffer = folder.path().join("model.bin");
    let contents = std::fs::read(&buffer).unwrap();
    std::fs::write(&buffer, &contents[..100]).unwrap();
    let ReadError::Contents { problem, .. } = read(&path).unwrap_err() else {
        panic!("the file itself can be read");
    };
    assert_eq!(problem.element(), &Element::Buffer(0));
    let (needed, found) = (contents.len() as u64, 100);
    assert_eq!(problem.problem, Problem::TooShort { needed, found });

    std::fs::remove_file(&buffer).unwrap();
    let error = read(&path).unwrap_err();
    let expected = format!(
        "{}: buffer 0: cannot read {}: entity not found",
        path.display(),
        buffer.display()
    );
    assert_eq!(error.to_string(), expected);
    let missing = folder.path().join("none.glb");
    assert!(matches!(read(missing), Err(ReadError::Io { .. })));
}

/// Nothing is written of a document that is not valid.
#[test]
fn a_bad_document_is_not_written() {
    let mut document = example(3);
    document.nodes[0].children.push(0);
    let folder = tempfile::tempdir().unwrap();
    for name in ["model.gltf", "model.glb"] {
        let path = folder.path().join(name);
        let error = write(&path, &document).unwrap_err();
        let expected = GltfError {
            path: vec![Element::Node(0)],
            problem: Problem::Cycle,
        };
        let expected = format!("cannot write {}: {expected}", path.display());
        assert_eq!(error.to_string(), expected);
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

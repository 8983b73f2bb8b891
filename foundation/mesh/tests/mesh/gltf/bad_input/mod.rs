//! Files that are not what they should be: each error names the element.

mod references;

use ga_files::ReadError;
use ga_mesh::gltf::{Element, Problem, decode, read, write};
use serde_json::{Value, json};

use super::documents::example;
use ga_mesh::FormatError;

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
    match decode(&glb(&json, &bytes)) {
        Ok(_) => "none".to_owned(),
        Err(error) => error.to_string(),
    }
}

/// The message of the model with other bytes from a place on.
fn message_of_bytes(at: usize, replaced: &[u8]) -> String {
    let (json, mut bytes) = model();
    bytes[at..at + replaced.len()].copy_from_slice(replaced);
    decode(&glb(&json, &bytes)).unwrap_err().to_string()
}

#[test]
fn the_model_is_good() {
    assert_eq!(message("/extras", json!(1)), "none");
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
    let message = |file: &[u8]| decode(file).unwrap_err().to_string();
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
    assert_eq!(decode(&longer).unwrap(), decode(&file).unwrap());
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
    let (needed, found) = (contents.len() as u64, 100);
    let expected = FormatError::Gltf {
        path: vec![Element::Buffer(0)],
        problem: Problem::TooShort { needed, found },
    };
    assert_eq!(problem, expected);

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
        let expected = FormatError::Gltf {
            path: vec![Element::Node(0)],
            problem: Problem::Cycle,
        };
        let expected = format!("cannot write {}: {expected}", path.display());
        assert_eq!(error.to_string(), expected);
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

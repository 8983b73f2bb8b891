//! Damaged files: an error or a document, never a panic.

use ga_mesh::gltf::{Vertices, decode, encode, encode_files};

use super::documents::example;
use super::samples::samples;

/// What reads must be a document that can be written and placed.
fn survives(file: &[u8]) {
    if let Ok(document) = decode(file) {
        encode(&document).unwrap();
        // A transform may be too large for double precision.
        let _ = document.to_mesh(Vertices::Merged);
    }
}

/// A GLB file whose header states the length that it has; other files as they are.
fn with_length(mut file: Vec<u8>) -> Vec<u8> {
    let length = file.len() as u32;
    if file.starts_with(b"glTF")
        && let Some(stated) = file.get_mut(8..12)
    {
        stated.copy_from_slice(&length.to_le_bytes());
    }
    file
}

/// One file of each form: the JSON with its buffer in a URI.
fn examples() -> Vec<Vec<u8>> {
    let document = example(11);
    let json = br#"{"asset":{"version":"2.0"},"accessors":[{"bufferView":0,"componentType":5126,
        "type":"VEC3","count":3,"sparse":{"count":1,"indices":{"bufferView":1,"componentType":5121},
        "values":{"bufferView":0}}}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,
        "byteLength":1}],"buffers":[{"byteLength":36,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAA
        AAAAAAAAAAAAAAgD8AAAAA"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":0},
        "mode":5}]}],"nodes":[{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}]}"#;
    let json: Vec<u8> = json
        .iter()
        .copied()
        .filter(|byte| !byte.is_ascii_whitespace())
        .collect();
    assert!(decode(&json).is_ok());
    vec![
        encode(&document).unwrap(),
        json,
        encode_files(&document, "x").unwrap().json,
    ]
}

#[test]
fn files_may_end_anywhere() {
    for file in examples() {
        for end in (0..file.len()).step_by(7) {
            survives(&file[..end]);
            survives(&with_length(file[..end].to_vec()));
        }
    }
    for path in samples() {
        let file = std::fs::read(&path).unwrap();
        if path.extension().is_some_and(|extension| extension == "glb") {
            for end in (0..file.len()).step_by(7) {
                assert!(decode(&file[..end]).is_err());
            }
        }
        for end in (0..file.len()).step_by(7 * 499) {
            survives(&with_length(file[..end].to_vec()));
        }
    }
}

#[test]
fn any_byte_may_be_wrong() {
    for file in examples() {
        let step = 1 + file.len() / 4096;
        for at in (0..file.len()).step_by(step) {
            for mask in [0x01, 0x04, 0x10, 0x80, 0xff] {
                let mut damaged = file.clone();
                damaged[at] ^= mask;
                survives(&damaged);
            }
        }
    }
}

/// A byte order mark, zeros behind a chunk of JSON, and a URI in capital letters (RFC 3986 and
/// RFC 2397).
#[test]
fn marks_zeros_and_capital_letters_are_read() {
    let [glb, json, _] = examples().try_into().unwrap();
    let marked = [b"\xef\xbb\xbf", &json[..]].concat();
    assert_eq!(decode(&marked).unwrap(), decode(&json).unwrap());
    let text = String::from_utf8(json.clone()).unwrap();
    let capitals = text.replace("data:;base64,", "DATA:;BASE64,");
    assert_ne!(capitals, text);
    assert_eq!(decode(capitals.as_bytes()).unwrap(), decode(&json).unwrap());

    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap());
    let end = 20 + length as usize;
    let mut padded = [&glb[..end], &[0; 4], &glb[end..]].concat();
    padded[12..16].copy_from_slice(&(length + 4).to_le_bytes());
    assert_eq!(decode(&with_length(padded)).unwrap(), decode(&glb).unwrap());
}

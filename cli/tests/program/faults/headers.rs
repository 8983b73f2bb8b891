//! Small files that claim to be large.

use std::path::Path;
use std::sync::OnceLock;

use tempfile::{TempDir, tempdir};

use super::table::{ROWS, Row, words};
use super::{assert_orderly, for_each, inputs, limited};
use crate::common::text;

const SIDE: u32 = 20_000;

/// The files, by what they take the place of.
const FILES: [(&str, &[&str]); 4] = [
    (
        "png pfm",
        &[
            "a.png", "a.jpg", "a.bmp", "a.tif", "a.webp", "a.pfm", "a.pgm", "a.y4m",
        ],
    ),
    ("y4m", &["a.y4m", "a.png"]),
    (
        "obj ply glb",
        &["a.ply", "b.ply", "a.glb", "a.gltf", "a.obj"],
    ),
    ("bvh clip", &["a.bvh", "a.clip", "a.glb"]),
];

fn folder() -> &'static Path {
    static FOLDER: OnceLock<TempDir> = OnceLock::new();
    FOLDER.get_or_init(make).path()
}

fn make() -> TempDir {
    let folder = tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    let of = |parts: &[&[u8]]| parts.concat();
    let [big, little] = [SIDE.to_be_bytes(), SIDE.to_le_bytes()];
    let side = u16::try_from(SIDE).unwrap();

    let header = of(&[b"IHDR", &big, &big, &[8, 2, 0, 0, 0]]);
    let check = crc32fast::hash(&header).to_be_bytes();
    let data = of(&[b"IDAT", &[0x78, 0x9C, 0x63, 0, 0]]);
    let data_check = crc32fast::hash(&data).to_be_bytes();
    let png = [
        b"\x89PNG\r\n\x1a\n\0\0\0\r",
        &header[..],
        &check,
        b"\0\0\0\x05",
        &data,
        &data_check,
    ];
    write("a.png", &of(&png));

    let frame = [
        8,
        side.to_be_bytes()[0],
        side.to_be_bytes()[1],
        side.to_be_bytes()[0],
    ];
    let jpeg = [
        b"\xFF\xD8\xFF\xC0\0\x0B",
        &frame[..],
        &[side.to_be_bytes()[1], 1, 1, 0x11, 0],
        b"\xFF\xDA\0\x08\x01\x01\0\0\x3F\0\0\0\xFF\xD9",
    ];
    write("a.jpg", &of(&jpeg));

    let bmp = [
        b"BM\x40\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0",
        &little[..],
        &little,
        b"\x01\0\x18\0",
    ];
    write("a.bmp", &of(&[&of(&bmp), &[0; 24][..], &[0; 10]]));

    let entry = |tag: u16, value: u32| {
        of(&[
            &tag.to_le_bytes(),
            &4u16.to_le_bytes(),
            &1u32.to_le_bytes(),
            &value.to_le_bytes(),
        ])
    };
    let fields = [
        entry(256, SIDE),
        entry(257, SIDE),
        entry(258, 8),
        entry(259, 1),
        entry(262, 1),
        entry(273, 8),
        entry(277, 1),
        entry(278, SIDE),
        entry(279, SIDE * SIDE),
    ];
    write(
        "a.tif",
        &of(&[b"II*\0\x08\0\0\0\x09\0", &fields.concat(), &[0; 8]]),
    );

    let bits = (SIDE - 1) | ((SIDE - 1) << 14);
    let vp8l = of(&[b"\x2F", &bits.to_le_bytes(), &[0; 5]]);
    write("a.webp", &of(&[b"RIFF\x16\0\0\0WEBPVP8L\x0A\0\0\0", &vp8l]));

    write("a.pfm", format!("PF\n{SIDE} {SIDE}\n-1.0\n0000").as_bytes());
    write("a.pgm", format!("P5 {SIDE} {SIDE} 255\n0000").as_bytes());
    write(
        "a.y4m",
        format!("YUV4MPEG2 W{SIDE} H{SIDE} F25:1 C420jpeg\nFRAME\n0000").as_bytes(),
    );

    let ply = |form: &str, vertices: u64, faces: u64| {
        format!(
            "ply\nformat {form} 1.0\nelement vertex {vertices}\nproperty float x\n\
             property float y\nproperty float z\nelement face {faces}\n\
             property list uchar int vertex_indices\nend_header\n"
        )
    };
    write(
        "a.ply",
        ply("ascii", 4_000_000_000, 4_000_000_000).as_bytes(),
    );
    let list = of(&[
        ply("binary_little_endian", 1, 1).as_bytes(),
        &[0; 12],
        &[255; 5],
    ]);
    write("b.ply", &list);
    write(
        "a.obj",
        b"v 0 0 0\nf 4000000000 -4000000000 99999999999999999999\n",
    );

    let json = r#"{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "accessors": [{"componentType": 5126, "type": "VEC3",
        "count": 4000000000, "min": [0, 0, 0], "max": [1, 1, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]}"#;
    write("a.gltf", json.as_bytes());
    let json = format!("{json}{}", " ".repeat((4 - json.len() % 4) % 4));
    let length = json.len() as u32;
    let all = (length + 20).to_le_bytes();
    let glb = [
        b"glTF\x02\0\0\0",
        &all[..],
        &length.to_le_bytes(),
        b"JSON",
        json.as_bytes(),
    ];
    write("a.glb", &of(&glb));

    let motion = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n\
                  End Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 4000000000\nFrame Time: 0.01\n";
    write("a.bvh", motion.as_bytes());
    let clip = std::fs::read(inputs::folder().join("walk.clip")).unwrap();
    let mut clip = clip[..clip.len() / 2].to_vec();
    clip[16..48].fill(0xFF);
    write("a.clip", &clip);
    folder
}

/// The row with each of its inputs in turn replaced by files that claim too much.
fn cases(row: &'static Row) -> Vec<(&'static Row, &'static str, &'static str)> {
    let mut cases = Vec::new();
    for input in row.inputs() {
        let ending = input.rsplit('.').next().unwrap();
        let files = FILES
            .iter()
            .filter(|(endings, _)| endings.split(' ').any(|e| e == ending));
        cases.extend(files.flat_map(|(_, files)| files.iter().map(|file| (row, input, *file))));
        // One of several pictures or films is enough.
        if ["png", "y4m"].contains(&ending) {
            break;
        }
    }
    cases
}

#[test]
fn files_that_claim_too_much_are_refused_without_memory_for_it() {
    let cases: Vec<_> = ROWS.iter().flat_map(cases).collect();
    for_each(&cases, |(row, input, file)| {
        let out = tempdir().unwrap();
        let huge = folder().join(file);
        let line = row
            .line
            .replace(&format!("DATA/{input}"), huge.to_str().unwrap());
        let output = limited(out.path(), &words(&line, inputs::folder(), "out"));
        assert_orderly(&output, &line);
        let status = output.status.code();
        // Of an animation without numbers, and of a board among others, the rest may do.
        if status == Some(1) {
            assert!(!out.path().join("out").exists(), "{line}");
        } else {
            let message = text(&output.stderr);
            let is_said = !message.is_empty() || line.contains("calibrate");
            assert!(is_said, "{line}: {status:?} without a word");
        }
    });
}

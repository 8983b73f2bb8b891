//! Pictures of every depth and orientation, as commands that measure read them.

use ga_image::plane::Plane;
use ga_image::{jpeg, png};
use serde_json::Value;

use crate::common::{assert_success, nullcone};

/// A texture of 10 bits without repetition, and the same further left by 7 px.
fn view(shift: usize) -> Plane<u16> {
    Plane::from_fn(120, 80, |column, row| {
        let block = |u: usize, v: usize| (u + 3) * 7919 * (v + 5) + u * 104_729;
        let fine = block(column + shift, row);
        let coarse = block((column + shift) / 6, row / 6);
        (((fine * fine / 977) % 512) + ((coarse * coarse / 977) % 512)) as u16
    })
}

fn matched(folder: &tempfile::TempDir, left: &str, right: &str) -> Value {
    let output = nullcone(
        folder.path(),
        [
            "stereo",
            "match",
            left,
            right,
            "--max-disparity",
            "16",
            "--out",
            "d.pfm",
            "--json",
        ],
    );
    assert_success(&output);
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Cameras of 10 bits write their numbers into files of 16 as they are.
#[test]
fn numbers_of_10_bits_are_matched_as_those_of_8() {
    let folder = tempfile::tempdir().unwrap();
    let write =
        |name: &str, bytes: Vec<u8>| std::fs::write(folder.path().join(name), bytes).unwrap();
    for (name, shift) in [("left", 0), ("right", 7)] {
        let deep = view(shift);
        write(&format!("{name}10.png"), png::encode(&deep).unwrap());
        let bytes = deep.map(|v| (v >> 2) as u8);
        write(&format!("{name}8.png"), png::encode(&bytes).unwrap());
    }
    for depth in ["8", "10"] {
        let report = matched(
            &folder,
            &format!("left{depth}.png"),
            &format!("right{depth}.png"),
        );
        assert!(
            report["mean_confidence"].as_f64().unwrap() > 0.5,
            "{report}"
        );
        let map = ga_vision::disparity::file::read(folder.path().join("d.pfm"), None).unwrap();
        let right = map
            .plane()
            .values()
            .iter()
            .filter(|d| (**d - 7.0).abs() < 0.5);
        assert!(right.count() > 110 * 80, "{depth} bits");
    }
}

/// A camera on its side: the pictures are upright, and both files are named.
#[test]
fn an_orientation_that_is_applied_is_said() {
    let folder = tempfile::tempdir().unwrap();
    for (name, shift) in [("left.jpg", 0), ("right.jpg", 7)] {
        let grey = view(shift).map(|v| [(v >> 2) as u8; 3]);
        // What is stored is to be rotated by 90° clockwise: its rows run upwards in the picture.
        let stored = Plane::from_fn(80, 120, |column, row| grey.row(column)[119 - row]);
        let bytes = jpeg::encode(&stored, 95).unwrap();
        let exif = b"Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0";
        let length = (exif.len() as u16 + 2).to_be_bytes();
        let bytes = [&bytes[..2], b"\xff\xe1", &length, exif, &bytes[2..]].concat();
        std::fs::write(folder.path().join(name), bytes).unwrap();
    }
    let report = matched(&folder, "left.jpg", "right.jpg");
    assert_eq!(
        (&report["width_px"], &report["height_px"]),
        (&120.into(), &80.into())
    );
    assert!(
        (report["greatest_px"].as_f64().unwrap() - 7.0).abs() < 1.0,
        "{report}"
    );
    let warnings = report["warnings"].as_array().unwrap();
    assert_eq!(warnings.len(), 2);
    for (warning, name) in warnings.iter().zip(["left.jpg", "right.jpg"]) {
        assert_eq!(warning["kind"], "orientation_applied");
        assert_eq!(warning["file"], name);
    }
}

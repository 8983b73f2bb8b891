//! `nullcone stereo rectify`, `undistort` and `diagnose`: views and the cameras that took them.

use std::path::Path;

use ga_camera::format::{self, CameraFile};
use ga_image::plane::Plane;
use nullcone_shared_data::shared;
use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, names, nullcone, number, text};

/// Blocks of random grey, larger and smaller ones, without an end.
fn texture(u: i64, v: i64) -> u8 {
    let block = |size: i64| {
        let (a, b) = (u.div_euclid(size) as u64, v.div_euclid(size) as u64);
        let mixed = (a.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ b.wrapping_mul(0xC2B2_AE3D_27D4_EB4F))
            .wrapping_mul(0xD6E8_FEB8_6659_FD93);
        mixed >> 57
    };
    (block(7) + block(19)) as u8
}

/// Views of 240 × 180 pixels, the right one with everything 6 pixels further left and `lower`
/// pixels further down.
fn views(lower: i64) -> TempDir {
    let folder = tempdir().unwrap();
    for (name, across, down) in [("left.png", 0, 0), ("right.png", 6, lower)] {
        let view = Plane::from_fn(240, 180, |u, v| texture(u as i64 + across, v as i64 - down));
        ga_image::file::write(folder.path().join(name), &view).unwrap();
    }
    folder
}

const K: &str = "[ [ 200, 0, 119.5 ], [ 0, 200, 89.5 ], [ 0, 0, 1 ] ]";

fn write_rig(folder: &Path, translation: &str) {
    let text = format!(
        "%YAML:1.0\n---\nimage_width: 240\nimage_height: 180\nM1: {K}\nM2: {K}\n\
         R: [ [ 1, 0, 0 ], [ 0, 1, 0 ], [ 0, 0, 1 ] ]\nT: {translation}\n"
    );
    std::fs::write(folder.join("rig.yml"), text).unwrap();
}

const RECTIFY: [&str; 7] = [
    "stereo",
    "rectify",
    "left.png",
    "right.png",
    "--rig",
    "rig.yml",
    "--out",
];

#[test]
fn rectified_views_stay_as_they_are() {
    let folder = views(0);
    write_rig(folder.path(), "[ -0.1, 0, 0 ]");
    let output = nullcone(folder.path(), RECTIFY.iter().chain(&["new", "--json"]));
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    for (key, expected) in [
        ("/width_px", 240.0),
        ("/height_px", 180.0),
        ("/focal_px", 200.0),
        ("/disparity_offset_px", 0.0),
        ("/baseline_metres", 0.1),
        ("/left_rotation_degrees", 0.0),
        ("/right_rotation_degrees", 0.0),
    ] {
        assert!(
            (number(&report, key) - expected).abs() < 1e-9,
            "{key}: {report}"
        );
    }
    for name in ["left.png", "right.png"] {
        let [old, new] = [folder.path().to_path_buf(), folder.path().join("new")]
            .map(|folder| ga_image::file::read(folder.join(name)).unwrap());
        assert_eq!(old, new, "{name}");
    }
    // The new rig is one that can be read again, with the matrices that OpenCV would return.
    let file = format::read(folder.path().join("new/rig.yml")).unwrap();
    assert!((file.rig(&[]).unwrap().baseline() - 0.1).abs() < 1e-15);
    let written = std::fs::read_to_string(folder.path().join("new/rig.yml")).unwrap();
    for name in ["R1", "R2", "P1", "P2", "Q"] {
        assert!(
            written.contains(&format!("\n{name}: !!opencv-matrix\n")),
            "{written}"
        );
    }
}

/// The right camera stands 10 cm below the left one: both views are put on their side.
#[test]
fn cameras_one_above_the_other_give_views_with_common_rows() {
    let folder = tempdir().unwrap();
    for (name, down) in [("left.png", 0), ("right.png", 6)] {
        let view = Plane::from_fn(240, 180, |u, v| texture(u as i64, v as i64 + down));
        ga_image::file::write(folder.path().join(name), &view).unwrap();
    }
    write_rig(folder.path(), "[ 0, -0.1, 0 ]");
    let output = nullcone(folder.path(), RECTIFY.iter().chain(&["new", "--json"]));
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    for (key, expected) in [
        ("/width_px", 180.0),
        ("/height_px", 240.0),
        ("/left_roll_degrees", -90.0),
        ("/right_roll_degrees", -90.0),
        ("/left_rotation_degrees", 90.0),
        ("/baseline_metres", 0.1),
    ] {
        assert!((number(&report, key) - expected).abs() < 1e-9, "{key}");
    }
    // What was below is now to the right.
    let [old, new] = [folder.path().to_path_buf(), folder.path().join("new")]
        .map(|folder| ga_image::file::read(folder.join("left.png")).unwrap());
    let [old, new]: [Plane<u8>; 2] =
        [old, new].map(|picture| picture.to_grey(ga_image::grey::Luma::Bt601));
    let rolled = Plane::from_fn(180, 240, |u, v| old.get(239 - v, u).unwrap());
    assert_eq!(new, rolled);
    let matched = "stereo match new/left.png new/right.png --max-disparity 32 --out d.pfm --json";
    let output = nullcone(folder.path(), matched.split(' '));
    assert_success(&output);
    let map = ga_vision::disparity::file::read(folder.path().join("d.pfm"), None).unwrap();
    let middle = map.get(90, 120).unwrap();
    assert!((middle - 6.0).abs() < 0.1, "{middle}");
}

#[test]
fn a_chessboard_pair_is_rectified() {
    let (Some(truth), Some(pictures)) = (
        shared("oracle/vision/seed1/truth.json"),
        shared("data/vision/opencv"),
    ) else {
        return;
    };
    let truth: Value = serde_json::from_slice(&std::fs::read(truth).unwrap()).unwrap();
    let board = &truth["chessboard"];
    let mut text = String::from("%YAML:1.0\nimage_width: 640\nimage_height: 480\n");
    for (name, key) in [
        ("M1", "K_left"),
        ("M2", "K_right"),
        ("D1", "D_left"),
        ("D2", "D_right"),
        ("R", "R"),
        ("T", "t"),
    ] {
        text.push_str(&format!("{name}: {}\n", board[key]));
    }
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("rig.yml"), text).unwrap();
    for side in ["left", "right"] {
        let name = pictures.join(format!("{side}01.jpg"));
        std::fs::copy(name, folder.path().join(format!("{side}.png"))).unwrap();
    }
    let rectified = RECTIFY.iter().chain(&["new", "--alpha", "0", "-q"]);
    assert_success(&nullcone(folder.path(), rectified));
    let diagnose = |left: &str, right: &str| -> Value {
        let output = nullcone(folder.path(), ["stereo", "diagnose", left, right, "--json"]);
        assert_success(&output);
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let before = diagnose("left.png", "right.png");
    let after = diagnose("new/left.png", "new/right.png");
    assert_eq!(
        (&before["rectified"], &after["rectified"]),
        (&false.into(), &true.into())
    );
    assert!(
        number(&after, "/vertical_disparity_rms_px") < 0.5,
        "{after}"
    );
    assert!(number(&after, "/rotation_degrees").abs() < 0.1, "{after}");
    assert!((number(&after, "/zoom") - 1.0).abs() < 0.005, "{after}");
    assert_eq!(after["views_exchanged"], false);
}

#[test]
fn a_pinhole_has_no_distortion_to_remove() {
    let folder = views(0);
    // A pose is kept.
    let pose = "R: [ 0., -1., 0., 1., 0., 0., 0., 0., 1. ]\nT: [ 0.5, 0.25, -2. ]\n";
    let camera = format!("%YAML:1.0\ncamera_matrix: {K}\nimage_size: [ 240, 180 ]\n{pose}");
    std::fs::write(folder.path().join("k.yml"), camera).unwrap();
    let arguments = [
        "stereo",
        "undistort",
        "left.png",
        "--camera",
        "k.yml",
        "--out",
        "new.png",
        "--new-camera",
        "new.yml",
        "--json",
    ];
    let output = nullcone(folder.path(), arguments);
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(number(&report, "/unseen_percent"), 0.0);
    assert_eq!(number(&report, "/focal_px/1"), 200.0);
    assert_eq!(number(&report, "/principal_px/0"), 119.5);
    let [old, new] =
        ["left.png", "new.png"].map(|name| ga_image::file::read(folder.path().join(name)).unwrap());
    assert_eq!(old, new);
    let [mut old, mut new] = ["k.yml", "new.yml"].map(|name| {
        let path = folder.path().join(name);
        format::read(path).unwrap()
    });
    let pose = |file: &mut CameraFile| file.cameras[0].pose.take().unwrap().to_matrix();
    let poses = [pose(&mut old), pose(&mut new)].map(|rows| rows.into_iter().flatten());
    let [old_pose, new_pose] = poses;
    assert!(old_pose.zip(new_pose).all(|(a, b)| (a - b).abs() < 1e-12));
    assert_eq!(old, new);

    // A camera in a picture.
    let before = names(folder.path());
    let arguments = "undistort left.png --camera k.yml --out a.png --new-camera ./a.png";
    let arguments: Vec<&str> = ["stereo"].into_iter().chain(arguments.split(' ')).collect();
    let output = nullcone(folder.path(), arguments);
    let message = "--new-camera ./a.png: its name must end in .yml or .yaml";
    assert_failure(&output, &[message]);
    assert_eq!(names(folder.path()), before);
}

#[test]
fn a_vertical_offset_is_diagnosed() {
    for lower in [0, 3] {
        let folder = views(lower);
        let arguments = ["stereo", "diagnose", "left.png", "right.png"];
        let output = nullcone(folder.path(), arguments.iter().chain(&["--json"]));
        assert_success(&output);
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(report["rectified"], lower == 0);
        assert!(
            (number(&report, "/vertical_offset_px") - lower as f64).abs() < 0.1,
            "{report}"
        );
        assert!(number(&report, "/rotation_degrees").abs() < 0.1, "{report}");
        assert!((number(&report, "/zoom") - 1.0).abs() < 2e-3, "{report}");
        assert!(
            (number(&report, "/disparity_median_px") - 6.0).abs() < 0.1,
            "{report}"
        );
        let output = nullcone(folder.path(), arguments);
        let expected = if lower == 0 {
            "the views are rectified\n"
        } else {
            "the views are not"
        };
        assert!(text(&output.stdout).starts_with(expected));
    }
}

#[test]
fn bad_rigs_and_views_write_nothing() {
    let folder = views(0);
    let refused = |message: &str| {
        let output = nullcone(folder.path(), RECTIFY.iter().chain(&["new"]));
        assert_failure(&output, &[message]);
        assert!(!names(folder.path()).contains(&"new".to_owned()));
    };
    refused("cannot read rig.yml");
    write_rig(folder.path(), "[ 0, 0, 0 ]");
    refused("rig.yml: line 8: `T` is zero");
    write_rig(folder.path(), "[ -0.1, .nan, 0 ]");
    refused("rig.yml: line 8: `T` has the value NaN");
    write_rig(folder.path(), "[ 0.1, 0, 0 ]");
    refused("the views are exchanged");
    write_rig(folder.path(), "[ 0, 0.01, -0.2 ]");
    refused("before or behind it, not beside it");
    std::fs::write(folder.path().join("rig.yml"), b"\x89PNG\r\n\x1a\n").unwrap();
    refused("rig.yml: line 1: not text in UTF-8");
    std::fs::write(folder.path().join("rig.yml"), "a: [ 1, 2\n").unwrap();
    refused("rig.yml: line");
    write_rig(folder.path(), "[ -0.1, 0, 0 ]");
    let other = Plane::filled(200, 180, 9u8);
    ga_image::file::write(folder.path().join("right.png"), &other).unwrap();
    refused("the views differ in size");
    ga_image::file::write(folder.path().join("left.png"), &other).unwrap();
    refused("left.png has 200 × 180 pixels, and rig.yml is for 240 × 180");
}

#[test]
fn views_that_cannot_be_diagnosed() {
    let folder = views(0);
    let diagnose = |left: &str, right: &str, message: &str| {
        let output = nullcone(folder.path(), ["stereo", "diagnose", left, right]);
        assert_failure(&output, &[message]);
    };
    let flat = Plane::filled(240, 180, 90u8);
    ga_image::file::write(folder.path().join("flat.png"), &flat).unwrap();
    diagnose(
        "flat.png",
        "flat.png",
        "0 pairs of points are given, and at least 3 are needed",
    );
    let small = Plane::filled(24, 18, 90u8);
    ga_image::file::write(folder.path().join("small.png"), &small).unwrap();
    diagnose("left.png", "small.png", "the views differ in size");
    std::fs::write(folder.path().join("broken.png"), b"\x89PNG\r\n\x1a\n").unwrap();
    diagnose("left.png", "broken.png", "broken.png");
}

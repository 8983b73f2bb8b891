//! `nullcone clip`: compressed clips written, described and sampled.

use nullcone_shared_data::shared;
use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, json, names, nullcone, text};

/// An arm of two joints that waves, in centimetres.
fn folder() -> TempDir {
    let mut motion = "HIERARCHY\nROOT arm\n{\nOFFSET 0 100 0\nCHANNELS 4 Xposition Zrotation Yrotation Xrotation\n\
         JOINT hand\n{\nOFFSET 30 0 0\nCHANNELS 1 Zrotation\nEnd Site\n{\nOFFSET 10 0 0\n}\n}\n}\n\
         MOTION\nFrames: 100\nFrame Time: 0.01\n"
        .to_owned();
    for frame in 0..100 {
        let t = f64::from(frame) * 0.1;
        let (x, z, y) = (10.0 * t.sin(), 30.0 * t.cos(), 20.0 * (2.0 * t).sin());
        motion += &format!("{x} {z} {y} 5 {}\n", 40.0 * t.sin());
    }
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("wave.bvh"), motion).unwrap();
    folder
}

const COMPRESS: [&str; 9] = [
    "clip",
    "compress",
    "wave.bvh",
    "--metres-per-unit",
    "0.01",
    "--tolerance",
    "0.0001",
    "--out",
    "wave.clip",
];

/// The matrices of a sample, by joint.
fn matrices(sample: &Value) -> Vec<(String, [[f64; 4]; 3])> {
    let joints = sample["joints"].as_array().unwrap();
    let matrix = |joint: &Value| serde_json::from_value(joint["matrix"].clone()).unwrap();
    let name = |joint: &Value| joint["joint"].as_str().unwrap().to_owned();
    joints
        .iter()
        .map(|joint| (name(joint), matrix(joint)))
        .collect()
}

/// The greatest distance of the image of a corner of a cube of this half-width.
fn distance(a: &[[f64; 4]; 3], b: &[[f64; 4]; 3], half_width: f64) -> f64 {
    let mut greatest = 0.0f64;
    for corner in 0..8 {
        let x = [0, 1, 2].map(|k| half_width * f64::from(1 - 2 * (corner >> k & 1)));
        let image =
            |m: &[[f64; 4]; 3]| m.map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3]);
        let (a, b) = (image(a), image(b));
        let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
        greatest = greatest.max(square.sqrt());
    }
    greatest
}

#[test]
fn a_clip_is_small_and_its_samples_are_those_of_the_motion() {
    let folder = folder();
    let report = json(folder.path(), &COMPRESS);
    assert_eq!(report["frames"], 100);
    assert_eq!(report["joints"], 2);
    assert_eq!(report["raw_bytes"], 100 * 2 * 40);
    let written = std::fs::metadata(folder.path().join("wave.clip"))
        .unwrap()
        .len();
    let bytes = report["bytes"].as_u64().unwrap();
    assert_eq!(bytes, written - "armhand".len() as u64);
    assert_eq!(report["ratio"].as_f64().unwrap(), 8000.0 / bytes as f64);
    assert!(report["ratio"].as_f64().unwrap() > 9.0);
    let error = report["max_error_metres"].as_f64().unwrap();
    assert!(error > 0.0 && error <= 1e-4);
    assert!(report["half_frame_error_metres"].as_f64().unwrap() <= 1.1e-4);

    let times = ["--times", "0,0.01,0.37,0.99"];
    let clip = json(
        folder.path(),
        &[&["clip", "sample", "wave.clip"][..], &times].concat(),
    );
    let unit = ["--metres-per-unit", "0.01"];
    let truth = json(
        folder.path(),
        &[&["clip", "sample", "wave.bvh"][..], &times, &unit].concat(),
    );
    let samples = clip["samples"].as_array().unwrap();
    assert_eq!(samples.len(), 4);
    let mut greatest = 0.0f64;
    for (found, truth) in samples.iter().zip(truth["samples"].as_array().unwrap()) {
        assert_eq!(found["time"], truth["time"]);
        for ((name, found), (expected, truth)) in matrices(found).iter().zip(matrices(truth)) {
            assert_eq!(*name, expected);
            // The corners of this cube are 3 cm from the joint.
            greatest = greatest.max(distance(found, &truth, 0.03 / 3f64.sqrt()));
        }
    }
    assert!(greatest > 0.0 && greatest <= error, "{greatest}");

    // The root in frame 37, from the formulas of the file.
    let (t, root) = (3.7f64, &matrices(&truth["samples"][2])[0].1);
    let (z, y) = (
        (30.0 * t.cos()).to_radians(),
        (20.0 * (2.0 * t).sin()).to_radians(),
    );
    assert!((root[0][3] - 0.1 * t.sin()).abs() < 1e-12 && (root[1][3] - 1.0).abs() < 1e-12);
    assert!((root[0][0] - z.cos() * y.cos()).abs() < 1e-12);
    assert!((root[2][0] + y.sin()).abs() < 1e-12);
}

#[test]
fn info_says_what_was_compressed_and_what_it_replaces() {
    let folder = folder();
    let own = [&COMPRESS[..], &["--joint", "hand=0.00002,0.1"]].concat();
    let report = json(folder.path(), &own);
    let info = json(
        folder.path(),
        &["clip", "info", "wave.clip", "--mesh-vertices", "5000"],
    );
    for key in [
        "bytes",
        "raw_bytes",
        "ratio",
        "frames",
        "joints",
        "bytes_per_frame",
    ] {
        assert_eq!(info[key], report[key], "{key}");
    }
    assert_eq!(info["mesh_bytes_per_frame"], 60_000);
    let ratio = 60_000.0 / info["bytes_per_frame"].as_f64().unwrap();
    assert_eq!(info["mesh_ratio"].as_f64().unwrap(), ratio);
    assert!(info["decoded_frames_per_second"].as_f64().unwrap() > 0.0);
    assert_eq!(info["tolerance_metres"], 1e-4);
    assert_eq!(info["shell_metres"], 0.03);
    assert_eq!(info["joint_bounds"][0]["joint"], "hand");
    assert_eq!(info["joint_bounds"][0]["tolerance_metres"], 2e-5);
    assert_eq!(info["joint_names"], serde_json::json!(["arm", "hand"]));
    assert_eq!(info["joint_parents"], serde_json::json!([null, 0]));
    let output = nullcone(folder.path(), ["clip", "info", "wave.clip"]);
    assert_success(&output);
    assert!(text(&output.stdout).contains("100 frames of 2 joints, 0.99 s at 100.00 Hz"));
}

#[test]
fn bad_input_is_one_line_and_writes_nothing() {
    let folder = folder();
    let path = folder.path();
    std::fs::write(path.join("note.txt"), "hello").unwrap();
    std::fs::write(path.join("empty.clip"), "").unwrap();
    let before = names(path);
    let run = |arguments: &[&str]| nullcone(path, arguments);
    let with = |name: &'static str, value: &'static str| {
        let mut arguments = COMPRESS.to_vec();
        match arguments.iter().position(|&argument| argument == name) {
            Some(at) => arguments[at + 1] = value,
            None => arguments.extend([name, value]),
        }
        run(&arguments)
    };
    for value in ["0", "-1", "nan", "inf"] {
        assert_failure(
            &with("--tolerance", value),
            &["wave.bvh", "the tolerance must be positive"],
        );
        assert_failure(
            &with("--metres-per-unit", value),
            &["--metres-per-unit", "greater than 0"],
        );
    }
    assert_failure(&with("--shell", "-1"), &["the shell must be positive"]);
    assert_failure(
        &with("--joint", "foot=0.1"),
        &["--joint foot", "no such joint"],
    );
    assert_failure(
        &run(&["clip", "sample", "note.txt", "--times", "0"]),
        &["note.txt", ".bvh"],
    );
    assert_failure(
        &run(&["clip", "sample", "none.clip", "--times", "0"]),
        &["cannot read none.clip"],
    );
    assert_failure(
        &run(&["clip", "sample", "wave.bvh", "--times", "inf"]),
        &["--times inf"],
    );
    assert_failure(
        &run(&["clip", "info", "empty.clip"]),
        &["empty.clip", "not a compressed clip"],
    );
    assert_eq!(names(path), before);

    assert_success(&run(&COMPRESS));
    let mut bytes = std::fs::read(path.join("wave.clip")).unwrap();
    bytes[200] ^= 1;
    std::fs::write(path.join("wave.clip"), &bytes).unwrap();
    assert_failure(
        &run(&["clip", "info", "wave.clip"]),
        &["wave.clip", "damaged"],
    );
    let again = [
        "clip",
        "compress",
        "wave.clip",
        "--tolerance",
        "1",
        "--out",
        "b.clip",
    ];
    assert_failure(&run(&again), &["wave.clip", "already compressed"]);
}

#[test]
fn options_that_do_not_apply_are_refused() {
    let folder = folder();
    assert_success(&nullcone(folder.path(), COMPRESS));
    let sample = |motion: &str, option: &str| {
        let arguments = ["clip", "sample", motion, "--times", "0", option, "1"];
        nullcone(folder.path(), arguments)
    };
    for option in ["--metres-per-unit", "--animation", "--rate"] {
        assert_failure(&sample("wave.clip", option), &["wave.clip", option]);
    }
    for option in ["--animation", "--rate"] {
        assert_failure(&sample("wave.bvh", option), &["wave.bvh", option]);
    }
}

#[test]
fn a_gltf_animation_is_compressed_and_sampled() {
    let Some(path) = shared("data/anim/gltf/Fox.glb") else {
        return;
    };
    let folder = tempdir().unwrap();
    let model = path.to_str().unwrap();
    let out = ["--tolerance", "0.02", "--shell", "3", "--out", "fox.clip"];
    let report = json(
        folder.path(),
        &[&["clip", "compress", model, "--animation", "1"][..], &out].concat(),
    );
    assert!(report["max_error_metres"].as_f64().unwrap() <= 0.02);
    assert!(report["mesh_vertices"].as_u64().unwrap() > 0);
    // At its keys, 24 in a second, the clip is near the document's own curves.
    let times = ["--times", "0,0.125,0.25,0.5"];
    let clip = json(
        folder.path(),
        &[&["clip", "sample", "fox.clip"][..], &times].concat(),
    );
    let truth = [&["clip", "sample", model, "--animation", "1"][..], &times].concat();
    let truth = json(folder.path(), &truth);
    let mut count = 0;
    for sample in 0..4 {
        let pairs = matrices(&clip["samples"][sample])
            .into_iter()
            .zip(matrices(&truth["samples"][sample]));
        for ((name, found), (expected, truth)) in pairs {
            assert_eq!(name, expected);
            assert!(
                distance(&found, &truth, 3.0 / 3f64.sqrt()) <= 0.0201,
                "{name}"
            );
            count += 1;
        }
    }
    assert!(count > 80);
}

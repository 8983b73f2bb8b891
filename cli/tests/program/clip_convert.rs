//! Motions in other formats, and the unit that every command finds for them.

use std::path::Path;

use nullcone_shared_data::shared;
use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, json, nullcone, text};

/// A folder with a person in CMU's unit and one in centimetres.
fn folder() -> TempDir {
    let folder = tempdir().unwrap();
    let units = Path::new(env!("CARGO_MANIFEST_DIR")).join("../anim/tests/data/units");
    for name in ["cmu_unit.bvh", "lying_cm.bvh"] {
        std::fs::copy(units.join(name), folder.path().join(name)).unwrap();
    }
    folder
}

/// The places of all joints at some times, in metres, by name.
fn places(folder: &Path, motion: &str) -> Vec<(String, [f64; 3])> {
    let sample = ["clip", "sample", motion, "--times", "0,0.2,0.5,0.9"];
    let mut places = Vec::new();
    for sample in json(folder, &sample)["samples"].as_array().unwrap() {
        let mut joints: Vec<(String, [f64; 3])> = Vec::new();
        for joint in sample["joints"].as_array().unwrap() {
            let rows: [[f64; 4]; 3] = serde_json::from_value(joint["matrix"].clone()).unwrap();
            let name = joint["joint"].as_str().unwrap().to_owned();
            joints.push((name, rows.map(|row| row[3])));
        }
        joints.sort_by(|a, b| a.0.cmp(&b.0));
        places.extend(joints);
    }
    places
}

#[track_caller]
fn assert_same_places(folder: &Path, [a, b]: [&str; 2], bound: f64) {
    let (found, truth) = (places(folder, a), places(folder, b));
    assert_eq!(found.len(), truth.len());
    for ((name, found), (expected, truth)) in found.iter().zip(&truth) {
        assert_eq!(name, expected);
        for (found, truth) in found.iter().zip(truth) {
            assert!((found - truth).abs() < bound, "{name}: {found} for {truth}");
        }
    }
}

fn kinds(report: &Value) -> Vec<&str> {
    let warnings = report["warnings"].as_array().unwrap();
    warnings
        .iter()
        .map(|w| w["kind"].as_str().unwrap())
        .collect()
}

#[test]
fn a_motion_comes_back_from_every_format() {
    let folder = folder();
    let path = folder.path();
    let convert = |from: &str, to: &str| json(path, &["clip", "convert", from, "--out", to]);
    for motion in ["cmu_unit.bvh", "lying_cm.bvh"] {
        let report = convert(motion, "same.bvh");
        assert_eq!(report["frames"], 30);
        assert_eq!(kinds(&report), [""; 0]);
        assert_same_places(path, ["same.bvh", motion], 1e-9);
        for format in ["glb", "gltf"] {
            let other = format!("there.{format}");
            assert_eq!(kinds(&convert(motion, &other)), ["end_sites_left_out"]);
            let back = convert(&other, "back.bvh");
            assert_eq!(back["frames"], 30);
            assert_same_places(path, [&other, motion], 1e-6);
            assert_same_places(path, ["back.bvh", motion], 1e-6);
        }
        convert(motion, "there.clip");
        convert("there.clip", "back.bvh");
        convert("there.clip", "back.GLB");
        assert_same_places(path, ["back.bvh", motion], 2e-4);
        assert_same_places(path, ["back.GLB", motion], 2e-4);
    }
    // In centimetres.
    let out = ["--out", "cm.bvh", "--out-metres-per-unit", "0.01"];
    let report = json(
        path,
        &[&["clip", "convert", "cmu_unit.bvh"][..], &out].concat(),
    );
    assert_eq!(report["out_metres_per_unit"], 0.01);
    let info = json(path, &["clip", "info", "cm.bvh"]);
    assert_eq!(info["metres_per_unit"], 0.01);
    assert_same_places(path, ["cm.bvh", "cmu_unit.bvh"], 1e-9);
}

#[test]
fn every_command_finds_the_same_unit() {
    let folder = folder();
    let path = folder.path();
    for (motion, unit) in [("cmu_unit.bvh", 0.0254 / 0.45), ("lying_cm.bvh", 0.01)] {
        let out = ["--out", "out.clip"];
        for command in [
            &["clip", "info", motion][..],
            &["clip", "sample", motion, "--times", "0"],
            &["clip", "convert", motion, "--out", "o.glb"],
            &[
                &["clip", "compress", motion, "--tolerance", "0.001"][..],
                &out,
            ]
            .concat(),
            &[&["clip", "resample", motion, "--rate", "20"][..], &out].concat(),
            &[&["clip", "mirror", motion][..], &out].concat(),
            &[
                &["clip", "blend", motion, motion, "--weights", "1,2"][..],
                &out,
            ]
            .concat(),
            &[
                "clip", "retarget", motion, "--target", motion, "--out", "o.bvh",
            ],
        ] {
            let report = json(path, command);
            assert_eq!(report["metres_per_unit"], unit, "{command:?}");
            assert!(!kinds(&report).contains(&"unclear_unit"), "{command:?}");
        }
        let given = ["clip", "info", motion, "--metres-per-unit", "0.5"];
        assert_eq!(json(path, &given)["metres_per_unit"], 0.5);
    }
}

#[test]
fn a_unit_that_is_not_clear_is_said() {
    let folder = tempdir().unwrap();
    let arm = "HIERARCHY ROOT arm { OFFSET 0 0 0 CHANNELS 1 Zrotation }\n\
               MOTION Frames: 2 Frame Time: 0.1\n1\n2\n";
    std::fs::write(folder.path().join("arm.bvh"), arm).unwrap();
    let report = json(folder.path(), &["clip", "info", "arm.bvh"]);
    assert_eq!(report["metres_per_unit"], 1.0);
    assert_eq!(kinds(&report), ["unclear_unit"]);
    let message = report["warnings"][0]["message"].as_str().unwrap();
    assert!(message.contains("1 m is taken") && message.contains("--metres-per-unit"));
}

#[test]
fn the_frames_of_input_and_output_are_told_apart() {
    let folder = folder();
    let resample = ["clip", "resample", "lying_cm.bvh", "--rate", "10", "--out"];
    for out in ["r.bvh", "r.glb", "r.clip"] {
        let output = nullcone(folder.path(), resample.iter().chain(&[out]));
        assert_success(&output);
        let lines: Vec<&str> = text(&output.stdout).lines().collect();
        assert!(lines[0].starts_with("lying_cm.bvh: 30 frames"), "{lines:?}");
        assert!(
            lines[1].starts_with(&format!("{out}: 10 frames")),
            "{lines:?}"
        );
    }
    let report = json(folder.path(), &[&resample[..], &["r.bvh"]].concat());
    assert_eq!(
        (&report["frames"], &report["inputs"][0]["frames"]),
        (&10.into(), &30.into())
    );
}

#[test]
fn what_does_not_fit_single_precision_names_the_distance() {
    let folder = folder();
    let path = folder.path();
    let text = std::fs::read_to_string(path.join("lying_cm.bvh")).unwrap();
    let (head, frames) = text.split_once("Frame Time: 0.033333\n").unwrap();
    let far = frames.lines().map(|line| {
        let (_, others) = line.split_once(' ').unwrap();
        format!("54300.3 {others}\n")
    });
    let far = format!("{head}Frame Time: 0.033333\n{}", far.collect::<String>());
    std::fs::write(path.join("far.bvh"), far).unwrap();
    let compress = [
        "clip",
        "compress",
        "far.bvh",
        "--out",
        "x.clip",
        "--tolerance",
    ];
    let failed = nullcone(path, compress.iter().chain(&["0.00001"]));
    assert_failure(&failed, &["far.bvh", "0.01 m", "from the origin"]);
    assert_success(&nullcone(path, compress.iter().chain(&["0.001"])));
}

#[test]
fn options_of_clips_are_refused_for_other_formats() {
    let folder = folder();
    let convert = ["clip", "convert", "lying_cm.bvh", "--out"];
    for (out, option) in [
        ("x.bvh", ["--tolerance", "0.1"]),
        ("x.glb", ["--shell", "0.1"]),
        ("x.clip", ["--out-metres-per-unit", "0.1"]),
    ] {
        let run = nullcone(folder.path(), convert.iter().chain(&[out]).chain(&option));
        assert_failure(&run, &[option[0], "does not apply", out]);
    }
    let unknown = nullcone(folder.path(), convert.iter().chain(&["x.txt"]));
    assert_failure(&unknown, &["--out x.txt", ".bvh"]);
}

#[test]
fn shorter_motions_are_repeated_or_named() {
    let Some(file) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let folder = tempdir().unwrap();
    let path = folder.path();
    let text = std::fs::read_to_string(&file).unwrap();
    let (head, frames) = text.split_once("MOTION").unwrap();
    let lines: Vec<&str> = frames.trim_start().lines().collect();
    let third = lines[2..][..917].join("\n");
    let third = format!("{head}MOTION\nFrames: 917\n{}\n{third}\n", lines[1]);
    std::fs::write(path.join("third.bvh"), third).unwrap();
    let blend = [
        "clip",
        "blend",
        file.to_str().unwrap(),
        "third.bvh",
        "--weights",
        "1,1",
    ];
    let out = ["--out", "mean.bvh"];
    let report = json(path, &[&blend[..], &out].concat());
    assert_eq!(kinds(&report), ["ends_early"]);
    let message = report["warnings"][0]["message"].as_str().unwrap();
    assert_eq!(report["warnings"][0]["file"], "third.bvh");
    assert!(message.contains("7.63 s"), "{message}");
    let looped = json(path, &[&blend[..], &["--loop"], &out].concat());
    assert_eq!(looped["frames"], 2752);
    assert!(!kinds(&looped).contains(&"ends_early"));
    // A motion without steps is an error that names it.
    let arm = "HIERARCHY ROOT arm { OFFSET 0 0 0 CHANNELS 1 Zrotation }\n\
               MOTION Frames: 2 Frame Time: 0.1\n1\n2\n";
    std::fs::write(path.join("arm.bvh"), arm).unwrap();
    let blend = [
        "clip",
        "blend",
        "arm.bvh",
        "arm.bvh",
        "--weights",
        "1,1",
        "--align-phases",
    ];
    let failed = nullcone(path, blend.iter().chain(&out));
    assert_failure(&failed, &["arm.bvh", "--align-phases", "no steps"]);
}

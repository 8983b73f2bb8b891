//! `nullcone clip resample`, `mirror` and `blend`.

use std::fmt::Write as _;
use std::path::Path;

use nullcone_shared_data::shared;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, json, names, nullcone, text};

/// A body with an arm on either side, in centimetres, for 0.49 s at 100 Hz.
fn body(left: &str, right: &str, angle: f64) -> String {
    let mut motion = format!(
        "HIERARCHY\nROOT Hips\n{{\nOFFSET 0 0 0\nCHANNELS 4 Xposition Yposition Zposition Yrotation\n\
         JOINT {left}\n{{\nOFFSET 20 40 0\nCHANNELS 1 Zrotation\nEnd Site\n{{\nOFFSET 30 0 0\n}}\n}}\n\
         JOINT {right}\n{{\nOFFSET -20 40 0\nCHANNELS 1 Zrotation\nEnd Site\n{{\nOFFSET -30 0 0\n}}\n}}\n}}\n\
         MOTION\nFrames: 50\nFrame Time: 0.01\n"
    );
    for frame in 0..50 {
        let t = f64::from(frame);
        writeln!(motion, "{} 90 {t} {angle} {} 0", 0.5 * t, angle + 0.2 * t).unwrap();
    }
    motion
}

fn folder() -> TempDir {
    let folder = tempdir().unwrap();
    let write = |name: &str, contents: String| {
        std::fs::write(folder.path().join(name), contents).unwrap();
    };
    write("a.bvh", body("LeftArm", "RightArm", 10.0));
    write("b.bvh", body("LeftArm", "RightArm", 40.0));
    write("other.bvh", body("LeftArm", "Tail", 0.0));
    write("note.txt", "hello".to_owned());
    folder
}

/// The matrix of a joint at a time.
#[track_caller]
fn matrix(folder: &Path, motion: &[&str], joint: &str, time: &str) -> [[f64; 4]; 3] {
    let sample = [&["clip", "sample"][..], motion, &["--times", time]].concat();
    let sample = json(folder, &sample);
    let joints = sample["samples"][0]["joints"].as_array().unwrap();
    let found = joints.iter().find(|found| found["joint"] == joint).unwrap();
    serde_json::from_value(found["matrix"].clone()).unwrap()
}

#[track_caller]
fn assert_near(found: [[f64; 4]; 3], truth: [[f64; 4]; 3], bound: f64) {
    for (found, truth) in found.as_flattened().iter().zip(truth.as_flattened()) {
        assert!((found - truth).abs() <= bound, "{found} for {truth}");
    }
}

/// The rotation about z by this many degrees, then the translation.
fn about_z(degrees: f64, [x, y, z]: [f64; 3]) -> [[f64; 4]; 3] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [[cos, -sin, 0.0, x], [sin, cos, 0.0, y], [0.0, 0.0, 1.0, z]]
}

const UNIT: [&str; 2] = ["--metres-per-unit", "0.01"];

#[test]
fn resampling_keeps_the_motion_at_another_rate() {
    let folder = folder();
    let path = folder.path();
    let resample = [
        "clip", "resample", "a.bvh", "--rate", "40", "--out", "r.clip",
    ];
    let report = json(path, &[&resample[..], &UNIT].concat());
    // 0.49 s are 19 steps of 1/40 s and a part.
    assert_eq!(report["frames"], 20);
    assert_eq!(report["frame_time_seconds"], 0.025);
    assert!(report["max_error_metres"].as_f64().unwrap() <= 1e-4);
    for (time, frame) in [("0", 0.0), ("0.025", 2.5), ("0.475", 47.5)] {
        let hips = matrix(path, &["r.clip"], "Hips", time);
        // The last column is the place.
        let truth = [0.005 * frame, 0.9, 0.01 * frame];
        for (row, truth) in hips.iter().zip(truth) {
            assert!((row[3] - truth).abs() <= 1e-4);
        }
    }
    // At the rate of a clip that is read again, with its own bounds.
    let compress = [
        "clip",
        "compress",
        "a.bvh",
        "--tolerance",
        "0.001",
        "--out",
        "c.clip",
    ];
    json(path, &[&compress[..], &UNIT].concat());
    json(
        path,
        &[
            "clip", "resample", "c.clip", "--rate", "100", "--out", "d.clip",
        ],
    );
    let info = json(path, &["clip", "info", "d.clip"]);
    assert_eq!(info["frames"], 50);
    assert_eq!(info["tolerance_metres"], 0.001);
    let [c, d] = ["c.clip", "d.clip"].map(|clip| matrix(path, &[clip], "LeftArm", "0.31"));
    assert_near(c, d, 0.001 / 0.03);
}

#[test]
fn mirroring_exchanges_left_and_right() {
    let folder = folder();
    let path = folder.path();
    let mirror = ["clip", "mirror", "a.bvh", "--out", "m.clip"];
    let report = json(path, &[&mirror[..], &UNIT].concat());
    assert_eq!(report["frames"], 50);
    for (time, frame) in [("0", 0.0), ("0.3", 30.0)] {
        // In frame f the hips are rotated by 10° about y and the left arm by (10 + f/5)° about z.
        let [before, after] =
            [("a.bvh", "LeftArm"), ("m.clip", "RightArm")].map(|(motion, joint)| {
                let unit: &[&str] = if motion == "a.bvh" { &UNIT } else { &[] };
                matrix(path, &[&[motion][..], unit].concat(), joint, time)
            });
        // Reflection in the plane across x of the axes and of the place.
        let sign = |k: usize| if k == 0 { -1.0 } else { 1.0 };
        let truth: [[f64; 4]; 3] = std::array::from_fn(|row| {
            std::array::from_fn(|column| {
                sign(row) * before[row][column] * if column == 3 { 1.0 } else { sign(column) }
            })
        });
        assert_near(after, truth, 1e-4 / 0.03);
        let (x, z) = (0.005 * frame, 0.01 * frame);
        let (sin, cos) = 10f64.to_radians().sin_cos();
        assert!((after[0][3] + x + 0.2 * cos).abs() <= 1e-4);
        assert!((after[2][3] - (z - 0.2 * sin)).abs() <= 1e-4);
    }
    // Across z, the way forward becomes the way back.
    let back = ["clip", "mirror", "m.clip", "--axis", "z", "--out", "z.clip"];
    json(path, &back);
    let hips = matrix(path, &["z.clip"], "Hips", "0.4");
    assert!((hips[2][3] + 0.4).abs() <= 3e-4 && (hips[0][3] + 0.2).abs() <= 3e-4);
}

#[test]
fn blending_is_the_mean_by_weights() {
    let folder = folder();
    let path = folder.path();
    let blend = |weights: &str, out: &str| {
        let arguments = [
            "clip",
            "blend",
            "a.bvh",
            "b.bvh",
            "--weights",
            weights,
            "--out",
            out,
        ];
        json(path, &[&arguments[..], &UNIT].concat())
    };
    let report = blend("1,1", "mean.clip");
    assert_eq!(report["file"], "a.bvh, b.bvh");
    assert_eq!(report["frames"], 50);
    // The arms' rotations have one axis in both, so that their mean has the mean angle; and so do
    // those of the hips.
    let hips = matrix(path, &["mean.clip"], "Hips", "0.2");
    let (sin, cos) = 25f64.to_radians().sin_cos();
    let truth = [
        [cos, 0.0, sin, 0.1],
        [0.0, 1.0, 0.0, 0.9],
        [-sin, 0.0, cos, 0.2],
    ];
    assert_near(hips, truth, 1e-4 / 0.03);
    let arm = matrix(path, &["mean.clip"], "LeftArm", "0.2");
    let local = about_z(25.0 + 4.0, [0.2, 0.4, 0.0]);
    let truth: [[f64; 4]; 3] = std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let product: f64 = (0..3).map(|k| truth[row][k] * local[k][column]).sum();
            product + if column == 3 { truth[row][3] } else { 0.0 }
        })
    });
    assert_near(arm, truth, 1e-4 / 0.03);
    // With one weight the bytes are those of that motion.
    blend("0,5", "b.clip");
    let compress = [
        "clip",
        "compress",
        "b.bvh",
        "--tolerance",
        "0.0001",
        "--out",
        "b2.clip",
    ];
    json(path, &[&compress[..], &UNIT].concat());
    let read = |name: &str| std::fs::read(path.join(name)).unwrap();
    assert_eq!(read("b.clip"), read("b2.clip"));
}

#[test]
fn what_cannot_be_done_is_one_line_and_writes_nothing() {
    let folder = folder();
    let path = folder.path();
    let before = names(path);
    let run = |arguments: &[&str]| {
        nullcone(
            path,
            [&["clip"][..], arguments, &["--out", "out.clip"]].concat(),
        )
    };
    for rate in ["0", "-1", "nan", "inf"] {
        assert_failure(
            &run(&["resample", "a.bvh", "--rate", rate]),
            &["a.bvh", "--rate", "is not a number of frames per second"],
        );
    }
    assert_failure(
        &run(&["resample", "a.bvh", "--rate", "1e12"]),
        &["a.bvh", "more than"],
    );
    for arguments in [
        &["resample", "none.bvh", "--rate", "30"][..],
        &["mirror", "none.bvh"],
        &["blend", "a.bvh", "none.bvh", "--weights", "1,1"],
    ] {
        assert_failure(&run(arguments), &["none.bvh"]);
    }
    assert_failure(&run(&["mirror", "note.txt"]), &["note.txt", ".bvh"]);
    assert_failure(
        &run(&["mirror", "other.bvh"]),
        &["other.bvh", "\"LeftArm\" has no counterpart \"RightArm\""],
    );
    let blend = |other: &str, weights: &str| run(&["blend", "a.bvh", other, "--weights", weights]);
    assert_failure(
        &blend("b.bvh", "1"),
        &["--weights", "1 weights for 2 motions"],
    );
    assert_failure(&blend("b.bvh", "1,2,3"), &["3 weights for 2 motions"]);
    assert_failure(&blend("b.bvh", "0,0"), &["a.bvh, b.bvh", "sum 0"]);
    for weight in ["-1", "nan", "inf"] {
        assert_failure(
            &blend("b.bvh", &format!("1,{weight}")),
            &["the weight of recording 1", "0 or more"],
        );
    }
    assert_failure(&blend("other.bvh", "1,1"), &["\"Tail\"", "\"RightArm\""]);
    assert_failure(
        &run(&["mirror", "a.bvh", "--tolerance", "0"]),
        &["a.bvh", "the tolerance must be positive"],
    );
    assert_failure(
        &run(&["mirror", "a.bvh", "--joint", "foot=0.1"]),
        &["--joint foot", "no such joint"],
    );
    assert_failure(
        &nullcone(path, ["clip", "mirror", "a.bvh", "--out", "out.txt"]),
        &["--out out.txt", ".clip"],
    );
    assert_eq!(names(path), before);
    for command in ["resample", "mirror", "blend"] {
        let help = nullcone(path, ["clip", command, "--help"]);
        assert_success(&help);
        assert!(text(&help.stdout).contains(&format!("nullcone clip {command} walk.clip")));
    }
}

#[test]
fn a_gltf_animation_is_resampled_from_its_curves() {
    let Some(model) = shared("data/anim/gltf/Fox.glb") else {
        return;
    };
    let folder = tempdir().unwrap();
    let path = folder.path();
    let model = model.to_str().unwrap();
    let animation = ["--animation", "1"];
    let out = ["--tolerance", "0.02", "--shell", "3", "--out", "fox.clip"];
    let resample = ["clip", "resample", model, "--rate", "60"];
    let report = json(path, &[&resample[..], &animation, &out].concat());
    assert!((report["frame_time_seconds"].as_f64().unwrap() - 1.0 / 60.0).abs() < 1e-15);
    // A frame between the keys, as the curves have it.
    let time = (7.0 / 60.0f64).to_string();
    let found = matrix(path, &["fox.clip"], "b_Head_05", &time);
    let truth = matrix(
        path,
        &[&[model][..], &animation].concat(),
        "b_Head_05",
        &time,
    );
    assert_near(found, truth, 0.0201);
}

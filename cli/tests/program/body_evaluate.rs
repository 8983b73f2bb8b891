//! `nullcone body evaluate`: errors of reconstructed bodies.

use std::fmt::Write;
use std::path::Path;

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, number, text};

/// A person who swings arms and legs, in metres times `scale`.
fn motion(scale: f64) -> String {
    let limb = |name: &str, parts: [&str; 3], offsets: [[f64; 3]; 4]| {
        let mut text = String::new();
        for (part, [x, y, z]) in parts.iter().zip(offsets) {
            let [x, y, z] = [x, y, z].map(|c| c * scale);
            let _ = write!(
                text,
                "JOINT {name}{part} {{ OFFSET {x} {y} {z} CHANNELS 3 Zrotation Xrotation Yrotation "
            );
        }
        let [x, y, z] = offsets[3].map(|c| c * scale);
        let _ = writeln!(text, "End Site {{ OFFSET {x} {y} {z} }} }} }} }}");
        text
    };
    let leg = |x: f64| {
        [
            [x, -0.05, 0.0],
            [0.0, -0.42, 0.0],
            [0.0, -0.42, 0.0],
            [0.0, -0.05, 0.15],
        ]
    };
    let arm = |x: f64| {
        [
            [x, 0.5, 0.0],
            [1.7 * x, 0.0, 0.0],
            [1.5 * x, 0.0, 0.0],
            [0.5 * x, 0.0, 0.0],
        ]
    };
    let mut text = format!(
        "HIERARCHY\nROOT Hips {{ OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n\
         {}{}{}{}{}}}\nMOTION\nFrames: 40\nFrame Time: 0.00833333\n",
        limb("Left", ["UpLeg", "Leg", "Foot"], leg(0.1)),
        limb("Right", ["UpLeg", "Leg", "Foot"], leg(-0.1)),
        limb("Left", ["Arm", "ForeArm", "Hand"], arm(0.17)),
        limb("Right", ["Arm", "ForeArm", "Hand"], arm(-0.17)),
        limb(
            "",
            ["Spine", "Neck", "Head"],
            [
                [0.0, 0.2, 0.0],
                [0.0, 0.35, 0.0],
                [0.0, 0.15, 0.02],
                [0.0, 0.15, 0.0]
            ]
        ),
    );
    for frame in 0..40 {
        let t = f64::from(frame) / 40.0;
        let swing = (std::f64::consts::TAU * t).sin();
        let _ = write!(
            text,
            "{} {} 0 0 0 {}",
            0.1 * t * scale,
            0.94 * scale,
            10.0 * swing
        );
        for joint in 0..15 {
            let angle =
                [25.0, 12.0, -8.0][joint % 3] * swing * if joint % 2 == 0 { 1.0 } else { -1.0 };
            let _ = write!(text, " {} {angle} {}", 0.3 * angle, 0.1 * angle);
        }
        text.push('\n');
    }
    text
}

fn evaluate(folder: &Path, arguments: &[&str]) -> std::process::Output {
    nullcone(
        folder,
        [&["body", "evaluate", "--motion"], arguments].concat(),
    )
}

fn report(output: &std::process::Output) -> Value {
    assert_success(output);
    serde_json::from_slice(&output.stdout).unwrap()
}

fn row<'a>(report: &'a Value, method: &str, views: u64, noise: f64) -> &'a Value {
    let rows = report["rows"].as_array().unwrap();
    let is_wanted =
        |row: &&Value| row["method"] == method && row["views"] == views && row["noise_px"] == noise;
    rows.iter().find(is_wanted).unwrap()
}

#[test]
fn rows_have_all_errors_and_grow_with_noise() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("m.bvh"), motion(1.0)).unwrap();
    let arguments = [
        "m.bvh", "--noise", "0,2", "--views", "1,2", "--json", "--plot", "p.svg",
    ];
    let first = report(&evaluate(folder.path(), &arguments));
    assert_eq!(first["rows"].as_array().unwrap().len(), 2 * 2 + 2 * 3);
    assert_eq!(number(&first, "/metres_per_unit"), 1.0);
    assert_eq!(number(&first, "/joints"), 16.0);
    assert!(first["data"].as_str().unwrap().contains("not Human3.6M"));
    for row in first["rows"].as_array().unwrap() {
        for key in [
            "missing",
            "mpjpe_mm",
            "root_relative_mm",
            "aligned_mm",
            "joint_error_px",
            "milliseconds_per_frame",
        ] {
            assert!(row[key].is_f64(), "{key}: {row}");
        }
    }
    let mpjpe = |method, views, noise| number(row(&first, method, views, noise), "/mpjpe_mm");
    // Rays of exact pixels meet. With noise of 2 px, the depth has a deviation of
    // z²/(f b) √2 · 2 px = 45 mm, whose mean magnitude is 36 mm.
    assert!(mpjpe("triangulation", 2, 0.0) < 1e-6);
    let raw = mpjpe("triangulation", 2, 2.0);
    assert!((33.0..43.0).contains(&raw), "{raw}");
    // Bones of known lengths help, and so do neighbouring frames.
    let single = mpjpe("single_frame", 2, 2.0);
    let clip = mpjpe("clip", 2, 2.0);
    assert!(
        single < raw && clip < 1.02 * single,
        "{raw} {single} {clip}"
    );
    assert!(mpjpe("single_frame", 2, 0.0) < 5.0);
    assert!(mpjpe("single_frame", 1, 2.0) > single);

    let svg = std::fs::read_to_string(folder.path().join("p.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("not Human3.6M") && svg.contains("m.bvh"));
    assert!(svg.contains("2-D joint error") && svg.contains("MPJPE"));

    // The same seed gives the same errors, another one others.
    let again = report(&evaluate(folder.path(), &arguments));
    for (a, b) in first["rows"]
        .as_array()
        .unwrap()
        .iter()
        .zip(again["rows"].as_array().unwrap())
    {
        assert_eq!(a["mpjpe_mm"], b["mpjpe_mm"]);
    }
    let other = [
        "m.bvh", "--noise", "2", "--views", "2", "--seed", "9", "--json",
    ];
    let other = report(&evaluate(folder.path(), &other));
    let [a, b] = [&first, &other].map(|r| row(r, "triangulation", 2, 2.0)["mpjpe_mm"].clone());
    assert_ne!(a, b);
}

#[test]
fn centimetres_are_guessed_and_missing_joints_are_left_out_of_triangulation() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("cm.bvh"), motion(100.0)).unwrap();
    let arguments = [
        "cm.bvh",
        "--noise",
        "1",
        "--views",
        "2",
        "--missing",
        "0.2",
        "--json",
    ];
    let found = report(&evaluate(folder.path(), &arguments));
    assert_eq!(number(&found, "/metres_per_unit"), 0.01);
    // Both views show a joint with the probability 0.8².
    let share = number(row(&found, "triangulation", 2, 1.0), "/joints_found");
    assert!((share - 0.64).abs() < 0.08, "{share}");
    assert_eq!(number(row(&found, "clip", 2, 1.0), "/joints_found"), 1.0);
    let every = [
        "cm.bvh", "--noise", "1", "--views", "2", "--every", "4", "--json",
    ];
    let every = report(&evaluate(folder.path(), &every));
    assert_eq!(number(&every, "/frames"), 10.0);
    assert!((number(&every, "/frames_per_second") - 30.0).abs() < 1e-3);
}

#[test]
fn tables_have_the_numbers_of_the_paper_beside() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("m.bvh"), motion(1.0)).unwrap();
    let output = evaluate(folder.path(), &["m.bvh", "--noise", "2", "--views", "2"]);
    assert_success(&output);
    let table = text(&output.stdout);
    for part in [
        "SMPLify",
        "57.20",
        "Deep Kinematic Pose",
        "106.95",
        "85.23",
        "as Cui prints it, on Human3.6M",
        "not on Human3.6M",
        "triangulation, 2 views, 2 px of noise",
        "clip, 2 views",
    ] {
        assert!(table.contains(part), "{part:?} is not in {table}");
    }
    let quiet = evaluate(
        folder.path(),
        &["m.bvh", "--noise", "2", "--views", "2", "--quiet"],
    );
    assert_success(&quiet);
    assert!(quiet.stdout.is_empty() && quiet.stderr.is_empty());
}

#[test]
fn what_cannot_be_evaluated_is_named_and_nothing_is_written() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("m.bvh"), motion(1.0)).unwrap();
    let cases: [(&[&str], &[&str]); 8] = [
        (&["m.bvh", "--noise", "-1"], &["--noise -1"]),
        (&["m.bvh", "--views", "0"], &["--views 0"]),
        (&["m.bvh", "--views", "1000"], &["--views 1000"]),
        (&["m.bvh", "--missing", "1"], &["--missing 1"]),
        (&["m.bvh", "--every", "0"], &["--every 0"]),
        (
            &["m.bvh", "--metres-per-unit", "0"],
            &["--metres-per-unit 0"],
        ),
        (&["nowhere.bvh"], &["nowhere.bvh"]),
        // A body of 170 m: the cameras stand in it.
        (
            &["m.bvh", "--metres-per-unit", "100"],
            &["m.bvh", "frame ", "view 0", "point ", "depth"],
        ),
    ];
    for (arguments, parts) in cases {
        let arguments = [arguments, &["--plot", "p.svg"]].concat();
        assert_failure(&evaluate(folder.path(), &arguments), parts);
    }
    assert_failure(
        &evaluate(folder.path(), &["m.bvh", "--plot", "p.png"]),
        &["p.png", ".svg"],
    );
    assert_eq!(names(folder.path()), ["m.bvh"]);
}

#[test]
fn motion_capture_is_reconstructed_from_two_views() {
    let Some(path) = nullcone_shared_data::shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let folder = tempdir().unwrap();
    let path = path.to_str().unwrap();
    let arguments = [
        path, "--noise", "2", "--views", "2", "--frames", "60", "--json",
    ];
    let found = report(&evaluate(folder.path(), &arguments));
    assert_eq!(number(&found, "/joints"), 21.0);
    assert!((number(&found, "/metres_per_unit") - 0.0254 / 0.45).abs() < 1e-12);
    let mpjpe = |method| number(row(&found, method, 2, 2.0), "/mpjpe_mm");
    assert!((33.0..42.0).contains(&mpjpe("triangulation")));
    assert!(mpjpe("single_frame") < mpjpe("triangulation"));
}

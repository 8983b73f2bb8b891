//! `nullcone body evaluate`: errors of reconstructed bodies.

use std::fmt::Write;
use std::path::Path;

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, number, program, text};

/// A person who swings arms and legs, in metres times `scale`.
fn motion(scale: f64) -> String {
    frames_of_motion(scale, 40, |_| [0.0; 3])
}

/// `count` frames of the same, with a period of 40 and the body moved by `moved` in metres.
fn frames_of_motion(scale: f64, count: usize, moved: impl Fn(usize) -> [f64; 3]) -> String {
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
         {}{}{}{}{}}}\nMOTION\nFrames: {count}\nFrame Time: 0.00833333\n",
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
    for frame in 0..count {
        let t = (frame % 40) as f64 / 40.0;
        let swing = (std::f64::consts::TAU * t).sin();
        let [x, y, z] = moved(frame);
        let place = [0.1 * t + x, 0.94 + y, z].map(|c| c * scale);
        let _ = write!(
            text,
            "{} {} {} 0 0 {}",
            place[0],
            place[1],
            place[2],
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

/// The rows but for what differs from run to run.
fn without_times(report: &Value) -> Vec<Value> {
    let mut rows = report["rows"].as_array().unwrap().clone();
    for row in &mut rows {
        let row = row.as_object_mut().unwrap();
        assert!(row.remove("milliseconds_per_frame").is_some());
    }
    rows
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
    assert!(svg.contains("1 view") && svg.contains("2 views"));

    // The same seed gives the same errors for any number of threads, another one others.
    for threads in ["1", "5"] {
        let mut again = program(folder.path());
        again.args(["body", "evaluate", "--motion"]).args(arguments);
        let again = again.env("RAYON_NUM_THREADS", threads).output().unwrap();
        assert_eq!(without_times(&report(&again)), without_times(&first));
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
    // A frame that shows too few joints has no pose by itself, and in a clip it has one.
    let few = [
        "cm.bvh",
        "--noise",
        "1",
        "--views",
        "2",
        "--missing",
        "0.9",
        "--json",
    ];
    let few = report(&evaluate(folder.path(), &few));
    let share = number(row(&few, "single_frame", 2, 1.0), "/joints_found");
    assert!((0.1..0.9).contains(&share), "{share}");
    assert_eq!(number(row(&few, "clip", 2, 1.0), "/joints_found"), 1.0);
    let every = [
        "cm.bvh", "--noise", "1", "--views", "2", "--every", "4", "--json",
    ];
    let every = report(&evaluate(folder.path(), &every));
    assert_eq!(number(&every, "/frames"), 10.0);
    assert!((number(&every, "/frames_per_second") - 30.0).abs() < 1e-3);
}

/// A motion twice as long, of the same frames again, has twice as many independent errors.
#[test]
fn each_stretch_has_noise_of_its_own() {
    let folder = tempdir().unwrap();
    let text = frames_of_motion(1.0, 240, |_| [0.0; 3]);
    std::fs::write(folder.path().join("m.bvh"), text).unwrap();
    let of = |frames: &str| {
        let arguments = [
            "m.bvh", "--noise", "2", "--views", "2", "--frames", frames, "--json",
        ];
        let report = report(&evaluate(folder.path(), &arguments));
        (
            number(&report, "/frames"),
            number(row(&report, "triangulation", 2, 2.0), "/mpjpe_mm"),
        )
    };
    let ((first, once), (all, twice)) = (of("120"), of("240"));
    assert_eq!((first, all), (120.0, 240.0));
    // 120 × 16 distances with a relative deviation of about 0.75.
    assert!(
        once != twice && (once / twice - 1.0).abs() < 0.1,
        "{once} {twice}"
    );
}

/// The frames that are taken keep their numbers.
#[test]
fn frames_are_named_as_the_file_counts_them() {
    let folder = tempdir().unwrap();
    // Cameras look along x; frame 30 is far behind them.
    let away = |frame: usize| {
        if frame == 30 {
            [300.0, 0.0, 1000.0]
        } else {
            [0.0; 3]
        }
    };
    let text = frames_of_motion(1.0, 40, away);
    std::fs::write(folder.path().join("m.bvh"), text).unwrap();
    let output = evaluate(folder.path(), &["m.bvh", "--views", "2", "--every", "5"]);
    assert_failure(
        &output,
        &["m.bvh", "2 views", "frame 30, view 0, joint \"Hips\""],
    );
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
        "joints found",
        "      2 px\n",
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
            &["m.bvh", "frame 1, view 0, joint \"RightFoot\"", "depth"],
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

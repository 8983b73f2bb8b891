//! `nullcone body fit`: the mannequin walks in front of two cameras.

use std::fmt::Write;
use std::path::Path;
use std::sync::OnceLock;

use ga_anim::gltf::Player;
use ga_mannequin::{Human, walk};
use ga_runtime::cga3::Point;
use serde_json::{Value, json};
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, names, nullcone, number};

const RATE: f64 = 30.0;
const FRAMES: usize = 20;
/// The walk is in front of the left camera, in metres.
const PLACE: [f64; 3] = [0.3, -0.9, -4.5];
/// The joints that are seen: all but the toes.
const JOINTS: [&str; 19] = [
    "Hips",
    "Spine",
    "Chest",
    "Neck",
    "Head",
    "LeftShoulder",
    "LeftUpperArm",
    "LeftLowerArm",
    "LeftHand",
    "RightShoulder",
    "RightUpperArm",
    "RightLowerArm",
    "RightHand",
    "LeftUpperLeg",
    "LeftLowerLeg",
    "LeftFoot",
    "RightUpperLeg",
    "RightLowerLeg",
    "RightFoot",
];

/// Where the joints are in all frames, with y up and the cameras looking along −z.
fn truth() -> &'static [Vec<[f64; 3]>] {
    static TRUTH: OnceLock<Vec<Vec<[f64; 3]>>> = OnceLock::new();
    TRUTH.get_or_init(|| {
        let (skeleton, walk) = (Human::new().skeleton, walk(1));
        let places = |frame: usize| {
            let bones = walk.sample(frame as f64 / RATE).bones(&skeleton).unwrap();
            let place = |name: &&str| {
                let [head, _] = bones[skeleton.index(name).unwrap()];
                [0, 1, 2].map(|k| head[k] + PLACE[k])
            };
            JOINTS.iter().map(place).collect()
        };
        (0..FRAMES).map(places).collect()
    })
}

/// A camera of 1000 px at the origin, or a metre to the right of it.
fn pixel([x, y, z]: [f64; 3], view: usize) -> [f64; 2] {
    [
        960.0 + 1000.0 * (x - view as f64) / -z,
        540.0 - 1000.0 * y / -z,
    ]
}

/// Files of joints, a rig and a camera. The left hand is missing in frame 3 of both views.
fn inputs() -> TempDir {
    let folder = tempdir().unwrap();
    let view = |view: usize| {
        let frame = |frame: usize| -> Vec<Value> {
            let joints = truth()[frame].iter().zip(JOINTS);
            joints
                .map(|(place, name)| match (frame, name) {
                    (3, "LeftHand") => Value::Null,
                    _ => json!(pixel(*place, view)),
                })
                .collect()
        };
        let frames: Vec<Vec<Value>> = (0..FRAMES).map(frame).collect();
        let name = ["left", "right"][view];
        json!({"name": name, "frames": frames})
    };
    let write = |name: &str, text: String| std::fs::write(folder.path().join(name), text).unwrap();
    let joints = |names: Vec<&str>, views: Vec<Value>| {
        json!({"version": 1, "frames_per_second": RATE, "deviation_px": 0.05,
            "joints": names, "views": views})
        .to_string()
    };
    write(
        "joints.json",
        joints(JOINTS.to_vec(), vec![view(0), view(1)]),
    );
    write("one.json", joints(JOINTS.to_vec(), vec![view(0)]));
    write(
        "crossed.json",
        joints(
            JOINTS.to_vec(),
            vec![view(1), {
                let mut other = view(0);
                other["name"] = json!("other");
                other
            }],
        ),
    );
    let mut tail = JOINTS.to_vec();
    tail[4] = "Tail";
    write("tail.json", joints(tail, vec![view(0), view(1)]));
    let few: Vec<Value> = [0, 1]
        .map(|k| json!({"name": k.to_string(), "frames": [[[640, 360], [650, 380], null]]}))
        .to_vec();
    write("few.json", joints(vec!["Hips", "Spine", "Chest"], few));
    let k = "[[1000, 0, 960], [0, 1000, 540], [0, 0, 1]]";
    let mut rig = String::from("%YAML:1.0\n---\n");
    write!(
        rig,
        "M1: {k}\nM2: {k}\nR: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nT: [[-1], [0], [0]]\n"
    )
    .unwrap();
    write("rig.yml", rig);
    write("camera.yml", format!("%YAML:1.0\n---\nK: {k}\n"));
    folder
}

fn fit(folder: &Path, joints: &str, rig: &str, more: &[&str]) -> std::process::Output {
    let given = [
        "body",
        "fit",
        "--joints",
        joints,
        "--rig",
        rig,
        "--character",
        "mannequin",
        "--out",
        "fitted.glb",
        "--json",
    ];
    nullcone(folder, [&given[..], more].concat())
}

/// The greatest distance of a joint in the file from the truth, in metres.
fn greatest_error(path: &Path) -> f64 {
    let document = ga_mesh::gltf::read(path).unwrap();
    let player = Player::new(&document).unwrap();
    let mut greatest = 0.0_f64;
    for frame in 0..FRAMES {
        let pose = player.pose(Some(0), frame as f64 / RATE).unwrap();
        for (name, truth) in JOINTS.iter().zip(&truth()[frame]) {
            let mut nodes = document.nodes.iter();
            let node = nodes
                .position(|node| node.name.as_deref() == Some(*name))
                .unwrap();
            let place = pose.world[node].transform(Point::default());
            greatest = greatest.max(place.distance((*truth).into()));
        }
    }
    greatest
}

#[test]
fn the_mannequin_walks_as_it_was_seen() {
    let folder = inputs();
    let output = fit(folder.path(), "joints.json", "rig.yml", &[]);
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["frames"], FRAMES);
    assert_eq!(report["joints"].as_array().unwrap().len(), JOINTS.len());
    assert_eq!(report["joints_unseen"], 1);
    assert_eq!(report["per_frame"][3]["joints_unseen"], json!(["LeftHand"]));
    assert!(number(&report, "/reprojection_rms_px") < 0.2);
    assert!(number(&report, "/milliseconds_per_frame") > 0.0);
    let error = greatest_error(&folder.path().join("fitted.glb"));
    assert!(error < 0.01, "{error} m");

    let output = fit(folder.path(), "joints.json", "rig.yml", &["--independent"]);
    assert_success(&output);
    let fitted = folder.path().join("fitted.glb");
    // A character from a file is fitted as well, and keeps its skin.
    std::fs::rename(&fitted, folder.path().join("person.glb")).unwrap();
    let output = fit(folder.path(), "joints.json", "rig.yml", &[]);
    assert_success(&output);
    let given = [
        "body",
        "fit",
        "--joints",
        "joints.json",
        "--rig",
        "rig.yml",
        "--character",
        "person.glb",
        "--out",
        "again.glb",
    ];
    assert_success(&nullcone(folder.path(), given));
    let again = folder.path().join("again.glb");
    assert_eq!(ga_mesh::gltf::read(&again).unwrap().skins.len(), 1);
    assert!(greatest_error(&again) < 0.01);
}

#[test]
fn one_view_needs_a_camera() {
    let folder = inputs();
    let output = fit(folder.path(), "one.json", "camera.yml", &[]);
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["views"], 1);
    assert!(number(&report, "/reprojection_rms_px") < 1.0);
}

#[test]
fn bad_input_is_named_and_nothing_is_written() {
    let folder = inputs();
    let before = names(folder.path());
    let fails = |joints: &str, rig: &str, more: &[&str], parts: &[&str]| {
        assert_failure(&fit(folder.path(), joints, rig, more), parts);
        assert_eq!(names(folder.path()), before);
    };
    fails("tail.json", "rig.yml", &[], &["tail.json", "\"Tail\""]);
    fails(
        "few.json",
        "rig.yml",
        &[],
        &["few.json", "frame 0", "2 points", "needs 3"],
    );
    fails(
        "crossed.json",
        "rig.yml",
        &[],
        &["crossed.json", "view", "\"Hips\"", "behind"],
    );
    fails("joints.json", "camera.yml", &[], &["camera.yml", "M1"]);
    fails("none.json", "rig.yml", &[], &["none.json"]);
    fails("joints.json", "rig.yml", &["--fps", "0"], &["--fps 0"]);
    let given = [
        "body",
        "fit",
        "--joints",
        "joints.json",
        "--rig",
        "rig.yml",
        "--character",
    ];
    let other = [&given[..], &["mannequin", "--out", "fitted.obj"]].concat();
    assert_failure(&nullcone(folder.path(), other), &["fitted.obj", ".glb"]);
    assert_eq!(names(folder.path()), before);
}

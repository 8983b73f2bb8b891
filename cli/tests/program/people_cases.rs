//! Joints that were fitted wrongly once, with what is right: `tests/data/people/README.md`.

use std::path::{Path, PathBuf};

use ga_anim::gltf::Player;
use ga_camera::Intrinsics;
use ga_files::table::Table;
use ga_mannequin::{skeleton, walk};
use ga_runtime::cga3::Point;
use ga_vision::perspective_n_point::{Options, estimate};
use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_success, json, nullcone, number, text};

/// The joints of the mannequin that COCO has from the shoulders on, in its order.
const JOINTS: [&str; 12] = [
    "LeftUpperArm",
    "RightUpperArm",
    "LeftLowerArm",
    "RightLowerArm",
    "LeftHand",
    "RightHand",
    "LeftUpperLeg",
    "RightUpperLeg",
    "LeftLowerLeg",
    "RightLowerLeg",
    "LeftFoot",
    "RightFoot",
];
/// Frames of `one_view.json` in a second of the walk.
const RATE: f64 = 15.0;

fn data(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/people");
    folder.join(name)
}

/// Where the walk of `one_view.json` has the joints in the world of its camera with y up. Where the
/// camera is follows from the pixels of all frames.
fn places() -> Vec<Vec<Point<f64>>> {
    let frames = std::fs::read_to_string(data("one_view.json")).unwrap();
    let frames: Vec<Value> = serde_json::from_str(&frames).unwrap();
    let (skeleton, walk) = (skeleton(), walk(1));
    let (mut points, mut pixels) = (Vec::new(), Vec::new());
    for (number, frame) in frames.iter().enumerate() {
        let pose = walk.sample(number as f64 / RATE);
        let bones = pose.bones(&skeleton).unwrap();
        for (name, keypoint) in JOINTS.iter().zip(5_usize..) {
            let [head, _] = bones[skeleton.index(name).unwrap()];
            points.push(Point::from(head));
            let number = |k: usize| frame["keypoints"][3 * keypoint + k].as_f64().unwrap();
            pixels.push([number(0), number(1)]);
        }
    }
    let intrinsics = Intrinsics::new([1000.0; 2], [640.0, 360.0]).unwrap();
    let found = estimate(&points, &pixels, &intrinsics, &Options::default()).unwrap();
    assert!(
        found.root_mean_square < 2.0,
        "{} px",
        found.root_mean_square
    );
    let placed = points.iter().map(|point| {
        let [x, y, z] = found.world_to_camera.transform(*point).coordinates();
        Point::new(x, -y, -z)
    });
    let placed: Vec<Point<f64>> = placed.collect();
    placed.chunks(JOINTS.len()).map(<[_]>::to_vec).collect()
}

/// The mean distance of the joints of a fitted character from the truth, in metres.
fn mean_error(path: &Path, rate: f64, truth: &[Vec<Point<f64>>]) -> f64 {
    let document = ga_mesh::gltf::read(path).unwrap();
    let player = Player::new(&document).unwrap();
    let mut sum = 0.0;
    for (frame, truth) in truth.iter().enumerate() {
        let pose = player.pose(Some(0), frame as f64 / rate).unwrap();
        for (name, truth) in JOINTS.iter().zip(truth) {
            let is_joint = |name_of: &Option<String>| name_of.as_deref() == Some(*name);
            let mut nodes = document.nodes.iter();
            let node = nodes.position(|node| is_joint(&node.name)).unwrap();
            sum += pose.world[node]
                .transform(Point::default())
                .distance(*truth);
        }
    }
    sum / (truth.len() * JOINTS.len()) as f64
}

#[test]
fn a_clip_of_one_view_is_no_worse_than_its_frames() {
    let folder = tempdir().unwrap();
    let truth = places();
    let [joints, camera] = ["one_view.json", "camera.yml"].map(data);
    for (rate, given) in [(30.0, &[][..]), (RATE, &["--fps", "15"])] {
        let [clip, frames] = [&[][..], &["--independent"]].map(|more| {
            let files = [joints.to_str().unwrap(), "--rig", camera.to_str().unwrap()];
            let character = ["--character", "mannequin", "--out", "x.glb"];
            let all = [
                &["body", "fit", "--joints"],
                &files[..],
                &character,
                given,
                more,
            ];
            assert_success(&nullcone(folder.path(), all.concat()));
            mean_error(&folder.path().join("x.glb"), rate, &truth)
        });
        assert!(
            clip <= frames,
            "{rate} frames a second: {clip} m, frames {frames} m"
        );
    }
}

/// The cameras are pitched down by 7.1°, and their files say nothing of a ground.
#[test]
fn the_walk_of_a_pitched_rig_stands_on_a_floor() {
    let folder = tempdir().unwrap();
    let [joints, rig] = ["walk.json", "rig.yml"].map(data);
    let files = [joints.to_str().unwrap(), "--rig", rig.to_str().unwrap()];
    let given = [&["people", "--joints"], &files[..], &["--out", "out"]].concat();
    let found = json(folder.path(), &given);
    let pitch = 7.1_f64.to_radians();
    let truth = [0.0, pitch.cos(), pitch.sin()];
    let cosine: f64 = (0..3)
        .map(|k| number(&found, &format!("/up/{k}")) * truth[k])
        .sum();
    let angle = cosine.min(1.0).acos().to_degrees();
    assert!(angle < 1.0, "{angle}°: {}", found["up"]);
    let csv = std::fs::read(folder.path().join("out/joints.csv")).unwrap();
    let csv = Table::with_names(&csv).unwrap();
    let value = |row: usize, name: &str| {
        let number = csv.number(row, csv.column(name).unwrap()).unwrap();
        number.unwrap()
    };
    // The floor does not fall, and the trunk is upright.
    let lowest: Vec<f64> = (0..csv.len())
        .map(|row| f64::min(value(row, "LeftToe_y"), value(row, "RightToe_y")))
        .collect();
    let is_near = |y: &f64| (0.01..0.08).contains(y);
    assert!(lowest.iter().all(is_near), "{lowest:?}");
    let lean = |row: usize| {
        let [x, y, z] = ["x", "y", "z"]
            .map(|axis| value(row, &format!("Neck_{axis}")) - value(row, &format!("Hips_{axis}")));
        f64::atan2(x.hypot(z), y).to_degrees()
    };
    let lean = (0..csv.len()).map(lean).sum::<f64>() / csv.len() as f64;
    assert!(lean < 2.0, "{lean}°");
}

#[test]
fn joints_that_are_confused_are_not_taken_for_good() {
    let folder = tempdir().unwrap();
    let [joints, rig] = ["confused.json", "rig.yml"].map(data);
    let files = [joints.to_str().unwrap(), "--rig", rig.to_str().unwrap()];
    let more = [
        "--character",
        "mannequin",
        "--out",
        "x.glb",
        "--json",
        "--check",
    ];
    let output = nullcone(
        folder.path(),
        [&["body", "fit", "--joints"], &files[..], &more].concat(),
    );
    assert_eq!(output.status.code(), Some(3), "{}", text(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["verdict"], "doubtful");
    let warnings = found["warnings"].as_array().unwrap();
    for view in ["left", "right"] {
        let is_of_view = |w: &&Value| w["kind"] == "large_error" && w["view"] == view;
        assert!(warnings.iter().any(|w| is_of_view(&w)), "{warnings:?}");
    }
}

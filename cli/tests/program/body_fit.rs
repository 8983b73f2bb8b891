//! `nullcone body fit`: the mannequin walks in front of two cameras.

use std::fmt::Write;
use std::path::Path;
use std::sync::OnceLock;

use ga_anim::gltf::Player;
use ga_mannequin::{skeleton, walk};
use ga_runtime::cga3::Point;
use serde_json::{Value, json};
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, names, nullcone, number, text};

/// Not the rate of files that state none.
pub(crate) const RATE: f64 = 25.0;
pub(crate) const FRAMES: usize = 20;
/// The walk is in front of the left camera, in metres.
pub(crate) const PLACE: [f64; 3] = [0.3, -0.9, -4.5];
/// The joints that are seen: all but the toes.
pub(crate) const JOINTS: [&str; 19] = [
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
pub(crate) fn truth() -> &'static [Vec<[f64; 3]>] {
    static TRUTH: OnceLock<Vec<Vec<[f64; 3]>>> = OnceLock::new();
    TRUTH.get_or_init(|| {
        let (skeleton, walk) = (skeleton(), walk(1));
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

/// Runs `body fit` with all that it needs but joints and cameras, into `fitted.glb`.
fn fit_with(folder: &Path, arguments: &[&str]) -> std::process::Output {
    let given = ["--character", "mannequin", "--out", "fitted.glb", "--json"];
    nullcone(folder, [&["body", "fit"], arguments, &given].concat())
}

fn fit(folder: &Path, joints: &str, rig: &str, more: &[&str]) -> std::process::Output {
    fit_with(
        folder,
        &[&["--joints", joints, "--rig", rig], more].concat(),
    )
}

fn report(output: &std::process::Output) -> Value {
    assert_success(output);
    serde_json::from_slice(&output.stdout).unwrap()
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
    let report = report(&fit(folder.path(), "joints.json", "rig.yml", &[]));
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
    let given =
        "body fit --joints joints.json --rig rig.yml --character person.glb --out again.glb";
    assert_success(&nullcone(folder.path(), given.split(' ')));
    let again = folder.path().join("again.glb");
    assert_eq!(ga_mesh::gltf::read(&again).unwrap().skins.len(), 1);
    assert!(greatest_error(&again) < 0.01);
}

/// A file is written with its folder.
#[test]
fn the_word_mannequin_is_the_figure_of_the_program_wherever_it_stands() {
    let folder = inputs();
    std::fs::create_dir(folder.path().join("mannequin")).unwrap();
    let output = fit(folder.path(), "one.json", "camera.yml", &[]);
    assert_eq!(report(&output)["character"], "mannequin");
    let arguments = "body fit --joints one.json --rig camera.yml --out a.glb --character";
    let arguments = arguments.split(' ').chain(["./mannequin"]);
    assert_failure(&nullcone(folder.path(), arguments), &["./mannequin"]);
}

/// Two views that do not belong together: the right one shows another frame, and shifted.
#[test]
fn a_bad_fit_is_doubtful() {
    let folder = inputs();
    let good = fit(folder.path(), "joints.json", "rig.yml", &["--check"]);
    let good = report(&good);
    assert_eq!(good["verdict"], "good");
    assert_eq!(good["warnings"], json!([]));

    let path = folder.path().join("joints.json");
    let mut joints: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
    for (index, place) in joints["views"][1]["frames"][2]
        .as_array_mut()
        .unwrap()
        .iter_mut()
        .enumerate()
    {
        if let Some(place) = place.as_array_mut() {
            let v = place[1].as_f64().unwrap();
            place[1] = json!(v + 80.0 * (index % 3) as f64 - 80.0);
        }
    }
    std::fs::write(&path, joints.to_string()).unwrap();
    let output = fit(folder.path(), "joints.json", "rig.yml", &["--check"]);
    assert_eq!(output.status.code(), Some(3), "{}", text(&output.stderr));
    let bad: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(bad["verdict"], "doubtful");
    let warnings = bad["warnings"].as_array().unwrap();
    let of_frames = |warning: &&Value| warning["frame"].is_number();
    let warning = warnings.iter().find(of_frames).unwrap();
    assert_eq!(warning["kind"], "large_error");
    let message = warning["message"].as_str().unwrap();
    assert!(message.contains("the worst is 2,"), "{message}");
}

#[test]
fn one_view_needs_a_camera() {
    let folder = inputs();
    let report = report(&fit(folder.path(), "one.json", "camera.yml", &[]));
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
    let other =
        "body fit --joints joints.json --rig rig.yml --character mannequin --out fitted.obj";
    let other = nullcone(folder.path(), other.split(' '));
    assert_failure(&other, &["fitted.obj", ".glb"]);
    // A character without a skin.
    std::fs::write(
        folder.path().join("box.gltf"),
        r#"{"asset": {"version": "2.0"}}"#,
    )
    .unwrap();
    let other = "body fit --joints joints.json --rig rig.yml --character box.gltf --out fitted.glb";
    let other = nullcone(folder.path(), other.split(' '));
    assert_failure(&other, &["box.gltf", "skin"]);
    assert!(!folder.path().join("fitted.glb").exists());
}

/// The rig of the walk in every format, and as views: the same poses, byte for byte.
#[test]
fn rigs_of_all_formats_are_fitted_alike() {
    let folder = inputs();
    let path = folder.path();
    let row = "[1000 0 960; 0 1000 540; 0 0 1]";
    let calib = format!("cam0={row}\ncam1={row}\nbaseline=1000\n");
    std::fs::write(path.join("calib.txt"), calib).unwrap();
    let view = |name: &str, x: f64| {
        json!({"picture": name, "translation": [x, 0, 0],
            "rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
            "camera": {"width": 1920, "height": 1080, "fx": 1000, "fy": 1000, "cx": 960, "cy": 540}})
    };
    let views = json!({"views": [view("left.png", 0.0), view("right.png", -1.0)]});
    std::fs::write(path.join("views.json"), views.to_string()).unwrap();
    let fitted = ["rig.yml", "calib.txt", "views.json"].map(|rig| {
        assert_success(&fit(path, "joints.json", rig, &[]));
        std::fs::read(path.join("fitted.glb")).unwrap()
    });
    assert!(greatest_error(&path.join("fitted.glb")) < 0.01);
    assert!(fitted[0] == fitted[1] && fitted[0] == fitted[2]);

    // One view takes one camera, of a rig by its name.
    let output = fit(path, "one.json", "rig.yml", &[]);
    assert_failure(&output, &["left, right", "--view NAME"]);
    let one = |rig: &str, more: &[&str]| {
        assert_success(&fit(path, "one.json", rig, more));
        std::fs::read(path.join("fitted.glb")).unwrap()
    };
    assert!(one("camera.yml", &[]) == one("views.json", &["--view", "left"]));
    // Cameras in the world of a file need poses.
    let arguments = ["--joints", "one.json", "--views", "camera.yml"];
    assert_failure(&fit_with(path, &arguments), &["camera.yml", "no pose"]);
}

/// Three cameras in the world of the walk, at the heights and in the directions of the angles, as
/// a file of views: of pictures that are not there.
pub(crate) fn views(folder: &Path) -> Vec<[[f64; 4]; 3]> {
    let cameras: Vec<[[f64; 4]; 3]> = [0.0_f64, 1.2, 3.0]
        .map(|angle| {
            let (s, c) = angle.sin_cos();
            // x to the right, y down and z forwards, four metres from the place of the walk.
            let axes = [[c, 0.0, -s], [0.0, -1.0, 0.0], [-s, 0.0, -c]];
            let eye = [PLACE[0] + 4.0 * s, PLACE[1] + 1.0, PLACE[2] + 4.0 * c];
            axes.map(|axis| {
                let along: f64 = axis.iter().zip(eye).map(|(a, x)| a * x).sum();
                [axis[0], axis[1], axis[2], -along]
            })
        })
        .to_vec();
    let entries = cameras.iter().enumerate().map(|(index, rows)| {
        json!({
            "picture": format!("view-{index:03}.png"),
            "camera": {"width": 1920, "height": 1080, "fx": 1000, "fy": 1000, "cx": 960, "cy": 540},
            "rotation": rows.map(|[x, y, z, _]| [x, y, z]),
            "translation": rows.map(|[.., t]| t),
        })
    });
    let entries: Vec<Value> = entries.collect();
    let text = json!({ "views": entries }).to_string();
    std::fs::write(folder.join("views.json"), text).unwrap();
    cameras
}

pub(crate) fn seen_by(camera: &[[f64; 4]; 3], [x, y, z]: [f64; 3]) -> [f64; 2] {
    let [u, v, depth] = camera.map(|[a, b, c, t]| a * x + b * y + c * z + t);
    [960.0 + 1000.0 * u / depth, 540.0 + 1000.0 * v / depth]
}

/// The joints in views of these names, `factor` times as far from the ground and each other.
pub(crate) fn in_views(
    cameras: &[[[f64; 4]; 3]],
    names: &[&str],
    factor: f64,
    deviation: f64,
) -> String {
    let views = names.iter().zip(cameras).map(|(name, camera)| {
        let pixel = |place: &[f64; 3]| {
            seen_by(
                camera,
                [0, 1, 2].map(|k| PLACE[k] + factor * (place[k] - PLACE[k])),
            )
        };
        let frames = truth()
            .iter()
            .map(|frame| frame.iter().map(pixel).collect());
        let frames: Vec<Vec<[f64; 2]>> = frames.collect();
        json!({"name": name, "frames": frames})
    });
    let views: Vec<Value> = views.collect();
    json!({"version": 1, "frames_per_second": RATE, "deviation_px": deviation, "joints": JOINTS,
        "views": views})
    .to_string()
}

#[test]
fn any_number_of_views_belong_to_pictures_by_name_or_in_order() {
    let folder = inputs();
    let path = folder.path();
    let cameras = views(path);
    let write = |name: &str, text: String| std::fs::write(path.join(name), text).unwrap();
    let [a, b, c] = [cameras[0], cameras[1], cameras[2]];
    write(
        "three.json",
        in_views(&[a, b, c], &["a", "b", "c"], 1.0, 0.05),
    );
    write(
        "named.json",
        in_views(&[c, a], &["view-002", "view-000.png"], 1.0, 0.05),
    );
    let with = |joints: &str| fit_with(path, &["--joints", joints, "--views", "views.json"]);
    for (joints, count) in [("three.json", 3), ("named.json", 2)] {
        let report = report(&with(joints));
        assert_eq!(report["views"], count);
        assert_eq!(report["per_view"].as_array().unwrap().len(), count);
        assert_eq!(
            number(&report, "/per_view/1/joints_seen"),
            (FRAMES * JOINTS.len()) as f64
        );
        assert!(number(&report, "/per_view/1/reprojection_rms_px") < 0.2);
        let error = greatest_error(&path.join("fitted.glb"));
        assert!(error < 0.01, "{joints}: {error} m");
        std::fs::remove_file(path.join("fitted.glb")).unwrap();
    }
    write("two.json", in_views(&[a, b], &["a", "b"], 1.0, 0.05));
    write(
        "lost.json",
        in_views(&[a, b], &["view-000", "front"], 1.0, 0.05),
    );
    write(
        "twice.json",
        in_views(&[a, b], &["view-000", "view-000.png"], 1.0, 0.05),
    );
    assert_failure(&with("two.json"), &["views.json", "2 views", "3 cameras"]);
    assert_failure(&with("lost.json"), &["views.json", "\"front\""]);
    assert_failure(
        &with("twice.json"),
        &["views.json", "\"view-000\"", "one picture"],
    );
    let rig = fit(path, "three.json", "rig.yml", &[]);
    assert_failure(&rig, &["rig.yml", "3 views", "--views"]);
    assert!(!path.join("fitted.glb").exists());
    // Cameras are needed, and only once.
    for cameras in [&[][..], &["--rig", "rig.yml", "--views", "views.json"]] {
        let output = fit_with(path, &[&["--joints", "three.json"], cameras].concat());
        assert_eq!(output.status.code(), Some(2));
    }
}

#[test]
fn lengths_are_those_of_the_person_on_request() {
    let folder = inputs();
    let path = folder.path();
    let cameras = views(path);
    let names = ["view-000", "view-001", "view-002"];
    let text = in_views(&cameras, &names, 1.2, 0.3);
    std::fs::write(path.join("large.json"), text).unwrap();
    let with = |more: &[&str]| {
        let given = ["--joints", "large.json", "--views", "views.json"];
        fit_with(path, &[&given, more].concat())
    };
    let own = report(&with(&[]));
    assert!(own.get("length_factors").is_none());
    // All frames show all joints.
    let rms = number(&own, "/reprojection_rms_px");
    let squares = own["per_frame"].as_array().unwrap().iter();
    let squares = squares.map(|frame| number(frame, "/reprojection_rms_px").powi(2));
    assert!((rms - (squares.sum::<f64>() / FRAMES as f64).sqrt()).abs() < 1e-9 * rms);
    assert!(rms > 5.0 && number(&own, "/reprojection_max_px") > rms);
    for lengths in ["--fit-lengths=size", "--fit-lengths"] {
        let found = report(&with(&[lengths]));
        assert!(number(&found, "/reprojection_rms_px") < 0.3, "{lengths}");
        for bone in ["Hips", "LeftLowerLeg", "RightHand"] {
            let factor = number(&found, &format!("/length_factors/{bone}"));
            assert!((factor - 1.2).abs() < 0.01, "{lengths}, {bone}: {factor}");
        }
        // The heights of the joints above the ground, in the file.
        let document = ga_mesh::gltf::read(path.join("fitted.glb")).unwrap();
        let pose = Player::new(&document).unwrap().pose(Some(0), 0.0).unwrap();
        for (name, place) in JOINTS.iter().zip(&truth()[0]) {
            let node = document
                .nodes
                .iter()
                .position(|n| n.name.as_deref() == Some(*name));
            let height = pose.world[node.unwrap()].translation[1] - PLACE[1];
            let wanted = 1.2 * (place[1] - PLACE[1]);
            assert!((height - wanted).abs() < 0.01, "{name}: {height} {wanted}");
        }
    }
    let one = fit(path, "one.json", "camera.yml", &["--fit-lengths"]);
    assert_failure(&one, &["one.json", "two views"]);
}

/// What detectors write: COCO's results for each view.
#[test]
fn joints_of_detectors_are_fitted() {
    const COCO: [(usize, &str); 12] = [
        (5, "LeftUpperArm"),
        (6, "RightUpperArm"),
        (7, "LeftLowerArm"),
        (8, "RightLowerArm"),
        (9, "LeftHand"),
        (10, "RightHand"),
        (11, "LeftUpperLeg"),
        (12, "RightUpperLeg"),
        (13, "LeftLowerLeg"),
        (14, "RightLowerLeg"),
        (15, "LeftFoot"),
        (16, "RightFoot"),
    ];
    let folder = inputs();
    for view in 0..2 {
        let picture = |frame: usize| {
            let mut numbers = vec![0.0; 3 * 17];
            for (joint, name) in COCO {
                let index = JOINTS.iter().position(|other| *other == name).unwrap();
                let [u, v] = pixel(truth()[frame][index], view);
                numbers[3 * joint..3 * joint + 3].copy_from_slice(&[u, v, 1.0]);
            }
            // Another person, who is seen less well.
            let other: Vec<f64> = numbers.iter().map(|x| 0.5 * x).collect();
            [other, numbers].map(|n| json!({"image_id": frame, "category_id": 1, "keypoints": n}))
        };
        let pictures: Vec<Value> = (0..FRAMES).flat_map(picture).collect();
        let name = ["left.json", "right.json"][view];
        let text = Value::from(pictures).to_string();
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    let given = "--joints left.json right.json --rig rig.yml --deviation 0.05 --fps 25";
    let given: Vec<&str> = given.split(' ').collect();
    let found = report(&fit_with(folder.path(), &given));
    assert_eq!(found["joints"].as_array().unwrap().len(), 12);
    let without = found["joints_without_counterpart"].as_array().unwrap();
    assert!(without.is_empty());
    let skin = found["points_of_the_skin"].as_array().unwrap();
    assert_eq!((skin.len(), &skin[0]), (5, &json!("nose")));
    assert!(number(&found, "/reprojection_rms_px") < 0.3);
    let lost = [&given[..], &["--person", "2"]].concat();
    let lost = fit_with(folder.path(), &lost);
    assert_failure(&lost, &["picture 0", "person 2", "2 of them"]);
    let zero = fit_with(
        folder.path(),
        &[&given[..5], &["--deviation", "0"]].concat(),
    );
    assert_failure(&zero, &["--deviation 0"]);
}

/// A view of AlphaPose with the joints of Halpe, whose pictures have plain numbers, without those
/// in which nobody was found.
#[test]
fn frames_without_people_keep_their_times_and_are_warned_of() {
    const HALPE: [(usize, &str); 4] = [
        (5, "LeftUpperArm"),
        (6, "RightUpperArm"),
        (11, "LeftUpperLeg"),
        (12, "RightUpperLeg"),
    ];
    const NOBODY: [usize; 3] = [5, 6, 7];
    let folder = inputs();
    for view in 0..2 {
        let picture = |frame: usize| {
            let mut numbers = vec![0.0; 3 * 26];
            for (joint, name) in HALPE {
                let index = JOINTS.iter().position(|other| *other == name).unwrap();
                let [u, v] = pixel(truth()[frame][index], view);
                numbers[3 * joint..3 * joint + 3].copy_from_slice(&[u, v, 1.0]);
            }
            json!({"image_id": format!("{frame}.jpg"), "category_id": 1, "keypoints": numbers})
        };
        let seen = (0..12).filter(|frame| !NOBODY.contains(frame));
        let text = Value::from(seen.map(picture).collect::<Vec<_>>()).to_string();
        std::fs::write(folder.path().join(format!("{view}.json")), text).unwrap();
    }
    let given = "--joints 0.json 1.json --rig rig.yml --deviation 0.05 --fps 25";
    let given: Vec<&str> = given.split(' ').collect();
    let found = report(&fit_with(folder.path(), &given));
    assert_eq!(found["frames"], 12);
    assert!(number(&found, "/reprojection_rms_px") < 0.3);
    let all = found["joints"].as_array().unwrap().len();
    for frame in 0..12 {
        let unseen = found["per_frame"][frame]["joints_unseen"]
            .as_array()
            .unwrap();
        let is_seen = unseen.len() < all;
        assert_eq!(is_seen, !NOBODY.contains(&frame), "{frame}");
    }
    let warnings = found["warnings"].as_array().unwrap();
    for view in ["0", "1"] {
        let mut warnings = warnings.iter();
        let warning = warnings.find(|warning| warning["view"] == view).unwrap();
        assert_eq!(warning["kind"], "frames_without_people");
        assert_eq!(warning["count"], 3);
    }
}

#[test]
fn the_model_of_a_detector_can_be_given() {
    let folder = inputs();
    let list = |count: usize| {
        let numbers: Vec<f64> = vec![1.0; 3 * count];
        json!([{"image_id": 0, "keypoints": numbers}]).to_string()
    };
    std::fs::write(folder.path().join("16.json"), list(16)).unwrap();
    let with = |more: &[&str]| fit(folder.path(), "16.json", "camera.yml", more);
    assert_failure(
        &with(&[]),
        &[
            "16.json",
            "picture 0",
            "16 joints",
            "mpii16 (16)",
            "--model",
        ],
    );
    let wrong = with(&["--model", "halpe26"]);
    assert_failure(&wrong, &["16.json", "16 joints", "halpe26 has 26"]);
    let unknown = with(&["--model", "coco19"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert!(
        text(&unknown.stderr).contains("body25b"),
        "{}",
        text(&unknown.stderr)
    );
}

//! `nullcone clip retarget`.

use std::fmt::Write as _;
use std::path::Path;

use ga_anim::bvh;
use nullcone_shared_data::shared;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, json, names, nullcone, text};

/// Parent and place of the joints of a person in metres.
const BODY: [(Option<usize>, [f64; 3]); 12] = [
    (None, [0.0, 0.95, 0.0]),
    (Some(0), [0.0, 1.2, 0.02]),
    (Some(1), [0.0, 1.5, 0.0]),
    (Some(1), [0.2, 1.4, 0.0]),
    (Some(3), [0.48, 1.4, 0.0]),
    (Some(4), [0.74, 1.4, 0.0]),
    (Some(0), [0.1, 0.9, 0.0]),
    (Some(6), [0.1, 0.5, 0.02]),
    (Some(7), [0.1, 0.08, 0.0]),
    (Some(0), [-0.1, 0.9, 0.0]),
    (Some(9), [-0.1, 0.5, 0.02]),
    (Some(10), [-0.1, 0.08, 0.0]),
];
const CMU: [&str; 12] = [
    "Hips",
    "Spine",
    "Head",
    "LeftArm",
    "LeftForeArm",
    "LeftHand",
    "LeftUpLeg",
    "LeftLeg",
    "LeftFoot",
    "RightUpLeg",
    "RightLeg",
    "RightFoot",
];
const BIPED: [&str; 12] = [
    "Bip01 Pelvis",
    "Bip01 Spine",
    "Bip01 Head",
    "Bip01 L UpperArm",
    "Bip01 L Forearm",
    "Bip01 L Hand",
    "Bip01 L Thigh",
    "Bip01 L Calf",
    "Bip01 L Foot",
    "Bip01 R Thigh",
    "Bip01 R Calf",
    "Bip01 R Foot",
];
const FRAMES: usize = 40;

/// The body with these names, in units of which a metre has `scale`, with another place of each
/// joint, and moving joints.
fn body(names: &[&str], scale: f64, place: impl Fn(usize, [f64; 3]) -> [f64; 3]) -> String {
    fn joint(index: usize, names: &[&str], places: &[[f64; 3]], text: &mut String) {
        let parent = BODY[index].0;
        let above = parent.map_or([0.0; 3], |parent| places[parent]);
        let [x, y, z]: [f64; 3] = std::array::from_fn(|k| places[index][k] - above[k]);
        let (keyword, positions) = match parent {
            None => ("ROOT", "6 Xposition Yposition Zposition"),
            Some(_) => ("JOINT", "3"),
        };
        let name = names[index];
        writeln!(
            text,
            "{keyword} {name}\n{{\nOFFSET {x} {y} {z}\nCHANNELS {positions} Zrotation Yrotation Xrotation"
        )
        .unwrap();
        let children = (0..BODY.len()).filter(|&child| BODY[child].0 == Some(index));
        for child in children.clone() {
            joint(child, names, places, text);
        }
        if children.count() == 0 {
            *text += "End Site\n{\nOFFSET 0 0 0.1\n}\n";
        }
        *text += "}\n";
    }
    let places: Vec<[f64; 3]> = BODY
        .iter()
        .enumerate()
        .map(|(index, &(_, at))| place(index, at).map(|x| x * scale))
        .collect();
    let mut motion = "HIERARCHY\n".to_owned();
    joint(0, names, &places, &mut motion);
    writeln!(motion, "MOTION\nFrames: {FRAMES}\nFrame Time: 0.01").unwrap();
    for frame in 0..FRAMES {
        let angle = |k: usize| {
            let wave = (0.07 * frame as f64 + k as f64).sin();
            let is_knee = matches!(k / 3, 7 | 10);
            // Knees bend backwards about x.
            let degrees = match (is_knee, k % 3) {
                (true, 2) => 25.0 + 15.0 * wave,
                (true, _) => 0.0,
                _ => 20.0 * wave,
            };
            degrees.to_string()
        };
        let way = [0.01, 0.0, 0.02];
        let place = [0, 1, 2].map(|k| places[0][k] + scale * way[k] * frame as f64);
        let place = place.map(|x: f64| x.to_string());
        let numbers: Vec<String> = place
            .into_iter()
            .chain((0..3 * BODY.len()).map(angle))
            .collect();
        writeln!(motion, "{}", numbers.join(" ")).unwrap();
    }
    motion
}

fn folder() -> TempDir {
    let folder = tempdir().unwrap();
    let write = |name: &str, contents: String| {
        std::fs::write(folder.path().join(name), contents).unwrap();
    };
    write("cmu.bvh", body(&CMU, 1.0, |_, place| place));
    // Centimetres, longer legs, another trunk, arms lower.
    let other = |index: usize, [x, y, z]: [f64; 3]| match index {
        0 | 6 | 9 => [1.4 * x, y + 0.1, z],
        1 => [x, y + 0.1, z + 0.05],
        2 => [x, y + 0.2, z - 0.08],
        5 => [0.65, 1.2, 0.1],
        _ => [1.4 * x, y, z],
    };
    write("biped.bvh", body(&BIPED, 100.0, other));
    let nameless: Vec<String> = (0..12).map(|k| format!("j{}", k * 5 % 12)).collect();
    let nameless: Vec<&str> = nameless.iter().map(String::as_str).collect();
    write("nameless.bvh", body(&nameless, 100.0, other));
    folder
}

/// The places of the joints at a time, in the order of BODY.
#[track_caller]
fn places(folder: &Path, motion: &str, names: &[&str], time: f64) -> Vec<[f64; 3]> {
    let time = time.to_string();
    let sample = json(folder, &["clip", "sample", motion, "--times", &time]);
    let joints = sample["samples"][0]["joints"].as_array().unwrap();
    let place = |name: &&str| {
        let joint = joints.iter().find(|joint| joint["joint"] == **name);
        let rows = &joint.unwrap()["matrix"];
        std::array::from_fn(|row| rows[row][3].as_f64().unwrap())
    };
    names.iter().map(place).collect()
}

/// The angle between the bones from one joint to another in two bodies.
fn angle(a: &[[f64; 3]], b: &[[f64; 3]], from: usize, to: usize) -> f64 {
    let direction = |places: &[[f64; 3]]| {
        let v: [f64; 3] = std::array::from_fn(|k| places[to][k] - places[from][k]);
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / length)
    };
    let (a, b) = (direction(a), direction(b));
    let chord = (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
    2.0 * (chord / 2.0).asin()
}

/// One bone of each joint, and the trunk from hips to head.
const BONES: [(usize, usize); 8] = [
    (0, 1),
    (0, 2),
    (3, 4),
    (4, 5),
    (6, 7),
    (7, 8),
    (9, 10),
    (10, 11),
];

#[test]
fn matched_bones_point_as_those_of_the_motion() {
    let folder = folder();
    let path = folder.path();
    for (target, known, by) in [
        ("biped.bvh", true, "names"),
        ("nameless.bvh", false, "structure"),
    ] {
        let nameless: Vec<String> = (0..12).map(|k| format!("j{}", k * 5 % 12)).collect();
        let own: Vec<&str> = match known {
            true => BIPED.to_vec(),
            false => nameless.iter().map(String::as_str).collect(),
        };
        for out in ["out.bvh", "out.glb", "out.gltf"] {
            let retarget = [
                "clip", "retarget", "cmu.bvh", "--target", target, "--out", out,
            ];
            let report = json(path, &[&retarget[..], &["--align", "all"]].concat());
            assert_eq!(report["frames"], FRAMES);
            // By structure no arm is known, which is said.
            let verdict = if known { "good" } else { "doubtful" };
            assert_eq!(report["verdict"], verdict);
            let confidence = report["mapping"]["confidence"].as_f64().unwrap();
            assert_eq!(confidence > 0.7, known, "{confidence}");
            assert_eq!(report["map_by"], by);
            for (index, name) in CMU.iter().enumerate() {
                // Only one arm: the structure does not tell arms.
                if known || !(1..=5).contains(&index) {
                    assert_eq!(report["map"][name], own[index], "{name}");
                }
            }
            for frame in [0, 17, 39] {
                let time = 0.01 * f64::from(frame);
                let there = places(path, "cmu.bvh", &CMU, time);
                let here = places(path, out, &own, time);
                for (from, to) in BONES {
                    if known || from >= 6 {
                        let angle = angle(&there, &here, from, to);
                        assert!(angle < 1e-6, "{out}: {} to {}: {angle}", own[from], own[to]);
                    }
                }
            }
        }
    }
    assert!(names(path).contains(&"out.gltf".to_owned()));
}

#[test]
fn a_map_that_is_printed_can_be_given() {
    let folder = folder();
    let path = folder.path();
    let retarget = [
        "clip",
        "retarget",
        "cmu.bvh",
        "--target",
        "biped.bvh",
        "--out",
    ];
    let report = json(path, &[&retarget[..], &["a.bvh"]].concat());
    std::fs::write(path.join("map.json"), report["map"].to_string()).unwrap();
    let again = json(
        path,
        &[&retarget[..], &["b.bvh", "--map", "map.json"]].concat(),
    );
    assert_eq!(again["map_by"], "file");
    assert_eq!(again["map"], report["map"]);
    let read = |name: &str| std::fs::read_to_string(path.join(name)).unwrap();
    assert_eq!(read("a.bvh"), read("b.bvh"));
    // The channels of the target are kept.
    assert!(read("a.bvh").contains("CHANNELS 3 Zrotation Yrotation Xrotation"));

    // From a clip and onto itself.
    let compress = [
        "clip",
        "compress",
        "cmu.bvh",
        "--tolerance",
        "0.00001",
        "--out",
        "cmu.clip",
    ];
    json(path, &compress);
    let onto = [
        "clip", "retarget", "cmu.clip", "--target", "cmu.bvh", "--out", "c.clip",
    ];
    let report = json(path, &onto);
    assert!((report["target_units_per_unit"].as_f64().unwrap() - 1.0).abs() < 1e-6);
    let (a, b) = (
        places(path, "cmu.bvh", &CMU, 0.2),
        places(path, "c.clip", &CMU, 0.2),
    );
    let lift = a[0][1] - b[0][1];
    for (a, b) in a.iter().zip(&b) {
        let b = [b[0], b[1] + lift, b[2]];
        assert!(
            (0..3).all(|k| (a[k] - b[k]).abs() < 3e-4),
            "{a:?} and {b:?}"
        );
    }
    // The trunk keeps its form.
    let limbs = [&retarget[..], &["l.bvh", "--align", "limbs"]].concat();
    json(path, &limbs);
    let there = places(path, "cmu.bvh", &CMU, 0.1);
    let here = places(path, "l.bvh", &BIPED, 0.1);
    assert!(angle(&there, &here, 0, 1) > 0.01 && angle(&there, &here, 6, 7) < 1e-6);
}

#[test]
fn what_cannot_be_retargeted_is_an_error_and_writes_nothing() {
    let folder = folder();
    let path = folder.path();
    std::fs::write(path.join("map.json"), r#"{"Tail": "Bip01 Pelvis"}"#).unwrap();
    let before = names(path);
    let run = |arguments: &[&str]| nullcone(path, [&["clip", "retarget"][..], arguments].concat());
    for (arguments, parts) in [
        (
            &["cmu.bvh", "--target", "biped.bvh", "--out", "out.txt"][..],
            &["--out", "out.txt"][..],
        ),
        (
            &["cmu.bvh", "--target", "cmu.txt", "--out", "out.bvh"],
            &["--target", "cmu.txt"],
        ),
        (
            &[
                "cmu.bvh",
                "--target",
                "biped.bvh",
                "--map",
                "map.json",
                "--out",
                "out.bvh",
            ],
            &["map.json", "the motion has no joint \"Tail\""],
        ),
        (
            &[
                "cmu.bvh",
                "--target",
                "biped.bvh",
                "--target-metres-per-unit",
                "0",
                "--out",
                "out.bvh",
            ],
            &["--target-metres-per-unit 0"],
        ),
        (
            &["nothing.bvh", "--target", "biped.bvh", "--out", "out.bvh"],
            &["nothing.bvh"],
        ),
        (
            &[
                "cmu.bvh",
                "--target",
                "biped.bvh",
                "--out",
                "out.bvh",
                "--tolerance",
                "0.01",
            ],
            &["--tolerance does not apply to out.bvh"],
        ),
        (
            &[
                "cmu.bvh",
                "--target",
                "biped.bvh",
                "--out",
                "out.glb",
                "--replace",
            ],
            &["--replace does not apply to biped.bvh"],
        ),
    ] {
        assert_failure(&run(arguments), parts);
    }
    assert_eq!(names(path), before);
    let help = nullcone(path, ["clip", "retarget", "--help"]);
    let help = text(&help.stdout);
    assert!(help.contains("nullcone clip retarget 01_01.bvh"));
}

/// The recording on a figure without names, whose nodes stand in the middle of a step.
#[test]
fn real_feet_stand_in_what_is_written() {
    let (Some(motion), Some(man)) = (
        shared("data/anim/bvh/01_01.bvh"),
        shared("data/anim/gltf/cesium_man.gltf"),
    ) else {
        return;
    };
    let folder = tempdir().unwrap();
    let path = folder.path();
    let [motion, man] = [motion, man].map(|path| path.to_str().unwrap().to_owned());
    let unit = ["--metres-per-unit", "0.056444"];
    let retarget = [
        "clip", "retarget", &motion, "--target", &man, "--out", "man.glb",
    ];
    let report = json(path, &[&retarget[..], &unit, &["--foot-locking"]].concat());
    assert_eq!(report["frames"], 2752);
    assert_eq!(report["map_by"], "structure");
    assert!(
        report["slide_metres"].as_f64().unwrap() <= 0.005,
        "{report}"
    );
    assert_eq!(report["feet"].as_array().unwrap().len(), 2);
    assert!(report["short_by_metres"].as_f64().unwrap() < 0.05);
    // The skin is there and moves.
    let skin = [
        "skin", "man.glb", "--time", "5", "--method", "linear", "--out", "man.obj",
    ];
    assert_success(&nullcone(path, skin));
}

#[test]
fn a_reference_and_a_vertical_are_given_by_options() {
    let folder = folder();
    let before = names(folder.path());
    let retarget = |more: &[&str]| {
        let words = [
            "clip",
            "retarget",
            "cmu.bvh",
            "--target",
            "biped.bvh",
            "--out",
            "o.bvh",
        ];
        nullcone(folder.path(), [&words, more].concat())
    };
    assert_failure(
        &retarget(&["--reference-frame", "4000"]),
        &["cmu.bvh", "the motion has no frame 4000 for reference"],
    );
    assert_failure(
        &retarget(&["--reference-pose", "biped.bvh"]),
        &["--reference-pose biped.bvh", "has no joint"],
    );
    assert_eq!(names(folder.path()), before);
    let written = |more: &[&str]| {
        assert_success(&retarget(more));
        std::fs::read(folder.path().join("o.bvh")).unwrap()
    };
    // The motion has y up, and its first frame stands as the same file's.
    let found = written(&[]);
    assert!(written(&["--up", "y"]) == found);
    assert!(written(&["--up", "-z"]) != found);
    let placed = |more: &[&str]| {
        written(more);
        places(folder.path(), "o.bvh", &BIPED, 0.17)
    };
    let frame = placed(&["--reference-frame", "0"]);
    let pose = placed(&["--reference-pose", "cmu.bvh"]);
    for (frame, pose) in frame.iter().flatten().zip(pose.iter().flatten()) {
        assert!((frame - pose).abs() < 1e-9, "{frame} {pose}");
    }
}

#[test]
fn what_another_format_leaves_out_of_the_target_is_listed() {
    let (Some(motion), Some(man)) = (
        shared("cases/motion/rest-not-upright/upright.bvh"),
        shared("data/anim/gltf/cesium_man.gltf"),
    ) else {
        return;
    };
    let folder = tempdir().unwrap();
    let [motion, man] = [motion, man].map(|path| path.to_str().unwrap().to_owned());
    let left_out = |out: &str| -> Vec<String> {
        let words = ["clip", "retarget", &motion, "--target", &man, "--out", out];
        let report = json(folder.path(), &words);
        let warnings = report["warnings"].as_array().cloned().unwrap_or_default();
        let kinds = warnings
            .iter()
            .map(|warning| warning["kind"].as_str().unwrap().to_owned());
        kinds.filter(|kind| kind.ends_with("left_out")).collect()
    };
    // One mesh with its skin, and one animation of its own; joints have axes.
    let beside = ["meshes_left_out", "animations_left_out"];
    assert_eq!(left_out("man.clip"), beside);
    assert_eq!(
        left_out("man.bvh"),
        [&beside[..], &["joint_axes_left_out"]].concat()
    );
    assert!(left_out("man.glb").is_empty());
}

/// What a format does not hold of a target is said, and is no doubt about the motion.
#[test]
fn ends_of_bones_are_kept_or_listed() {
    let folder = folder();
    let lost = |out: &str| {
        let words = [
            "clip",
            "retarget",
            "cmu.bvh",
            "--target",
            "biped.bvh",
            "--out",
            out,
        ];
        let report = json(folder.path(), &words);
        assert_eq!(report["verdict"], "good", "{out}");
        let warnings = report["warnings"].as_array().unwrap().iter();
        let kinds = warnings.map(|warning| warning["kind"].as_str().unwrap().to_owned());
        kinds.collect::<Vec<_>>()
    };
    assert_eq!(lost("o.bvh"), [""; 0]);
    assert_eq!(lost("o.glb"), ["end_sites_left_out"]);
    assert_eq!(lost("o.clip"), ["end_sites_left_out"]);
    let [before, after] = ["biped.bvh", "o.bvh"].map(|name| {
        let text = std::fs::read_to_string(folder.path().join(name)).unwrap();
        bvh::decode(text.as_bytes()).unwrap().joints().to_vec()
    });
    assert_eq!(before, after);
}

/// The skeleton of a recording is the same after its compression.
#[test]
fn a_compressed_clip_is_a_target() {
    let folder = folder();
    let path = folder.path();
    let compress = ["clip", "compress", "biped.bvh", "--tolerance", "0.00001"];
    json(path, &[&compress[..], &["--out", "biped.clip"]].concat());
    let retarget = |target: &str, out: &str| {
        let words = [
            "clip", "retarget", "cmu.bvh", "--target", target, "--out", out,
        ];
        json(path, &words)
    };
    let truth = retarget("biped.bvh", "truth.bvh");
    for out in ["o.bvh", "o.glb", "o.clip"] {
        let report = retarget("biped.clip", out);
        for key in ["map", "map_by", "frames", "joints", "verdict"] {
            assert_eq!(report[key], truth[key], "{key}");
        }
        assert_eq!(report["target_metres_per_unit"], 1.0);
        for time in [0.0, 0.17, 0.39] {
            let [found, known] =
                [out, "truth.bvh"].map(|motion| places(path, motion, &BIPED, time));
            for (found, known) in found.iter().flatten().zip(known.iter().flatten()) {
                assert!((found - known).abs() < 2e-3, "{out}: {found} {known}");
            }
        }
    }
    let words = [
        "clip",
        "retarget",
        "cmu.bvh",
        "--target",
        "biped.clip",
        "--out",
        "p.bvh",
    ];
    let unit = ["--target-metres-per-unit", "0.01"];
    assert_failure(
        &nullcone(path, [&words[..], &unit].concat()),
        &["--target-metres-per-unit", "biped.clip"],
    );
    assert!(!names(path).contains(&"p.bvh".to_owned()));
}

//! `nullcone animate` on a figure written by hand, and on a real one.

use std::path::Path;
use std::process::Output;

use nullcone_shared_data::shared;
use tempfile::{TempDir, tempdir};

use crate::common::figure::{self, RATE, STEP, UNITS};
use crate::common::{
    FILES, assert_success, contents, extent, heights, names, nullcone, number, report, text,
};

const FRAMES: usize = 26;

/// A folder with the figure of boxes in it.
fn boxes() -> TempDir {
    let folder = tempdir().unwrap();
    figure::write(folder.path(), FRAMES);
    folder
}

/// Animates the figure of boxes in a folder.
fn animate(folder: &Path, more: &[&str]) -> Output {
    let files = [
        "animate",
        "--mesh",
        "mesh.obj",
        "--rig",
        "rig.json",
        "--weights",
        "weights.json",
        "--motion",
        "motion.bvh",
    ];
    nullcone(folder, files.iter().chain(more))
}

/// The times and the places of a node in the only animation of a model.
fn track(model: &Path, node: &str) -> (Vec<f32>, Vec<[f32; 3]>) {
    let (document, buffers, _) = gltf::import(model).unwrap();
    let animation = document.animations().next().unwrap();
    let found = animation.channels().find_map(|channel| {
        if channel.target().node().name() != Some(node) {
            return None;
        }
        let reader = channel.reader(|buffer| Some(&buffers[buffer.index()]));
        let times = reader.read_inputs()?.collect();
        match reader.read_outputs()? {
            gltf::animation::util::ReadOutputs::Translations(places) => {
                Some((times, places.collect()))
            }
            _ => None,
        }
    });
    found.unwrap()
}

#[test]
fn a_figure_of_boxes_goes_as_its_motion_says() {
    let folder = boxes();
    let output = animate(folder.path(), &[]);
    assert_success(&output);
    assert!(output.stderr.is_empty(), "{}", text(&output.stderr));
    let out = folder.path().join("out");
    assert_eq!(names(&out), FILES);
    let report = report(&out);
    let close = |path: &str, expected: f64| {
        let found = number(&report, path);
        assert!((found - expected).abs() < 1e-9, "{path} is {found}");
    };
    close("/figure/height_metres", 1.7);
    close("/figure/vertices", 72.0);
    close("/figure/faces", 54.0);
    close("/figure/triangles", 108.0);
    close("/figure/joints", 9.0);
    close("/figure/influences_max", 2.0);
    close("/input/motion/metres_per_unit", 1.0 / UNITS);
    close("/input/motion/frames", FRAMES as f64);
    close("/input/motion/first_frame", 0.0);
    close("/input/motion/last_frame", (FRAMES - 1) as f64);
    close("/animation/checks/bone_length_deviation_max_metres", 0.0);
    close("/animation/checks/trunk_from_upright_max_degrees", 0.0);
    close("/animation/frames", 16.0);
    assert_eq!(report["figure"]["group"], "body");
    assert_eq!(
        report["input"]["motion"]["joints_without_counterpart"],
        serde_json::json!(["head"])
    );
    assert_eq!(
        report["input"]["motion"]["calibration_frame_left_out"],
        false
    );
    let heights = heights(&std::fs::read_to_string(out.join("model.obj")).unwrap());
    assert!((extent(&heights) - 1.7).abs() < 1e-12);

    let (times, places) = track(&out.join("model.glb"), "hips");
    for (time, place) in times.iter().zip(places) {
        let expected = f64::from(*time) * RATE * STEP / UNITS;
        assert!((f64::from(place[2]) - expected).abs() < 1e-6);
        assert!(place[0].abs() < 1e-6);
    }
}

#[test]
fn a_map_names_the_joints_that_belong_together() {
    let folder = boxes();
    let path = folder.path().join("motion.bvh");
    let motion = std::fs::read_to_string(&path).unwrap();
    // Names that say nothing, and one frame more than there are.
    let names: Vec<String> = motion
        .lines()
        .filter_map(|line| {
            line.trim()
                .strip_prefix("JOINT ")
                .or(line.strip_prefix("ROOT "))
        })
        .map(ToOwned::to_owned)
        .collect();
    let mut strange = motion.replace(
        &format!("Frames: {FRAMES}"),
        &format!("Frames: {}", FRAMES + 1),
    );
    assert_ne!(strange, motion);
    let mut map = serde_json::Map::new();
    for (index, name) in names.iter().enumerate() {
        for keyword in ["JOINT", "ROOT"] {
            strange = strange.replace(
                &format!("{keyword} {name}\n"),
                &format!("{keyword} q{index}\n"),
            );
        }
        map.insert(format!("q{index}"), name.clone().into());
    }
    assert_success(&animate(folder.path(), &[]));
    let expected = std::fs::read(folder.path().join("out/model.glb")).unwrap();
    std::fs::write(&path, strange).unwrap();
    let map = serde_json::Value::Object(map).to_string();
    std::fs::write(folder.path().join("map.json"), map).unwrap();
    let output = animate(folder.path(), &["--map", "map.json"]);
    assert_success(&output);
    let stderr = text(&output.stderr);
    assert_eq!(
        stderr.matches("warning: motion.bvh: line").count(),
        1,
        "{stderr}"
    );
    let found = std::fs::read(folder.path().join("out/model.glb")).unwrap();
    assert!(found == expected);
    let mapped = report(&folder.path().join("out"));
    assert_success(&animate(folder.path(), &[]));
    let unmapped = report(&folder.path().join("out"));
    // By structure another joint of the trunk is left out.
    let left_out = |report: &serde_json::Value| {
        report["input"]["motion"]["joints_without_counterpart"].clone()
    };
    assert_ne!(left_out(&mapped), left_out(&unmapped));

    std::fs::write(folder.path().join("map.json"), r#"{"q0": "tail"}"#).unwrap();
    let output = animate(folder.path(), &["--map", "map.json"]);
    assert!(!output.status.success());
    let stderr = text(&output.stderr);
    assert!(
        stderr.contains("map.json: the skeleton has no joint \"tail\""),
        "{stderr}"
    );
}

#[test]
fn frames_rate_group_and_unit_are_chosen() {
    let folder = boxes();
    let options = [
        "--from",
        "5",
        "--to",
        "9",
        "--fps",
        "100",
        "--group",
        "guide",
        "--metres-per-unit",
        "0.2",
        "--out",
        "o",
    ];
    // The triangle hangs on the head: the feet of the skeleton stand, which have no mesh.
    assert_success(&animate(folder.path(), &options));
    let (_, with_guide) = track(&folder.path().join("o/model.glb"), "hips");

    let options = options.map(|option| if option == "guide" { "body" } else { option });
    assert_success(&animate(folder.path(), &options));
    let report = report(&folder.path().join("o"));
    assert!((number(&report, "/figure/height_metres") - 3.4).abs() < 1e-12);
    assert_eq!(number(&report, "/input/motion/first_frame"), 5.0);
    assert_eq!(number(&report, "/input/motion/last_frame"), 9.0);
    assert_eq!(number(&report, "/animation/frames"), 9.0);
    let (times, places) = track(&folder.path().join("o/model.glb"), "hips");
    assert!((times.last().unwrap() - 0.08).abs() < 1e-6);
    let expected = 5.0 * STEP * 2.0 / UNITS;
    assert!((f64::from(places[0][2]) - expected).abs() < 1e-6);
    // On the triangle, the hips would be about as deep below the ground as they are above it.
    assert!(
        (places[0][1] - with_guide[0][1]).abs() < 0.2,
        "{places:?} {with_guide:?}"
    );
}

#[test]
fn one_frame_is_enough() {
    let folder = boxes();
    assert_success(&animate(folder.path(), &["--from", "3", "--to", "3"]));
    let report = report(&folder.path().join("out"));
    assert_eq!(number(&report, "/animation/frames"), 1.0);
    assert_eq!(
        number(&report, "/animation/in_between_deviation_max_metres"),
        0.0
    );
}

#[test]
fn a_calibration_frame_is_left_out_unless_it_is_asked_for() {
    let folder = boxes();
    std::fs::write(folder.path().join("motion.bvh"), figure::bvh(FRAMES, true)).unwrap();
    let output = animate(folder.path(), &[]);
    assert_success(&output);
    assert!(text(&output.stdout).contains("frame 0 is a calibration pose"));
    let left_out = report(&folder.path().join("out"));
    assert_eq!(number(&left_out, "/input/motion/first_frame"), 1.0);
    assert_eq!(
        left_out["input"]["motion"]["calibration_frame_left_out"],
        true
    );

    assert_success(&animate(folder.path(), &["--from", "0"]));
    let kept = report(&folder.path().join("out"));
    assert_eq!(number(&kept, "/input/motion/first_frame"), 0.0);
    assert_eq!(kept["input"]["motion"]["calibration_frame_left_out"], false);
}

#[test]
fn a_mesh_without_a_body_is_taken_whole() {
    let folder = boxes();
    let obj = figure::obj().replace("g body\n", "");
    std::fs::write(folder.path().join("mesh.obj"), obj).unwrap();
    assert_success(&animate(folder.path(), &[]));
    let report = report(&folder.path().join("out"));
    assert_eq!(number(&report, "/figure/vertices"), 75.0);
    assert!(report["figure"]["group"].is_null());
}

#[test]
fn nothing_in_the_files_tells_where_they_were_made() {
    let [here, there] = [boxes(), boxes()];
    assert_success(&animate(here.path(), &["--out", "a"]));
    let absolute = there.path().join("b/c");
    assert_success(&animate(
        there.path(),
        &["--out", absolute.to_str().unwrap()],
    ));
    assert!(contents(&here.path().join("a")) == contents(&absolute));
}

/// The CMU recording of a person who jumps ahead, turns round and jumps back, on the MakeHuman
/// person.
#[test]
fn a_real_recording_moves_a_real_figure() {
    let (Some(mesh), Some(rig), Some(weights), Some(motion)) = (
        shared("data/anim/human_base.obj"),
        shared("data/anim/human/rig.cmu_mb.json"),
        shared("data/anim/human/weights.cmu_mb.json"),
        shared("data/anim/bvh/01_01.bvh"),
    ) else {
        return;
    };
    let folder = tempdir().unwrap();
    let run = |out: &str, more: &[&str]| {
        let files = [
            ("--mesh", &mesh),
            ("--rig", &rig),
            ("--weights", &weights),
            ("--motion", &motion),
        ];
        let files = files.map(|(option, path)| [option, path.to_str().unwrap()]);
        let arguments = ["animate", "--out", out];
        let output = nullcone(
            folder.path(),
            arguments.iter().chain(files.as_flattened()).chain(more),
        );
        assert_success(&output);
        report(&folder.path().join(out))
    };
    let report = run("standing", &["--from", "900", "--to", "940"]);

    // The person is the first 13,380 vertices of the mesh, in decimetres.
    let source = heights(&std::fs::read_to_string(&mesh).unwrap());
    let height = extent(&source[..13_380]) / 10.0;
    assert_eq!(number(&report, "/figure/vertices"), 13_380.0);
    assert!((number(&report, "/figure/height_metres") - height).abs() < 1e-9);
    assert_eq!(
        report["input"]["motion"]["joints_without_counterpart"],
        serde_json::json!(["LeftHandFinger1", "RightHandFinger1"])
    );
    // The recording's unit is 1/0.45 inches, and the people are of about one size.
    let unit = number(&report, "/input/motion/metres_per_unit");
    assert!((unit / (0.0254 / 0.45) - 1.0).abs() < 0.1, "{unit}");
    let checks = |name: &str| number(&report, &format!("/animation/checks/{name}"));
    assert!(checks("bone_length_deviation_max_metres") < 1e-9);
    // From one jump to the next the person stands.
    assert!(checks("lowest_vertex_min_metres") > -0.02);
    assert!(checks("lowest_vertex_max_metres") < 0.03);
    assert!(checks("trunk_from_upright_max_degrees") < 20.0);
    assert!(checks("linear_to_motor_blend_max_metres") < 0.05);
    // The same measures as of `clip retarget`.
    assert!(number(&report, "/checks/longest_stretch") < 1e-9);
    assert!(number(&report, "/checks/trunk_from_upright_degrees") < 90.0);
    assert!(number(&report, "/checks/largest_rotation_degrees_per_frame") > 0.0);
    // A hand that swings, found from poses 1/12 s apart.
    let deviation = number(&report, "/animation/in_between_deviation_max_metres");
    assert!(deviation > 0.0 && deviation < 0.04, "{deviation}");

    let start = run("start", &["--to", "8"]);
    assert_eq!(number(&start, "/input/motion/first_frame"), 1.0);
    assert_eq!(start["input"]["motion"]["calibration_frame_left_out"], true);
}

/// A file that the program wrote is a character again, and moves in the same way.
#[test]
fn a_character_from_gltf_moves_as_its_parts_do() {
    let folder = boxes();
    let range = ["--from", "2", "--to", "20", "--fps", "20"];
    assert_success(&animate(folder.path(), &range));
    let first = track(&folder.path().join("out/model.glb"), "hips");
    let arguments = [
        "animate",
        "--character",
        "out/model.glb",
        "--motion",
        "motion.bvh",
    ];
    let again = ["--out", "again"];
    let output = nullcone(folder.path(), arguments.iter().chain(&range).chain(&again));
    assert_success(&output);
    let second = track(&folder.path().join("again/model.glb"), "hips");
    assert_eq!(first.0, second.0);
    for (a, b) in first.1.iter().zip(&second.1) {
        for axis in 0..3 {
            assert!((a[axis] - b[axis]).abs() < 1e-4, "{a:?} {b:?}");
        }
    }
}

#[test]
fn a_character_excludes_a_mesh_and_needs_a_skin() {
    let folder = boxes();
    let both = animate(folder.path(), &["--character", "model.glb"]);
    assert!(!both.status.success());
    let glb = ["mesh", "convert", "mesh.obj", "plain.glb"];
    assert_success(&nullcone(folder.path(), glb.iter()));
    let arguments = [
        "animate",
        "--character",
        "plain.glb",
        "--motion",
        "motion.bvh",
    ];
    let output = nullcone(folder.path(), arguments.iter());
    assert!(!output.status.success());
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        message.contains("plain.glb: no node has a skin"),
        "{message}"
    );
    assert!(!folder.path().join("out").exists());
}

/// The motion of the boxes is the same; the weights of the real figure change over more edges.
#[test]
fn weights_are_smoothed_and_feet_locked_where_asked() {
    let folder = boxes();
    let model = folder.path().join("out/model.glb");
    assert_success(&animate(folder.path(), &[]));
    let plain = std::fs::read(&model).unwrap();
    assert_success(&animate(folder.path(), &["--smooth-weights", "0"]));
    assert!(std::fs::read(&model).unwrap() == plain);
    assert_success(&animate(folder.path(), &["--foot-locking"]));
    let output = animate(folder.path(), &["--smooth-weights", "101"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("--smooth-weights 101"));

    let files = [
        shared("data/anim/human_base.obj"),
        shared("data/anim/human/rig.cmu_mb.json"),
        shared("data/anim/human/weights.cmu_mb.json"),
        shared("data/anim/bvh/01_01.bvh"),
    ];
    let [Some(mesh), Some(rig), Some(weights), Some(motion)] = files else {
        return;
    };
    let [mesh, rig, weights, motion] =
        [mesh, rig, weights, motion].map(|path| path.to_str().unwrap().to_owned());
    let frames = |out: &str, more: &[&str]| {
        let arguments = [
            "animate",
            "--mesh",
            &mesh,
            "--rig",
            &rig,
            "--weights",
            &weights,
            "--motion",
            &motion,
            "--from",
            "700",
            "--to",
            "710",
            "--out",
            out,
        ];
        assert_success(&nullcone(folder.path(), arguments.iter().chain(more)));
        report(&folder.path().join(out))
    };
    let [before, after] = [
        frames("painted", &[]),
        frames("smooth", &["--smooth-weights", "10", "--foot-locking"]),
    ];
    assert_eq!(number(&before, "/figure/influences_max"), 7.0);
    assert_eq!(number(&after, "/figure/influences_max"), 8.0);
    let weights = ["painted", "smooth"].map(|out| {
        let (document, buffers, _) =
            gltf::import(folder.path().join(out).join("model.glb")).unwrap();
        let primitive = document
            .meshes()
            .next()
            .unwrap()
            .primitives()
            .next()
            .unwrap();
        let reader = primitive.reader(|buffer| Some(&buffers[buffer.index()]));
        let rows: Vec<[f32; 4]> = reader.read_weights(0).unwrap().into_f32().collect();
        // Vertices that one joint alone moves.
        rows.iter().filter(|row| row[0] > 0.999).count()
    });
    assert!(weights[1] < weights[0], "{weights:?}");
}

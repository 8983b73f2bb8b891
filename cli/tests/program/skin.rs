//! `nullcone skin`: the vertices that it writes, and what it refuses.

use std::path::{Path, PathBuf};

use nullcone_shared_data::shared;
use serde_json::{Value, json};
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, nullcone, text};

/// A file of the test data of ga-anim.
fn data(name: &str) -> PathBuf {
    let this = Path::new(env!("CARGO_MANIFEST_DIR"));
    this.join("../anim/tests/data").join(name)
}

/// The coordinates of the vertices in `frame.obj`.
fn vertices(folder: &Path) -> Vec<[f64; 3]> {
    let obj = std::fs::read_to_string(folder.join("frame.obj")).unwrap();
    let lines = obj.lines().filter_map(|line| line.strip_prefix("v "));
    let vertex = |line: &str| -> [f64; 3] {
        let numbers = line.split(' ').map(|word| word.parse().unwrap());
        numbers.collect::<Vec<f64>>().try_into().unwrap()
    };
    lines.map(vertex).collect()
}

/// Runs the command for `model` and returns what it prints as JSON.
fn skin(folder: &Path, model: &Path, options: &[&str]) -> Value {
    let mut arguments = vec!["skin", model.to_str().unwrap()];
    arguments.extend(options);
    arguments.extend(["--out", "frame.obj", "--json"]);
    let output = nullcone(folder, &arguments);
    assert_success(&output);
    serde_json::from_slice(&output.stdout).unwrap()
}

#[track_caller]
fn assert_near(found: [f64; 3], known: &Value, bound: f64) {
    for (axis, found) in found.into_iter().enumerate() {
        let known = known[axis].as_f64().unwrap();
        let error = (found - known).abs() / known.abs().max(1.0);
        assert!(error <= bound, "{found} instead of {known}");
    }
}

const METHODS: [(&str, &str); 2] = [("linear", "lbs"), ("dual-quaternion", "dqs")];

/// Compares the vertices of all moments of a file with the oracle.
fn check(model: &Path, cases: &Value, bound: f64) {
    let folder = tempdir().unwrap();
    for case in cases.as_array().unwrap() {
        let (animation, time) = (case["animation"].to_string(), case["t"].to_string());
        for (method, key) in METHODS {
            let options = [
                "--animation",
                &animation,
                "--time",
                &time,
                "--method",
                method,
            ];
            let report = skin(folder.path(), model, &options);
            let parts = report["parts"].as_array().unwrap();
            let is_it = |part: &&Value| {
                (&part["node"], &part["primitive"]) == (&case["node"], &case["primitive"])
            };
            let part = parts.iter().find(is_it).unwrap();
            assert_eq!(part["vertices"], case["vertices"]);
            let first = part["first_vertex"].as_u64().unwrap() as usize;
            let found = vertices(folder.path());
            assert_eq!(report["vertices"], found.len());
            let indices = case["index"].as_array().unwrap().iter();
            for (index, known) in indices.zip(case[key].as_array().unwrap()) {
                assert_near(
                    found[first + index.as_u64().unwrap() as usize],
                    known,
                    bound,
                );
            }
        }
    }
}

#[test]
fn the_simple_skin_is_where_the_oracle_has_it() {
    let truth: Value = serde_json::from_slice(&std::fs::read(data("gltf.json")).unwrap()).unwrap();
    let cases = &truth["skin"]["files"]["gltf/SimpleSkin.gltf"];
    check(&data("SimpleSkin.gltf"), cases, 1e-12);
}

#[test]
fn the_samples_are_where_the_oracle_has_them() {
    let Some(truth) = shared("cases/motion/slerp-close-keys/skin.json") else {
        return;
    };
    let truth: Value = serde_json::from_slice(&std::fs::read(truth).unwrap()).unwrap();
    for (file, cases) in truth["files"].as_object().unwrap() {
        let path = shared(&format!("data/anim/{file}")).unwrap();
        check(&path, cases, 1e-12);
    }
}

/// Two nodes with one mesh, the first of which rotates about z and goes along x.
fn model() -> Value {
    let bytes = |numbers: &[f32]| -> Vec<u8> {
        numbers
            .iter()
            .flat_map(|number| number.to_le_bytes())
            .collect()
    };
    let half = 0.5f32.sqrt();
    let positions = bytes(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.1, 0.0]);
    let times = bytes(&[0.0, 2.0]);
    let rotations = bytes(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, half, half]);
    let places = bytes(&[0.0, 0.0, 0.0, 4.0, 0.0, 0.0]);
    let all = [positions, times, rotations, places].concat();
    let digits = all.iter().map(|byte| format!("%{byte:02x}"));
    let uri = "data:application/octet-stream,".to_owned() + &digits.collect::<String>();
    let view = |start: usize, length: usize| json!({"buffer": 0, "byteOffset": start, "byteLength": length});
    let accessor = |view: usize, count: usize, shape: &str| json!({"bufferView": view, "componentType": 5126, "count": count, "type": shape});
    let channel = |sampler: usize, path: &str| json!({"sampler": sampler, "target": {"node": 0, "path": path}});
    let animation = |sampler: usize, path: &str, name: &str| {
        json!({"name": name, "channels": [channel(0, path)],
            "samplers": [{"input": 1, "output": sampler}]})
    };
    json!({
        "asset": {"version": "2.0"},
        "nodes": [{"mesh": 0, "name": "arm"}, {"mesh": 0, "translation": [0, 0, 5]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "animations": [animation(2, "rotation", "turn"), animation(3, "translation", "go")],
        "buffers": [{"uri": uri, "byteLength": all.len()}],
        "bufferViews": [view(0, 36), view(36, 8), view(44, 32), view(76, 24)],
        "accessors": [
            accessor(0, 3, "VEC3"), accessor(1, 2, "SCALAR"),
            accessor(2, 2, "VEC4"), accessor(3, 2, "VEC3"),
        ],
    })
}

fn folder(model: &Value) -> TempDir {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("model.gltf"), model.to_string()).unwrap();
    folder
}

#[test]
fn nodes_carry_their_meshes() {
    let folder = folder(&model());
    let model = Path::new("model.gltf");
    // Without a number the first animation plays; time is kept within the keys.
    for (time, degrees) in [("-3", 0.0f64), ("1", 45.0), ("7.5", 90.0)] {
        let report = skin(folder.path(), model, &["--time", time]);
        assert_eq!(
            (&report["animation"], &report["animation_name"]),
            (&json!(0), &json!("turn"))
        );
        assert_eq!(
            (&report["duration_seconds"], &report["method"]),
            (&json!(2.0), &json!("linear"))
        );
        let found = vertices(folder.path());
        let (sine, cosine) = degrees.to_radians().sin_cos();
        assert_near(found[1], &json!([cosine, sine, 0.0]), 1e-7);
        assert_eq!(found[3..5], [[0.0, 0.0, 5.0], [1.0, 0.0, 5.0]]);
    }
    let report = skin(folder.path(), model, &["--animation", "1", "--time", "0.5"]);
    assert_eq!(report["animation_name"], "go");
    assert_eq!(vertices(folder.path())[0], [1.0, 0.0, 0.0]);
    let report = skin(
        folder.path(),
        model,
        &["--animation", "rest", "--time", "0.5"],
    );
    assert_eq!(
        (&report["animation"], &report["animations"]),
        (&Value::Null, &json!(2))
    );
    assert_eq!(vertices(folder.path())[1], [1.0, 0.0, 0.0]);
    // The number of the file, which is not 0.1, with all its digits.
    assert_eq!(vertices(folder.path())[2], [0.0, f64::from(0.1f32), 0.0]);
    assert_eq!(report["parts"][1]["first_vertex"], 3);
    assert_eq!(report["parts"][0]["node_name"], "arm");
    assert_eq!(
        report["bounds"]["max"],
        json!([1.0, f64::from(0.1f32), 5.0])
    );
}

#[test]
fn a_model_without_animations_has_its_pose() {
    let mut still = model();
    still.as_object_mut().unwrap().remove("animations");
    let folder = folder(&still);
    let report = skin(folder.path(), Path::new("model.gltf"), &["--time", "3"]);
    assert_eq!(
        (&report["animation"], &report["animations"]),
        (&Value::Null, &json!(0))
    );
    assert_eq!(vertices(folder.path())[1], [1.0, 0.0, 0.0]);
}

#[test]
fn one_line_says_what_was_written() {
    let folder = folder(&model());
    let arguments = ["skin", "model.gltf", "--time", "0.5", "--out", "frame.obj"];
    let output = nullcone(folder.path(), arguments);
    assert_success(&output);
    let expected = "wrote frame.obj: 6 vertices and 2 faces, animation 0 (turn) at 0.5 s of 2 s\n";
    assert_eq!(text(&output.stdout), expected);
    let quiet = nullcone(folder.path(), arguments.into_iter().chain(["--quiet"]));
    assert_eq!(text(&quiet.stdout), "");
}

/// Expects the command to fail without writing anything.
#[track_caller]
fn fails(model: &[u8], options: &[&str], parts: &[&str]) {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("model"), model).unwrap();
    let mut arguments = vec!["skin", "model", "--out", "frame.obj"];
    arguments.extend(options);
    if !options.contains(&"--time") {
        arguments.extend(["--time", "0.5"]);
    }
    assert_failure(&nullcone(folder.path(), &arguments), parts);
    assert!(!folder.path().join("frame.obj").exists());
}

/// Fails for the model with one value replaced.
#[track_caller]
fn fails_with(place: &str, value: Value, parts: &[&str]) {
    let mut model = model();
    *model.pointer_mut(place).unwrap() = value;
    fails(model.to_string().as_bytes(), &[], parts);
}

#[test]
fn what_is_wrong_is_named() {
    let good = model().to_string().into_bytes();
    fails(
        &good,
        &["--animation", "2"],
        &["there is no animation 2", "the file has 2"],
    );
    fails(&good, &["--time", "nan"], &["--time NaN"]);
    fails(&good, &["--time", "inf"], &["--time inf"]);
    fails(&good[..good.len() / 2], &[], &["model: JSON", "line 1"]);
    fails(b"", &[], &["model: "]);
    fails(
        br#"{"asset": {"version": "2.0"}}"#,
        &[],
        &["model: no node has a mesh"],
    );
    fails_with(
        "/accessors/0/count",
        json!(99),
        &["accessor 0", "needs", "but has"],
    );
    fails_with(
        "/nodes/0",
        json!({"mesh": 0, "children": [0]}),
        &["node 0", "ancestor of itself"],
    );
    fails_with(
        "/animations/0/channels/0/target/node",
        json!(9),
        &["animation 0, channel 0", "node 9", "there are 2"],
    );
    fails_with(
        "/animations/0/samplers/0/input",
        json!(2),
        &["animation 0, channel 0", "accessor 2", "VEC4"],
    );
    // Times that do not rise: the bytes of the second are those of the first.
    fails_with(
        "/bufferViews/1/byteOffset",
        json!(0),
        &["animation 0, channel 0", "key 1", "not after"],
    );
    let matrix = json!({"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]});
    fails_with(
        "/nodes/0",
        matrix,
        &["animation 0, channel 0", "node 0", "matrix"],
    );
}

/// A binary file that is cut off anywhere is refused.
#[test]
fn truncated_files() {
    let model = json!({"asset": {"version": "2.0"}})
        .to_string()
        .into_bytes();
    let mut file = [b"glTF", &2u32.to_le_bytes()[..], &0u32.to_le_bytes()].concat();
    file.extend((model.len() as u32 + 1).next_multiple_of(4).to_le_bytes());
    file.extend(b"JSON");
    file.extend(&model);
    file.resize(file.len().next_multiple_of(4), b' ');
    let length = file.len() as u32;
    file[8..12].copy_from_slice(&length.to_le_bytes());
    for end in [4, 11, 12, 19, 20, file.len() - 1] {
        fails(&file[..end], &[], &["model: "]);
    }
}

/// A triangle with a painted material, which an animation moves.
fn painted(folder: &Path) {
    use ga_mesh::gltf::{self, Animation, Channel, Document, Interpolation, Keys, Mesh, Node};

    let paint = ga_image::plane::Plane::filled(2, 2, [200u8, 30, 30]);
    let corner = gltf::Primitive {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        normals: vec![[0.0, 0.0, 1.0]; 3],
        texcoords: vec![vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.25]]],
        colours: vec![vec![[1.0, 0.5, 0.25, 1.0]; 3]],
        material: Some(0),
        ..gltf::Primitive::default()
    };
    let turn = Channel {
        node: 0,
        times: vec![0.0, 2.0],
        interpolation: Interpolation::Linear,
        keys: Keys::Rotation(vec![
            [0.0, 0.0, 0.0, 1.0],
            [0.5f32.sqrt(), 0.0, 0.0, 0.5f32.sqrt()],
        ]),
        extras: None,
    };
    let document = Document {
        nodes: vec![Node {
            mesh: Some(0),
            ..Node::default()
        }],
        meshes: vec![Mesh {
            primitives: vec![corner],
            ..Mesh::default()
        }],
        materials: vec![gltf::MaterialElement {
            name: Some("paint".to_owned()),
            base_colour_texture: Some(gltf::TextureInfo::default()),
            ..gltf::MaterialElement::default()
        }],
        textures: vec![gltf::TextureElement {
            image: Some(0),
            ..gltf::TextureElement::default()
        }],
        images: vec![gltf::Image {
            name: None,
            source: gltf::ImageSource::Bytes {
                media_type: "image/png".to_owned(),
                bytes: ga_image::png::encode(&paint).unwrap(),
            },
            extras: None,
        }],
        animations: vec![Animation {
            channels: vec![turn],
            ..Animation::default()
        }],
        ..Document::default()
    };
    gltf::write(folder.join("painted.glb"), &document).unwrap();
}

/// After 2 s the triangle, which faced +z, faces −y.
#[test]
fn what_the_model_has_is_written_in_every_format() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    painted(folder);
    for out in ["frame.obj", "frame.glb", "frame.gltf", "frame.ply"] {
        let arguments = ["skin", "painted.glb", "--time", "2", "--out", out];
        let report = crate::common::json(folder, &arguments);
        assert_eq!(report["files"][0], out);
        let (mesh, warnings) = ga_mesh::format::read(folder.join(out), Default::default()).unwrap();
        assert_eq!(warnings, []);
        let place = |vertex: usize| mesh.positions()[vertex].coordinates();
        let top = (0..3)
            .map(place)
            .find(|place| place[0] < 0.5 && place[2] > 0.5);
        assert_near(top.unwrap(), &json!([0, 0, 1]), 1e-6);
        let normal = mesh.normals().unwrap().get(0).unwrap();
        assert_near(normal.coordinates(), &json!([0, -1, 0]), 1e-6);
        let coordinates = mesh.texture_coordinates().unwrap();
        let mut heights: Vec<f64> = coordinates.values.iter().map(|place| place[1]).collect();
        heights.sort_by(f64::total_cmp);
        assert_eq!(
            (heights[0], heights[heights.len() - 1]),
            (0.75, 1.0),
            "{out}"
        );
        assert!(mesh.colours().is_some(), "{out}");
        if out != "frame.ply" {
            let [material] = mesh.materials() else {
                panic!("{out}: one material")
            };
            assert_eq!(material.name, "paint");
            assert!(material.base_colour_texture.is_some(), "{out}");
        }
    }
    let obj = std::fs::read_to_string(folder.join("frame.obj")).unwrap();
    let lines = |start: &str| obj.lines().filter(|line| line.starts_with(start)).count();
    assert_eq!(
        (lines("vt "), lines("vn "), lines("usemtl paint")),
        (3, 3, 1)
    );
    let files = crate::common::names(folder);
    assert!(files.contains(&"frame.mtl".into()) && files.contains(&"frame-1.png".into()));
}

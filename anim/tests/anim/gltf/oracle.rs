//! Evaluation against what an independent evaluator made of the Khronos samples.

use std::path::PathBuf;

use ga_anim::gltf::{LocalFrame, Placement, Player};
use ga_anim::skin::Method;
use ga_mesh::gltf::{Animation, Channel, Document, Interpolation, Keys, Node, read};
use glam::DQuat;
use nullcone_shared_data::shared;
use serde_json::Value;

use crate::assert_relative;

fn in_repository() -> (Value, PathBuf) {
    let truth = serde_json::from_str(include_str!("../../data/gltf.json")).unwrap();
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    (truth, folder)
}

fn json(path: &str) -> Option<Value> {
    let text = std::fs::read(shared(path)?).unwrap();
    Some(serde_json::from_slice(&text).unwrap())
}

fn numbers(value: &Value) -> Vec<f64> {
    let numbers = value.as_array().unwrap().iter();
    numbers.map(|number| number.as_f64().unwrap()).collect()
}

fn index(value: &Value) -> usize {
    value.as_u64().unwrap() as usize
}

/// The greatest difference from the oracle, relative to the number or to 1.
const BOUND: f64 = 1e-12;

/// Checks all channels of a file, and returns how many values there are.
fn check_channels(document: &Document, cases: &Value) -> usize {
    let player = Player::new(document).unwrap();
    let mut count = 0;
    for case in cases.as_array().unwrap() {
        let animation = index(&case["animation"]);
        let channel = &document.animations[animation].channels[index(&case["channel"])];
        assert_eq!(case["path"], channel.keys.path());
        let times = numbers(&case["t"]);
        for (&time, known) in times.iter().zip(case["value"].as_array().unwrap()) {
            let pose = player.pose(Some(animation), time).unwrap();
            let LocalFrame::Parts(parts) = pose.locals[channel.node] else {
                panic!("a node that moves has parts");
            };
            let found = match channel.keys {
                Keys::Translation(_) => parts.translation().coordinates().to_vec(),
                Keys::Scale(_) => parts.scale.coordinates().to_vec(),
                _ => {
                    let ([x, y, z], w) = parts.rotor().to_quaternion();
                    vec![x, y, z, w]
                }
            };
            let mut known = numbers(known);
            // A quaternion and its negative are one rotation.
            let product: f64 = found.iter().zip(&known).map(|(a, b)| a * b).sum();
            if matches!(channel.keys, Keys::Rotation(_)) && product < 0.0 {
                known.iter_mut().for_each(|x| *x = -*x);
            }
            for (found, known) in found.into_iter().zip(known) {
                assert_relative(found, known, BOUND);
            }
            count += 1;
        }
    }
    count
}

/// Checks the vertices of all moments of a file.
fn check_vertices(document: &Document, cases: &Value) {
    let player = Player::new(document).unwrap();
    let placement = Placement::new(&player).unwrap();
    for case in cases.as_array().unwrap() {
        let animation = index(&case["animation"]);
        let time = case["t"].as_f64().unwrap();
        let pose = player.pose(Some(animation), time).unwrap();
        let (node, primitive) = (index(&case["node"]), index(&case["primitive"]));
        let mut parts = placement.parts().iter();
        let part = parts
            .find(|part| (part.node, part.primitive) == (node, primitive))
            .unwrap();
        assert_eq!(part.vertices.len(), index(&case["vertices"]));
        for (name, method) in [("lbs", Method::Linear), ("dqs", Method::DualQuaternion)] {
            let placed = placement.place(&pose, method).unwrap();
            let positions = &placed.positions[part.vertices.clone()];
            let of_all = || positions.iter().map(|point| point.coordinates());
            let sum = of_all().fold([0.0; 3], |sum, p| [0, 1, 2].map(|axis| sum[axis] + p[axis]));
            // Coordinates of either sign cancel, and their rounding does not.
            let largest = of_all()
                .flatten()
                .fold(0.0, |largest: f64, x| largest.max(x.abs()));
            for (found, known) in sum.into_iter().zip(numbers(&case[format!("{name}_sum")])) {
                let scale = largest.max(known.abs()).max(1.0);
                assert!(
                    (found - known).abs() <= BOUND * scale,
                    "{found} instead of {known}"
                );
            }
            let vertices = case["index"].as_array().unwrap().iter();
            for (vertex, known) in vertices.zip(case[name].as_array().unwrap()) {
                let found = positions[index(vertex)].coordinates();
                for (found, known) in found.into_iter().zip(numbers(known)) {
                    assert_relative(found, known, BOUND);
                }
            }
        }
    }
}

#[test]
fn channels_of_the_interpolation_test() {
    let (truth, folder) = in_repository();
    let document = read(folder.join("interpolation_test.gltf")).unwrap();
    let cases = &truth["samplers"]["gltf/interpolation_test.gltf"];
    assert_eq!(check_channels(&document, cases), 9 * 17);
}

#[test]
fn vertices_of_the_simple_skin() {
    let (truth, folder) = in_repository();
    let document = read(folder.join("SimpleSkin.gltf")).unwrap();
    check_vertices(&document, &truth["skin"]["files"]["gltf/SimpleSkin.gltf"]);
}

#[test]
fn channels_of_all_samples() {
    let Some(truth) = json("cases/motion/slerp-close-keys/samplers.json") else {
        return;
    };
    let mut count = 0;
    for (file, cases) in truth.as_object().unwrap() {
        let Some(path) = file
            .contains('/')
            .then(|| shared(&format!("data/anim/{file}")))
        else {
            continue;
        };
        count += check_channels(&read(path.unwrap()).unwrap(), cases);
    }
    assert_eq!(count, 594);
}

#[test]
fn vertices_of_all_samples() {
    let Some(truth) = json("cases/motion/slerp-close-keys/skin.json") else {
        return;
    };
    for (file, cases) in truth["files"].as_object().unwrap() {
        let path = shared(&format!("data/anim/{file}")).unwrap();
        check_vertices(&read(path).unwrap(), cases);
    }
}

/// Two keys whose numbers have a scalar product of 1 or more, 0.0405° apart.
#[test]
fn near_keys_are_interpolated() {
    let keys = [
        [0xbdf7_1714, 0x3e29_2ee1, 0xbf16_3822, 0x3f48_9141],
        [0xbdf7_333f, 0x3e29_422a, 0xbf16_4942, 0x3f48_82dd],
    ];
    let keys = keys.map(|key: [u32; 4]| key.map(f32::from_bits));
    let document = Document {
        nodes: vec![Node::default()],
        animations: vec![Animation {
            channels: vec![Channel {
                node: 0,
                times: vec![0.0, 1.0],
                interpolation: Interpolation::Linear,
                keys: Keys::Rotation(keys.to_vec()),
                extras: None,
            }],
            ..Animation::default()
        }],
        ..Document::default()
    };
    let player = Player::new(&document).unwrap();
    let rotation = |time: f64| {
        let pose = player.pose(Some(0), time).unwrap();
        let LocalFrame::Parts(parts) = pose.locals[0] else {
            panic!("a node that moves has parts");
        };
        let ([x, y, z], w) = parts.rotor().to_quaternion();
        DQuat::from_xyzw(x, y, z, w)
    };
    // By the vector part of the rotation between, which has no cosine.
    let angle = |a: DQuat, b: DQuat| {
        let between = a.conjugate() * b;
        2.0 * between.xyz().length().atan2(between.w.abs()).to_degrees()
    };
    for (time, expected) in [(0.0, 0.0), (0.25, 0.0101), (0.5, 0.0202), (0.75, 0.0304)] {
        let found = angle(rotation(0.0), rotation(time));
        assert!((found - expected).abs() < 6e-5, "{found} at {time}");
        let part = time * angle(rotation(0.0), rotation(1.0));
        assert!((found - part).abs() < 1e-9, "{found} instead of {part}");
    }
}

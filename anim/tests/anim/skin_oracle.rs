//! Skins bound once, against known answers: the palettes of glTF models, with and without scale,
//! and the whole human.

use crate::skin::pose;
use ga_anim::rig;
use ga_anim::skin::{Binding, Method, Posed, SkinScalar};
use ga_anim::weights::SkinWeights;
use ga_mesh::obj;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use nullcone_shared_data::shared;
use serde_json::Value;

const METHODS: [(&str, Method); 2] = [("lbs", Method::Linear), ("dqs", Method::DualQuaternion)];

fn vector(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|axis| value[axis].as_f64().unwrap())
}

fn rows<S: SkinScalar>(palette: &Value) -> Vec<[[S; 4]; 3]> {
    let entry = |value: &Value| S::from_f64(value.as_f64().unwrap());
    let matrix = |matrix: &Value| [0, 1, 2].map(|r| [0, 1, 2, 3].map(|c| entry(&matrix[r][c])));
    palette.as_array().unwrap().iter().map(matrix).collect()
}

/// Compares with the positions of some vertices, relative to the size of the model, and with the
/// sums of all.
fn compare<S: SkinScalar>(moved: &[Point<S>], case: &Value, known: &Value, name: &str, bound: f64) {
    let coordinates = |vertex: usize| moved[vertex].coordinates().map(Into::<f64>::into);
    let size = (0..moved.len())
        .flat_map(coordinates)
        .fold(0.0, |size: f64, x| size.max(x.abs()));
    let listed = known[name].as_array().unwrap();
    for (index, known) in case["index"].as_array().unwrap().iter().zip(listed) {
        let ours = coordinates(index.as_u64().unwrap() as usize);
        for (ours, known) in ours.into_iter().zip(vector(known)) {
            let error = (ours - known).abs() / size;
            assert!(
                error <= bound,
                "{name}: {ours} instead of {known}: {error:e}"
            );
        }
    }
    for (axis, known) in vector(&known[format!("{name}_sum")])
        .into_iter()
        .enumerate()
    {
        let sum: f64 = (0..moved.len())
            .map(|vertex| coordinates(vertex)[axis])
            .sum();
        let error = (sum - known).abs() / (size * moved.len() as f64);
        assert!(
            error <= bound,
            "sum of {name}: {sum} instead of {known}: {error:e}"
        );
    }
}

fn check_models<S: SkinScalar>(bound: f64) {
    let (Some(truth), Some(models)) = (
        shared("cases/motion/slerp-close-keys/skin.json"),
        shared("data/anim"),
    ) else {
        return;
    };
    let truth: Value = serde_json::from_slice(&std::fs::read(truth).unwrap()).unwrap();
    let mut cases = 0;
    for (file, list) in truth["files"].as_object().unwrap() {
        let (document, buffers, _) = gltf::import(models.join(file)).unwrap();
        for case in list.as_array().unwrap() {
            let node = document
                .nodes()
                .nth(case["node"].as_u64().unwrap() as usize)
                .unwrap();
            let number = case["primitive"].as_u64().unwrap() as usize;
            let primitive = node.mesh().unwrap().primitives().nth(number).unwrap();
            let reader = primitive.reader(|buffer| Some(&buffers[buffer.index()]));
            let point = |p: [f32; 3]| Point::from(p.map(|x| S::from_f64(f64::from(x))));
            let rest: Vec<Point<S>> = reader.read_positions().unwrap().map(point).collect();
            let palette = rows::<S>(&case["palette"]);
            let joints = reader.read_joints(0).unwrap().into_u16();
            let influences = joints.zip(reader.read_weights(0).unwrap().into_f32());
            let influences = influences.map(|(joints, weights)| {
                let mut row: Vec<(u32, f64)> = Vec::new();
                for (joint, weight) in joints.into_iter().zip(weights) {
                    match row.iter_mut().find(|(other, _)| *other == u32::from(joint)) {
                        Some((_, sum)) => *sum += f64::from(weight),
                        None => row.push((u32::from(joint), f64::from(weight))),
                    }
                }
                row
            });
            let weights = SkinWeights::new(palette.len(), influences).unwrap();
            let binding = Binding::new(&rest, &weights).unwrap();
            for (name, method) in METHODS {
                let mut frame = binding.palette(method);
                frame.set_matrices(&palette).unwrap();
                let mut moved = rest.clone();
                binding.pose(&frame, Posed::of_points(&mut moved)).unwrap();
                compare(&moved, case, case, name, bound);
            }
            cases += 1;
        }
    }
    assert_eq!(cases, 42);
}

#[test]
fn models_move_as_they_should_in_double_precision() {
    check_models::<f64>(1e-12);
}

#[test]
fn models_move_as_they_should_in_single_precision() {
    check_models::<f32>(1e-5);
}

fn check_human<S: SkinScalar>(bound: f64) {
    let (Some(mesh), Some(weights), Some(truth)) = (
        shared("data/anim/human_base.obj"),
        shared("data/anim/human/weights.cmu_mb.json"),
        shared("oracle/anim/human.json"),
    ) else {
        return;
    };
    let truth: Value = serde_json::from_slice(&std::fs::read(truth).unwrap()).unwrap();
    let mesh = obj::read(mesh).unwrap();
    let skeleton = rig::decode(include_bytes!("../data/rig.cmu_mb.json")).unwrap();
    let all = rig::read_weights(weights, &skeleton, mesh.vertex_count()).unwrap();
    let scalars = |p: [f64; 3]| p.map(S::from_f64);
    let rest: Vec<Point<S>> = mesh
        .coordinates()
        .map(|p| Point::from(scalars(p)))
        .collect();
    let mut cases = 0;
    for known in truth["poses"].as_array().unwrap() {
        let motions = pose(&skeleton, &truth["bones"], &known["bone_rotvec"])
            .motions(&skeleton)
            .unwrap();
        let motions: Vec<Motor<S>> = motions.into_iter().map(|motion| rounded(motion)).collect();
        for count in ["8", "4", "2", "1"] {
            let weights = all.strongest(count.parse().unwrap());
            let binding = Binding::new(&rest, &weights).unwrap();
            for (name, method) in METHODS {
                let mut palette = binding.palette(method);
                palette.set_motions(&motions).unwrap();
                let mut moved = rest.clone();
                binding
                    .pose(&palette, Posed::of_points(&mut moved))
                    .unwrap();
                compare(&moved, known, &known["influences"][count], name, bound);
                cases += 1;
            }
        }
    }
    assert_eq!(cases, 24);
}

fn rounded<S: SkinScalar>(motion: Motor<f64>) -> Motor<S> {
    let ([x, y, z], w) = motion.rotor().to_quaternion();
    let rotor = Rotor::from_quaternion([x, y, z].map(S::from_f64), S::from_f64(w)).unwrap();
    Translator::from_displacement(motion.translator().displacement().map(S::from_f64)) * rotor
}

#[test]
fn the_human_moves_as_it_should_in_double_precision() {
    check_human::<f64>(1e-12);
}

#[test]
fn the_human_moves_as_it_should_in_single_precision() {
    check_human::<f32>(1e-5);
}

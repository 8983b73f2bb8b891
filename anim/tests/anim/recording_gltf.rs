//! Recordings of glTF animations, against the oracle and in closed form.

use ga_anim::MotionFileError;
use ga_anim::gltf::Player;
use ga_anim::recording::{GltfMotion, Recording, RecordingError, model_maps};
use ga_mesh::gltf::{
    Animation, Channel, Document, Interpolation, Keys, Mesh, MorphTarget, Node, Primitive,
    Transform, read,
};
use ga_runtime::geometry::Affine;
use nullcone_shared_data::shared;
use serde_json::Value;

use crate::assert_relative;

fn keys(node: usize, times: &[f32], keys: Keys) -> Channel {
    Channel {
        node,
        times: times.to_vec(),
        interpolation: Interpolation::Linear,
        keys,
        extras: None,
    }
}

fn places(node: usize, times: &[f32]) -> Channel {
    let place = |&time: &f32| [10.0 * time, 0.0, 1.0];
    keys(
        node,
        times,
        Keys::Translation(times.iter().map(place).collect()),
    )
}

fn document(nodes: Vec<Node>, channels: Vec<Channel>) -> Document {
    Document {
        nodes,
        animations: vec![Animation {
            channels,
            ..Animation::default()
        }],
        ..Document::default()
    }
}

fn node(name: &str, children: &[usize], translation: [f32; 3], scale: [f32; 3]) -> Node {
    Node {
        name: Some(name.to_owned()),
        children: children.to_vec(),
        transform: Transform::Decomposed {
            translation,
            rotation: [0.0, 0.0, 0.0, 1.0],
            scale,
        },
        ..Node::default()
    }
}

#[track_caller]
fn assert_maps(found: &[Affine<f64>], expected: &[Affine<f64>], bound: f64) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        let numbers = |map: &Affine<f64>| -> Vec<f64> {
            let linear = map.linear.as_flattened();
            linear.iter().chain(&map.translation).copied().collect()
        };
        for (found, expected) in numbers(found).into_iter().zip(numbers(expected)) {
            assert_relative(found, expected, bound);
        }
    }
}

/// The maps of a frame of a recording.
fn maps(recording: &Recording, frame: usize) -> Vec<Affine<f64>> {
    let mut maps = vec![Affine::default(); recording.joints().len()];
    model_maps(
        recording.parents(),
        recording.frame(frame).unwrap(),
        &mut maps,
    )
    .unwrap();
    maps
}

/// Joints of the samples at any time, and those of the frames at keys.
#[test]
fn joints_of_the_samples_are_where_the_oracle_has_them() {
    let Some(truth) = shared("cases/motion/slerp-close-keys/skin.json") else {
        return;
    };
    let truth: Value = serde_json::from_slice(&std::fs::read(truth).unwrap()).unwrap();
    for (file, cases) in truth["files"].as_object().unwrap() {
        let document = read(shared(&format!("data/anim/{file}")).unwrap()).unwrap();
        let player = Player::new(&document).unwrap();
        for case in cases.as_array().unwrap() {
            let animation = case["animation"].as_u64().unwrap() as usize;
            let time = case["t"].as_f64().unwrap();
            let motion = GltfMotion::new(&player, animation, 1.0).unwrap();
            let exact = motion.model_maps(time).unwrap();
            let joints = &document.skins[0].joints;
            for (known, joint) in case["joint_world"].as_array().unwrap().iter().zip(joints) {
                let entry = |row: usize, column: usize| known[row][column].as_f64().unwrap();
                let rows = [0, 1, 2];
                let linear = rows.map(|row| rows.map(|column| entry(row, column)));
                let known = Affine::new(linear, rows.map(|row| entry(row, 3)));
                let place = motion.nodes().position(|node| node == *joint).unwrap();
                assert_maps(&exact[place..=place], &[known], 1e-12);
            }
            let recording = motion.recording(None).unwrap();
            let frame = (time / recording.frame_time()).round();
            if (frame * recording.frame_time() - time).abs() < 1e-6 {
                assert_maps(&maps(&recording, frame as usize), &exact, 1e-5);
            }
        }
    }
}

#[test]
fn the_fox_has_its_joints_and_frames() {
    let Some(path) = shared("data/anim/gltf/Fox.glb") else {
        return;
    };
    let document = read(path).unwrap();
    let recording = Recording::from_gltf(&document, 1, 0.01, None).unwrap();
    assert_eq!(recording.joints().len(), document.skins[0].joints.len());
    assert_eq!(recording.frame_count(), 18);
    assert_relative(recording.frame_time(), 1.0 / 24.0, 1e-6);
    assert!(
        recording
            .joints()
            .iter()
            .any(|joint| joint.name == "b_Tail03_014")
    );
    assert!(recording.tracks().is_empty());
}

/// A node that stays at the top and scales evenly belongs to the joint below, one that scales
/// along one axis is a joint.
#[test]
fn what_stays_at_the_top() {
    let nodes = |scale| {
        vec![
            node("top", &[1], [1.0, 2.0, 3.0], scale),
            node("mid", &[2], [0.5, 0.0, 0.0], [1.0; 3]),
            node("arm", &[3], [0.0; 3], [1.0; 3]),
            node("hand", &[4], [0.0, 1.0, 0.0], [1.0, 1.0, -2.0]),
            node("finger", &[], [0.0, 0.0, 1.0], [1.0; 3]),
        ]
    };
    let channels = || vec![places(2, &[0.0, 0.5, 1.0]), places(4, &[0.0, 1.0])];
    for (scale, names) in [
        ([0.01; 3], &["arm", "hand", "finger"][..]),
        ([1.0, 2.0, 1.0], &["top", "mid", "arm", "hand", "finger"]),
        ([-1.0; 3], &["top", "mid", "arm", "hand", "finger"]),
        // What is uneven by a hundredth of a millimetre on a metre is not left out.
        (
            [1.0, 1.000_01, 1.0],
            &["top", "mid", "arm", "hand", "finger"],
        ),
    ] {
        let document = document(nodes(scale), channels());
        let player = Player::new(&document).unwrap();
        let motion = GltfMotion::new(&player, 0, 0.5).unwrap();
        let found: Vec<&str> = motion.joints().iter().map(|j| j.name.as_str()).collect();
        assert_eq!(found, names);
        let recording = motion.recording(None).unwrap();
        assert_eq!((recording.frame_count(), recording.frame_time()), (3, 0.5));
        for frame in 0..3 {
            let exact = motion.model_maps(0.5 * frame as f64).unwrap();
            assert_maps(&maps(&recording, frame), &exact, 1e-12);
        }
        // By hand: the arm is at x = 1 + s (0.5 + 10 t), in half metres.
        let arm = motion
            .joints()
            .iter()
            .position(|joint| joint.name == "arm")
            .unwrap();
        let x = 1.0 + f64::from(scale[0]) * (0.5 + 5.0);
        let found = motion.model_maps(0.5).unwrap()[arm].translation[0];
        assert_relative(found, 0.5 * x, 1e-12);
    }
}

#[test]
fn matrices_are_split_unless_they_shear() {
    let with = |matrix: [f32; 16]| {
        let mut nodes = vec![
            node("arm", &[1], [0.0; 3], [1.0; 3]),
            node("hand", &[2], [0.0; 3], [1.0; 3]),
        ];
        nodes[1].transform = Transform::Matrix(matrix);
        nodes.push(node("finger", &[], [0.0; 3], [1.0; 3]));
        document(nodes, vec![places(0, &[0.0, 1.0]), places(2, &[0.0, 1.0])])
    };
    // Rotated about y by 30°, mirrored and scaled.
    let (sine, cosine) = (0.5f32, 0.75f32.sqrt());
    let mirrored = [
        -2.0 * cosine,
        0.0,
        2.0 * sine,
        0.0,
        0.0,
        3.0,
        0.0,
        0.0,
        sine,
        0.0,
        cosine,
        0.0,
        4.0,
        5.0,
        6.0,
        1.0,
    ];
    let document = with(mirrored);
    let player = Player::new(&document).unwrap();
    let motion = GltfMotion::new(&player, 0, 1.0).unwrap();
    let recording = motion.recording(None).unwrap();
    assert_maps(&maps(&recording, 1), &motion.model_maps(1.0).unwrap(), 1e-6);
    assert!(motion.deviation(&recording, None, 0.03).unwrap() < 1e-5);
    let mut shears = mirrored;
    shears[1] = 0.1;
    let mut singular = mirrored;
    singular[5] = 0.0;
    for matrix in [shears, singular] {
        let found = Recording::from_gltf(&with(matrix), 0, 1.0, None);
        assert_eq!(found, Err(MotionFileError::Shears { node: 1 }));
    }
}

/// A matrix as a file with few digits has it, with a shear that no factors have.
#[test]
fn what_little_shear_moves_is_the_deviation() {
    let mut nodes = vec![
        node("arm", &[1], [0.0; 3], [1.0; 3]),
        node("hand", &[2], [0.0; 3], [1.0; 3]),
    ];
    let mut matrix = [0.0; 16];
    (0..4).for_each(|k| matrix[5 * k] = 1.0);
    matrix[1] = 9e-6;
    nodes[1].transform = Transform::Matrix(matrix);
    nodes.push(node("finger", &[], [0.0; 3], [1.0; 3]));
    let times = [0.0, 0.5, 1.0];
    let document = document(nodes, vec![places(0, &times), places(2, &times)]);
    let player = Player::new(&document).unwrap();
    let motion = GltfMotion::new(&player, 0, 1.0).unwrap();
    let recording = motion.recording(None).unwrap();
    let places_alone = motion.deviation(&recording, None, 0.0).unwrap();
    let mut greatest = 0.0f64;
    for frame in 0..recording.frame_count() {
        let truth = motion.model_maps(frame as f64 * recording.frame_time());
        for (found, truth) in maps(&recording, frame).iter().zip(truth.unwrap()) {
            let [a, b] = [found.translation, truth.translation].map(glam::DVec3::from);
            greatest = greatest.max(a.distance(b));
        }
    }
    assert!(
        (places_alone - greatest).abs() < 1e-12,
        "{places_alone} instead of {greatest}"
    );
    // The finger is 10 m out along x in the last frame, and the rotation takes half of the shear.
    assert!((4e-5..1e-4).contains(&greatest), "{greatest}");
    // A shell adds what the linear parts differ by.
    let with_shell = motion.deviation(&recording, None, 2.0).unwrap();
    let added = with_shell - places_alone;
    assert!((8e-6..2e-5).contains(&added), "{added}");
    let error = motion.deviation(&recording, Some(-1.0), 0.0).unwrap_err();
    assert_eq!(error, MotionFileError::Rate(-1.0));
}

/// Keys on a grid are kept, wherever they begin; others are resampled at the finest interval.
#[test]
fn rates() {
    let arm = || vec![node("arm", &[], [0.0; 3], [1.0; 3])];
    let frames = |times: &[f32], rate| {
        let document = document(arm(), vec![places(0, times)]);
        let recording = Recording::from_gltf(&document, 0, 1.0, rate).unwrap();
        // Before the first key and after the last the value is that of the key.
        let [first, last] = [times[0], times[times.len() - 1]].map(f64::from);
        for frame in 0..recording.frame_count() {
            let time = (frame as f64 * recording.frame_time()).clamp(first, last);
            let x = recording.frame(frame).unwrap()[0]
                .translation()
                .coordinates()[0];
            assert!((x - 10.0 * time).abs() < 1e-5, "{x} at {time}");
        }
        (recording.frame_count(), recording.frame_time())
    };
    let film: Vec<f32> = (1..25).map(|k| k as f32 / 24.0).collect();
    let (count, step) = frames(&film, None);
    assert_eq!(count, 25);
    assert!((step - 1.0 / 24.0).abs() < 1e-8);
    assert_eq!(frames(&[0.0, 0.5, 2.0], None), (5, 0.5));
    assert_eq!(frames(&[0.0, 0.5, 1.2], None), (4, 0.5));
    assert_eq!(frames(&[0.0, 1e-5, 1.0], None), (241, 1.0 / 240.0));
    assert_eq!(frames(&[0.0, 0.0005, 0.001], None).0, 3);
    assert_eq!(frames(&[0.0, 0.5, 1.0], Some(10.0)), (11, 0.1));
    assert_eq!(frames(&[0.0], None), (1, 1.0 / 30.0));
    // A key half a thousandth of a step after its frame does not stand for the frame.
    assert_eq!(frames(&[0.0, 0.1, 0.200_05, 0.3], None).0, 4);
    // A key is taken as it is although its time is rounded.
    let document = document(arm(), vec![places(0, &film)]);
    let recording = Recording::from_gltf(&document, 0, 1.0, None).unwrap();
    for (frame, &time) in film.iter().enumerate() {
        let x = recording.frame(frame + 1).unwrap()[0]
            .translation()
            .coordinates()[0];
        assert_eq!(x, f64::from(10.0 * time));
    }
}

#[test]
fn weights_of_morph_targets_are_tracks() {
    let target = MorphTarget {
        positions: vec![[1.0; 3]],
        ..MorphTarget::default()
    };
    let vertex = Primitive {
        positions: vec![[0.0; 3]],
        targets: vec![target; 2],
        ..Primitive::default()
    };
    let face = Node {
        mesh: Some(0),
        ..node("face", &[], [0.0; 3], [1.0; 3])
    };
    let weights = keys(0, &[0.0, 1.0], Keys::Weights(vec![0.0, 1.0, 0.5, 0.25]));
    let mut document = document(vec![face], vec![weights, places(0, &[0.0, 1.0])]);
    document.meshes = vec![Mesh {
        primitives: vec![vertex],
        ..Mesh::default()
    }];
    let recording = Recording::from_gltf(&document, 0, 1.0, Some(2.0)).unwrap();
    let tracks = recording.tracks();
    assert_eq!(tracks[1].name, "face, morph target 1");
    assert_eq!(tracks[0].values, [0.0, 0.25, 0.5]);
    assert_eq!(tracks[1].values, [1.0, 0.625, 0.25]);
    let player = Player::new(&document).unwrap();
    let motion = GltfMotion::new(&player, 0, 1.0).unwrap();
    let expected = [
        ("face, morph target 0".to_owned(), 0.125),
        ("face, morph target 1".to_owned(), 0.8125),
    ];
    assert_eq!(motion.track_values(0.25).unwrap(), expected);
}

#[test]
fn what_is_no_recording() {
    let arm = || vec![node("arm", &[], [0.0; 3], [1.0; 3])];
    let good = document(arm(), vec![places(0, &[0.0, 1000.0])]);
    let error = |document: &Document, animation, unit, rate| {
        Recording::from_gltf(document, animation, unit, rate).unwrap_err()
    };
    let (animation, count) = (1, 1);
    let none = MotionFileError::NoAnimation { animation, count };
    assert_eq!(error(&good, 1, 1.0, None), none);
    assert_eq!(error(&good, 0, 0.0, None), RecordingError::Unit(0.0).into());
    assert_eq!(
        error(&good, 0, 1.0, Some(-1.0)),
        MotionFileError::Rate(-1.0)
    );
    assert!(matches!(
        error(&good, 0, 1.0, Some(1e9)),
        MotionFileError::RecordingTooLarge { .. }
    ));
    let still = document(arm(), Vec::new());
    assert_eq!(error(&still, 0, 1.0, None), RecordingError::NoJoints.into());
}

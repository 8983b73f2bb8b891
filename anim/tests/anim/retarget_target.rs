//! Skeletons in files of every format as targets, and what their motions become in files.

use ga_anim::MotionFileError;
use ga_anim::bvh;
use ga_anim::clip::Clip;
use ga_anim::gltf::{Player, Rigged};
use ga_anim::motion_file::{
    Animations, Contents, Format, Loss, MotionFile, Options, WriteOptions, Written,
};
use ga_anim::pose::Pose;
use ga_anim::recording::{Recording, RecordingError, ScalarTrack};
use ga_anim::retarget::{Source, Target};
use ga_anim::skeleton::Skeleton;
use ga_mesh::gltf::{Document, Keys, Mesh, MorphTarget, Node, Primitive, Skin, Transform};
use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;

/// Rigs in the pose in which they were bound and in another, feet on the root, a figure whose nodes
/// stand in the middle of a step, a fox.
const RIGS: [&str; 6] = [
    "cases/motion/node-pose-not-bind-pose/bind.gltf",
    "cases/motion/node-pose-not-bind-pose/posed.gltf",
    "cases/motion/foot-under-root/ik_rig.gltf",
    "cases/motion/foot-under-root/fk_rig.gltf",
    "data/anim/gltf/cesium_man.gltf",
    "data/anim/gltf/Fox.glb",
];

fn rigs() -> Option<Vec<Target>> {
    let target = |path: &str| {
        let file = MotionFile::read(shared(path)?, Options::default()).unwrap();
        Some(Target::new(file).unwrap())
    };
    RIGS.into_iter().map(target).collect()
}

/// All joints rotate, and the whole moves.
fn dance(skeleton: &Skeleton) -> Clip {
    let size = skeleton.joints().iter().map(|joint| joint.head[1].abs());
    let size = size.fold(0.0, f64::max);
    let pose = |frame: usize| {
        let rotor = |joint: usize| {
            let angles = [0, 1, 2].map(|k| 0.5 * ((joint * 7 + frame * 3 + k) as f64).sin());
            Rotor::from_rotation_vector(angles).unwrap()
        };
        let rotors: Vec<Rotor<f64>> = (0..skeleton.len()).map(rotor).collect();
        let way = [0.1 * size * frame as f64, 0.02 * size, 0.0];
        let root = Motor::from(Translator::from_displacement(way));
        Pose::from_rotors(skeleton, root, &rotors).unwrap()
    };
    Clip::new(0.04, (0..5).map(pose).collect()).unwrap()
}

/// The greatest distance between the joints of a recording and where the poses of a clip put them,
/// as a part of the size of the skeleton.
fn apart(recording: &Recording, skeleton: &Skeleton, clip: &Clip, unit: f64) -> f64 {
    let joints = recording.joints().iter();
    let names: Vec<&str> = joints.map(|joint| joint.name.as_str()).collect();
    let (mut greatest, mut size) = (0.0_f64, 0.0_f64);
    for (frame, pose) in clip.frames().iter().enumerate() {
        let found = recording.frames_of_joints(frame).unwrap();
        let bones = pose.bones(skeleton).unwrap();
        for (joint, [head, _]) in skeleton.joints().iter().zip(bones) {
            let place = names.iter().position(|name| *name == joint.name).unwrap();
            let found = Vector::from(found[place].translator().displacement());
            let head = Vector::from(head) * unit;
            greatest = greatest.max(found.distance(head));
            size = size.max(head.length());
        }
    }
    greatest / size
}

fn written(target: &Target, recording: &Recording, format: Format, more: Animations) -> Written {
    let options = WriteOptions {
        name: "dance",
        like: Some(target.file()),
        animations: more,
        ..WriteOptions::default()
    };
    Written::new(recording, format, &options, |_, _| {}).unwrap()
}

fn document(contents: &Contents) -> &Document {
    match contents {
        Contents::Gltf(document) => document,
        other => panic!("{:?}", other.format()),
    }
}

#[test]
fn a_character_plays_the_motion_and_keeps_what_it_has() {
    let Some(rigs) = rigs() else {
        return;
    };
    for (target, name) in rigs.iter().zip(RIGS) {
        let (skeleton, before) = (target.skeleton(), document(target.file().contents()));
        let clip = dance(skeleton);
        let recording = target.recording(&clip).unwrap();
        let error = apart(&recording, skeleton, &clip, 1.0);
        assert!(error < 1e-6, "{name}: {error}");
        // Its joints at rest are those of the pose in which the skin was bound.
        for (joint, place) in recording.joints().iter().zip(recording.rest_positions()) {
            if let Some(known) = skeleton.joint(&joint.name) {
                let error = Vector::from(known.head).distance(place.into());
                assert!(
                    error < 1e-5 * (1.0 + Vector::from(place).length()),
                    "{name}: {error}"
                );
            }
        }
        for animations in [Animations::First, Animations::Alone] {
            let written = written(target, &recording, Format::Gltf, animations);
            assert_eq!(written.losses, [], "{name}");
            let bytes = written.encode().unwrap();
            let after = ga_mesh::gltf::decode(&bytes).unwrap();
            assert_eq!(after.animations[0].name.as_deref(), Some("dance"));
            match animations {
                Animations::First => assert_eq!(after.animations[1..], before.animations),
                _ => assert_eq!(after.animations.len(), 1),
            }
            assert_eq!(
                (&after.meshes, &after.skins, &after.materials),
                (&before.meshes, &before.skins, &before.materials),
                "{name}"
            );
            let player = Player::new(&after).unwrap();
            let nodes = Rigged::new(before).unwrap().nodes().to_vec();
            for (frame, pose) in clip.frames().iter().enumerate() {
                let time = f64::from((0.04 * frame as f64) as f32);
                let played = player.pose(Some(0), time).unwrap();
                let bones = pose.bones(skeleton).unwrap();
                for (node, [head, _]) in nodes.iter().zip(bones) {
                    let place = Vector::from(played.world[*node].translation);
                    let head = Vector::from(head);
                    let error = place.distance(head);
                    assert!(error < 1e-5 * (1.0 + head.length()), "{name}: {error}");
                }
            }
        }
        // Read again it is as it was written.
        let again = written(target, &recording, Format::Gltf, Animations::First);
        let again = Recording::from_gltf(document(&again.contents), 0, 1.0, None).unwrap();
        assert!(apart(&again, skeleton, &clip, 1.0) < 1e-5, "{name}");
        assert_eq!(again.joints().len(), recording.joints().len());
    }
}

#[test]
fn other_formats_stand_as_the_skin_was_bound() {
    let Some(rigs) = rigs() else {
        return;
    };
    for (target, name) in rigs.iter().zip(RIGS) {
        let (skeleton, before) = (target.skeleton(), document(target.file().contents()));
        let clip = dance(skeleton);
        let recording = target.recording(&clip).unwrap();
        let lost =
            |written: &Written| -> Vec<&str> { written.losses.iter().map(Loss::kind).collect() };
        let in_bvh = written(target, &recording, Format::Bvh, Animations::First);
        let mut beside = vec!["meshes_left_out"];
        if !before.animations.is_empty() {
            beside.push("animations_left_out");
        }
        assert_eq!(lost(&in_bvh)[..beside.len()], beside, "{name}");
        let Contents::Bvh(motion) = &in_bvh.contents else {
            panic!("BVH");
        };
        let again = Recording::from_bvh(motion, 1.0).unwrap();
        assert!(apart(&again, skeleton, &clip, 1.0) < 1e-6, "{name}");
        let rest = motion.skeleton().unwrap();
        for joint in skeleton.joints() {
            let found = rest.joint(&joint.name).unwrap();
            let (found, known) = (Vector::from(found.head), Vector::from(joint.head));
            assert!(
                found.distance(known) < 1e-5 * (1.0 + known.length()),
                "{name}"
            );
        }

        // The clip is a target with the same skeleton.
        let in_clip = written(target, &recording, Format::Clip, Animations::Alone);
        assert_eq!(lost(&in_clip), ["meshes_left_out"], "{name}");
        let file = MotionFile::new(in_clip.contents, Options::default());
        let target = Target::new(file).unwrap();
        let clip = dance(target.skeleton());
        assert!(target.motion().is_some() && target.soles().is_none());
        let recording = target.recording(&clip).unwrap();
        let error = apart(&recording, target.skeleton(), &clip, 1.0);
        assert!(error < 1e-6, "{name}: {error}");
        for joint in skeleton.joints() {
            let found = target.skeleton().joint(&joint.name).unwrap();
            let (found, known) = (Vector::from(found.head), Vector::from(joint.head));
            assert!(
                found.distance(known) < 1e-5 * (1.0 + known.length()),
                "{name}"
            );
        }
    }
}

/// A clip is in metres, whatever unit is given with it.
#[test]
fn the_unit_of_a_clip_is_a_metre() {
    let Some(rigs) = rigs() else {
        return;
    };
    let recording = rigs[0].recording(&dance(rigs[0].skeleton())).unwrap();
    let in_clip = written(&rigs[0], &recording, Format::Clip, Animations::Alone);
    let options = Options {
        metres_per_unit: Some(0.01),
        ..Options::default()
    };
    let target = Target::new(MotionFile::new(in_clip.contents, options)).unwrap();
    assert_eq!(target.metres_per_unit(), 1.0);
    let clip = dance(target.skeleton());
    let recording = target.recording(&clip).unwrap();
    assert!(apart(&recording, target.skeleton(), &clip, 1.0) < 1e-6);
}

#[test]
fn nodes_that_are_not_there_and_units_of_no_length_are_errors() {
    let body = b"HIERARCHY ROOT hips { OFFSET 0 0 0 CHANNELS 3 Zrotation Yrotation Xrotation
          End Site { OFFSET 0 1 0 } } MOTION Frames: 1 Frame Time: 0.01
          0 0 0";
    let motion = bvh::decode(body).unwrap();
    let skeleton = motion.skeleton().unwrap();
    let document = Document {
        nodes: vec![Node::default()],
        ..Document::default()
    };
    let error = Rigged::from_nodes(document, skeleton.clone(), vec![1]).unwrap_err();
    assert_eq!(error, MotionFileError::NoNode { node: 1, count: 1 });
    for unit in [0.0, -1.0, f64::INFINITY] {
        let options = Options {
            metres_per_unit: Some(unit),
            ..Options::default()
        };
        let file = MotionFile::new(Contents::Bvh(motion.clone()), options);
        let error = Target::new(file)
            .unwrap()
            .recording(&dance(&skeleton))
            .unwrap_err();
        assert_eq!(
            error,
            MotionFileError::Recording(RecordingError::Unit(unit))
        );
    }
}

/// A frame above a joint that is turned round by two negative factors, or is mirrored in a point.
#[test]
fn joints_move_below_negative_factors() {
    for scale in [[-2.0, -2.0, 2.0], [-2.0; 3]] {
        let node = |name: &str, children: &[usize], scale| Node {
            name: Some(name.to_owned()),
            children: children.to_vec(),
            transform: Transform::Decomposed {
                translation: [0.3, 1.0, 0.1],
                rotation: [0.0, 0.6, 0.0, 0.8],
                scale,
            },
            ..Node::default()
        };
        let rig = Document {
            nodes: vec![
                node("rig", &[1], scale),
                node("hips", &[2], [1.0; 3]),
                node("head", &[], [1.0; 3]),
            ],
            skins: vec![Skin {
                joints: vec![1, 2],
                ..Skin::default()
            }],
            ..Document::default()
        };
        let file = MotionFile::new(Contents::Gltf(Box::new(rig)), Options::default());
        let target = Target::new(file).unwrap();
        let clip = dance(target.skeleton());
        let recording = target.recording(&clip).unwrap();
        let error = apart(&recording, target.skeleton(), &clip, 1.0);
        assert!(error < 1e-12, "{scale:?}: {error}");
    }
}

/// All channels, offsets, ends and the unit.
#[test]
fn a_recording_keeps_its_form_as_a_target() {
    let motion = bvh::decode(
        b"HIERARCHY ROOT hips { OFFSET 1 90 2
            CHANNELS 6 Yposition Xposition Zposition Yrotation Xrotation Zrotation
            JOINT chest { OFFSET 0 40 5
              CHANNELS 6 Xposition Yposition Zposition Xrotation Zrotation Yrotation
              End Site { OFFSET 0 30 -5 } }
            JOINT leg { OFFSET 10 -5 0 CHANNELS 3 Zrotation Yrotation Xrotation
              JOINT foot { OFFSET 0 -80 0 CHANNELS 3 Xrotation Yrotation Zrotation
                End Site { OFFSET 0 -4 12 } } } }
          MOTION Frames: 1 Frame Time: 0.01
          90 1 2 0 0 0 0 40 5 0 0 0 0 0 0 0 0 0",
    )
    .unwrap();
    let options = Options {
        metres_per_unit: Some(0.01),
        ..Options::default()
    };
    let target = Target::new(MotionFile::new(Contents::Bvh(motion.clone()), options)).unwrap();
    let clip = dance(target.skeleton());
    let recording = target.recording(&clip).unwrap();
    assert!(apart(&recording, target.skeleton(), &clip, 0.01) < 1e-12);
    let written = written(&target, &recording, Format::Bvh, Animations::First);
    assert_eq!(
        (written.metres_per_unit, &written.losses[..]),
        (0.01, &[][..])
    );
    let Contents::Bvh(again) = &written.contents else {
        panic!("BVH");
    };
    assert_eq!(again.joints(), motion.joints());
    let again = bvh::decode(again.encode().as_bytes()).unwrap();
    let again = Recording::from_bvh(&again, 0.01).unwrap();
    assert!(apart(&again, target.skeleton(), &clip, 0.01) < 1e-12);
}

/// A rig in centimetres below a node that scales it, with two morph targets.
#[test]
fn what_a_scaled_rig_does_not_keep_in_another_format_is_listed() {
    let node = |name: &str, children: &[usize], translation, scale| Node {
        name: Some(name.to_owned()),
        children: children.to_vec(),
        transform: Transform::Decomposed {
            translation,
            rotation: [0.0, 0.6, 0.0, 0.8],
            scale: [scale; 3],
        },
        ..Node::default()
    };
    let target = MorphTarget {
        positions: vec![[1.0; 3]],
        ..MorphTarget::default()
    };
    let vertex = Primitive {
        positions: vec![[0.0; 3]],
        joints: vec![vec![[0; 4]]],
        weights: vec![vec![[1.0, 0.0, 0.0, 0.0]]],
        targets: vec![target.clone(), target],
        ..Primitive::default()
    };
    let rig = Document {
        nodes: vec![
            node("rig", &[1], [0.3, 0.0, 0.1], 0.01),
            node("hips", &[2], [0.0, 97.3, 0.0], 1.0),
            node("head", &[], [3.1, 71.7, 0.0], 1.0),
            Node {
                mesh: Some(0),
                skin: Some(0),
                ..node("face", &[], [0.0; 3], 1.0)
            },
        ],
        meshes: vec![Mesh {
            primitives: vec![vertex],
            weights: vec![0.0, 0.125],
            ..Mesh::default()
        }],
        skins: vec![Skin {
            joints: vec![1, 2],
            ..Skin::default()
        }],
        ..Document::default()
    };
    let file = MotionFile::new(Contents::Gltf(Box::new(rig)), Options::default());
    let target = Target::new(file).unwrap();
    let clip = dance(target.skeleton());
    let track = |name: &str| ScalarTrack {
        name: name.to_owned(),
        values: vec![0.0, 0.25, 0.5, 0.75, 1.0],
    };
    let tracks = ["face, morph target 0", "smile"].map(track).to_vec();
    let recording = target.recording(&clip).unwrap();
    let recording = recording.with_tracks(tracks.clone()).unwrap();
    assert!(apart(&recording, target.skeleton(), &clip, 1.0) < 1e-12);
    let lost = |format| -> Vec<&'static str> {
        let written = written(&target, &recording, format, Animations::First);
        written.losses.iter().map(Loss::kind).collect()
    };
    let in_bvh = [
        "meshes_left_out",
        "scale_left_out",
        "joint_axes_left_out",
        "tracks_left_out",
    ];
    assert_eq!(lost(Format::Bvh), in_bvh);
    assert_eq!(lost(Format::Clip), ["meshes_left_out"]);
    // A metre is far from what single precision rounds, in whichever unit it is written; the
    // document has one of the tracks.
    assert_eq!(lost(Format::Gltf), ["tracks_left_out"]);
    let in_gltf = written(&target, &recording, Format::Gltf, Animations::First);
    assert_eq!(
        in_gltf.losses,
        [Loss::Tracks {
            tracks: vec!["smile".to_owned()]
        }]
    );
    let channels = &document(&in_gltf.contents).animations[0].channels;
    let weights = channels.iter().find_map(|channel| match &channel.keys {
        Keys::Weights(keys) => Some((channel.node, keys.clone())),
        _ => None,
    });
    // The other target keeps its weight.
    let keys = [0.0, 0.25, 0.5, 0.75, 1.0].map(|key| [key, 0.125]);
    assert_eq!(weights, Some((3, keys.concat())));
    // Only the hips leave their place.
    let moved = channels.iter();
    let moved = moved.filter(|channel| matches!(channel.keys, Keys::Translation(_)));
    assert_eq!(moved.map(|channel| channel.node).collect::<Vec<_>>(), [1]);
    let again = Recording::from_gltf(document(&in_gltf.contents), 0, 1.0, None).unwrap();
    assert!(apart(&again, target.skeleton(), &clip, 1.0) < 1e-6);
    assert_eq!(again.tracks()[0], tracks[0]);
    assert_eq!(again.tracks()[1].values, [0.125; 5]);
    assert!(
        recording
            .with_tracks(vec![ScalarTrack {
                name: "short".into(),
                values: vec![]
            }])
            .is_err()
    );
}

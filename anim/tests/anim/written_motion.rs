//! Clips as BVH files and as animations of glTF documents, read again.

use ga_anim::MotionFileError;
use ga_anim::bvh::{self, Bvh};
use ga_anim::clip::Clip;
use ga_anim::gltf::{Player, Rigged, character};
use ga_anim::motion_file::Loss;
use ga_anim::pose::Pose;
use ga_anim::recording::{Recording, RecordingError};
use ga_anim::skeleton::{Joint, Skeleton};
use ga_mesh::gltf::{Document, Keys, Node, Transform};
use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;

/// A tree whose joints are not in the order of a file: the children of the first come last.
fn skeleton(places: &[[f64; 3]]) -> Skeleton {
    let parents = [None, Some(0), None, Some(1), Some(2), Some(0), Some(3)];
    let joints = parents.iter().zip(places).enumerate();
    let joints = joints.map(|(index, (&parent, &head))| Joint {
        name: format!("joint {index}"),
        parent,
        head,
        tail: head.map(|x| x + 0.5),
    });
    Skeleton::new(joints.collect()).unwrap()
}

fn pose(skeleton: &Skeleton, numbers: &[[f64; 3]], way: [f64; 3]) -> Pose {
    let rotors: Vec<Rotor<f64>> = numbers
        .iter()
        .map(|&v| Rotor::from_rotation_vector(v).unwrap())
        .collect();
    let root = Motor::from(Translator::from_displacement(way));
    Pose::from_rotors(skeleton, root, &rotors).unwrap()
}

proptest! {
    #[test]
    fn a_clip_comes_back_from_bvh(
        places in vec(uniform3(-2.0..2.0f64), 7),
        poses in vec((vec(uniform3(-3.0..3.0f64), 7), uniform3(-5.0..5.0f64)), 1..5),
    ) {
        let skeleton = skeleton(&places);
        let poses = poses.iter().map(|(numbers, way)| pose(&skeleton, numbers, *way));
        let clip = Clip::new(0.025, poses.collect()).unwrap();
        let recording = Recording::from_clip(&skeleton, &clip).unwrap();
        let (motion, losses) = Bvh::from_recording(&recording, 1.0, None);
        prop_assert!(losses.is_empty(), "{:?}", losses);
        let again = bvh::decode(motion.encode().as_bytes()).unwrap();
        prop_assert_eq!(&again, &motion);
        prop_assert_eq!(again.frame_count(), clip.frames().len());
        for (frame, pose) in clip.frames().iter().enumerate() {
            let bones = pose.bones(&skeleton).unwrap();
            let heads = again.joint_positions(frame).unwrap();
            let ends = again.end_site_positions(frame).unwrap();
            for (joint, described) in skeleton.joints().iter().enumerate() {
                let there = again.index(&described.name).unwrap();
                let [head, tail] = bones[joint].map(Vector::from);
                prop_assert!(head.distance(heads[there].into()) < 1e-12);
                if let Some(end) = ends[there] {
                    prop_assert!(tail.distance(end.into()) < 1e-12);
                }
            }
        }
        // With the channels of a recording that is there already.
        let source = again.skeleton().unwrap();
        let own = Clip::new(0.1, vec![again.pose(0).unwrap()]).unwrap();
        let own = Recording::from_clip(&source, &own).unwrap();
        let (other, _) = Bvh::from_recording(&own, 1.0, Some((&again, 1.0)));
        let (a, b) = (other.joint_positions(0).unwrap(), again.joint_positions(0).unwrap());
        for (a, b) in a.into_iter().zip(b) {
            prop_assert!(Vector::from(a).distance(b.into()) < 1e-12);
        }
    }
}

#[test]
fn what_moves_has_positions_and_what_is_not_a_motion_is_an_error() {
    let places: Vec<[f64; 3]> = (0..7).map(|k| [f64::from(k), 0.0, 1.0]).collect();
    let skeleton = skeleton(&places);
    let mut moved = Pose::rest(7);
    moved.joints[3] = Motor::from(Translator::from_displacement([0.0, 0.25, 0.0]));
    let clip = Clip::new(0.1, vec![Pose::rest(7), moved]).unwrap();
    // A joint that leaves its place has positions.
    let in_bvh = |skeleton: &Skeleton, clip: &Clip| {
        let recording = Recording::from_clip(skeleton, clip);
        recording.map(|recording| Bvh::from_recording(&recording, 1.0, None))
    };
    let (motion, _) = in_bvh(&skeleton, &clip).unwrap();
    let again = bvh::decode(motion.encode().as_bytes()).unwrap();
    let joint = again.index("joint 3").unwrap();
    let place = |frame: usize| again.joint_positions(frame).unwrap()[joint];
    assert_eq!(place(0), [3.0, 0.0, 1.0]);
    assert!(Vector::from(place(1)).distance(Vector::new(3.0, 0.25, 1.0)) < 1e-12);
    let short = Clip::new(0.1, vec![Pose::rest(6)]).unwrap();
    assert!(matches!(
        in_bvh(&skeleton, &short),
        Err(RecordingError::Skeleton(_))
    ));
    let named = |a: &str, b: &str| {
        let joint = |name: &str| Joint {
            name: name.into(),
            parent: None,
            head: [0.0; 3],
            tail: [0.0; 3],
        };
        let skeleton = Skeleton::new(vec![joint(a), joint(b)]).unwrap();
        let still = Clip::new(0.1, vec![Pose::rest(2)]).unwrap();
        let (motion, losses) = in_bvh(&skeleton, &still).unwrap();
        let names = motion.joints().iter().map(|joint| joint.name.clone());
        let kinds = losses.iter().map(Loss::kind);
        (names.collect::<Vec<_>>(), kinds.collect::<Vec<_>>())
    };
    let renamed = "joint_renamed";
    let expected = |names: [&str; 2]| (names.map(str::to_owned).to_vec(), vec![renamed; 2]);
    assert_eq!(named("a{", "a}"), expected(["a_", "a__2"]));
    assert_eq!(named("a\nb", ""), expected(["a b", "_"]));
}

/// The places of the joints of a document in its animation are those of the poses.
fn assert_played(rigged: &Rigged, document: &Document, clip: &Clip, bound: f64) {
    let player = Player::new(document).unwrap();
    let nodes: Vec<usize> = rigged.nodes().to_vec();
    for (frame, pose) in clip.frames().iter().enumerate() {
        let time = f64::from((frame as f64 * clip.frame_time()) as f32);
        let played = player.pose(Some(0), time).unwrap();
        let bones = pose.bones(rigged.skeleton()).unwrap();
        for (node, [head, _]) in nodes.iter().zip(bones) {
            let place = Vector::from(played.world[*node].translation);
            assert!(
                place.distance(head.into()) < bound,
                "node {node}: {place:?} instead of {head:?}"
            );
        }
    }
}

#[test]
fn a_real_figure_plays_a_clip() {
    let Some(path) = shared("data/anim/gltf/cesium_man.gltf") else {
        return;
    };
    let document = ga_mesh::gltf::read(path).unwrap();
    let rigged = Rigged::new(&document).unwrap();
    let skeleton = rigged.skeleton();
    assert_eq!(*skeleton, character(&document).unwrap().skeleton);
    let numbers = |frame: usize| -> Vec<[f64; 3]> {
        (0..skeleton.len())
            .map(|joint| [0, 1, 2].map(|k| ((joint * 7 + frame * 3 + k) as f64).sin()))
            .collect()
    };
    let poses = (0..5).map(|frame| pose(skeleton, &numbers(frame), [0.1 * frame as f64, 0.2, 0.0]));
    let clip = Clip::new(0.04, poses.collect()).unwrap();
    let played = rigged.with_clip("dance", &clip).unwrap().0;
    // Its own animation follows.
    assert_eq!(played.animations[0].name.as_deref(), Some("dance"));
    assert_eq!(played.animations[1..], document.animations);
    let twice = Rigged::new(&played).unwrap().with_clip("dance", &clip);
    let names = twice.unwrap().0.animations.into_iter().map(|it| it.name);
    let names: Vec<_> = names.take(2).flatten().collect();
    assert_eq!(names, ["dance 2", "dance"]);
    assert_eq!(
        (&played.meshes, &played.skins),
        (&document.meshes, &document.skins)
    );
    assert_played(&rigged, &played, &clip, 2e-6);
    // Written and read.
    let bytes = ga_mesh::gltf::encode(&played).unwrap();
    let again = ga_mesh::gltf::decode(&bytes).unwrap();
    assert_played(&rigged, &again, &clip, 2e-6);
}

#[test]
fn a_skeleton_alone_plays_a_clip() {
    let places: Vec<[f64; 3]> = (0..7)
        .map(|k| [f64::from(k), (f64::from(k)).cos(), 1.0])
        .collect();
    let skeleton = skeleton(&places);
    let numbers: Vec<[f64; 3]> = (0..7).map(|k| [0.3, f64::from(k) * 0.2, -0.4]).collect();
    let clip = Clip::new(
        0.5,
        vec![Pose::rest(7), pose(&skeleton, &numbers, [1.0, 2.0, 3.0])],
    );
    let clip = clip.unwrap();
    let rigged = Rigged::of_skeleton(&skeleton);
    let document = rigged.with_clip("bow", &clip).unwrap().0;
    assert_played(&rigged, &document, &clip, 5e-6);
    // Only roots move along.
    let moved = document.animations[0].channels.iter();
    let moved = moved.filter(|channel| matches!(channel.keys, Keys::Translation(_)));
    assert_eq!(
        moved.map(|channel| channel.node).collect::<Vec<_>>(),
        [0, 2]
    );
    let short = Clip::new(0.1, vec![Pose::rest(6)]).unwrap();
    assert!(matches!(
        rigged.with_clip("short", &short),
        Err(MotionFileError::Recording(RecordingError::Skeleton(_)))
    ));
    // A frame that is scaled non-uniformly has no rotation below it.
    let node = |children: Vec<usize>, scale| Node {
        children,
        transform: Transform::Decomposed {
            translation: [0.0, 1.0, 0.0],
            rotation: [0.0, 0.0, 0.0, 1.0],
            scale,
        },
        ..Node::default()
    };
    let stretched = Document {
        nodes: vec![node(vec![1], [1.0, 2.0, 1.0]), node(vec![], [1.0; 3])],
        ..Document::default()
    };
    let rigged = Rigged::new(&stretched).unwrap();
    let still = Clip::new(0.1, vec![Pose::rest(2)]).unwrap();
    assert_eq!(
        rigged.with_clip("still", &still).unwrap_err(),
        RecordingError::NonUniformScale {
            name: "node 0".into()
        }
        .into()
    );
}

proptest! {
    #[test]
    fn bones_of_other_lengths_move_along(
        places in vec(uniform3(-2.0..2.0f64), 7),
        factors in vec(0.5..2.0f64, 7),
        (numbers, way) in (vec(uniform3(-3.0..3.0f64), 7), uniform3(-5.0..5.0f64)),
    ) {
        let skeleton = skeleton(&places);
        let longer = Rigged::of_skeleton(&skeleton).with_lengths(&factors).unwrap();
        let joints = longer.skeleton().joints();
        for (joint, old) in skeleton.joints().iter().enumerate() {
            let (from, to) = match old.parent {
                Some(parent) => (skeleton.joints()[parent].head, joints[parent].head),
                None => ([0.0; 3], [0.0; 3]),
            };
            let way = Vector::from(old.head) - Vector::from(from);
            let head = Vector::from(to) + way * factors[joint];
            prop_assert!(head.distance(joints[joint].head.into()) < 1e-5);
        }
        let pose = pose(longer.skeleton(), &numbers, way);
        let clip = Clip::new(0.1, vec![pose]).unwrap();
        let played = longer.with_clip("longer", &clip).unwrap().0;
        assert_played(&longer, &played, &clip, 1e-4);
    }
}

/// One factor for all joints gives the same figure in another size, below a frame of its own.
#[test]
fn a_figure_grows_with_its_skin() {
    let Some(path) = shared("data/anim/gltf/cesium_man.gltf") else {
        return;
    };
    let document = ga_mesh::gltf::read(path).unwrap();
    let rigged = Rigged::new(&document).unwrap();
    let count = rigged.skeleton().len();
    let still = Clip::new(1.0, vec![Pose::rest(count)]).unwrap();
    let grown = rigged.with_lengths(&vec![1.25; count]).unwrap();
    let before = character(&rigged.with_clip("still", &still).unwrap().0).unwrap();
    let after = character(&grown.with_clip("still", &still).unwrap().0).unwrap();
    assert_eq!(before.mesh.vertex_count(), after.mesh.vertex_count());
    for (old, new) in before.mesh.coordinates().zip(after.mesh.coordinates()) {
        let wanted = Vector::from(old) * 1.25;
        assert!(wanted.distance(new.into()) < 1e-5, "{old:?} {new:?}");
    }
    let refused = |factors: &[f64]| rigged.with_lengths(factors).unwrap_err();
    assert!(matches!(refused(&[1.0]), MotionFileError::Skeleton(_)));
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let mut factors = vec![1.0; count];
        factors[2] = wrong;
        let name = &rigged.skeleton().joints()[2].name;
        assert!(refused(&factors).to_string().contains(name.as_str()));
    }
}

//! Clips as glTF's nodes and keys, against the matrices of glam.

use ga_anim::clip::Clip;
use ga_anim::gltf::{animation, joint_nodes, vertex_weights};
use ga_anim::pose::{Pose, PoseError};
use ga_anim::skeleton::{Joint, Skeleton};
use ga_anim::weights::SkinWeights;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use glam::{DMat4, DQuat, DVec3};
use proptest::prelude::*;

fn vector() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-1f64..1.0)
}

/// A rotation by the length of `turn` about its direction, then a translation.
fn matrix(turn: [f64; 3], translation: [f64; 3]) -> DMat4 {
    let rotation = DQuat::from_scaled_axis(turn.into());
    DMat4::from_rotation_translation(rotation, translation.into())
}

fn motor(turn: [f64; 3], translation: [f64; 3]) -> Motor<f64> {
    Translator::from_displacement(translation) * rotor(turn)
}

fn rotor(turn: [f64; 3]) -> Rotor<f64> {
    Rotor::from_axis_angle(turn, DVec3::from(turn).length()).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// The skeleton's joints rotate about their positions and the whole moves after them. A player
    /// of the nodes and keys, whose frames are chained from parent to child, sees the same.
    #[test]
    fn a_clip_plays_as_its_motors_say(
        heads in prop::collection::vec((vector(), any::<Option<prop::sample::Index>>()), 1..9),
        turns in prop::collection::vec(prop::collection::vec(vector(), 10), 1..4),
        steps in prop::collection::vec(vector(), 4),
        at in vector(),
    ) {
        prop_assume!(turns.iter().flatten().all(|&t| DVec3::from(t).length() > 1e-3));
        let joint = |(j, &(head, parent)): (usize, &([f64; 3], Option<prop::sample::Index>))| Joint {
            name: format!("joint {j}"),
            parent: parent.filter(|_| j > 0).map(|parent| parent.index(j)),
            head,
            tail: head,
        };
        let skeleton = Skeleton::new(heads.iter().enumerate().map(joint).collect()).unwrap();
        let poses = turns.iter().zip(&steps).map(|(turns, &step)| {
            let rotors: Vec<_> = turns[..skeleton.len()].iter().map(|&turn| rotor(turn)).collect();
            Pose::from_rotors(&skeleton, motor(turns[9], step), &rotors).unwrap()
        });
        let clip = Clip::new(0.25, poses.collect()).unwrap();

        let nodes = joint_nodes(&skeleton);
        let animation = animation("clip", &skeleton, &clip).unwrap();
        prop_assert_eq!(nodes.len(), skeleton.len());
        prop_assert_eq!(animation.tracks.len(), skeleton.len());
        let mut rest: Vec<Motor<f64>> = Vec::new();
        for (node, joint) in nodes.iter().zip(skeleton.joints()) {
            prop_assert_eq!((&node.name, node.parent), (&joint.name, joint.parent));
            rest.push(node.parent.map_or(node.rest, |parent| rest[parent] * node.rest));
        }
        for (frame, (turns, &step)) in turns.iter().zip(&steps).enumerate() {
            prop_assert_eq!(animation.times[frame], 0.25 * frame as f64);
            let mut played: Vec<Motor<f64>> = Vec::new();
            let mut expected: Vec<DMat4> = Vec::new();
            for (j, joint) in skeleton.joints().iter().enumerate() {
                prop_assert_eq!(animation.tracks[j].joint, j);
                let key = animation.tracks[j].keys[frame];
                played.push(joint.parent.map_or(key, |parent| played[parent] * key));
                let above = joint.parent.map_or(matrix(turns[9], step), |parent| expected[parent]);
                let head = DVec3::from(joint.head);
                let about = DMat4::from_translation(head)
                    * matrix(turns[j], [0.0; 3])
                    * DMat4::from_translation(-head);
                expected.push(above * about);

                let found = (played[j] * rest[j].reverse()).transform(Point::from(at));
                let expected = expected[j].transform_point3(at.into());
                prop_assert!(found.distance(Point::from(expected.to_array())) < 1e-13);
            }
        }
    }
}

#[test]
fn weights_are_listed_by_vertex() {
    let weights = SkinWeights::new(3, [vec![(2, 1.0), (0, 3.0)], vec![(1, 2.0)]]).unwrap();
    let expected = [vec![(2, 0.25), (0, 0.75)], vec![(1, 1.0)]];
    assert_eq!(vertex_weights(&weights), expected);
}

#[test]
fn a_clip_for_another_skeleton_is_refused() {
    let joint = Joint {
        name: "one".into(),
        parent: None,
        head: [0.0; 3],
        tail: [0.0; 3],
    };
    let skeleton = Skeleton::new(vec![joint]).unwrap();
    let clip = Clip::new(1.0, vec![Pose::rest(2)]).unwrap();
    assert_eq!(
        animation("clip", &skeleton, &clip),
        Err(PoseError {
            expected: 1,
            found: 2
        })
    );
}

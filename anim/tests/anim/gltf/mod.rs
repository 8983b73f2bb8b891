//! Clips as recordings, and as the animation of a written file, against the matrices of glam.

mod character;
mod encoded;
mod made_up;
mod oracle;
mod player;
mod reference;
mod refused;

use ga_anim::clip::Clip;
use ga_anim::gltf::{Rigged, joint_nodes, vertex_weights};
use ga_anim::pose::Pose;
use ga_anim::recording::{Recording, RecordingError};
use ga_anim::skeleton::{Joint, Skeleton, SkeletonError};
use ga_anim::weights::SkinWeights;
use ga_mesh::gltf::model::{Dielectric, Model, Skin, to_document};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use glam::{DMat4, DQuat, DVec3};
use proptest::prelude::*;

use player::{Played, play};

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

/// A position and, perhaps, which of the positions before it is its parent's.
type Head = ([f64; 3], Option<prop::sample::Index>);

fn heads() -> impl Strategy<Value = Vec<Head>> {
    prop::collection::vec((vector(), any::<Option<prop::sample::Index>>()), 1..9)
}

/// For each of a few frames, ten rotations. The last one is of the whole skeleton.
fn rotations() -> impl Strategy<Value = Vec<Vec<[f64; 3]>>> {
    let rotation = || vector().prop_filter("an axis", |&r| DVec3::from(r).length() > 1e-3);
    prop::collection::vec(prop::collection::vec(rotation(), 10), 1..4)
}

fn skeleton(heads: &[Head]) -> Skeleton {
    let joint = |(j, &(head, parent)): (usize, &Head)| Joint {
        name: format!("joint {j}"),
        parent: parent.filter(|_| j > 0).map(|parent| parent.index(j)),
        head,
        tail: head,
    };
    Skeleton::new(heads.iter().enumerate().map(joint).collect()).unwrap()
}

fn clip(skeleton: &Skeleton, rotations: &[Vec<[f64; 3]>], steps: &[[f64; 3]]) -> Clip {
    let poses = rotations.iter().zip(steps).map(|(rotations, &step)| {
        let joints = rotations[..skeleton.len()].iter();
        let rotors: Vec<_> = joints.map(|&rotation| rotor(rotation)).collect();
        Pose::from_rotors(skeleton, motor(rotations[9], step), &rotors).unwrap()
    });
    Clip::new(0.25, poses.collect()).unwrap()
}

/// The motion of every joint in a frame: each rotates about its position, x' = h + R (x − h), and
/// its parent's motion follows.
fn motions(skeleton: &Skeleton, rotations: &[[f64; 3]], step: [f64; 3]) -> Vec<DMat4> {
    let mut motions: Vec<DMat4> = Vec::new();
    for (joint, &rotation) in skeleton.joints().iter().zip(rotations) {
        let root = || matrix(rotations[9], step);
        let above = joint.parent.map_or_else(root, |parent| motions[parent]);
        let head = DVec3::from(joint.head);
        let about = DMat4::from_translation(head)
            * matrix(rotation, [0.0; 3])
            * DMat4::from_translation(-head);
        motions.push(above * about);
    }
    motions
}

/// Vertices, each with a weight for every joint that there may be; at least three, for a triangle.
fn vertices() -> impl Strategy<Value = Vec<([f64; 3], [f64; 8])>> {
    prop::collection::vec((vector(), prop::array::uniform8(0.01f64..1.0)), 3..20)
}

/// A file of a mesh with these vertices and one triangle, which a clip moves.
fn file(
    positions: &[[f64; 3]],
    weights: &[Vec<(u32, f64)>],
    skeleton: &Skeleton,
    clip: &Clip,
) -> Vec<u8> {
    let normals = vec![[0.0, 0.0, 1.0]; positions.len()];
    let model = Model {
        name: "triangle",
        positions,
        normals: &normals,
        triangles: &[[0, 1, 2]],
        material: Dielectric::default(),
        skin: Some(Skin {
            joints: &joint_nodes(skeleton),
            weights,
        }),
        animations: &[],
    };
    let nodes = (0..skeleton.len()).collect();
    let rigged = Rigged::from_nodes(to_document(&model).unwrap(), skeleton.clone(), nodes);
    let document = rigged.unwrap().with_clip("clip", clip).unwrap().0;
    ga_mesh::gltf::encode(&document).unwrap()
}

fn assert_near(found: &[DVec3], expected: &[DVec3], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (vertex, (found, expected)) in found.iter().zip(expected).enumerate() {
        let error = found.distance(*expected);
        assert!(
            error <= tolerance,
            "vertex {vertex}: {found} is not {expected}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// The skeleton's joints rotate about their positions and the whole moves after them. The
    /// transforms of a recording, chained from parent to child, move points in the same way.
    #[test]
    fn nodes_and_recordings_move_points_as_the_motors_do(
        heads in heads(),
        rotations in rotations(),
        steps in prop::collection::vec(vector(), 4),
        at in vector(),
    ) {
        let skeleton = skeleton(&heads);
        let clip = clip(&skeleton, &rotations, &steps);

        let nodes = joint_nodes(&skeleton);
        let recording = Recording::from_clip(&skeleton, &clip).unwrap();
        prop_assert_eq!(nodes.len(), skeleton.len());
        prop_assert_eq!(recording.frame_time(), 0.25);
        let mut rest: Vec<Motor<f64>> = Vec::new();
        for (node, joint) in nodes.iter().zip(skeleton.joints()) {
            prop_assert_eq!((&node.name, node.parent), (&joint.name, joint.parent));
            rest.push(node.parent.map_or(node.rest, |parent| rest[parent] * node.rest));
        }
        for (frame, (rotations, &step)) in rotations.iter().zip(&steps).enumerate() {
            let expected = motions(&skeleton, rotations, step);
            let mut played: Vec<Motor<f64>> = Vec::new();
            for (j, joint) in skeleton.joints().iter().enumerate() {
                let key = recording.frame(frame).unwrap()[j].motor;
                played.push(joint.parent.map_or(key, |parent| played[parent] * key));

                let found = (played[j] * rest[j].reverse()).transform(Point::from(at));
                let expected = expected[j].transform_point3(at.into());
                prop_assert!(found.distance(Point::from(expected.to_array())) < 1e-13);
            }
        }
    }

    /// A player of the written file moves the vertices as the rotations of the clip say.
    #[test]
    fn a_clip_plays_as_its_motors_say(
        heads in heads(),
        rotations in rotations(),
        steps in prop::collection::vec(vector(), 4),
        vertices in vertices(),
    ) {
        let skeleton = skeleton(&heads);
        let clip = clip(&skeleton, &rotations, &steps);
        let positions: Vec<[f64; 3]> = vertices.iter().map(|vertex| vertex.0).collect();
        let row = |(_, weights): &([f64; 3], [f64; 8])| -> Vec<(u32, f64)> {
            (0..).zip(*weights).take(skeleton.len()).collect()
        };
        let rows = vertices.iter().map(row);
        let weights = vertex_weights(&SkinWeights::new(skeleton.len(), rows).unwrap());
        let file = file(&positions, &weights, &skeleton, &clip);

        // Up to eight joints in a chain, in single precision.
        let rest: Vec<DVec3> = positions.iter().map(|&position| position.into()).collect();
        assert_near(&play(&file, None).positions, &rest, 1e-5);
        for (frame, (rotations, &step)) in rotations.iter().zip(&steps).enumerate() {
            let motions = motions(&skeleton, rotations, step);
            let moved = |(&position, row): (&DVec3, &Vec<(u32, f64)>)| -> DVec3 {
                let part = |&(joint, weight): &(u32, f64)| {
                    motions[joint as usize].transform_point3(position) * weight
                };
                row.iter().map(part).sum()
            };
            let expected: Vec<DVec3> = rest.iter().zip(&weights).map(moved).collect();
            let Played { positions, time } = play(&file, Some(frame));
            prop_assert_eq!(time, 0.25 * frame as f64);
            assert_near(&positions, &expected, 3e-5);
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
    let error = SkeletonError::PoseLength {
        expected: 1,
        found: 2,
    };
    assert_eq!(
        Recording::from_clip(&skeleton, &clip),
        Err(RecordingError::Skeleton(error))
    );
}

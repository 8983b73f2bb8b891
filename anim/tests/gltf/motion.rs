//! Clips through a file and back, against matrices by Rodrigues' formula.

use ga_anim::clip::Clip;
use ga_anim::gltf::{Animation, JointNode, RigidTransform, to_glb};
use ga_anim::pose::{Pose, PoseError};
use ga_anim::skeleton::{Joint, Skeleton};
use ga_runtime::cga3::{Motor, Rotor, Translator};
use proptest::prelude::*;

use crate::matrix::{IDENTITY, Matrix, Vector, apply, assert_near, product};
use crate::reader::Read;
use crate::source::{Source, source, vector};

/// A turn by the length of `turn` about its direction, then a displacement.
fn rodrigues(turn: Vector, [x, y, z]: Vector) -> Matrix {
    let angle = turn.iter().map(|c| c * c).sum::<f64>().sqrt();
    let [a, b, c] = turn.map(|c| c / angle);
    let k = [[0.0, -c, b], [c, 0.0, -a], [-b, a, 0.0]];
    let turned = |i: usize, j: usize| {
        let square: f64 = (0..3).map(|m| k[i][m] * k[m][j]).sum();
        IDENTITY[i][j] + angle.sin() * k[i][j] + (1.0 - angle.cos()) * square
    };
    let row = |i: usize, displaced: f64| [turned(i, 0), turned(i, 1), turned(i, 2), displaced];
    [row(0, x), row(1, y), row(2, z), IDENTITY[3]]
}

fn rotor(turn: Vector) -> Rotor<f64> {
    let angle = turn.iter().map(|c| c * c).sum::<f64>().sqrt();
    Rotor::from_axis_angle(turn, angle).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn a_motor_becomes_its_quaternion_and_translation(turn in vector(), step in vector(), at in vector()) {
        prop_assume!(turn.iter().map(|c| c * c).sum::<f64>() > 1e-6);
        let motor = Motor::from(Translator::from_displacement(step)) * Motor::from(rotor(turn));
        let transform = RigidTransform::from(motor);
        let expected = apply(&rodrigues(turn, step), at);
        assert_near(&[apply(&crate::matrix::matrix(&transform), at)], &[expected], 1e-12);
        let length: f64 = transform.rotation.iter().map(|c| c * c).sum();
        prop_assert!((length - 1.0).abs() < 1e-12);
    }

    /// The skeleton's joints turn about their places, the whole moves after them: a player of the
    /// file sees the same.
    #[test]
    fn a_clip_plays_as_its_motors_say(
        source in source(1..9),
        heads in prop::collection::vec(vector(), 9),
        turns in prop::collection::vec(prop::collection::vec(vector(), 10), 1..4),
        steps in prop::collection::vec(vector(), 4),
    ) {
        prop_assume!(turns.iter().flatten().all(|t| t.iter().map(|c| c * c).sum::<f64>() > 1e-6));
        let joints = source.joints.len();
        let skeleton = Skeleton::new(
            (0..joints)
                .map(|j| Joint {
                    name: source.joints[j].name.clone(),
                    parent: source.joints[j].parent,
                    head: heads[j],
                    tail: heads[j],
                })
                .collect(),
        )
        .unwrap();
        let poses = turns.iter().zip(&steps).map(|(turns, &step)| {
            let root = Motor::from(Translator::from_displacement(step)) * Motor::from(rotor(turns[9]));
            let rotors: Vec<_> = turns[..joints].iter().map(|&turn| rotor(turn)).collect();
            Pose::from_rotors(&skeleton, root, &rotors).unwrap()
        });
        let clip = Clip::new(0.25, poses.collect()).unwrap();
        let model = Source {
            joints: JointNode::from_skeleton(&skeleton),
            animations: vec![Animation::from_clip("clip", &skeleton, &clip).unwrap()],
            ..source
        };
        let read = Read::new(&to_glb(&model.model()).unwrap());
        assert_near(&read.skinned(None), &model.positions, 1e-5);

        for (frame, (turns, &step)) in turns.iter().zip(&steps).enumerate() {
            let mut motions: Vec<Matrix> = Vec::new();
            for (j, joint) in skeleton.joints().iter().enumerate() {
                let above = joint.parent.map_or(rodrigues(turns[9], step), |parent| motions[parent]);
                let turned = apply(&rodrigues(turns[j], [0.0; 3]), joint.head);
                // x' = h + R (x − h)
                let rest = std::array::from_fn(|axis| joint.head[axis] - turned[axis]);
                motions.push(product(&above, &rodrigues(turns[j], rest)));
            }
            let expected: Vec<Vector> = model
                .positions
                .iter()
                .zip(model.weights.iter())
                .map(|(&position, row)| {
                    row.iter().fold([0.0; 3], |sum, influence| {
                        let moved = apply(&motions[influence.joint as usize], position);
                        std::array::from_fn(|axis| sum[axis] + influence.weight * moved[axis])
                    })
                })
                .collect();
            assert_near(&read.skinned(Some((0, frame))), &expected, 3e-5);
        }
    }
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
        Animation::from_clip("clip", &skeleton, &clip),
        Err(PoseError {
            expected: 1,
            found: 2
        })
    );
}

//! Skinning: the real human in known poses, and what must hold for any skin.

use crate::assert_relative;
use ga_anim::pose::Pose;
use ga_anim::rig;
use ga_anim::skeleton::Skeleton;
use ga_anim::skin::{self, Method, SkinError};
use ga_anim::weights::{Influence, SkinWeights};
use ga_mesh::obj;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use nullcone_shared_data::shared;
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;
use serde_json::Value;

fn vector(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|axis| value[axis].as_f64().unwrap())
}

fn rotor(rotation_vector: [f64; 3]) -> Rotor<f64> {
    let angle = rotation_vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    Rotor::from_axis_angle(rotation_vector, angle).unwrap_or_default()
}

/// The pose of a known answer: rotation vectors of the bones in the order of `bones`.
pub(crate) fn pose(skeleton: &Skeleton, bones: &Value, rotation_vectors: &Value) -> Pose {
    let mut rotors = vec![Rotor::default(); skeleton.len()];
    for (bone, vector_) in bones
        .as_array()
        .unwrap()
        .iter()
        .zip(rotation_vectors.as_array().unwrap())
    {
        rotors[skeleton.index(bone.as_str().unwrap()).unwrap()] = rotor(vector(vector_));
    }
    Pose::from_rotors(skeleton, Motor::default(), &rotors).unwrap()
}

const METHODS: [(&str, Method); 2] = [("lbs", Method::Linear), ("dqs", Method::Motor)];

#[test]
fn some_vertices_of_the_human_go_where_they_should() {
    let truth: Value = serde_json::from_str(include_str!("../data/human.json")).unwrap();
    let skeleton = rig::decode(include_bytes!("../data/rig.cmu_mb.json")).unwrap();
    for known in truth["poses"].as_array().unwrap() {
        let pose = pose(&skeleton, &truth["bones"], &known["rotation_vector"]);
        let motions = pose.motions(&skeleton).unwrap();
        let vertices = known["vertices"].as_array().unwrap();
        let positions: Vec<Point<f64>> = vertices
            .iter()
            .map(|vertex| Point::from(vector(&vertex["position"])))
            .collect();
        let rows = vertices.iter().map(|vertex| {
            let by_name = vertex["weights"].as_object().unwrap();
            let row = by_name.iter().map(|(bone, weight)| {
                (
                    skeleton.index(bone).unwrap() as u32,
                    weight.as_f64().unwrap(),
                )
            });
            row.collect::<Vec<_>>()
        });
        let weights = SkinWeights::new(skeleton.len(), rows).unwrap();
        for (count, known) in known["influences"].as_object().unwrap() {
            let weights = weights.strongest(count.parse().unwrap());
            for (name, method) in METHODS {
                let moved = skin::skin(&positions, &weights, &motions, method).unwrap();
                for (moved, known) in moved.iter().zip(known[name].as_array().unwrap()) {
                    for (ours, known) in moved.coordinates().into_iter().zip(vector(known)) {
                        assert_relative(ours, known, 1e-9);
                    }
                }
            }
        }
    }
}

/// The whole mesh: 500 vertices of each pose one by one, the others by their sum.
#[test]
fn the_whole_human_goes_where_it_should() {
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
    for known in truth["poses"].as_array().unwrap() {
        let motions = pose(&skeleton, &truth["bones"], &known["bone_rotvec"])
            .motions(&skeleton)
            .unwrap();
        for (bone, palette) in truth["bones"]
            .as_array()
            .unwrap()
            .iter()
            .zip(known["palette"].as_array().unwrap())
        {
            let ours = motions[skeleton.index(bone.as_str().unwrap()).unwrap()].to_matrix();
            for row in 0..3 {
                for column in 0..4 {
                    assert_relative(
                        ours[row][column],
                        palette[row][column].as_f64().unwrap(),
                        1e-13,
                    );
                }
            }
        }
        for count in ["8", "4", "2", "1"] {
            let weights = all.strongest(count.parse().unwrap());
            let known_here = &known["influences"][count];
            for (name, method) in METHODS {
                let moved = skin::skin(mesh.positions(), &weights, &motions, method).unwrap();
                let index = known["index"].as_array().unwrap();
                for (index, known) in index.iter().zip(known_here[name].as_array().unwrap()) {
                    let ours = moved[index.as_u64().unwrap() as usize].coordinates();
                    for (ours, known) in ours.into_iter().zip(vector(known)) {
                        assert_relative(ours, known, 1e-9);
                    }
                }
                for (axis, sum) in vector(&known_here[format!("{name}_sum")])
                    .into_iter()
                    .enumerate()
                {
                    assert_relative(moved.iter().map(|x| x.coordinates()[axis]).sum(), sum, 1e-9);
                }
            }
        }
    }
}

fn motors() -> impl Strategy<Value = Motor<f64>> {
    (uniform3(-5.0..5.0f64), uniform3(-4.0..4.0f64))
        .prop_map(|(shift, turn)| Translator::from_displacement(shift) * rotor(turn))
}

/// Positions, weights on `joints` joints and their motions.
fn skins(joints: usize) -> impl Strategy<Value = (Vec<Point<f64>>, SkinWeights, Vec<Motor<f64>>)> {
    let row = proptest::sample::subsequence((0..joints as u32).collect::<Vec<_>>(), 1..=joints)
        .prop_flat_map(|joints| {
            vec(0.01..1.0f64, joints.len())
                .prop_map(move |w| joints.iter().copied().zip(w).collect::<Vec<_>>())
        });
    let vertex = (uniform3(-3.0..3.0f64), row);
    (vec(vertex, 1..20), vec(motors(), joints)).prop_map(move |(vertices, motions)| {
        let positions = vertices.iter().map(|(x, _)| Point::from(*x)).collect();
        let weights = SkinWeights::new(joints, vertices.into_iter().map(|(_, row)| row)).unwrap();
        (positions, weights, motions)
    })
}

fn assert_close(a: Point<f64>, b: Point<f64>, bound: f64) -> Result<(), TestCaseError> {
    prop_assert!(a.distance(b) <= bound, "{a:?} is not {b:?}");
    Ok(())
}

proptest! {
    #[test]
    fn a_skin_whose_joints_move_alike_moves_like_them(
        (positions, weights, _) in skins(12),
        motor in motors(),
    ) {
        for (_, method) in METHODS {
            let moved = skin::skin(&positions, &weights, &[motor; 12], method).unwrap();
            for (moved, rest) in moved.iter().zip(&positions) {
                assert_close(*moved, motor.transform(*rest), 1e-12)?;
            }
        }
    }

    #[test]
    fn a_motor_and_its_negative_are_one_motion(
        (positions, weights, motions) in skins(6),
        negative in vec(any::<bool>(), 6),
    ) {
        let other: Vec<_> = motions.iter().zip(negative).map(|(&m, negative)| if negative { -m } else { m }).collect();
        for (_, method) in METHODS {
            let one = skin::skin(&positions, &weights, &motions, method).unwrap();
            let two = skin::skin(&positions, &weights, &other, method).unwrap();
            for (one, two) in one.iter().zip(&two) {
                assert_close(*one, *two, 1e-11)?;
            }
        }
    }

    #[test]
    fn both_methods_go_with_the_whole((positions, weights, motions) in skins(6), whole in motors()) {
        for (_, method) in METHODS {
            let moved = skin::skin(&positions, &weights, &motions, method).unwrap();
            let together: Vec<_> = motions.iter().map(|&motion| whole * motion).collect();
            let moved_together = skin::skin(&positions, &weights, &together, method).unwrap();
            for (moved, together) in moved.iter().zip(&moved_together) {
                assert_close(whole.transform(*moved), *together, 1e-10)?;
            }
        }
    }

    #[test]
    fn the_linear_blend_is_the_mean_of_where_each_joint_takes_the_vertex(
        (positions, weights, motions) in skins(6),
    ) {
        let moved = skin::skin(&positions, &weights, &motions, Method::Linear).unwrap();
        for (vertex, moved) in moved.iter().enumerate() {
            let mut mean = [0.0; 3];
            for influence in weights.influences(vertex) {
                let there = motions[influence.joint as usize].transform(positions[vertex]).coordinates();
                for axis in 0..3 {
                    mean[axis] += influence.weight * there[axis];
                }
            }
            assert_close(*moved, Point::from(mean), 1e-12)?;
        }
    }

    #[test]
    fn the_strongest_are_the_strongest_and_sum_to_one((_, weights, _) in skins(9), count in 0usize..12) {
        let kept = weights.strongest(count);
        prop_assert_eq!(kept.vertex_count(), weights.vertex_count());
        for (kept, all) in kept.iter().zip(weights.iter()) {
            prop_assert_eq!(kept.len(), count.clamp(1, all.len()));
            prop_assert!((kept.iter().map(|i| i.weight).sum::<f64>() - 1.0).abs() < 1e-15 * 20.0);
            let weight_of = |joint| all.iter().find(|i| i.joint == joint).unwrap().weight;
            let least = kept.iter().map(|i| weight_of(i.joint)).fold(f64::MAX, f64::min);
            let dropped = all.iter().filter(|i| !kept.iter().any(|k| k.joint == i.joint));
            for influence in dropped {
                prop_assert!(influence.weight <= least);
            }
            for pair in kept.windows(2) {
                prop_assert!(pair[0].weight >= pair[1].weight);
                let ratio = weight_of(pair[0].joint) / weight_of(pair[1].joint);
                prop_assert!((pair[0].weight / pair[1].weight - ratio).abs() < 1e-12 * ratio);
            }
        }
    }
}

/// Two joints turn by 120 degrees either way: next to the third, which is still, both are near, but
/// next to each other they are not.
#[test]
fn motors_take_the_sign_that_suits_the_strongest() {
    let turned = |angle: f64| Motor::from(rotor([0.0, 0.0, angle.to_radians()]));
    let motions = [turned(120.0), Motor::default(), turned(-120.0)];
    let weights = SkinWeights::new(3, [[(0, 0.2), (1, 0.6), (2, 0.2)]]).unwrap();
    let place = Point::new(1.0, 2.0, 3.0);
    let moved = skin::skin(&[place], &weights, &motions, Method::Motor).unwrap();
    assert!(moved[0].distance(place) < 1e-15);
}

#[test]
fn of_equal_weights_the_one_listed_first_stays() {
    let weights = SkinWeights::new(4, [[(3, 0.25), (1, 0.25), (0, 0.5)]]).unwrap();
    let kept = weights.strongest(2);
    assert_eq!(
        kept.influences(0)[1],
        Influence {
            joint: 3,
            weight: 0.25 / 0.75
        }
    );
}

#[test]
fn weights_can_be_had_for_a_part() {
    let weights = SkinWeights::new(
        2,
        [vec![(0, 1.0)], vec![(1, 1.0)], vec![(0, 0.5), (1, 0.5)]],
    )
    .unwrap();
    let part = weights.select(&[2, 0]).unwrap();
    assert_eq!(
        (part.influences(0), part.influences(1)),
        (weights.influences(2), weights.influences(0))
    );
    assert_eq!(weights.select(&[3]), None);
    assert_eq!(weights.influences(3), []);
}

#[test]
fn tiny_and_huge_weights_are_weights() {
    let weights = SkinWeights::new(
        2,
        [[(0, f64::MAX), (1, f64::MAX)], [(0, 1e-310), (1, 1e-310)]],
    )
    .unwrap();
    for vertex in 0..2 {
        assert!(
            weights
                .influences(vertex)
                .iter()
                .all(|influence| influence.weight == 0.5)
        );
    }
    for (row, error) in [
        (
            [(0, f64::NAN)],
            SkinError::BadWeight {
                vertex: 0,
                joint: 0,
                weight: f64::NAN,
            }
            .to_string(),
        ),
        (
            [(0, f64::INFINITY)],
            SkinError::BadWeight {
                vertex: 0,
                joint: 0,
                weight: f64::INFINITY,
            }
            .to_string(),
        ),
        (
            [(2, 1.0)],
            SkinError::JointOutOfRange {
                vertex: 0,
                joint: 2,
                joints: 2,
            }
            .to_string(),
        ),
        ([(0, 0.0)], SkinError::Unweighted { vertex: 0 }.to_string()),
    ] {
        assert_eq!(SkinWeights::new(2, [row]).unwrap_err().to_string(), error);
    }
}

#[test]
fn what_does_not_fit_together_is_an_error() {
    let weights = SkinWeights::new(2, [[(0, 0.5), (1, 0.5)]]).unwrap();
    let point = Point::new(1.0, 2.0, 3.0);
    let still = Motor::default();
    for (_, method) in METHODS {
        assert_eq!(
            skin::skin(&[point, point], &weights, &[still; 2], method),
            Err(SkinError::VertexCount {
                expected: 2,
                found: 1
            })
        );
        assert_eq!(
            skin::skin(&[point], &weights, &[still; 3], method),
            Err(SkinError::JointCount {
                expected: 2,
                found: 3
            })
        );
    }
}

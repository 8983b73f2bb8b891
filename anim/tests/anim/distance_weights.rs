//! Weights from distance: known answers, and what must hold for any bones.

use ga_anim::distance_weights::{distance_to_bone, distance_weights};
use ga_anim::skin::SkinError;
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;
use serde_json::Value;

fn vector(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|axis| value[axis].as_f64().unwrap())
}

fn vectors(value: &Value) -> Vec<[f64; 3]> {
    value.as_array().unwrap().iter().map(vector).collect()
}

#[test]
fn weights_are_those_of_the_oracle() {
    let oracle: Value = serde_json::from_str(include_str!("../data/weights.json")).unwrap();
    let mut points = 0;
    for case in oracle["cases"].as_array().unwrap() {
        let influences = case["n"].as_u64().unwrap() as usize;
        let exponent = case["m"].as_f64().unwrap();
        let (heads, tails) = (vectors(&case["bone_head"]), vectors(&case["bone_tail"]));
        let bones: Vec<_> = heads
            .into_iter()
            .zip(tails)
            .map(|(head, tail)| [head, tail])
            .collect();
        let positions = vectors(&case["point"]);
        let weights = distance_weights(positions.clone(), &bones, influences, exponent).unwrap();
        for (vertex, position) in positions.into_iter().enumerate() {
            for (bone, ends) in bones.iter().enumerate() {
                let expected = case["distance"][vertex][bone].as_f64().unwrap();
                assert!((distance_to_bone(position, *ends) - expected).abs() < 1e-14);
            }
            assert_eq!(weights.influences(vertex).len(), influences);
            for (k, influence) in weights.influences(vertex).iter().enumerate() {
                assert_eq!(
                    u64::from(influence.joint),
                    case["joint"][vertex][k].as_u64().unwrap()
                );
                let expected = case["weight"][vertex][k].as_f64().unwrap();
                assert!(
                    (influence.weight - expected).abs() < 1e-14,
                    "{} {expected}",
                    influence.weight
                );
            }
            points += 1;
        }
    }
    assert_eq!(points, 80);
}

const UPRIGHT: [[f64; 3]; 2] = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
const ABOVE: [[f64; 3]; 2] = [[0.0, 1.0, 0.0], [0.0, 2.0, 0.0]];
const ASIDE: [[f64; 3]; 2] = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]];

#[test]
fn a_point_on_bones_follows_these_alone() {
    let bones = [ASIDE, UPRIGHT, ABOVE];
    let weights = distance_weights([[0.0, 0.5, 0.0], [0.0, 1.0, 0.0]], &bones, 3, 2.0).unwrap();
    let row = |vertex| {
        weights
            .influences(vertex)
            .iter()
            .map(|i| (i.joint, i.weight))
            .collect::<Vec<_>>()
    };
    assert_eq!(row(0), [(1, 1.0)]);
    assert_eq!(row(1), [(1, 0.5), (2, 0.5)]);
}

#[test]
fn a_bone_without_length_is_a_point() {
    let distance = distance_to_bone([3.0, 4.0, 0.0], [[0.0; 3]; 2]);
    assert_eq!(distance, 5.0);
}

#[test]
fn a_tiny_distance_or_a_steep_fall_does_not_overflow() {
    let weights = distance_weights([[1e-200, 0.5, 0.0]], &[UPRIGHT, ASIDE], 2, 300.0).unwrap();
    assert_eq!(weights.influences(0)[0].weight, 1.0);
}

#[test]
fn bad_input_is_named() {
    let point = [[0.0; 3]];
    assert_eq!(
        distance_weights(point, &[], 1, 1.0),
        Err(SkinError::NoBones)
    );
    assert_eq!(
        distance_weights(point, &[UPRIGHT], 0, 1.0),
        Err(SkinError::NoInfluences)
    );
    for exponent in [0.0, -1.0, f64::INFINITY] {
        let error = distance_weights(point, &[UPRIGHT], 1, exponent).unwrap_err();
        assert_eq!(error, SkinError::BadExponent { exponent });
    }
    assert!(matches!(
        distance_weights(point, &[UPRIGHT], 1, f64::NAN),
        Err(SkinError::BadExponent { .. })
    ));
    let error = distance_weights(point, &[UPRIGHT, [[f64::INFINITY; 3]; 2]], 1, 1.0).unwrap_err();
    assert!(error.to_string().starts_with("bone 1 "), "{error}");
    for far in [f64::NAN, f64::MAX] {
        let error = distance_weights([[0.0; 3], [far; 3]], &[UPRIGHT], 1, 1.0).unwrap_err();
        assert!(error.to_string().starts_with("point 1 "), "{error}");
    }
}

fn coordinates() -> impl Strategy<Value = [f64; 3]> {
    uniform3(-10.0..10.0)
}

proptest! {
    #[test]
    fn ratios_of_weights_are_powers_of_ratios_of_distances(
        point in coordinates(),
        bones in vec((coordinates(), coordinates()), 2..8),
        influences in 1usize..10,
        exponent in 0.5..4.0,
    ) {
        let bones: Vec<_> = bones.into_iter().map(|(head, tail)| [head, tail]).collect();
        let weights = distance_weights([point], &bones, influences, exponent).unwrap();
        let row = weights.influences(0);
        prop_assert_eq!(row.len(), influences.min(bones.len()));
        let sum: f64 = row.iter().map(|influence| influence.weight).sum();
        prop_assert!((sum - 1.0).abs() < 1e-14);
        let distance = |bone: u32| distance_to_bone(point, bones[bone as usize]);
        for pair in row.windows(2) {
            let ratio = (distance(pair[1].joint) / distance(pair[0].joint)).powf(exponent);
            prop_assert!((pair[0].weight / pair[1].weight / ratio - 1.0).abs() < 1e-12);
        }
        let furthest = row.iter().map(|influence| distance(influence.joint)).fold(0.0, f64::max);
        for other in 0..bones.len() as u32 {
            let left_out = row.iter().all(|influence| influence.joint != other);
            prop_assert!(!left_out || distance(other) >= furthest);
        }
    }

    #[test]
    fn no_point_of_a_bone_is_nearer_than_its_distance(
        point in coordinates(),
        head in coordinates(),
        tail in coordinates(),
    ) {
        let distance = distance_to_bone(point, [head, tail]);
        let at = |t: f64| {
            let square = |k: usize| (head[k] + t * (tail[k] - head[k]) - point[k]).powi(2);
            (square(0) + square(1) + square(2)).sqrt()
        };
        let nearest = (0..=1000).map(|i| at(f64::from(i) / 1000.0)).fold(f64::INFINITY, f64::min);
        // Between two samples the distance falls by at most half the step's length.
        let step = (0..3).map(|k| (tail[k] - head[k]).powi(2)).sum::<f64>().sqrt() / 1000.0;
        prop_assert!(distance <= nearest + 1e-12 && distance >= nearest - 0.5 * step - 1e-12);
    }
}

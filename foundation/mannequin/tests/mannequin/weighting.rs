//! The skin weights.

use std::collections::HashMap;

use crate::closed::pieces;
use crate::{HUMAN, joint, positions};

fn weight(vertex: usize, joint: usize) -> f64 {
    let influences = HUMAN.weights.influences(vertex);
    influences
        .iter()
        .find(|i| i.joint as usize == joint)
        .map_or(0.0, |i| i.weight)
}

#[test]
fn weights_sum_to_one() {
    assert_eq!(HUMAN.weights.vertex_count(), HUMAN.mesh.vertex_count());
    assert_eq!(HUMAN.weights.joint_count(), HUMAN.skeleton.len());
    for row in HUMAN.weights.iter() {
        assert!((1..=4).contains(&row.len()));
        assert!(row.iter().all(|i| i.weight > 0.0));
        let sum: f64 = row.iter().map(|i| i.weight).sum();
        assert!((sum - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_vertex_follows_joints_that_belong_together() {
    let parent = |joint: u32| {
        HUMAN.skeleton.joints()[joint as usize]
            .parent
            .map(|p| p as u32)
    };
    for (vertex, row) in HUMAN.weights.iter().enumerate() {
        let joints: Vec<u32> = row.iter().map(|i| i.joint).collect();
        // In a tree, what is connected has one member whose parent is outside; brothers may stand
        // in for their parent.
        let mut tops: Vec<Option<u32>> = joints
            .iter()
            .filter(|&&j| parent(j).is_none_or(|p| !joints.contains(&p)))
            .map(|&j| parent(j))
            .collect();
        tops.dedup();
        assert_eq!(
            tops.len(),
            1,
            "vertex {vertex} at {:?} follows {row:?}",
            positions()[vertex]
        );
    }
}

#[test]
fn the_skin_of_each_joint_is_in_one_piece() {
    let triangles = HUMAN.mesh.triangles();
    for (index, joint) in HUMAN.skeleton.joints().iter().enumerate() {
        let found = pieces(HUMAN.mesh.vertex_count(), &triangles, |vertex| {
            weight(vertex, index) > 0.0
        });
        assert_eq!(found, 1, "{}", joint.name);
    }
}

#[test]
fn no_limb_follows_another() {
    let limbs: Vec<(usize, f64)> = [
        "UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot", "Toe",
    ]
    .iter()
    .flat_map(|name| {
        [
            (joint(&format!("Left{name}")), 1.0),
            (joint(&format!("Right{name}")), -1.0),
        ]
    })
    .collect();
    for (vertex, p) in positions().iter().enumerate() {
        for &(limb, side) in &limbs {
            // The thighs meet at the crotch; nothing else may cross the middle.
            let across = p[0] * side < -0.04 || (p[0] * side < -0.005 && p[1] < 0.70);
            assert!(
                !across || weight(vertex, limb) == 0.0,
                "{p:?} follows joint {limb}"
            );
            let near = p[0] * side < -0.015 && p[1] < 0.78;
            assert!(
                !near || weight(vertex, limb) < 0.02,
                "{p:?} follows joint {limb}"
            );
        }
    }
}

#[test]
fn the_middle_of_each_bone_follows_it() {
    let ends = |name: &str, t: f64| {
        let bone = HUMAN.skeleton.joint(name).unwrap();
        [0, 1, 2].map(|k| bone.head[k] + t * (bone.tail[k] - bone.head[k]))
    };
    let nearest = |place: [f64; 3]| {
        let distance = |p: &[f64; 3]| (0..3).map(|k| (p[k] - place[k]).powi(2)).sum::<f64>();
        let positions = positions();
        (0..positions.len())
            .min_by(|&a, &b| distance(&positions[a]).total_cmp(&distance(&positions[b])))
            .unwrap()
    };
    for name in [
        "LeftUpperArm",
        "LeftLowerArm",
        "LeftUpperLeg",
        "RightLowerLeg",
        "Head",
        "RightHand",
    ] {
        let vertex = nearest(ends(name, 0.5));
        assert!(
            weight(vertex, joint(name)) > 0.8,
            "{name} {:?}",
            HUMAN.weights.influences(vertex)
        );
    }
    for (name, place) in [
        ("Head", [0.0, 1.75, 0.0]),
        ("Head", [0.0, 1.54, 0.11]),
        ("LeftFoot", [0.095, 0.02, -0.085]),
        ("LeftToe", [0.13, 0.01, 0.17]),
        ("LeftHand", ends("LeftHand", 1.0)),
        ("Chest", [0.0, 1.32, 0.12]),
        ("Hips", [0.0, 0.95, 0.1]),
        ("Spine", [0.13, 1.12, 0.0]),
    ] {
        let row = HUMAN.weights.influences(nearest(place));
        let strongest = row
            .iter()
            .max_by(|a, b| a.weight.total_cmp(&b.weight))
            .unwrap();
        assert_eq!(
            strongest.joint as usize,
            joint(name),
            "{name} at {place:?}: {row:?}"
        );
    }
}

#[test]
fn weights_are_mirror_images() {
    let key = |p: [f64; 3]| p.map(|x| (x + 0.0).to_bits());
    let positions = positions();
    let number: HashMap<_, _> = positions
        .iter()
        .enumerate()
        .map(|(vertex, p)| (key(*p), vertex))
        .collect();
    let other = |joint: usize| {
        let name = &HUMAN.skeleton.joints()[joint].name;
        let swapped = match name.strip_prefix("Left") {
            Some(rest) => format!("Right{rest}"),
            None => name.replace("Right", "Left"),
        };
        crate::joint(&swapped)
    };
    for (vertex, p) in positions.iter().enumerate() {
        let image = number[&key([-p[0], p[1], p[2]])];
        for influence in HUMAN.weights.influences(vertex) {
            let mirrored = weight(image, other(influence.joint as usize));
            assert!(
                (influence.weight - mirrored).abs() < 1e-12,
                "{p:?} {:?} {:?}",
                HUMAN.weights.influences(vertex),
                HUMAN.weights.influences(image)
            );
        }
    }
}

#[test]
fn weights_change_gently_over_the_skin() {
    let positions = positions();
    for t in HUMAN.mesh.triangles() {
        for k in 0..3 {
            let (a, b) = (t[k] as usize, t[(k + 1) % 3] as usize);
            let length = (0..3)
                .map(|k| (positions[a][k] - positions[b][k]).powi(2))
                .sum::<f64>()
                .sqrt();
            for joint in 0..HUMAN.skeleton.len() {
                let change = (weight(a, joint) - weight(b, joint)).abs();
                assert!(
                    change < 45.0 * length + 0.02,
                    "{change} over {length} m at {:?}",
                    positions[a]
                );
            }
        }
    }
}

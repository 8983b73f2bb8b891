//! The mesh and the skeleton at rest.

use ga_mannequin::{Human, STATURE};

use ga_runtime::vga3::Vector;

use crate::closed::{
    assert_one_ring_each, assert_without_boundary, euler_characteristic, least_angles, pieces,
    volume, winding_number,
};
use crate::{HUMAN, joint, positions};

#[test]
fn the_skin_is_one_closed_surface_like_a_sphere() {
    let (vertices, triangles) = (HUMAN.mesh.vertex_count(), HUMAN.mesh.triangles());
    assert_eq!(
        triangles.len(),
        HUMAN.mesh.faces().len(),
        "the faces are triangles"
    );
    assert_without_boundary(&triangles);
    assert_one_ring_each(vertices, &triangles);
    assert_eq!(pieces(vertices, &triangles, |_| true), 1);
    assert_eq!(euler_characteristic(vertices, &triangles), 2);
    assert!((8_000..20_000).contains(&vertices), "{vertices} vertices");
}

#[test]
fn it_faces_outwards_and_holds_what_a_person_does() {
    // 60 to 80 kg at the density of water.
    let volume = volume(&positions(), &HUMAN.mesh.triangles());
    assert!((0.060..0.080).contains(&volume), "{volume} m³");
}

#[test]
fn triangles_are_well_shaped() {
    let angles = least_angles(&positions(), &HUMAN.mesh.triangles());
    assert!(angles[0] > 15.0, "{}", angles[0]);
    assert!(
        angles[angles.len() / 100] > 40.0,
        "{}",
        angles[angles.len() / 100]
    );
    assert!(
        angles[angles.len() / 2] > 52.0,
        "{}",
        angles[angles.len() / 2]
    );
}

#[test]
fn it_is_as_tall_as_stated_and_stands_on_the_ground() {
    let [low, high] = HUMAN.mesh.bounds().unwrap();
    assert!(
        low[1].abs() < 1e-3 && (high[1] - STATURE).abs() < 1e-3,
        "{low:?} {high:?}"
    );
    assert_eq!(STATURE, 1.75);
}

#[test]
fn left_and_right_are_mirror_images() {
    let mut left: Vec<[u64; 3]> = positions()
        .iter()
        .map(|p| p.map(|x| (x + 0.0).to_bits()))
        .collect();
    let mut right: Vec<[u64; 3]> = positions()
        .iter()
        .map(|p| [-p[0], p[1], p[2]].map(|x| (x + 0.0).to_bits()))
        .collect();
    left.sort_unstable();
    right.sort_unstable();
    assert!(left == right);
    for right in HUMAN
        .skeleton
        .joints()
        .iter()
        .filter(|joint| joint.name.starts_with("Right"))
    {
        let left = HUMAN
            .skeleton
            .joint(&right.name.replace("Right", "Left"))
            .unwrap();
        for (l, r) in [(left.head, right.head), (left.tail, right.tail)] {
            assert_eq!([-l[0], l[1], l[2]], r, "{}", right.name);
        }
        assert!(left.head[0] > 0.0);
    }
}

/// The breadth from side to side of the part of the skin near a height, no further than `reach`
/// from the middle.
fn breadth(height: f64, reach: f64) -> f64 {
    let level = |p: &&[f64; 3]| (p[1] - height).abs() < 0.01 && p[0].abs() < reach;
    2.0 * positions()
        .iter()
        .filter(level)
        .map(|p| p[0])
        .fold(0.0, f64::max)
}

#[test]
fn proportions_are_those_of_an_adult() {
    let length = |name: &str| {
        let bone = &HUMAN.skeleton.joints()[joint(name)];
        Vector::from(bone.tail).distance(bone.head.into()) / STATURE
    };
    // Segment lengths as fractions of stature: Drillis and Contini 1966, as tabulated by Winter.
    for (name, expected) in [
        ("LeftUpperArm", 0.186),
        ("LeftLowerArm", 0.146),
        ("LeftUpperLeg", 0.245),
        ("LeftLowerLeg", 0.246),
    ] {
        let found = length(name);
        assert!(
            (found / expected - 1.0).abs() < 0.1,
            "{name}: {found} of {expected}"
        );
    }
    let height = |name: &str| HUMAN.skeleton.joints()[joint(name)].head[1] / STATURE;
    for (name, expected) in [
        ("LeftFoot", 0.039),
        ("LeftLowerLeg", 0.285),
        ("LeftUpperLeg", 0.530),
        ("LeftUpperArm", 0.818),
    ] {
        let found = height(name);
        assert!(
            (found - expected).abs() < 0.02,
            "{name} at {found} of {expected}"
        );
    }
    // The head with the chin is a good eighth of the whole, the foot a good seventh.
    let chin = positions()
        .iter()
        .filter(|p| p[1] > 1.45 && p[2] > 0.09)
        .map(|p| p[1])
        .fold(2.0, f64::min);
    let head = (STATURE - chin) / STATURE;
    assert!((1.0 / 8.0..1.0 / 7.0).contains(&head), "head {head}");
    let foot: Vec<f64> = positions()
        .iter()
        .filter(|p| p[1] < 0.05)
        .map(|p| p[2])
        .collect();
    let foot = foot.iter().copied().fold(-1.0, f64::max) - foot.iter().copied().fold(1.0, f64::min);
    assert!(
        (foot / STATURE - 0.152).abs() < 0.01,
        "foot {}",
        foot / STATURE
    );
    // Shoulders are broader than hips, hips than the waist, the waist than the neck.
    let widths = [(1.40, 0.3), (0.90, 0.3), (1.10, 0.18), (1.52, 0.3)]
        .map(|(height, reach)| breadth(height, reach));
    assert!(
        widths.windows(2).all(|pair| pair[0] > 1.1 * pair[1]),
        "{widths:?}"
    );
}

#[test]
fn joints_lie_under_the_skin() {
    let (positions, triangles) = (positions(), HUMAN.mesh.triangles());
    for joint in HUMAN.skeleton.joints() {
        let inside = winding_number(&positions, &triangles, joint.head);
        assert!((inside - 1.0).abs() < 1e-9, "{} {inside}", joint.name);
    }
    let outside = winding_number(&positions, &triangles, [0.3, 1.0, 0.3]);
    assert!(outside.abs() < 1e-9);
}

#[test]
fn it_looks_ahead_with_its_feet() {
    let bone = |name: &str| &HUMAN.skeleton.joints()[joint(name)];
    assert!(bone("LeftFoot").tail[2] > bone("LeftFoot").head[2] + 0.1);
    // What sticks out furthest in front on the head, on the plane of symmetry, is the nose.
    let nose = positions()
        .into_iter()
        .filter(|p| p[1] > 1.5)
        .max_by(|a, b| a[2].total_cmp(&b[2]))
        .unwrap();
    assert!(
        nose[0].abs() < 0.005 && (1.58..1.63).contains(&nose[1]),
        "{nose:?}"
    );
}

#[test]
fn it_is_the_same_every_time() {
    assert!(*HUMAN == Human::new());
}

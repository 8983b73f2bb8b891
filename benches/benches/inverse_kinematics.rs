//! Inverse kinematics beside the same written by hand with glam in `f64`.
//!
//! Two bones: the middle joint and the end of a limb, for targets of which some are out of reach,
//! and the rotors of both bones. FABRIK: one iteration over a chain of nine bones.

use criterion::{Criterion, criterion_group, criterion_main};
use ga_anim::inverse_kinematics::{Fabrik, TwoBone};
use ga_runtime::cga3::Point;
use glam::{DQuat, DVec3};
use nullcone_benches::comparison::{self, Comparison};
use nullcone_benches::inputs::list;

const UPPER: f64 = 0.8;
const LOWER: f64 = 0.7;
const JOINTS: usize = 10;
const BONE: f64 = 0.25;

/// Root, target and pole of a limb.
type Limb = [[f64; 3]; 3];

fn two_bones(criterion: &mut Criterion) {
    let limbs: Vec<Limb> = list(1, |numbers| [0; 3].map(|_| numbers.numbers()));
    let ours: Vec<[Point<f64>; 3]> = limbs.iter().map(|limb| limb.map(Point::from)).collect();
    let theirs: Vec<[DVec3; 3]> = limbs.iter().map(|limb| limb.map(DVec3::from)).collect();
    let limb = TwoBone::new(UPPER, LOWER).expect("lengths");

    let mut group = Comparison::new(criterion, "inverse_kinematics/two bones");
    group.map("nullcone", &ours, |&[root, target, pole]| {
        limb.solve(root, target, pole)
            .map(|bent| [bent.middle, bent.end])
    });
    group.map("glam", &theirs, |&[root, target, pole]| {
        by_cosines(root, target, pole)
    });
    drop(group);

    // Each limb on its own: a loop over many limbs is vectorised with glam.
    let mut group = Comparison::new(
        criterion,
        "inverse_kinematics/two bones, one limb at a time",
    );
    let poles: Vec<Point<f64>> = ours.iter().map(|limb| limb[2]).collect();
    group.one_by_one("nullcone", &ours, &poles, |&[root, target, _], &pole| {
        limb.solve(root, target, pole)
            .map(|bent| [bent.middle, bent.end])
    });
    let poles: Vec<DVec3> = theirs.iter().map(|limb| limb[2]).collect();
    group.one_by_one("glam", &theirs, &poles, |&[root, target, _], &pole| {
        by_cosines(root, target, pole)
    });
    drop(group);

    let from = [
        [0.0, 0.0, 0.0],
        [0.0, -UPPER, 0.1],
        [0.0, -UPPER - LOWER, 0.0],
    ];
    let mut group = Comparison::new(criterion, "inverse_kinematics/two bones with rotors");
    let at_rest = from.map(Point::from);
    group.map("nullcone", &ours, |&[root, target, pole]| {
        limb.solve(root, target, pole)
            .map(|bent| bent.rotors_from(at_rest))
    });
    let at_rest = from.map(DVec3::from);
    group.map("glam", &theirs, |&[root, target, pole]| {
        let [middle, end] = by_cosines(root, target, pole);
        rotations(at_rest, [root, middle, end])
    });
}

/// By the law of cosines, and the part of the pole's direction across the limb.
fn by_cosines(root: DVec3, target: DVec3, pole: DVec3) -> [DVec3; 2] {
    let way = target - root;
    let distance = way.length();
    let along = way / distance;
    let reach = distance.clamp((UPPER - LOWER).abs(), UPPER + LOWER);
    let foot = (reach * reach + UPPER * UPPER - LOWER * LOWER) / (2.0 * reach);
    let height = (UPPER * UPPER - foot * foot).max(0.0).sqrt();
    let aside = (pole - root).reject_from_normalized(along).normalize();
    [root + along * foot + aside * height, root + along * reach]
}

/// The rotations of both bones that keep the plane of the limb.
fn rotations(from: [DVec3; 3], to: [DVec3; 3]) -> [DQuat; 2] {
    let normal = |places: [DVec3; 3]| {
        (places[1] - places[0])
            .cross(places[2] - places[1])
            .normalize()
    };
    let normals = [normal(from), normal(to)];
    [0, 1].map(|k| {
        let [a, b] = [from, to].map(|places| (places[k + 1] - places[k]).normalize());
        let first = DQuat::from_rotation_arc(a, b);
        let side = first * normals[0];
        let angle = side.cross(normals[1]).dot(b).atan2(side.dot(normals[1]));
        DQuat::from_axis_angle(b, angle) * first
    })
}

fn fabrik(criterion: &mut Criterion) {
    let chains: Vec<([[f64; 3]; JOINTS], [f64; 3])> = list(2, |numbers| {
        ([0; JOINTS].map(|_| numbers.numbers()), numbers.numbers())
    });
    let ours: Vec<_> = chains
        .iter()
        .map(|(joints, target)| (joints.map(Point::from), Point::from(*target)))
        .collect();
    let theirs: Vec<_> = chains
        .iter()
        .map(|(joints, target)| (joints.map(DVec3::from), DVec3::from(*target)))
        .collect();
    let chain = Fabrik::new(vec![BONE; JOINTS - 1]).expect("lengths");
    let lengths = [BONE; JOINTS - 1];
    let mut group = Comparison::new(criterion, "inverse_kinematics/an iteration of FABRIK");
    group.map("nullcone", &ours, |&(mut joints, target)| {
        chain.iterate(&mut joints, target);
        joints
    });
    group.map("glam", &theirs, |&(mut joints, target)| {
        iterate(&mut joints, &lengths, target);
        joints
    });
}

fn iterate(joints: &mut [DVec3], lengths: &[f64], target: DVec3) {
    let root = joints[0];
    let mut next = target;
    joints[lengths.len()] = target;
    for (joint, length) in joints.iter_mut().zip(lengths).rev() {
        *joint = next + (*joint - next).normalize() * *length;
        next = *joint;
    }
    joints[0] = root;
    let mut before = root;
    for (joint, length) in joints[1..].iter_mut().zip(lengths) {
        *joint = before + (*joint - before).normalize() * *length;
        before = *joint;
    }
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = two_bones, fabrik
}
criterion_main!(benches);

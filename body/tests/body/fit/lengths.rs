//! Lengths of bones.

use ga_anim::pose::Pose;
use ga_anim::skeleton::{Joint, Skeleton};
use ga_body::{BodyFit, BodyModel, Lengths, fit_lengths};
use ga_runtime::cga3::{Point, Rotor};

use super::{biped, heads, moved_biped, rig, seen, turned};

#[test]
fn bones_with_wrong_lengths_leave_residuals() {
    // The check that lengths are used: a skeleton that is too large by a tenth does not fit.
    let skeleton = biped();
    let truth = heads(&skeleton, &moved_biped(&skeleton));
    let cameras = rig(std::slice::from_ref(&truth), 2);
    let observed = seen(&cameras, &truth, 0.5, 0.0, 4);
    let rms = |factor: f64| {
        let model = BodyModel::of_distinct_joints(skeleton.scaled(factor).unwrap()).unwrap();
        BodyFit::new(&model, &cameras)
            .unwrap()
            .frame(&observed)
            .unwrap()
            .root_mean_square_px
    };
    assert!(rms(1.1) > 3.0 * rms(1.0));
    assert!(rms(1.0) < 1.0);
}

/// Poses of a skeleton with other bends of hips, knees and neck in each.
fn poses(skeleton: &Skeleton) -> Vec<Pose> {
    let pose = |k: usize| {
        let phase = k as f64;
        let mut rotors = vec![Rotor::default(); skeleton.len()];
        rotors[0] = turned([0.3, 1.0, 0.0], 0.4 * phase.sin());
        for (joint, lag) in [(1, 0.5), (3, 1.0), (4, 2.0), (6, 3.0), (7, 4.0)] {
            rotors[joint] = turned([1.0, 0.2, 0.5], 0.8 * (phase + lag).sin());
        }
        Pose::from_rotors(skeleton, Default::default(), &rotors).unwrap()
    };
    (0..12).map(pose).collect()
}

#[test]
fn a_larger_person_is_found_to_be_larger() {
    let small = biped();
    let large = small.scaled(1.17).unwrap();
    let truth: Vec<Vec<Point<f64>>> = poses(&large).iter().map(|p| heads(&large, p)).collect();
    let cameras = rig(&truth, 2);
    let frames = truth.iter().enumerate();
    let observed: Vec<_> = frames
        .map(|(k, points)| seen(&cameras, points, 1.0, 0.0, k as u64))
        .collect();
    let model = BodyModel::of_distinct_joints(small).unwrap();
    let found = fit_lengths(&model, &cameras, &observed, Lengths::OneFactor).unwrap();
    for factor in &found.factors {
        assert!((factor - 1.17).abs() < 0.01, "{factor}");
    }
    let height = |skeleton: &Skeleton| skeleton.joints()[2].head[1] - skeleton.joints()[5].head[1];
    let grown = height(found.model.skeleton()) / height(model.skeleton());
    assert!((grown - found.factors[0]).abs() < 1e-12);
}

#[test]
fn each_bone_gets_its_own_length() {
    let usual = biped();
    // Longer thighs and a shorter neck.
    let longer = |joint: &Joint| {
        let mut joint = joint.clone();
        if joint.name.contains("knee") || joint.name.contains("ankle") {
            joint.head[1] -= 0.06;
        }
        if joint.name == "head" {
            joint.head[1] -= 0.03;
        }
        joint
    };
    let other = Skeleton::new(usual.joints().iter().map(longer).collect()).unwrap();
    let truth: Vec<Vec<Point<f64>>> = poses(&other).iter().map(|p| heads(&other, p)).collect();
    let cameras = rig(&truth, 4);
    let frames = truth.iter().enumerate();
    let observed: Vec<_> = frames
        .map(|(k, points)| seen(&cameras, points, 0.5, 0.0, k as u64))
        .collect();
    let model = BodyModel::of_distinct_joints(usual).unwrap();
    let found = fit_lengths(&model, &cameras, &observed, Lengths::EachBone).unwrap();
    let length = |skeleton: &Skeleton, joint: usize| {
        let joints = skeleton.joints();
        let above = Point::from(joints[joints[joint].parent.unwrap()].head);
        above.distance(joints[joint].head.into())
    };
    for joint in 1..other.len() {
        let (truth, found) = (length(&other, joint), length(found.model.skeleton(), joint));
        assert!(
            (truth - found).abs() < 0.008,
            "joint {joint}: {truth} m, found {found} m"
        );
    }
}

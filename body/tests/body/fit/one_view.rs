//! Clips that one camera sees.

use ga_anim::pose::Pose;
use ga_body::pose_error::mean_per_joint_position_error;
use ga_body::{BodyFit, BodyModel, BodyPoint, FittedPose, Observation};
use ga_camera::Camera;
use ga_mannequin::{skeleton, walk};
use ga_runtime::cga3::{Point, Rotor, Translator};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::{biped, heads, intrinsics, rig, seen, turned};

/// The frames of the walk in a second, and their number.
const RATE: f64 = 15.0;
const FRAMES: usize = 12;
/// The joints of the mannequin that COCO's annotations name.
const SEEN: [&str; 12] = [
    "LeftUpperArm",
    "RightUpperArm",
    "LeftLowerArm",
    "RightLowerArm",
    "LeftHand",
    "RightHand",
    "LeftUpperLeg",
    "RightUpperLeg",
    "LeftLowerLeg",
    "RightLowerLeg",
    "LeftFoot",
    "RightFoot",
];

/// The mean errors of a fit of the clip and of fits of its frames, in metres.
fn errors(
    model: &BodyModel,
    cameras: &[Camera],
    truth: &[Vec<Point<f64>>],
    observed: &[Observation],
    rate: f64,
) -> [f64; 2] {
    let fit = BodyFit::new(model, cameras).unwrap();
    let clip = fit.clip(observed, rate).unwrap();
    let frames: Vec<FittedPose> = observed.iter().map(|o| fit.frame(o).unwrap()).collect();
    [clip, frames].map(|fits| {
        let pairs = truth.iter().zip(&fits);
        let sum: f64 = pairs
            .map(|(truth, fit)| mean_per_joint_position_error(truth, &fit.points).unwrap())
            .sum();
        sum / truth.len() as f64
    })
}

/// Legs that swing, a body that turns and a trunk that leans, with amplitudes of their own for each
/// seed.
fn swinging(seed: u64, frames: usize, rate: f64) -> Vec<Vec<Point<f64>>> {
    let skeleton = biped();
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut number = |from: f64, to: f64| {
        from + (to - from) * f64::from(random.next_u32()) / f64::from(u32::MAX)
    };
    let (facing, turning) = (number(-0.8, 0.8), number(-0.3, 0.3));
    let (swing, bend) = (number(0.4, 0.9), number(0.3, 0.8));
    let (lean, speed) = (number(-0.3, 0.3), number(4.0, 8.0));
    let pose = |frame: usize| {
        let time = frame as f64 / rate;
        let (sin, cos) = (speed * time).sin_cos();
        let mut rotors = vec![Rotor::default(); skeleton.len()];
        rotors[0] = turned([0.0, 1.0, 0.0], facing + turning * time);
        rotors[1] = turned([1.0, 0.2, 0.0], lean * cos);
        rotors[3] = turned([1.0, 0.0, 0.0], swing * sin);
        rotors[4] = turned([1.0, 0.0, 0.0], bend * (1.0 + cos));
        rotors[6] = turned([1.0, 0.0, 0.0], -swing * sin);
        rotors[7] = turned([1.0, 0.0, 0.0], bend * (1.0 - cos));
        let root = Translator::from_displacement([0.3 * time, 0.0, 0.5 * time]);
        heads(
            &skeleton,
            &Pose::from_rotors(&skeleton, root.into(), &rotors).unwrap(),
        )
    };
    (0..frames).map(pose).collect()
}

#[test]
fn a_clip_of_one_view_is_no_worse_than_its_frames() {
    let model = BodyModel::of_distinct_joints(biped()).unwrap();
    for (rate, noise) in [(30.0, 1.0), (30.0, 2.0), (60.0, 2.0)] {
        let mut sums = [0.0; 2];
        for seed in 0..8 {
            let truth = swinging(seed, 40, rate);
            let cameras = rig(&truth, 1);
            let frames = truth.iter().zip((1000 * seed)..);
            let observed = frames.map(|(points, seed)| seen(&cameras, points, noise, 0.0, seed));
            let observed: Vec<_> = observed.collect();
            let found = errors(&model, &cameras, &truth, &observed, rate);
            sums = [0, 1].map(|k| sums[k] + found[k]);
        }
        assert!(
            sums[0] <= sums[1],
            "{rate} frames per second, {noise} px: {sums:?}"
        );
    }
}

/// Errors of the mannequin's walk towards a camera, seen without noise.
fn of_walk() -> [f64; 2] {
    let (skeleton, walk) = (skeleton(), walk(1));
    let joints = SEEN.map(|name| skeleton.index(name).unwrap());
    let place = |frame: usize| -> Vec<Point<f64>> {
        let bones = walk.sample(frame as f64 / RATE).bones(&skeleton).unwrap();
        joints.iter().map(|&joint| bones[joint][0].into()).collect()
    };
    let truth: Vec<Vec<Point<f64>>> = (0..FRAMES).map(place).collect();
    let points = SEEN.iter().zip(joints).map(|(name, joint)| BodyPoint {
        name: (*name).to_owned(),
        at_rest: skeleton.joints()[joint].head,
        joints: vec![(joint, 1.0)],
    });
    let model = BodyModel::new(skeleton.clone(), points.collect()).unwrap();
    let (eye, target) = ([0.3, 1.4, 4.5], [0.0, 0.9, 0.0]);
    let camera = Camera::look_at(intrinsics(), eye.into(), target.into(), [0.0, 1.0, 0.0]).unwrap();
    let observed = truth.iter().map(|points| {
        let mut observed = seen(&[camera], points, 0.0, 0.0, 0);
        for pixel in observed.views[0].iter_mut().flatten() {
            pixel.deviation = 0.05;
        }
        observed
    });
    let observed: Vec<_> = observed.collect();
    errors(&model, &[camera], &truth, &observed, RATE)
}

#[test]
fn a_walk_that_one_camera_sees_is_no_worse_than_its_frames() {
    let [clip, frames] = of_walk();
    assert!(clip <= frames, "{clip} m, frames {frames} m");
}

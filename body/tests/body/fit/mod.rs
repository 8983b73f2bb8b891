//! Poses of bodies against motion capture seen by synthetic cameras, and against points moved by
//! hand.

mod lengths;
mod made;
mod one_view;
mod recorded;
mod refused;

use ga_anim::pose::Pose;
use ga_anim::skeleton::{Joint, Skeleton};
use ga_body::{JointPixel, Observation};
use ga_camera::observation::observe;
use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::{Point, Rotor, Translator};
use ga_runtime::vga3::Vector;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

fn intrinsics() -> Intrinsics {
    Intrinsics::new([1000.0, 1000.0], [960.0, 540.0]).unwrap()
}

/// Cameras side by side, a metre apart in all, four metres from the mean of points.
fn rig(points: &[Vec<Point<f64>>], views: usize) -> Vec<Camera> {
    let all = points.iter().flatten();
    let sum = all.fold(Vector::default(), |sum, point| sum + Vector::from(*point));
    let middle = sum / points.iter().map(Vec::len).sum::<usize>() as f64;
    let camera = |view: usize| {
        let x = if views == 1 {
            0.0
        } else {
            view as f64 / (views - 1) as f64 - 0.5
        };
        let eye = middle + Vector::new(x, 0.0, 4.0);
        let target = middle + Vector::new(x, 0.0, 0.0);
        Camera::look_at(intrinsics(), eye.into(), target.into(), [0.0, 1.0, 0.0]).unwrap()
    };
    (0..views).map(camera).collect()
}

/// Pixels with noise, without a part of them.
fn seen(
    cameras: &[Camera],
    points: &[Point<f64>],
    noise: f64,
    missing: f64,
    seed: u64,
) -> Observation {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let views = cameras.iter().enumerate().map(|(view, camera)| {
        let pixels = observe(camera, points, noise, seed * 16 + view as u64).unwrap();
        let kept = pixels.into_iter().map(|position| {
            let is_kept = f64::from(random.next_u32()) / f64::from(u32::MAX) >= missing;
            is_kept.then_some(JointPixel {
                position,
                deviation: noise.max(1e-3),
            })
        });
        kept.collect()
    });
    Observation {
        views: views.collect(),
    }
}

/// A human of few bones: hips with two legs and a spine with a head, all in one plane at rest.
fn biped() -> Skeleton {
    let joint = |name: &str, parent, head: [f64; 3], tail: [f64; 3]| Joint {
        name: name.into(),
        parent,
        head,
        tail,
    };
    Skeleton::new(vec![
        joint("hips", None, [0.0, 1.0, 0.0], [0.0, 1.5, 0.0]),
        joint("neck", Some(0), [0.0, 1.5, 0.0], [0.0, 1.75, 0.0]),
        joint("head", Some(1), [0.0, 1.75, 0.0], [0.0, 1.75, 0.0]),
        joint("left hip", Some(0), [0.15, 0.95, 0.0], [0.15, 0.5, 0.0]),
        joint("left knee", Some(3), [0.15, 0.5, 0.0], [0.15, 0.1, 0.0]),
        joint("left ankle", Some(4), [0.15, 0.1, 0.0], [0.15, 0.1, 0.15]),
        joint("right hip", Some(0), [-0.15, 0.95, 0.0], [-0.15, 0.5, 0.0]),
        joint("right knee", Some(6), [-0.15, 0.5, 0.0], [-0.15, 0.1, 0.0]),
        joint(
            "right ankle",
            Some(7),
            [-0.15, 0.1, 0.0],
            [-0.15, 0.1, 0.15],
        ),
    ])
    .unwrap()
}

fn turned(axis: [f64; 3], angle: f64) -> Rotor<f64> {
    Rotor::from_axis_angle(axis, angle).unwrap()
}

/// The left knee bent, the right leg raised to the side, the body rotated and moved.
fn moved_biped(skeleton: &Skeleton) -> Pose {
    let mut rotors = vec![Rotor::default(); skeleton.len()];
    rotors[0] = turned([0.2, 1.0, 0.1], 0.7);
    rotors[1] = turned([0.0, 0.3, 1.0], 0.3);
    rotors[3] = turned([1.0, 0.0, 0.0], -0.9);
    rotors[4] = turned([1.0, 0.0, 0.0], 1.2);
    rotors[6] = turned([0.0, 0.0, 1.0], -0.6);
    let root = Translator::from_displacement([0.2, -0.1, 0.4]);
    Pose::from_rotors(skeleton, root.into(), &rotors).unwrap()
}

fn heads(skeleton: &Skeleton, pose: &Pose) -> Vec<Point<f64>> {
    let bones = pose.bones(skeleton).unwrap();
    bones.into_iter().map(|[head, _]| head.into()).collect()
}

fn greatest_error(truth: &[Point<f64>], found: &[Point<f64>]) -> f64 {
    let distances = truth.iter().zip(found).map(|(a, b)| a.distance(*b));
    distances.fold(0.0, f64::max)
}

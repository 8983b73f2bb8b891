//! The walk, as it is between its key poses too.

use std::f64::consts::FRAC_PI_2;
use std::sync::LazyLock;

use ga_anim::clip::Clip;
use ga_anim::skin::{self, Method};
use ga_mannequin::{KEY_NAMES, KEY_TIME, KEYS_PER_STRIDE, walk};
use ga_runtime::vga3::Vector;

use crate::closed::volume;
use crate::{HUMAN, joint, positions};

static WALK: LazyLock<Clip> = LazyLock::new(|| walk(2));

const STRIDE: f64 = KEYS_PER_STRIDE as f64 * KEY_TIME;

/// The vertices at a time given in keys.
fn skin_at(keys: f64) -> Vec<[f64; 3]> {
    let pose = WALK.sample(keys * KEY_TIME);
    let motions = pose.motions(&HUMAN.skeleton).unwrap();
    let moved = skin::skin(
        HUMAN.mesh.positions(),
        &HUMAN.weights,
        &motions,
        Method::Linear,
    )
    .unwrap();
    moved.into_iter().map(|p| p.coordinates()).collect()
}

/// The bones at a time given in keys.
fn bones_at(keys: f64) -> Vec<[[f64; 3]; 2]> {
    WALK.sample(keys * KEY_TIME).bones(&HUMAN.skeleton).unwrap()
}

fn lowest(skin: &[[f64; 3]]) -> f64 {
    skin.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min)
}

#[test]
fn it_has_the_keys_it_says() {
    assert_eq!(KEY_NAMES.len(), KEYS_PER_STRIDE);
    assert_eq!(WALK.frames().len(), 2 * KEYS_PER_STRIDE + 1);
    assert_eq!(WALK.frame_time(), KEY_TIME);
    assert_eq!(walk(0).frames().len(), 1);
}

#[test]
fn the_lowest_point_stays_at_the_ground() {
    for sample in 0..=64 {
        let low = lowest(&skin_at(f64::from(sample) / 8.0));
        assert!(
            low.abs() < 0.01,
            "{low} m at key {}",
            f64::from(sample) / 8.0
        );
    }
}

/// A vertex of the left sole near a place along the foot at rest.
fn sole(z: f64) -> usize {
    let positions = positions();
    let off = |v: usize| {
        (positions[v][2] - z).abs()
            + 3.0 * positions[v][1]
            + if positions[v][0] > 0.0 { 0.0 } else { 9.0 }
    };
    (0..positions.len())
        .min_by(|&a, &b| off(a).total_cmp(&off(b)))
        .unwrap()
}

#[test]
fn the_foot_that_stands_does_not_slip() {
    // Heel, ball and tip of the left foot, and the keys between which each is on the ground.
    for (z, from, to) in [(-0.06, 0, 3), (0.085, 1, 4), (0.12, 1, 4), (0.155, 4, 5)] {
        let vertex = sole(z);
        let places: Vec<[f64; 3]> = (from * 8..=to * 8)
            .map(|s| skin_at(f64::from(s) / 8.0)[vertex])
            .collect();
        for p in &places {
            let slip = (p[0] - places[0][0]).hypot(p[2] - places[0][2]);
            assert!(slip < 0.01, "{slip} m at {z}");
            assert!(
                p[1] < 0.045,
                "the part of the foot at {z} is on the ground, not at {}",
                p[1]
            );
        }
    }
}

#[test]
fn the_foot_that_swings_clears_the_ground_and_lands_ahead() {
    let foot = joint("LeftFoot");
    let before = bones_at(4.0)[foot][0];
    let landed = bones_at(8.0)[foot][0];
    assert!(
        (1.0..1.6).contains(&(landed[2] - before[2])),
        "{}",
        landed[2] - before[2]
    );
    let positions = positions();
    for sample in 46..=57 {
        let skin = skin_at(f64::from(sample) / 8.0);
        let left = skin
            .iter()
            .zip(&positions)
            .filter(|(_, rest)| rest[0] > 0.0 && rest[1] < 0.1);
        let clearance = left.map(|(p, _)| p[1]).fold(1.0, f64::min);
        assert!(
            clearance > 0.01,
            "{clearance} m at key {}",
            f64::from(sample) / 8.0
        );
    }
}

#[test]
fn strides_repeat_and_go_ahead_at_walking_speed() {
    let (first, second) = (bones_at(0.0), bones_at(8.0));
    let length = second[0][0][2] - first[0][0][2];
    for (a, b) in first.iter().zip(&second) {
        for end in 0..2 {
            assert!(
                Vector::from(b[end]).distance(Vector::from(a[end]) + Vector::new(0.0, 0.0, length))
                    < 1e-12
            );
        }
    }
    let speed = length / STRIDE;
    assert!((1.1..1.5).contains(&speed), "{speed} m/s");
    // The hips go on evenly; they neither stop nor jump.
    for key in 0..KEYS_PER_STRIDE {
        let part = (bones_at(key as f64 + 1.0)[0][0][2] - bones_at(key as f64)[0][0][2]) / length;
        assert!(
            (0.1..0.15).contains(&part),
            "{part} of a stride from key {key}"
        );
    }
}

#[test]
fn the_second_step_is_the_mirror_image_of_the_first() {
    let step = bones_at(4.0)[0][0][2] - bones_at(0.0)[0][0][2];
    for sample in 0..16 {
        let keys = f64::from(sample) / 4.0;
        let (first, second) = (bones_at(keys), bones_at(keys + 4.0));
        for (i, left) in HUMAN
            .skeleton
            .joints()
            .iter()
            .enumerate()
            .filter(|(_, j)| j.name.starts_with("Left"))
        {
            let right = joint(&left.name.replace("Left", "Right"));
            let [x, y, z] = first[i][1];
            assert!(
                Vector::from(second[right][1]).distance(Vector::new(-x, y, z + step)) < 1e-9,
                "{} at key {keys}",
                left.name
            );
        }
    }
}

#[test]
fn arms_swing_against_the_legs_and_knees_bend_backwards() {
    let ahead = |bones: &[[[f64; 3]; 2]], name: &str| bones[joint(name)][0][2] - bones[0][0][2];
    for (key, front, rear) in [(0.0, "Left", "Right"), (4.0, "Right", "Left")] {
        let bones = bones_at(key);
        assert!(ahead(&bones, &format!("{front}Foot")) > 0.25);
        assert!(ahead(&bones, &format!("{rear}Foot")) < -0.25);
        assert!(ahead(&bones, &format!("{front}Hand")) < 0.0);
        assert!(ahead(&bones, &format!("{rear}Hand")) > 0.1);
    }
    let bend = |bones: &[[[f64; 3]; 2]], upper: &str, lower: &str| {
        let along = |name: &str| {
            let [head, tail] = bones[joint(name)];
            Vector::from(tail) - Vector::from(head)
        };
        let (u, l) = (along(upper), along(lower));
        // About x: positive when the lower bone goes to the back of the upper one.
        (u[1] * l[2] - u[2] * l[1])
            .atan2(u[1] * l[1] + u[2] * l[2])
            .to_degrees()
    };
    for sample in 0..64 {
        let bones = bones_at(f64::from(sample) / 8.0);
        let knee = bend(&bones, "LeftUpperLeg", "LeftLowerLeg");
        assert!(
            (0.0..75.0).contains(&knee),
            "knee {knee}° at key {}",
            f64::from(sample) / 8.0
        );
        let elbow = bend(&bones, "LeftUpperArm", "LeftLowerArm");
        assert!(
            (-50.0..0.0).contains(&elbow),
            "elbow {elbow}° at key {}",
            f64::from(sample) / 8.0
        );
    }
}

#[test]
fn it_stays_upright() {
    for sample in 0..64 {
        let bones = bones_at(f64::from(sample) / 8.0);
        let [neck, crown] = bones[joint("Head")].map(Vector::from);
        let up = crown - Vector::from(bones[0][0]);
        let lean = FRAC_PI_2 - (up.e2 / up.length()).asin();
        assert!(lean.to_degrees() < 8.0);
        let head = crown - neck;
        assert!(head.e2 / head.length() > 0.97);
    }
}

#[test]
fn limbs_keep_their_volume() {
    let triangles = HUMAN.mesh.triangles();
    let rest = volume(&positions(), &triangles);
    for (key, name) in KEY_NAMES.iter().enumerate() {
        let moved = volume(&skin_at(key as f64), &triangles);
        assert!(
            (moved / rest - 1.0).abs() < 0.02,
            "{} at {name}",
            moved / rest
        );
    }
}

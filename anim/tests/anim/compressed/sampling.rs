//! Sampling between frames, in any order.

use ga_anim::clip::compressed::{Options, Sampler};
use ga_runtime::cga3::Rotor;
use glam::DQuat;
use proptest::prelude::*;

use super::{chain, compressed, noise, recording, rigid, rotation, tree};

fn quaternion(rotor: Rotor<f32>) -> DQuat {
    let ([x, y, z], w) = rotor.to_quaternion();
    DQuat::from_array([x, y, z, w].map(f64::from)).normalize()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// A pose depends on the time alone, not on what was sampled before.
    #[test]
    fn any_order_gives_the_same_pose(
        times in proptest::collection::vec(-0.1..1.2f64, 1..30),
        frames in 1usize..100,
    ) {
        let recording = recording(&tree(11), 0.01, frames, |frame, joint| {
            let angles = [0, 1, 2].map(|k| 0.2 * noise(frame / 3, joint, k));
            rigid([noise(frame, joint, 7), 0.2, 0.0], rotation(angles))
        });
        let clip = compressed(&recording, &Options::new(1e-3, 0.03));
        let mut sampler = Sampler::new(&clip);
        for time in times {
            sampler.sample(time);
            let mut fresh = Sampler::new(&clip);
            fresh.sample(time);
            prop_assert_eq!(sampler.rotors(), fresh.rotors());
            prop_assert_eq!(sampler.translations(), fresh.translations());
            prop_assert_eq!(sampler.scales(), fresh.scales());
        }
    }

    /// Rotations between frames are the slerp of those at the frames.
    #[test]
    fn rotations_between_frames_are_slerp(angle in 0.0..1.5f64, t in 0.0..1.0f64) {
        let recording = recording(&chain(1), 1.0, 2, |frame, _| {
            rigid([0.0; 3], rotation([0.3, frame as f64 * angle, 0.1]))
        });
        let clip = compressed(&recording, &Options::new(1e-6, 0.03));
        let mut sampler = Sampler::new(&clip);
        let mut at = |time| {
            sampler.sample(time);
            quaternion(sampler.rotors()[0])
        };
        let (from, to, between) = (at(0.0), at(1.0), at(t));
        let truth = from.slerp(to, t);
        prop_assert!(between.angle_between(truth) < 2e-6);
        let half = at(0.5);
        prop_assert!(half.angle_between(from.slerp(to, 0.5)) < 2e-6);
    }
}

#[test]
fn beyond_the_ends_the_pose_is_that_of_the_end() {
    let recording = recording(&chain(2), 0.5, 5, |frame, joint| {
        rigid(
            [noise(frame, joint, 0), 0.0, 0.0],
            rotation([noise(frame, joint, 1), 0.0, 0.0]),
        )
    });
    let clip = compressed(&recording, &Options::default());
    let at = |time| {
        let mut sampler = Sampler::new(&clip);
        sampler.sample(time);
        (sampler.rotors().to_vec(), sampler.translations().to_vec())
    };
    for early in [-1.0, f64::NEG_INFINITY, f64::NAN] {
        assert_eq!(at(early), at(0.0));
    }
    for late in [2.1, 1e300, f64::INFINITY] {
        assert_eq!(at(late), at(2.0));
    }
    let mut sampler = Sampler::new(&clip);
    sampler.sample_frame(99);
    assert_eq!(sampler.rotors(), at(2.0).0);
}

//! The bound holds on made recordings of every kind.

use ga_anim::clip::ClipError;
use ga_anim::clip::compressed::{JointBound, Options, Sampler, compress, measure};
use ga_anim::recording::{Recording, ScalarTrack};
use ga_anim::transform::Transform;
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

use super::{
    chain, compressed, greatest_error, noise, ratio, recording, rigid, rotation, shell_error, tree,
};

/// Compresses, checks the bound by points and that the measured error is no less, and returns the
/// ratio.
#[track_caller]
fn check(recording: &Recording, tolerance: f64, shell: f64) -> f64 {
    let clip = compressed(recording, &Options::new(tolerance, shell));
    let found = greatest_error(recording, &clip, shell);
    let measured = measure(recording, &clip).unwrap();
    assert!(found <= tolerance, "{found} is beyond {tolerance}");
    assert!(measured.error <= tolerance);
    // The measured error is an upper bound of that of the points, up to single precision.
    assert!(
        found <= measured.error + 1e-7,
        "{found} is beyond the measured {}",
        measured.error
    );
    ratio(&clip)
}

fn smooth(frame: usize, joint: usize) -> Transform<f64> {
    let t = frame as f64 * 0.01;
    let angle = |k: usize| 0.6 * (t * (1.0 + (joint % 5) as f64) + k as f64).sin();
    let place = if joint == 0 {
        [t, 1.0 + 0.05 * (4.0 * t).sin(), 0.0]
    } else {
        [0.1, 0.02, 0.0]
    };
    rigid(place, rotation([angle(0), angle(1), angle(2)]))
}

fn noisy(frame: usize, joint: usize) -> Transform<f64> {
    let jitter = [0, 1, 2].map(|k| 0.003 * noise(frame, joint, k));
    let mut transform = smooth(frame, joint);
    transform.motor *= ga_runtime::cga3::Motor::from(rotation(jitter));
    transform
}

#[test]
fn smooth_and_noisy_motion() {
    let smooth_ratio = check(&recording(&tree(15), 0.01, 200, smooth), 1e-4, 0.03);
    assert!(smooth_ratio > 20.0, "{smooth_ratio}");
    let noisy_ratio = check(&recording(&tree(15), 0.01, 200, noisy), 1e-4, 0.03);
    assert!(noisy_ratio > 9.0, "{noisy_ratio}");
}

#[test]
fn thirty_frames_a_second() {
    let quick = |frame, joint| noisy(4 * frame, joint);
    let ratio = check(&recording(&tree(10), 1.0 / 30.0, 100, quick), 1e-4, 0.03);
    assert!(ratio > 9.0, "{ratio}");
}

#[test]
fn still_motion_costs_nothing() {
    let still = |_, joint| noisy(7, joint);
    let short = recording(&tree(20), 0.01, 40, still);
    let long = recording(&tree(20), 0.01, 4000, still);
    check(&short, 1e-4, 0.03);
    let bytes = |recording| compressed(recording, &Options::default()).as_bytes().len();
    assert_eq!(bytes(&short), bytes(&long));
}

#[test]
fn jumps_and_rotations_by_full_turns() {
    let jumping = |frame: usize, joint| {
        let mut transform = smooth(frame, joint);
        if (frame / 13 + joint).is_multiple_of(3) {
            let far = rotation([3.0, -1.0, 2.0 * joint as f64]);
            transform = rigid(transform.translation().coordinates(), far);
        }
        transform
    };
    check(&recording(&tree(7), 0.01, 100, jumping), 1e-4, 0.03);
    let spinning = |frame: usize, joint| {
        let angle = frame as f64 * (0.2 + joint as f64);
        let place = if joint == 0 {
            [0.0; 3]
        } else {
            [0.2, 0.0, 0.0]
        };
        rigid(place, rotation([0.0, 0.6 * angle, 0.8 * angle]))
    };
    check(&recording(&chain(3), 0.01, 100, spinning), 1e-4, 0.03);
}

#[test]
fn many_joints_and_deep_chains() {
    let deep = |frame, joint| {
        let mut transform = noisy(frame, joint);
        if joint > 0 {
            let slight = [0, 1, 2].map(|k| 0.05 * noise(frame / 20, joint, k));
            transform = rigid([0.05, 0.0, 0.0], rotation(slight));
        }
        transform
    };
    check(&recording(&chain(200), 0.01, 34, deep), 1e-4, 0.03);
    check(&recording(&tree(200), 0.01, 34, smooth), 1e-4, 0.03);
}

/// Neither memory nor time grows with the square of the number of joints.
#[test]
fn a_still_chain_of_thousands_of_joints() {
    let still = |_, joint: usize| rigid([0.01, 0.0, 0.0], rotation([0.0, 0.0, joint as f64]));
    check(&recording(&chain(4096), 0.01, 1, still), 1e-4, 0.03);
    let error = compress(
        &recording(&chain(20_000), 0.01, 1, still),
        &Options::default(),
        |_, _| (),
    );
    assert_eq!(
        error.unwrap_err(),
        ClipError::TooManyJoints {
            joints: 20_000,
            most: 4096
        }
    );
}

/// Deviations below what may be left out, which add up along a chain.
#[test]
fn small_deviations_that_add_up() {
    let trembling = |frame: usize, _| {
        let angle = 2e-6 * (frame as f64).sin();
        rigid([0.1, 0.0, 0.0], rotation([0.0, 0.0, angle]))
    };
    check(&recording(&chain(150), 0.01, 40, trembling), 1e-4, 0.03);
}

#[test]
fn one_frame_and_one_joint() {
    check(&recording(&chain(1), 0.5, 1, smooth), 1e-4, 0.03);
    check(&recording(&tree(9), 0.5, 1, noisy), 1e-4, 0.03);
    for frames in [2, 3, 31, 32, 33, 65] {
        check(&recording(&chain(1), 0.5, frames, noisy), 1e-4, 0.03);
    }
}

#[test]
fn joints_that_move_and_roots_far_away() {
    let moving = |frame: usize, joint: usize| {
        let place = [0, 1, 2].map(|k| 0.1 * noise(frame / 9, joint, k) + 0.3);
        let rotor = noisy(frame, joint).rotor();
        rigid(
            if joint == 0 {
                place.map(|x| x + 200.0)
            } else {
                place
            },
            rotor,
        )
    };
    check(&recording(&tree(6), 0.02, 70, moving), 1e-4, 0.03);
}

#[test]
fn scaled_joints() {
    let scaled = |uniform: bool| {
        move |frame: usize, joint: usize| {
            let mut transform = noisy(frame, joint);
            let factor = |k: usize| 1.0 + 0.3 * ((frame as f64) * 0.1 + (joint + k) as f64).sin();
            let place = transform.translation();
            transform = Transform::from_parts(
                place,
                transform.rotor(),
                Vector::from([0, 1, 2].map(|k| factor(if uniform { 0 } else { k }))),
            );
            transform
        }
    };
    check(&recording(&tree(7), 0.02, 70, scaled(true)), 1e-4, 0.03);
    check(&recording(&tree(7), 0.02, 70, scaled(false)), 1e-4, 0.03);
    // A constant factor, as from a change of unit, leaves the loop closed.
    let centimetres = |frame, joint: usize| {
        let mut transform = smooth(frame, joint);
        let factor = if joint == 0 { 0.01 } else { 1.0 };
        let place = transform.translation() * if joint == 0 { 1.0 } else { 100.0 };
        transform = Transform::from_parts(
            place,
            transform.rotor(),
            Vector::new(factor, factor, factor),
        );
        transform
    };
    let ratio = check(&recording(&tree(15), 0.01, 200, centimetres), 1e-4, 0.03);
    assert!(ratio > 20.0, "{ratio}");
}

/// The points near a joint that shrinks are far from it in its own coordinates, those near a joint
/// that grows are near to it there.
#[test]
fn joints_under_very_small_and_large_factors() {
    let under = |factors: [f64; 3]| {
        move |frame: usize, joint: usize| {
            let transform = noisy(frame, joint);
            let (place, factors) = match joint {
                0 => (transform.translation(), Vector::from(factors)),
                // The distances between joints stay about as they are.
                _ => (
                    transform.translation() * factors[0].recip(),
                    Vector::new(1.0, 1.0, 1.0),
                ),
            };
            Transform::from_parts(place, transform.rotor(), factors)
        }
    };
    let unscaled = check(&recording(&tree(7), 0.01, 100, noisy), 1e-4, 0.03);
    for factor in [1e-3, 100.0] {
        let ratio = check(
            &recording(&tree(7), 0.01, 100, under([factor; 3])),
            1e-4,
            0.03,
        );
        assert!(ratio > 0.95 * unscaled, "{ratio} instead of {unscaled}");
    }
    check(
        &recording(&tree(7), 0.01, 100, under([0.01, 0.05, -0.02])),
        1e-4,
        0.03,
    );
}

#[test]
fn joints_that_shrink_to_nothing() {
    let factor = |frame: usize| (1.0 - frame as f64 / 40.0).max(0.0).powi(2);
    let shrinking = |frame: usize, joint: usize| {
        let transform = noisy(frame, joint);
        let factor = if joint == 1 { factor(frame) } else { 1.0 };
        let factors = Vector::new(factor, factor, factor);
        Transform::from_parts(transform.translation(), transform.rotor(), factors)
    };
    let recording = recording(&chain(3), 0.01, 60, shrinking);
    let clip = compressed(&recording, &Options::default());
    let mut sampler = Sampler::new(&clip);
    for frame in 0..recording.frame_count() {
        sampler.sample_frame(frame);
        let found = super::found(&sampler, clip.parents());
        let truth = super::truth(&recording, frame);
        for joint in 0..3 {
            // Points within the shell of the joint as it is, or at 1 % of its greatest size.
            let size = if joint == 0 {
                1.0
            } else {
                factor(frame).max(0.01)
            };
            for axis in [glam::DVec3::X, glam::DVec3::Y, glam::DVec3::Z] {
                let point = axis * (0.03 / size);
                let places = [&found[joint], &truth[joint]].map(|map| map.transform_point3(point));
                let error = places[0].distance(places[1]);
                assert!(error <= 1e-4, "frame {frame}, joint {joint}: {error}");
            }
        }
    }
}

#[test]
fn joints_with_bounds_of_their_own() {
    let recording = recording(&tree(15), 0.01, 100, noisy);
    let (joint, tolerance, shell) = (14, 1e-5, 0.2);
    let mut options = Options::new(1e-3, 0.03);
    options.joints.push(JointBound {
        joint,
        tolerance,
        shell,
    });
    let clip = compressed(&recording, &options);
    assert_eq!(clip.options(), &options);
    let mut sampler = Sampler::new(&clip);
    for frame in 0..recording.frame_count() {
        sampler.sample_frame(frame);
        let found = super::found(&sampler, clip.parents());
        let truth = super::truth(&recording, frame);
        assert!(shell_error(&found[joint], &truth[joint], shell) <= tolerance);
        assert!(shell_error(&found[3], &truth[3], 0.03) <= 1e-3);
    }
    let alike = compressed(&recording, &Options::new(1e-3, 0.03));
    assert!(alike.as_bytes().len() < clip.as_bytes().len());
}

#[test]
fn scalar_tracks_stay_within_their_tolerance() {
    let still = recording(&chain(1), 0.01, 100, |_, _| Transform::default());
    let values = |value: &dyn Fn(usize) -> f64| (0..100).map(value).collect();
    let track = |name: &str, values| ScalarTrack {
        name: name.into(),
        values,
    };
    let tracks = vec![
        track("smile", values(&|frame| (frame as f64 * 0.1).sin())),
        track("noise", values(&|frame| noise(frame, 1, 2) * 40.0)),
        track("constant", values(&|_| 7.25)),
        track("switch", values(&|frame| f64::from(u8::from(frame > 50)))),
    ];
    let recording = Recording::new(
        still.joints().to_vec(),
        still.frame_time(),
        still.locals().to_vec(),
        tracks,
    )
    .unwrap();
    let options = Options {
        track_tolerance: 1e-3,
        ..Options::default()
    };
    let clip = compressed(&recording, &options);
    assert!(
        clip.track_names()
            .eq(["smile", "noise", "constant", "switch"])
    );
    let mut sampler = Sampler::new(&clip);
    let mut greatest = 0.0f64;
    for frame in 0..100 {
        sampler.sample_frame(frame);
        for (track, &found) in recording.tracks().iter().zip(sampler.tracks()) {
            greatest = greatest.max((track.values[frame] - found).abs());
        }
        assert_eq!(sampler.tracks()[2], 7.25);
    }
    assert!(greatest <= 1e-3, "{greatest}");
    assert_eq!(measure(&recording, &clip).unwrap().track_error, greatest);
}

#[test]
fn what_cannot_be_kept_is_an_error_that_names_it() {
    let far = recording(&chain(2), 0.01, 40, |frame, joint| {
        let place = if joint == 0 {
            [1e7 + frame as f64, 0.0, 0.0]
        } else {
            [1.0, 0.0, 0.0]
        };
        rigid(place, noisy(frame, joint).rotor())
    });
    let error = compress(&far, &Options::default(), |_, _| ()).unwrap_err();
    let names_it = matches!(
        &error,
        ClipError::Bound { joint, .. } | ClipError::Precision { joint, .. }
            if joint.starts_with("joint ")
    );
    assert!(names_it, "{error}");
    let small = recording(&chain(2), 0.01, 4, smooth);
    for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = compress(&small, &Options::new(value, 0.03), |_, _| ()).unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("the tolerance must be positive"),
            "{error}"
        );
    }
    let error = compress(&small, &Options::new(1e-4, -1.0), |_, _| ()).unwrap_err();
    assert!(
        error.to_string().starts_with("the shell must be positive"),
        "{error}"
    );
    let mut options = Options::default();
    options.joints.push(JointBound {
        joint: 2,
        tolerance: 1.0,
        shell: 1.0,
    });
    let error = compress(&small, &options, |_, _| ()).unwrap_err();
    assert_eq!(
        error,
        ClipError::BoundJoint {
            joint: 2,
            joints: 2
        }
    );
}

#[test]
fn any_number_of_threads_writes_the_same_bytes() {
    let recording = recording(&tree(9), 0.01, 150, noisy);
    let bytes = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| {
            compressed(&recording, &Options::default())
                .as_bytes()
                .to_vec()
        })
    };
    assert_eq!(bytes(1), bytes(3));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_bound_holds_for_any_motion(
        seed in 0usize..1 << 16,
        joints in 1usize..12,
        frames in 1usize..80,
        calm in 1usize..40,
        amplitude in -4.0..0.7f64,
        exponent in -4.5..-2.0f64,
        shell in 0.0..0.3f64,
    ) {
        let amplitude = 10f64.powf(amplitude);
        let local = |frame: usize, joint: usize| {
            let value = |k| noise(frame / calm, joint + seed, k) * amplitude;
            let place = [0, 1, 2].map(|k| 0.3 * noise(joint, seed, k));
            let place = if joint.is_multiple_of(5) { place.map(|x| x + value(4)) } else { place };
            rigid(place, rotation([value(0), value(1), value(2)]))
        };
        let parents: Vec<_> = (0..joints)
            .map(|joint| (joint > 0).then(|| (noise(seed, joint, 9).abs() * joint as f64) as usize % joint))
            .collect();
        let recording = recording(&parents, 0.01, frames, local);
        let tolerance = 10f64.powf(exponent);
        let clip = compressed(&recording, &Options::new(tolerance, shell));
        let found = greatest_error(&recording, &clip, shell);
        prop_assert!(found <= tolerance, "{} is beyond {}", found, tolerance);
    }
}

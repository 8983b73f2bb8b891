//! Recordings resampled, mirrored and blended, and read back from compressed clips.

use ga_anim::bvh;
use ga_anim::clip::Mirror;
use ga_anim::clip::compressed::{Options, compress};
use ga_anim::recording::{
    RecordedJoint, Recording, RecordingError, ScalarTrack, blend, model_maps, model_motors,
};
use ga_anim::transform::Transform;
use ga_runtime::cga3::{DualPlane, Motor, Point, Rotor};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;
use glam::{DAffine3, DQuat, DVec3};
use nullcone_shared_data::shared;
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;

const NAMES: [&str; 6] = ["Hips", "LeftLeg", "LFoot", "RightLeg", "RFoot", "Head"];
const PARENTS: [Option<usize>; 6] = [None, Some(0), Some(1), Some(0), Some(3), Some(0)];
const COUNTERPARTS: [usize; 6] = [0, 3, 4, 1, 2, 5];

fn rotor() -> impl Strategy<Value = Rotor<f64>> {
    uniform3(-2.0..2.0f64).prop_map(|axis| {
        let q = DQuat::from_scaled_axis(DVec3::from(axis));
        Rotor::from_quaternion([q.x, q.y, q.z], q.w).unwrap()
    })
}

/// A transform with the same factor along all axes.
fn transform() -> impl Strategy<Value = Transform<f64>> {
    (uniform3(-2.0..2.0f64), rotor(), 0.5..2.0f64)
        .prop_map(|(t, rotor, s)| Transform::from_parts(t.into(), rotor, Vector::new(s, s, s)))
}

/// A recording of the joints above with tracks of both sides.
fn recording(frames: usize) -> impl Strategy<Value = Recording> {
    let numbers = move || vec(-1.0..1.0f64, frames);
    (
        vec(transform(), NAMES.len()),
        vec(transform(), NAMES.len() * frames),
        (numbers(), numbers(), numbers()),
    )
        .prop_map(|(rests, locals, (left, right, middle))| {
            let joints = NAMES.iter().zip(PARENTS).zip(rests);
            let joints = joints.map(|((&name, parent), rest)| RecordedJoint {
                name: name.into(),
                parent,
                rest,
            });
            let tracks = [("eye.L", left), ("eye.R", right), ("mouth", middle)];
            let tracks = tracks.map(|(name, values)| ScalarTrack {
                name: name.into(),
                values,
            });
            Recording::new(joints.collect(), 0.01, locals, tracks.into()).unwrap()
        })
}

/// How far points of a unit cube go apart under two transforms.
fn apart(a: &Transform<f64>, b: &Transform<f64>) -> f64 {
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let distance = |x: [f64; 3]| {
        let x = Point::from(x);
        a.transform(x).distance(b.transform(x))
    };
    corners.map(distance).into_iter().fold(0.0, f64::max)
}

/// The place of each joint in model space in a frame.
fn places(recording: &Recording, frame: usize) -> Vec<DVec3> {
    let locals = recording.frame(frame).unwrap();
    let mut maps = vec![Affine::default(); locals.len()];
    model_maps(recording.parents(), locals, &mut maps).unwrap();
    maps.iter()
        .map(|map| DVec3::from(map.translation))
        .collect()
}

/// The reflection in the plane through the origin with this unit normal.
fn reflection(normal: DVec3) -> impl Fn(DVec3) -> DVec3 {
    move |x| x - 2.0 * normal.dot(x) * normal
}

proptest! {
    #[test]
    fn the_mirror_image_of_a_mirror_image_is_the_recording(
        recording in recording(3), normal in uniform3(0.1..1.0f64),
    ) {
        let normal = Vector::from(normal);
        let back = recording.mirrored(normal).unwrap().mirrored(normal).unwrap();
        prop_assert_eq!(back.joints(), recording.joints());
        prop_assert_eq!(back.tracks(), recording.tracks());
        // Places are divided by the factors of up to three joints above, from 0.5 to 2.
        for (a, b) in recording.locals().iter().zip(back.locals()) {
            prop_assert!(apart(a, b) < 1e-11);
        }
    }

    /// Of a body that is its own mirror image, with axes of any direction, every joint is where its
    /// counterpart's image is.
    #[test]
    fn a_symmetric_body_moves_as_its_mirror_image(
        motion in recording(2), axes in vec(uniform3(-2.0..2.0f64), 6), normal in uniform3(0.1..1.0f64),
    ) {
        let unit = DVec3::from(normal).normalize();
        let image = reflection(unit);
        // Places at rest in model space: the right side is the image of the left one.
        let heads: Vec<DVec3> = (0..6).map(|joint| {
            let source = &motion.joints()[joint.min(COUNTERPARTS[joint])].rest;
            let place = DVec3::from(source.translation().coordinates());
            match COUNTERPARTS[joint] {
                other if other == joint => (place + image(place)) / 2.0,
                other if other < joint => image(place),
                _ => place,
            }
        }).collect();
        let frames: Vec<DAffine3> = axes.iter().zip(&heads).map(|(axes, &head)| {
            let rotation = DQuat::from_scaled_axis(DVec3::from(*axes));
            DAffine3::from_rotation_translation(rotation, head)
        }).collect();
        let rest = |joint: usize| {
            let above = PARENTS[joint].map_or(DAffine3::IDENTITY, |parent| frames[parent]);
            let (_, q, t) = (above.inverse() * frames[joint]).to_scale_rotation_translation();
            Transform::from_parts(
                t.to_array().into(),
                Rotor::from_quaternion([q.x, q.y, q.z], q.w).unwrap(),
                Vector::new(1.0, 1.0, 1.0),
            )
        };
        let joints: Vec<RecordedJoint> = (0..6).map(|joint| RecordedJoint {
            rest: rest(joint),
            ..motion.joints()[joint].clone()
        }).collect();
        let recording =
            Recording::new(joints, 0.01, motion.locals().to_vec(), Vec::new()).unwrap();
        let mirrored = recording.mirrored(normal.into()).unwrap();
        for frame in 0..2 {
            let (before, after) = (places(&recording, frame), places(&mirrored, frame));
            for joint in 0..6 {
                let truth = image(before[COUNTERPARTS[joint]]);
                prop_assert!(after[joint].distance(truth) < 1e-11);
            }
        }
    }

    #[test]
    fn the_own_rate_changes_nothing(recording in recording(4)) {
        prop_assert_eq!(&recording.resampled(100.0).unwrap(), &recording);
        prop_assert_eq!(&recording.resampled(recording.frame_time().recip()).unwrap(), &recording);
    }

    /// At a multiple of the rate the frames are kept, and those between are samples.
    #[test]
    fn resampled_frames_are_samples(recording in recording(4), rate in 20.0..900.0f64) {
        let resampled = recording.resampled(rate).unwrap();
        let last = resampled.duration();
        prop_assert!(last <= recording.duration() * (1.0 + 1e-9));
        prop_assert!(last + resampled.frame_time() > recording.duration());
        let mut locals = vec![Transform::default(); 6];
        for frame in 0..resampled.frame_count() {
            let time = frame as f64 / rate;
            recording.sample(time, &mut locals).unwrap();
            for (a, b) in locals.iter().zip(resampled.frame(frame).unwrap()) {
                prop_assert!(apart(a, b) < 1e-12);
            }
            let value = recording.sample_track(1, time).unwrap();
            prop_assert!((resampled.tracks()[1].values[frame] - value).abs() < 1e-12);
        }
        let doubled = recording.resampled(200.0).unwrap();
        prop_assert_eq!(doubled.frame_count(), 7);
        for frame in 0..4 {
            prop_assert_eq!(doubled.frame(2 * frame), recording.frame(frame));
        }
    }

    #[test]
    fn a_blend_with_one_weight_is_that_recording(a in recording(3), b in recording(5), w in 0.1..9.0f64) {
        prop_assert_eq!(&blend(&[(&a, w), (&b, 0.0)]).unwrap(), &a);
        prop_assert_eq!(&blend(&[(&a, 0.0), (&b, w)]).unwrap(), &b);
    }

    #[test]
    fn a_blend_with_itself_is_itself(a in recording(3), v in 0.1..9.0f64, w in 0.1..9.0f64) {
        let mean = blend(&[(&a, v), (&a, w)]).unwrap();
        prop_assert_eq!(mean.frame_count(), 3);
        for (a, b) in a.locals().iter().zip(mean.locals()) {
            prop_assert!(apart(a, b) < 1e-13);
        }
        for (a, b) in a.tracks().iter().zip(mean.tracks()) {
            prop_assert_eq!(&a.name, &b.name);
            for (a, b) in a.values.iter().zip(&b.values) {
                prop_assert!((a - b).abs() < 1e-14);
            }
        }
    }

    /// Against glam: normalised sums of quaternions, sums of translations and of factors.
    #[test]
    fn a_blend_is_the_mean_of_transforms(a in recording(2), b in recording(4), w in 0.05..0.95f64) {
        let mean = blend(&[(&a, 3.0 * (1.0 - w)), (&b, 3.0 * w)]).unwrap();
        prop_assert_eq!(mean.frame_count(), 4);
        let quaternion = |rotor: Rotor<f64>| {
            let (axis, angle) = rotor.to_axis_angle();
            DQuat::from_axis_angle(DVec3::from(axis).normalize_or(DVec3::X), angle)
        };
        for frame in 0..4 {
            // The shorter recording stays at its last frame.
            let pairs = a.frame(frame.min(1)).unwrap().iter().zip(b.frame(frame).unwrap());
            for ((a, b), found) in pairs.zip(mean.frame(frame).unwrap()) {
                let (p, q) = (quaternion(a.rotor()), quaternion(b.rotor()));
                prop_assume!(p.dot(q).abs() > 1e-6);
                let rotation = (p * (1.0 - w) + q * (w * p.dot(q).signum())).normalize();
                let [s, t] = [
                    [a.scale, b.scale],
                    [a.translation(), b.translation()],
                ].map(|[a, b]| DVec3::from(a.coordinates()).lerp(b.coordinates().into(), w));
                let truth = DAffine3::from_scale_rotation_translation(s, rotation, t);
                for x in [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z] {
                    let image = found.transform(Point::from(x.to_array())).coordinates();
                    prop_assert!(truth.transform_point3(x).distance(image.into()) < 1e-11);
                }
            }
            let (at_a, at_b) = (a.tracks()[2].values[frame.min(1)], b.tracks()[2].values[frame]);
            let value = mean.tracks()[2].values[frame];
            prop_assert!((value - (at_a + (at_b - at_a) * w)).abs() < 1e-14);
        }
    }
}

#[test]
fn a_walk_is_mirrored_as_a_clip_of_it_is() {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let recording = Recording::from_bvh(&bvh::read(path).unwrap(), 0.056_444).unwrap();
    let mirrored = recording.mirrored(Vector::new(1.0, 0.0, 0.0)).unwrap();
    let skeleton = recording.to_skeleton().unwrap();
    let plane = DualPlane::new(1.0, 0.0, 0.0, 0.0);
    let mirror = Mirror::by_names(&skeleton, plane).unwrap();
    let truth = mirror.clip(&recording.to_clip().unwrap()).unwrap();
    let truth = Recording::from_clip(&skeleton, &truth).unwrap();
    let count = recording.joints().len();
    let mut motors = [
        vec![Motor::default(); count],
        vec![Motor::default(); count],
        vec![Motor::default(); count],
    ];
    let left_hand = recording
        .joints()
        .iter()
        .position(|joint| joint.name == "LeftHand");
    let right_hand = recording
        .joints()
        .iter()
        .position(|joint| joint.name == "RightHand");
    let (left_hand, right_hand) = (left_hand.unwrap(), right_hand.unwrap());
    for frame in [0, 700, 2751] {
        for (recording, motors) in [&recording, &mirrored, &truth].into_iter().zip(&mut motors) {
            let locals = recording.frame(frame).unwrap();
            model_motors(recording.parents(), locals, motors).unwrap();
        }
        let place = |motor: &Motor<f64>| DVec3::from(motor.translator().displacement());
        let [before, found, truth] = &motors;
        for (found, truth) in found.iter().zip(truth) {
            // There both sides have the axes at rest, here those of their bones, which were
            // measured and differ a little.
            let [a, b] = [found, truth].map(place);
            assert!(a.distance(b) < 0.05, "{a} {b}");
        }
        // The body is nearly its own mirror image.
        let image = reflection(DVec3::X)(place(&before[left_hand]));
        assert!(place(&found[right_hand]).distance(image) < 0.05);
    }
}

#[test]
fn a_compressed_clip_is_read_back_within_its_bound() {
    let motion = bvh::decode(
        b"HIERARCHY ROOT arm { OFFSET 0 1 0 CHANNELS 4 Xposition Yposition Zposition Zrotation
            JOINT hand { OFFSET 0.3 0 0 CHANNELS 1 Xrotation } }
          MOTION Frames: 4 Frame Time: 0.02
          0 1 0 10 5
          0.1 1 0 20 -5
          0.2 1 0.1 35 -9
          0.4 1.1 0 40 20",
    );
    let recording = Recording::from_bvh(&motion.unwrap(), 1.0).unwrap();
    let clip = compress(&recording, &Options::default(), |_, _| {}).unwrap();
    let decoded = Recording::from_compressed(&clip).unwrap();
    assert_eq!(decoded.frame_count(), 4);
    assert_eq!(decoded.frame_time(), 0.02);
    assert_eq!(decoded.parents(), recording.parents());
    for (a, b) in decoded.joints().iter().zip(recording.joints()) {
        assert_eq!(a.name, b.name);
        assert!(apart(&a.rest, &b.rest) < 1e-6);
    }
    for frame in 0..4 {
        let pairs = places(&decoded, frame)
            .into_iter()
            .zip(places(&recording, frame));
        for (a, b) in pairs {
            assert!(a.distance(b) <= 1e-4);
        }
    }
}

/// A leg whose joint is twice as large as that of the other side, with a foot at half the distance,
/// so that the body is its own mirror image; and tracks of both sides.
#[test]
fn units_of_joints_and_tracks_change_sides() {
    let turned = |angle: f64| Rotor::from_axis_angle([1.0, 0.0, 0.0], angle).unwrap();
    let at = |place: [f64; 3], angle: f64, scale: f64| {
        Transform::from_parts(
            place.into(),
            turned(angle),
            Vector::new(scale, scale, scale),
        )
    };
    let rests = [
        at([0.0, 2.0, 0.0], 0.0, 1.0),
        at([1.0, -1.0, 0.0], 0.0, 2.0),
        at([0.0, -0.5, 0.0], 0.0, 1.0),
        at([-1.0, -1.0, 0.0], 0.0, 1.0),
        at([0.0, -1.0, 0.0], 0.0, 1.0),
        at([0.0, 1.0, 0.0], 0.0, 1.0),
    ];
    let joints = NAMES.iter().zip(PARENTS).zip(rests);
    let joints = joints.map(|((&name, parent), rest)| RecordedJoint {
        name: name.into(),
        parent,
        rest,
    });
    // The left foot leaves its place at rest.
    let mut locals = rests.to_vec();
    locals[0] = at([0.3, 2.1, 0.4], 0.2, 1.0);
    locals[1] = at([1.0, -1.0, 0.0], 0.7, 2.0);
    locals[2] = at([0.1, -0.45, 0.2], -0.4, 1.0);
    locals[3] = at([-1.0, -1.0, 0.0], -0.3, 1.0);
    let tracks = [("eye.L", 0.25), ("eye.R", 0.75), ("mouth", 0.5)];
    let tracks = tracks.map(|(name, value)| ScalarTrack {
        name: name.into(),
        values: vec![value],
    });
    let recording = Recording::new(joints.collect(), 0.01, locals, tracks.into()).unwrap();
    let mirrored = recording.mirrored(Vector::new(1.0, 0.0, 0.0)).unwrap();
    let image = reflection(DVec3::X);
    let (before, after) = (places(&recording, 0), places(&mirrored, 0));
    for (joint, &other) in COUNTERPARTS.iter().enumerate() {
        let error = after[joint].distance(image(before[other]));
        assert!(error < 1e-12, "{}: {error}", NAMES[joint]);
    }
    let values = mirrored.tracks().iter().map(|track| track.values[0]);
    assert_eq!(values.collect::<Vec<_>>(), [0.75, 0.25, 0.5]);
}

fn still(joints: &[(&str, Option<usize>)], frames: usize) -> Recording {
    let joint = |&(name, parent): &(&str, Option<usize>)| RecordedJoint {
        name: name.into(),
        parent,
        rest: Transform::default(),
    };
    let locals = vec![Transform::default(); joints.len() * frames];
    Recording::new(joints.iter().map(joint).collect(), 0.01, locals, Vec::new()).unwrap()
}

#[test]
fn rates_that_are_none_are_errors() {
    let recording = still(&[("a", None)], 100);
    for rate in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-310] {
        let error = recording.resampled(rate).unwrap_err();
        assert!(matches!(error, RecordingError::Rate(_)), "{rate}: {error}");
    }
    let error = recording.resampled(1e12).unwrap_err();
    assert!(matches!(error, RecordingError::TooLarge { .. }), "{error}");
    assert_eq!(recording.resampled(1e-6).unwrap().frame_count(), 1);
}

#[test]
fn what_cannot_be_mirrored_is_an_error_that_names_the_joint() {
    let x = Vector::new(1.0, 0.0, 0.0);
    let error = |joints: &[(&str, Option<usize>)]| still(joints, 1).mirrored(x).unwrap_err();
    assert_eq!(
        still(&[("a", None)], 1).mirrored(Vector::default()),
        Err(RecordingError::MirrorPlane)
    );
    assert_eq!(
        error(&[("Hips", None), ("LeftLeg", Some(0))]).to_string(),
        "joint \"LeftLeg\" has no counterpart \"RightLeg\""
    );
    let parents = [
        ("a", None),
        ("b", None),
        ("LeftLeg", Some(0)),
        ("RightLeg", Some(1)),
    ];
    assert!(matches!(
        error(&parents),
        RecordingError::PairParents { .. }
    ));
    let twice = [("LeftLeg", None), ("LeftLeg", None), ("RightLeg", None)];
    assert!(matches!(error(&twice), RecordingError::PairedTwice { .. }));

    let recording = still(&[("hip", None)], 2);
    let mut locals = recording.locals().to_vec();
    locals[1].scale = Vector::new(1.0, 2.0, 1.0);
    let uneven = Recording::new(recording.joints().to_vec(), 0.01, locals, Vec::new());
    let message = uneven.unwrap().mirrored(x).unwrap_err().to_string();
    assert!(message.contains("joint \"hip\"") && message.contains("frame 1"));
}

#[test]
fn what_cannot_be_blended_is_an_error_that_names_the_element() {
    let body = [("hip", None), ("knee", Some(0))];
    let (a, b) = (still(&body, 2), still(&body, 3));
    for weight in [-1.0, f64::NAN, f64::INFINITY] {
        let error = blend(&[(&a, 1.0), (&b, weight)]).unwrap_err();
        assert!(matches!(error, RecordingError::Weight { recording: 1, .. }));
    }
    assert_eq!(
        blend(&[(&a, 0.0), (&b, 0.0)]),
        Err(RecordingError::Sum(0.0))
    );
    assert_eq!(blend(&[]), Err(RecordingError::Sum(0.0)));
    assert!(blend(&[(&a, f64::MAX), (&b, f64::MAX)]).is_err());
    let error = |other: &[(&str, Option<usize>)]| {
        let other = still(other, 1);
        blend(&[(&a, 1.0), (&b, 0.0), (&other, 0.0)])
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        error(&body[..1]),
        "recording 2 has 1 joints, but the first has 2"
    );
    assert_eq!(
        error(&[("hip", None), ("shin", Some(0))]),
        "joint 1 of recording 2 is \"shin\", but that of the first is \"knee\""
    );
    assert_eq!(
        error(&[("hip", None), ("knee", None)]),
        "joint \"knee\" of recording 2 has another parent than in the first"
    );
    // One long frame and one very short one are more frames than their files warrant.
    let times = |recording: &Recording, time| {
        Recording::new(
            recording.joints().to_vec(),
            time,
            recording.locals().to_vec(),
            Vec::new(),
        )
        .unwrap()
    };
    let error = blend(&[(&times(&a, 1e6), 1.0), (&times(&b, 1e-6), 1.0)]).unwrap_err();
    assert!(matches!(error, RecordingError::TooLarge { .. }));
}

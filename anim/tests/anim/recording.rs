//! Recordings: what files say, in model space, and as clips and back.

use ga_anim::bvh;
use ga_anim::kinematics::KinematicsError;
use ga_anim::recording::{
    RecordedJoint, Recording, RecordingError, ScalarTrack, model_maps, model_motors,
};
use ga_anim::transform::Transform;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;
use glam::{DAffine3, DQuat, DVec3};
use nullcone_shared_data::shared;
use proptest::collection::vec;
use proptest::prelude::*;

/// Transforms as glam's parts: scale, rotation, translation.
type Parts = (DVec3, DQuat, DVec3);

fn parts() -> impl Strategy<Value = Parts> {
    let three = || proptest::array::uniform3(-2.0..2.0f64).prop_map(DVec3::from);
    (three(), three(), three())
        .prop_map(|(scale, turn, translation)| (scale, DQuat::from_scaled_axis(turn), translation))
}

fn transform((scale, q, translation): Parts) -> Transform<f64> {
    Transform::from_parts(
        Vector::from(translation.to_array()),
        Rotor::from_quaternion([q.x, q.y, q.z], q.w).unwrap(),
        Vector::from(scale.to_array()),
    )
}

fn affine((scale, rotation, translation): Parts) -> DAffine3 {
    DAffine3::from_scale_rotation_translation(scale, rotation, translation)
}

/// Each joint's parent is the one before it, or one further up.
fn parents(count: usize) -> Vec<Option<usize>> {
    (0..count)
        .map(|joint| (joint > 0).then(|| (joint - 1) / 2))
        .collect()
}

proptest! {
    #[test]
    fn transforms_are_those_of_matrices(parts in parts(), x in proptest::array::uniform3(-2.0..2.0f64)) {
        let ours = transform(parts);
        let truth = affine(parts).transform_point3(DVec3::from(x));
        let found = DVec3::from(ours.transform(Point::from(x)).coordinates());
        prop_assert!(found.distance(truth) < 1e-13);
        let mapped = DVec3::from(ours.to_affine().transform(Point::from(x)).coordinates());
        prop_assert!(mapped.distance(truth) < 1e-13);
    }

    #[test]
    fn interpolation_is_by_slerp_and_lerp(a in parts(), b in parts(), t in 0.0..1.0f64) {
        let found = transform(a).interpolate(&transform(b), t);
        let truth = affine((a.0.lerp(b.0, t), a.1.slerp(b.1, t), a.2.lerp(b.2, t)));
        let corner = DVec3::new(1.0, -2.0, 3.0);
        let image = DVec3::from(found.transform(Point::from(corner.to_array())).coordinates());
        // Near a half turn either arc may be taken.
        prop_assume!(a.1.dot(b.1).abs() > 1e-6);
        prop_assert!(image.distance(truth.transform_point3(corner)) < 1e-9);
    }

    #[test]
    fn model_space_is_the_product_of_matrices(all in vec(parts(), 1..12)) {
        let parents = parents(all.len());
        let locals: Vec<_> = all.iter().map(|&parts| transform(parts)).collect();
        let mut maps = vec![Affine::from_translation([0.0; 3]); all.len()];
        model_maps(&parents, &locals, &mut maps).unwrap();
        let mut truth: Vec<DAffine3> = Vec::new();
        for (&parts, parent) in all.iter().zip(&parents) {
            let above = parent.map_or(DAffine3::IDENTITY, |parent| truth[parent]);
            truth.push(above * affine(parts));
        }
        for (found, truth) in maps.iter().zip(truth) {
            let rows = truth.matrix3.transpose().to_cols_array_2d();
            for (found, truth) in found.linear.as_flattened().iter().zip(rows.as_flattened()) {
                prop_assert!((found - truth).abs() < 1e-11);
            }
            let place = DVec3::from(found.translation);
            prop_assert!(place.distance(truth.translation) < 1e-11);
        }
    }
}

#[test]
fn a_real_recording_is_in_model_space_where_its_file_says() {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let motion = bvh::read(path).unwrap();
    let unit = 0.056_444;
    let recording = Recording::from_bvh(&motion, unit).unwrap();
    assert_eq!(recording.frame_count(), motion.frame_count());
    let count = recording.joints().len();
    let mut motors = vec![Motor::default(); count];
    for frame in [0, 1, 1000, motion.frame_count() - 1] {
        model_motors(
            recording.parents(),
            recording.frame(frame).unwrap(),
            &mut motors,
        )
        .unwrap();
        let places = motion.joint_positions(frame).unwrap();
        for (motor, place) in motors.iter().zip(places) {
            let found = DVec3::from(motor.translator().displacement());
            assert!(found.distance(DVec3::from(place) * unit) < 1e-12);
        }
    }

    // The motions of the mesh's coordinates give the same places from those at rest.
    let (skeleton, clip) = (
        recording.to_skeleton().unwrap(),
        recording.to_clip().unwrap(),
    );
    let bones = clip.frames()[1000].bones(&skeleton).unwrap();
    for ([head, _], place) in bones.iter().zip(motion.joint_positions(1000).unwrap()) {
        assert!(DVec3::from(*head).distance(DVec3::from(place) * unit) < 1e-12);
    }
    // All rest frames of this file have the axes of the mesh.
    let back = Recording::from_clip(&skeleton, &clip).unwrap();
    for (a, b) in recording.locals().iter().zip(back.locals()) {
        let corner = Point::new(1.0, 2.0, 3.0);
        assert!(a.transform(corner).distance(b.transform(corner)) < 1e-12);
    }
}

fn joint(name: &str, parent: Option<usize>) -> RecordedJoint {
    let rest = Transform::default();
    let name = name.into();
    RecordedJoint { name, parent, rest }
}

#[test]
fn what_is_not_a_recording_is_an_error_that_names_the_element() {
    let joints = || vec![joint("hip", None), joint("knee", Some(0))];
    let still = |frames: usize| vec![Transform::default(); 2 * frames];
    let message = |joints, time, locals, tracks| {
        Recording::new(joints, time, locals, tracks)
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        message(vec![], 1.0, still(1), vec![]),
        "the recording has no joints"
    );
    assert_eq!(
        message(joints(), 1.0, vec![], vec![]),
        "the recording has no frames"
    );
    for time in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        let error = message(joints(), time, still(1), vec![]);
        assert_eq!(
            error,
            format!("{time} seconds is not a time from one frame to the next")
        );
    }
    assert_eq!(
        message(joints(), 1.0, still(2)[1..].to_vec(), vec![]),
        "3 transforms are not a whole number of frames of 2 joints"
    );
    assert_eq!(
        message(vec![joint("a", Some(0))], 1.0, still(1), vec![]),
        "joint \"a\" has joint 0 as its parent, which does not come before it"
    );
    let mut broken = still(2);
    broken[3].scale = Vector::new(1.0, f64::NAN, 1.0);
    assert_eq!(
        message(joints(), 1.0, broken, vec![]),
        "joint \"knee\" has no rigid motion or no finite factors in frame 1"
    );
    let mut broken = still(2);
    broken[2].motor = Motor::new_unchecked(2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    assert_eq!(
        message(joints(), 1.0, broken, vec![]),
        "joint \"hip\" has no rigid motion or no finite factors in frame 1"
    );
    let track = |values| {
        vec![ScalarTrack {
            name: "smile".into(),
            values,
        }]
    };
    assert_eq!(
        message(joints(), 1.0, still(2), track(vec![1.0])),
        "track \"smile\" has 1 numbers for 2 frames"
    );
    assert_eq!(
        message(joints(), 1.0, still(2), track(vec![1.0, f64::INFINITY])),
        "track \"smile\" is inf in frame 1"
    );
    let motion = bvh::decode(
        b"HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 1 Xrotation } MOTION Frames: 0 Frame Time: 1",
    );
    let motion = motion.unwrap();
    assert_eq!(
        Recording::from_bvh(&motion, 1.0),
        Err(RecordingError::NoFrames)
    );
    assert_eq!(
        Recording::from_bvh(&motion, 0.0),
        Err(RecordingError::Unit(0.0))
    );
}

#[test]
fn sampling_between_frames_and_beyond_the_ends() {
    let at = |x| Transform::from(Motor::from(Translator::from_displacement([x, 0.0, 0.0])));
    let track = ScalarTrack {
        name: "smile".into(),
        values: vec![0.0, 2.0, 4.0],
    };
    let recording = Recording::new(
        vec![joint("a", None)],
        0.5,
        vec![at(0.0), at(1.0), at(3.0)],
        vec![track],
    );
    let recording = recording.unwrap();
    let mut locals = [Transform::default()];
    for (time, x, smile) in [
        (-1.0, 0.0, 0.0),
        (f64::NAN, 0.0, 0.0),
        (0.25, 0.5, 1.0),
        (0.75, 2.0, 3.0),
        (9.0, 3.0, 4.0),
    ] {
        recording.sample(time, &mut locals).unwrap();
        assert_eq!(locals[0].translation().coordinates(), [x, 0.0, 0.0]);
        assert_eq!(recording.sample_track(0, time), Some(smile));
    }
    assert_eq!(recording.sample_track(1, 0.0), None);
    let error = recording.sample(0.0, &mut []).unwrap_err();
    assert_eq!(
        error,
        KinematicsError::SliceLength {
            expected: 1,
            found: 0
        }
    );
}

#[test]
fn model_space_refuses_what_does_not_fit() {
    let one = [Transform::<f64>::default()];
    let mut map = [Affine::from_translation([0.0; 3])];
    let length = KinematicsError::SliceLength {
        expected: 1,
        found: 0,
    };
    assert_eq!(model_maps(&[None], &[], &mut map), Err(length.clone()));
    assert_eq!(model_maps(&[None], &one, &mut []), Err(length));
    let order = KinematicsError::ParentNotBefore {
        joint: 0,
        parent: 0,
    };
    assert_eq!(model_maps(&[Some(0)], &one, &mut map), Err(order));
    let mut scaled = one;
    scaled[0].scale = Vector::new(1.0, 2.0, 1.0);
    let error = model_motors(&[None], &scaled, &mut [Motor::default()]);
    assert_eq!(error, Err(KinematicsError::Scaled { joint: 0 }));
}

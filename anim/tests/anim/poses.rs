//! Poses and clips: bones stay whole, in-betweens are the ones known in closed form.

use ga_anim::clip::{Clip, ClipError};
use ga_anim::pose::Pose;
use ga_anim::skeleton::{Joint, Skeleton, SkeletonError};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;

fn turn(axis: [f64; 3], angle: f64) -> Rotor<f64> {
    Rotor::from_axis_angle(axis, angle).unwrap()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    Point::from(a).distance(Point::from(b))
}

/// A tree of joints, each child at the tail of its parent, and a rotor for each.
fn posed_trees() -> impl Strategy<Value = (Skeleton, Vec<Rotor<f64>>, Motor<f64>)> {
    let joint = (
        any::<prop::sample::Index>(),
        uniform3(-1.0..1.0f64),
        uniform3(-1.0..1.0f64),
        -3.0..3.0f64,
    );
    let root = (uniform3(-2.0..2.0f64), uniform3(0.1..1.0f64), -3.0..3.0f64);
    (vec(joint, 1..12), root).prop_map(|(list, (shift, axis, angle))| {
        let mut joints: Vec<Joint> = Vec::new();
        let mut rotors = Vec::new();
        for (index, (parent, bone, axis, angle)) in list.into_iter().enumerate() {
            let parent = (index > 0).then(|| parent.index(index));
            let head = parent.map_or([0.0; 3], |parent| joints[parent].tail);
            let tail = std::array::from_fn(|i| head[i] + bone[i]);
            joints.push(Joint {
                name: format!("j{index}"),
                parent,
                head,
                tail,
            });
            rotors.push(Rotor::from_axis_angle(axis, angle).unwrap_or_default());
        }
        let root = Translator::from_displacement(shift) * turn(axis, angle);
        (Skeleton::new(joints).unwrap(), rotors, root)
    })
}

proptest! {
    #[test]
    fn bones_keep_their_lengths_and_hang_together((skeleton, rotors, root) in posed_trees()) {
        let bones = Pose::from_rotors(&skeleton, root, &rotors).unwrap().bones(&skeleton).unwrap();
        for (joint, bone) in skeleton.joints().iter().zip(&bones) {
            let length = distance(joint.head, joint.tail);
            prop_assert!((distance(bone[0], bone[1]) - length).abs() < 1e-13);
            if let Some(parent) = joint.parent {
                prop_assert!(distance(bones[parent][1], bone[0]) < 1e-13);
            }
        }
    }

    #[test]
    fn the_line_of_a_bone_goes_from_its_head_to_its_tail((skeleton, rotors, root) in posed_trees()) {
        let pose = Pose::from_rotors(&skeleton, root, &rotors).unwrap();
        let bones = pose.bones(&skeleton).unwrap();
        for (line, [head, tail]) in pose.bone_lines(&skeleton).unwrap().into_iter().zip(bones) {
            let direction = line.unwrap().direction();
            for axis in 0..3 {
                prop_assert!((direction[axis] - (tail[axis] - head[axis])).abs() < 1e-13);
            }
        }
    }

    /// By matrices, apart from any motor: x' = h + R (x − h) from the bone up to the root.
    #[test]
    fn motions_are_those_of_matrices((skeleton, rotors, root) in posed_trees()) {
        let motions = Pose::from_rotors(&skeleton, root, &rotors).unwrap().motions(&skeleton).unwrap();
        for (index, motion) in motions.into_iter().enumerate() {
            let mut place = skeleton.joints()[index].tail;
            let ours = motion.transform(Point::from(place)).coordinates();
            let mut above = Some(index);
            while let Some(joint) = above {
                let Joint { head, parent, .. } = &skeleton.joints()[joint];
                let matrix = Motor::from(rotors[joint]).to_matrix();
                let from_head: [f64; 3] = std::array::from_fn(|i| place[i] - head[i]);
                place = std::array::from_fn(|i| head[i] + (0..3).map(|k| matrix[i][k] * from_head[k]).sum::<f64>());
                above = *parent;
            }
            let matrix = root.to_matrix();
            place = std::array::from_fn(|i| matrix[i][3] + (0..3).map(|k| matrix[i][k] * place[k]).sum::<f64>());
            prop_assert!(distance(ours, place) < 1e-12);
        }
    }

    #[test]
    fn in_betweens_keep_bones_whole(
        (skeleton, rotors, root) in posed_trees(),
        part in 0.0..1.0f64,
    ) {
        let rest = Pose::rest(skeleton.len());
        let pose = Pose::from_rotors(&skeleton, root, &rotors).unwrap();
        let between = rest.interpolate(&pose, part);
        for (joint, bone) in skeleton.joints().iter().zip(between.bones(&skeleton).unwrap()) {
            prop_assert!((distance(bone[0], bone[1]) - distance(joint.head, joint.tail)).abs() < 1e-13);
        }
        // A joint turns about its own place by a part of its angle.
        for (joint, (own, rotor)) in skeleton.joints().iter().zip(between.joints.iter().zip(&rotors)) {
            let fixed = own.transform(Point::from(joint.head)).coordinates();
            prop_assert!(distance(fixed, joint.head) < 1e-12);
            let cosine = own.scalar().abs().min(1.0);
            let whole = 2.0 * rotor.scalar().abs().min(1.0).acos();
            prop_assert!((2.0 * cosine.acos() - part * whole).abs() < 1e-6);
        }
    }

    #[test]
    fn a_sample_at_a_frame_is_that_frame(angles in vec(-3.0..3.0f64, 1..10), rate in 1.0..100.0f64) {
        let pose = |&angle: &f64| Pose { root: Motor::from(turn([0.0, 0.0, 1.0], angle)), joints: vec![] };
        let frames: Vec<Pose> = angles.iter().map(pose).collect();
        let clip = Clip::new(1.0 / rate, frames.clone()).unwrap();
        for (index, frame) in frames.iter().enumerate() {
            let sample = clip.sample(index as f64 * clip.frame_time());
            prop_assert!(distance(
                sample.root.transform(Point::new(1.0, 0.0, 0.0)).coordinates(),
                frame.root.transform(Point::new(1.0, 0.0, 0.0)).coordinates(),
            ) < 1e-12);
        }
    }
}

#[test]
fn the_root_moves_along_a_helix() {
    let angle = 2.0;
    let root = Translator::from_displacement([0.0, 0.0, 3.0]) * turn([0.0, 0.0, 1.0], angle);
    let there = Pose {
        root,
        joints: vec![],
    };
    let clip = Clip::new(0.5, vec![Pose::rest(0), there]).unwrap();
    for step in 0..=20 {
        let t = f64::from(step) / 20.0;
        let place = clip
            .sample(0.5 * t)
            .root
            .transform(Point::new(1.0, 0.0, 0.0))
            .coordinates();
        let helix = [(angle * t).cos(), (angle * t).sin(), 3.0 * t];
        assert!(
            distance(place, helix) < 1e-13,
            "{place:?} instead of {helix:?}"
        );
    }
}

#[test]
fn turns_take_the_shorter_way() {
    let at = |degrees: f64| {
        let root = Motor::from(turn([0.0, 1.0, 0.0], degrees.to_radians()));
        Pose {
            root,
            joints: vec![],
        }
    };
    let between = at(170.0).interpolate(&at(-170.0), 0.5);
    let place = between
        .root
        .transform(Point::new(1.0, 0.0, 0.0))
        .coordinates();
    assert!(distance(place, [-1.0, 0.0, 0.0]) < 1e-14);
}

#[test]
fn before_and_after_a_clip_stand_its_ends() {
    let shifted = |x| Pose {
        root: Motor::from(Translator::from_displacement([x, 0.0, 0.0])),
        joints: vec![],
    };
    let clip = Clip::new(0.1, vec![shifted(1.0), shifted(2.0), shifted(3.0)]).unwrap();
    for (time, expected) in [
        (-5.0, 1.0),
        (f64::NAN, 1.0),
        (0.2, 3.0),
        (9.0, 3.0),
        (f64::INFINITY, 3.0),
    ] {
        let place = clip
            .sample(time)
            .root
            .transform(Point::new(0.0, 0.0, 0.0))
            .coordinates();
        assert!((place[0] - expected).abs() < 1e-12, "at {time}");
    }
}

#[test]
fn resampling_keeps_the_motion_and_reaches_the_end() {
    let shifted = |x| Pose {
        root: Motor::from(Translator::from_displacement([x, 0.0, 0.0])),
        joints: vec![],
    };
    let clip = Clip::new(
        1.0 / 120.0,
        (0..=120).map(|i| shifted(f64::from(i))).collect(),
    )
    .unwrap();
    for rate in [10.0, 24.0, 25.0, 30.0, 60.0, 120.0, 240.0, 7.0] {
        let resampled = clip.resampled(rate).unwrap();
        assert_eq!(resampled.frames().len(), rate as usize + 1, "{rate}");
        for (index, frame) in resampled.frames().iter().enumerate() {
            let x = frame
                .root
                .transform(Point::new(0.0, 0.0, 0.0))
                .coordinates()[0];
            assert!((x - 120.0 * index as f64 / rate).abs() < 1e-9);
        }
    }
    // 7 × (1/24) × 24 is less than 7 by rounding.
    let clip = Clip::new(1.0 / 24.0, vec![Pose::rest(0); 8]).unwrap();
    assert_eq!(clip.resampled(24.0).unwrap().frames().len(), 8);
    for rate in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e12] {
        assert!(matches!(clip.resampled(rate), Err(ClipError::Rate(_))));
    }
}

#[test]
fn what_is_no_clip_pose_or_skeleton_is_an_error() {
    assert_eq!(Clip::new(0.1, vec![]), Err(ClipError::Empty));
    for time in [0.0, -0.1, f64::INFINITY] {
        assert_eq!(
            Clip::new(time, vec![Pose::rest(1)]),
            Err(ClipError::FrameTime(time))
        );
    }
    assert_eq!(
        Clip::new(0.1, vec![Pose::rest(1), Pose::rest(2)]),
        Err(ClipError::JointCount {
            frame: 1,
            expected: 1,
            found: 2
        })
    );

    let joint = |name: &str, parent| Joint {
        name: name.into(),
        parent,
        head: [0.0; 3],
        tail: [0.0; 3],
    };
    assert_eq!(Skeleton::new(vec![]), Err(SkeletonError::Empty));
    for parent in [0, 1, 7] {
        let error = SkeletonError::ParentNotBefore {
            name: "a".into(),
            parent,
        };
        assert_eq!(
            Skeleton::new(vec![joint("a", Some(parent)), joint("b", None)]),
            Err(error)
        );
    }
    let error = SkeletonError::DuplicateName { name: "a".into() };
    assert_eq!(
        Skeleton::new(vec![joint("a", None), joint("a", None)]),
        Err(error)
    );
    let far = Joint {
        tail: [0.0, f64::NAN, 0.0],
        ..joint("a", None)
    };
    assert!(matches!(
        Skeleton::new(vec![far]),
        Err(SkeletonError::NotFinite { .. })
    ));

    let one = Skeleton::new(vec![joint("a", None)]).unwrap();
    assert_eq!(
        Pose::rest(2).motions(&one),
        Err(SkeletonError::PoseLength {
            expected: 1,
            found: 2
        })
    );
    assert_eq!(Pose::rest(1).bone_lines(&one), Ok(vec![None]));
}

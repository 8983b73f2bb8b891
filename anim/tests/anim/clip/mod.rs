//! Layers, additive clips, cross-fades, root motion, mirror images, uneven clocks and events.

mod mirror;
mod timing;

use ga_anim::clip::{
    Clip, ClipError, EventTrack, GroundMotion, Layer, Mirror, RootMotion, TimeWarp, overlay,
};
use ga_anim::pose::Pose;
use ga_anim::recording::RecordingError;
use ga_anim::skeleton::{Joint, Skeleton};
use ga_runtime::cga3::{DualPlane, Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;
use glam::{DMat3, DQuat, DVec3};
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;

/// A body with two legs; its mirror image in the plane x = 0.1 is itself, but for one foot.
fn body() -> Skeleton {
    let joint = |name: &str, parent, head: [f64; 3]| Joint {
        name: name.into(),
        parent,
        head,
        tail: [head[0], head[1] - 0.4, head[2]],
    };
    let side = |x: f64| 0.1 + x;
    Skeleton::new(vec![
        joint("Hips", None, [side(0.0), 1.0, 0.1]),
        joint("LeftUpLeg", Some(0), [side(0.2), 0.9, 0.0]),
        joint("LeftFoot", Some(1), [side(0.25), 0.1, 0.05]),
        joint("RightUpLeg", Some(0), [side(-0.2), 0.9, 0.0]),
        joint("RightFoot", Some(3), [side(-0.22), 0.13, 0.0]),
    ])
    .unwrap()
}

const PAIRS: [(usize, usize); 2] = [(1, 3), (2, 4)];

fn mirror_plane() -> DualPlane<f64> {
    // Of another weight than 1.
    DualPlane::new(-2.0, 0.0, 0.0, -0.2)
}

fn rotor() -> impl Strategy<Value = Rotor<f64>> {
    (uniform3(-1.0..1.0_f64), -3.0..3.0_f64)
        .prop_map(|(axis, angle)| Rotor::from_axis_angle(axis, angle).unwrap_or_default())
}

fn motor() -> impl Strategy<Value = Motor<f64>> {
    (rotor(), uniform3(-2.0..2.0_f64))
        .prop_map(|(rotor, t)| Translator::from_displacement(t) * rotor)
}

fn poses(count: usize) -> impl Strategy<Value = Vec<Pose>> {
    let pose = (motor(), vec(rotor(), 5))
        .prop_map(|(root, rotors)| Pose::from_rotors(&body(), root, &rotors).unwrap());
    vec(pose, count)
}

/// How far points of a unit cube go apart under two motions.
fn apart(a: Motor<f64>, b: Motor<f64>) -> f64 {
    let corners = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
    ];
    corners
        .map(|corner| {
            let [p, q] = [a, b].map(|motor| motor.transform(Point::from(corner)));
            p.distance(q)
        })
        .into_iter()
        .fold(0.0, f64::max)
}

#[track_caller]
fn assert_same(a: &Pose, b: &Pose, bound: f64) {
    assert_eq!(a.joints.len(), b.joints.len());
    assert!(
        apart(a.root, b.root) <= bound,
        "root: {:e}",
        apart(a.root, b.root)
    );
    for (joint, (&a, &b)) in a.joints.iter().zip(&b.joints).enumerate() {
        assert!(apart(a, b) <= bound, "joint {joint}: {:e}", apart(a, b));
    }
}

/// A skeleton of which only the names and the parents count.
fn named(joints: &[(&str, Option<usize>)]) -> Skeleton {
    let joint = |&(name, parent): &(&str, _)| Joint {
        name: name.to_owned(),
        parent,
        head: [0.0; 3],
        tail: [0.0; 3],
    };
    Skeleton::new(joints.iter().map(joint).collect()).unwrap()
}

/// A quaternion of glam.
fn quaternion(motor: Motor<f64>) -> DQuat {
    let rows = motor.rotor().to_matrix();
    DQuat::from_mat3(&DMat3::from_cols_array_2d(&rows).transpose())
}

proptest! {
    #[test]
    fn a_layer_replaces_nothing_or_all(list in poses(3), factors in vec(0.0..=1.0_f64, 5)) {
        let [below, first, second] = [0, 1, 2].map(|i| &list[i]);
        let mut pose = below.clone();
        let none = [Layer::new(first, 0.0), Layer::new(second, 1.0).of_joints(&[0.0; 5])];
        overlay(&mut pose, &none).unwrap();
        prop_assert_eq!(&pose, below);
        overlay(&mut pose, &[Layer::new(second, 0.4), Layer::new(first, 1.0)]).unwrap();
        prop_assert_eq!(&pose, first);

        // Rotations are the normalised sums of glam's quaternions.
        let mut pose = below.clone();
        overlay(&mut pose, &[Layer::new(first, 0.75).of_joints(&factors)]).unwrap();
        prop_assert_eq!(pose.root, below.root);
        for (joint, factor) in factors.iter().enumerate() {
            let [a, b] = [below, first].map(|pose| quaternion(pose.joints[joint]));
            // Half a turn apart either way is right.
            if a.dot(b).abs() > 1e-3 {
                let expected = a.lerp(b, 0.75 * factor);
                let found = quaternion(pose.joints[joint]);
                prop_assert!(found.dot(expected).abs() > 1.0 - 1e-12);
            }
        }
    }

    #[test]
    fn the_mean_of_equal_weights_is_half_of_the_screw(list in poses(2)) {
        let mut pose = list[0].clone();
        overlay(&mut pose, &[Layer::new(&list[1], 0.5)]).unwrap();
        let near = |a: Motor<f64>, b: Motor<f64>| quaternion(a).dot(quaternion(b)).abs() > 0.1;
        let pairs = || list[0].joints.iter().zip(&list[1].joints);
        // Rotated by 180° against each other, poses have two means.
        prop_assume!(pairs().all(|(&a, &b)| near(a, b)) && near(list[0].root, list[1].root));
        assert_same(&pose, &list[0].interpolate(&list[1], 0.5), 1e-12);
    }

    #[test]
    fn an_added_difference_restores_the_pose(list in poses(4), weight in -1.0..2.0_f64) {
        let clip = Clip::new(0.1, list[..3].to_vec()).unwrap();
        let differences = clip.difference(&list[3]).unwrap();
        let still = Clip::new(0.1, vec![list[3].clone(); 3]).unwrap();
        let restored = still.added(&differences, 1.0).unwrap();
        for (a, b) in restored.frames().iter().zip(clip.frames()) {
            assert_same(a, b, 1e-12);
        }
        let unchanged = clip.added(&differences, 0.0).unwrap();
        for (a, b) in unchanged.frames().iter().zip(clip.frames()) {
            assert_same(a, b, 1e-12);
        }
        // Adding and taking away again.
        let there = list[0].added(&differences.frames()[1], weight);
        assert_same(&there.added(&differences.frames()[1], -weight), &list[0], 1e-11);
    }

    #[test]
    fn a_mirror_image_of_a_mirror_image_is_the_pose(list in poses(2)) {
        let mirror = Mirror::by_names(&body(), mirror_plane()).unwrap();
        prop_assert_eq!(mirror.counterparts().collect::<Vec<_>>(), [0, 3, 4, 1, 2]);
        prop_assert_eq!(&mirror, &Mirror::by_pairs(&body(), mirror_plane(), &PAIRS).unwrap());
        let clip = Clip::new(0.5, list).unwrap();
        let twice = mirror.clip(&mirror.clip(&clip).unwrap()).unwrap();
        for (a, b) in twice.frames().iter().zip(clip.frames()) {
            assert_same(a, b, 1e-12);
        }
        // Bones of the upper legs, which are symmetric at rest, are where the mirror shows them.
        for pose in clip.frames() {
            let bones = pose.bones(&body()).unwrap();
            let images = mirror.pose(pose).unwrap().bones(&body()).unwrap();
            for (joint, other) in [(0, 0), (1, 3), (3, 1)] {
                for end in 0..2 {
                    let [x, y, z] = bones[joint][end];
                    let found = Point::from(images[other][end]);
                    prop_assert!(found.distance(Point::new(0.2 - x, y, z)) < 1e-12);
                }
            }
            // The feet keep the length of their own legs.
            let [hip, foot] = [images[3][0], images[4][0]].map(Point::from);
            let joints = body();
            let rest = [3, 4].map(|joint| Point::from(joints.joints()[joint].head));
            prop_assert!((hip.distance(foot) - rest[0].distance(rest[1])).abs() < 1e-12);
        }
    }

    #[test]
    fn root_motion_goes_over_the_ground_and_is_restored(
        list in poses(4),
        joint in 0..5_usize,
        up in uniform3(-1.0..1.0_f64),
        rotation: bool,
    ) {
        let up = Vector::from(up) + Vector::new(0.0, 0.0, 1.5);
        let clip = Clip::new(0.25, list).unwrap();
        let ground = GroundMotion { joint, up, rotation };
        let (motion, in_place) = clip.root_motion(&body(), ground).unwrap();
        let restored = in_place.with_root_motion(&motion).unwrap();
        for (a, b) in restored.frames().iter().zip(clip.frames()) {
            assert_same(a, b, 1e-12);
        }
        let unit = up * up.length().recip();
        let head = Point::from(body().joints()[joint].head);
        for (&way, pose) in motion.motions().iter().zip(in_place.frames()) {
            // The vertical and the height stay.
            let direction = Vector::from(way.transform(Point::from(unit.coordinates())))
                - Vector::from(way.transform(Point::new(0.0, 0.0, 0.0)));
            prop_assert!(direction.distance(unit) < 1e-12);
            let step = Vector::from(way.transform(head)) - Vector::from(head);
            prop_assert!(step.dot(unit).abs() < 1e-12);
            // In place the joint is above where it is at rest, and does not turn.
            let total = pose.motions(&body()).unwrap()[joint];
            let moved = Vector::from(total.transform(head)) - Vector::from(head);
            prop_assert!((moved - unit * moved.dot(unit)).length() < 1e-12);
            if rotation {
                let q = quaternion(total);
                prop_assert!(DVec3::new(q.x, q.y, q.z).dot(DVec3::from(unit.coordinates())).abs() < 1e-9);
            }
        }
        let twice = motion.between(0.0, 0.5) * motion.between(0.5, 0.75);
        prop_assert!(apart(twice, motion.whole()) < 1e-12);
    }

    #[test]
    fn an_uneven_clock_rises_and_is_inverted(
        gaps in vec((0.01..2.0_f64, 0.01..2.0_f64), 2..8),
        part in 0.0..=1.0_f64,
    ) {
        let mut sum = [1.0, -2.0];
        let (seen, clip): (Vec<f64>, Vec<f64>) = gaps.iter().map(|&(a, b)| {
            sum = [sum[0] + a, sum[1] + b];
            (sum[0], sum[1])
        }).unzip();
        let warp = TimeWarp::through(&seen, &clip).unwrap();
        let (start, last) = (seen[0], seen[seen.len() - 1]);
        let mut before = f64::NEG_INFINITY;
        for step in 0..=200 {
            let time = warp.clip_time(start + (last - start) * f64::from(step) / 200.0);
            prop_assert!(time >= before - 1e-14);
            before = time;
        }
        for (&seen, &clip) in seen.iter().zip(&clip) {
            prop_assert_eq!(warp.clip_time(seen), clip);
        }
        let time = clip[0] + part * (clip[clip.len() - 1] - clip[0]);
        prop_assert!((warp.clip_time(warp.seen_at(time)) - time).abs() < 1e-12);
    }

    #[test]
    fn a_loop_has_each_event_once_in_each_repetition(
        times in vec(0.0..2.0_f64, 0..6),
        cuts in vec(0.0..1.5_f64, 1..6),
    ) {
        let events = EventTrack::new(times.iter().map(|&t| (t, t)).collect()).unwrap();
        let mut from = -3.1;
        let mut found = Vec::new();
        for cut in cuts {
            found.extend(events.in_loop(2.0, from, from + cut).map(|(time, _)| time));
            from += cut;
        }
        let mut expected: Vec<f64> = (-3..4)
            .flat_map(|turn| times.iter().map(move |t| f64::from(turn) * 2.0 + t))
            .filter(|&time| -3.1 < time && time <= from)
            .collect();
        expected.sort_by(f64::total_cmp);
        prop_assert_eq!(found, expected);
    }

    /// Multiples of the period, which are rounded, are the ends of intervals here.
    #[test]
    fn a_loop_has_events_at_its_begin_once_in_each_repetition(
        period in 0.01..10.0_f64,
        first in 0..2000_i32,
        count in 1..20_i32,
    ) {
        let events = EventTrack::new(vec![(0.0, ())]).unwrap();
        let ends = |n: i32| [n, n + 1].map(|n| f64::from(n) * period);
        for n in first..first + count {
            let [from, to] = ends(n);
            let found: Vec<f64> = events.in_loop(period, from, to).map(|(time, _)| time).collect();
            prop_assert_eq!(found, [to]);
        }
    }
}

fn at(x: f64) -> Pose {
    let mut pose = Pose::rest(1);
    pose.root = Motor::from(Translator::from_displacement([x, 0.0, 0.0]));
    pose
}

fn x(pose: &Pose) -> f64 {
    pose.root.translator().displacement()[0]
}

#[test]
fn what_does_not_fit_is_said() {
    let (one, two) = (Pose::rest(1), Pose::rest(2));
    let mut pose = two.clone();
    let error = overlay(&mut pose, &[Layer::new(&two, 1.0), Layer::new(&one, 0.5)]).unwrap_err();
    assert_eq!(
        error,
        ClipError::LayerJointCount {
            layer: 1,
            expected: 2,
            found: 1
        }
    );
    let error = overlay(&mut pose, &[Layer::new(&two, 1.0).of_joints(&[1.0])]).unwrap_err();
    assert_eq!(
        error,
        ClipError::LayerWeightCount {
            layer: 0,
            expected: 2,
            found: 1
        }
    );
    for weight in [-0.1, 1.1, f64::INFINITY] {
        let error = overlay(&mut pose, &[Layer::new(&two, weight)]).unwrap_err();
        assert_eq!(error, ClipError::LayerWeight { layer: 0, weight });
    }
    assert!(overlay(&mut pose, &[Layer::new(&two, f64::NAN)]).is_err());
    assert_eq!(pose, two);

    let clip = Clip::new(1.0, vec![one.clone()]).unwrap();
    assert!(matches!(
        clip.difference(&two),
        Err(ClipError::JointCount { .. })
    ));
    let mirror = Mirror::by_names(&body(), mirror_plane()).unwrap();
    assert!(matches!(
        mirror.clip(&clip),
        Err(ClipError::JointCount { .. })
    ));

    let by_pairs = |pairs: &[(usize, usize)]| Mirror::by_pairs(&body(), mirror_plane(), pairs);
    assert_eq!(
        by_pairs(&[(1, 5)]),
        Err(RecordingError::MirrorNoJoint { joint: 5, count: 5 })
    );
    let twice = RecordingError::PairedTwice {
        name: "LeftUpLeg".into(),
    };
    assert_eq!(by_pairs(&[(1, 3), (1, 2)]), Err(twice));
    let parents = RecordingError::PairParents {
        name: "LeftFoot".into(),
        other: "RightFoot".into(),
    };
    assert_eq!(by_pairs(&[(2, 4)]), Err(parents));
    let plane = DualPlane::new(0.0, 0.0, 0.0, 1.0);
    assert_eq!(
        Mirror::by_names(&body(), plane),
        Err(RecordingError::MirrorPlane)
    );
    let mut joints = body().joints().to_vec();
    joints[4].name = "RightToe".into();
    let lone = Mirror::by_names(&Skeleton::new(joints).unwrap(), mirror_plane()).unwrap_err();
    assert_eq!(
        lone.to_string(),
        "joint \"LeftFoot\" has no counterpart \"RightFoot\""
    );

    let walk = Clip::new(1.0, vec![Pose::rest(5)]).unwrap();
    let of = |joint, up: [f64; 3]| {
        let ground = GroundMotion {
            joint,
            up: up.into(),
            rotation: true,
        };
        walk.root_motion(&body(), ground).map(|_| ())
    };
    assert_eq!(
        of(5, [0.0, 1.0, 0.0]),
        Err(ClipError::NoJoint { joint: 5, count: 5 })
    );
    assert_eq!(of(0, [0.0; 3]), Err(ClipError::Up([0.0; 3])));
    assert!(clip.root_motion(&body(), GroundMotion::default()).is_err());
    let way = RootMotion::new(1.0, vec![Motor::default(); 2]).unwrap();
    let error = walk.with_root_motion(&way).unwrap_err();
    assert_eq!(
        error,
        ClipError::MotionCount {
            expected: 1,
            found: 2
        }
    );
    assert_eq!(RootMotion::new(1.0, Vec::new()), Err(ClipError::Empty));
    assert_eq!(
        RootMotion::new(0.0, vec![Motor::default()]),
        Err(ClipError::FrameTime(0.0))
    );
}

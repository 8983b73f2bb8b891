//! Retargeting: made bodies whose motion is known.

#![allow(clippy::unwrap_used, reason = "a test may panic")]
use ga_anim::bvh::{self, Bvh};
use ga_anim::recording::RecordingError;
use ga_anim::retarget::{Alignment, BodyProblem, JointMap, Options, Retarget, Soles, UpAxis};
use ga_anim::skeleton::{Joint, Skeleton, SkeletonError};
use ga_anim::skin::SkinError;
use ga_anim::weights::SkinWeights;
use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_runtime::vga3::Vector;
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;

/// Name, parent and place of the joints of a body that stands with its arms out; an end of a limb
/// is a joint too.
const BODY: [(&str, Option<usize>, [f64; 3]); 17] = [
    ("hips", None, [0.0, 10.0, 0.0]),
    ("chest", Some(0), [0.0, 14.0, 0.2]),
    ("head", Some(1), [0.0, 17.0, 0.0]),
    ("upper arm l", Some(1), [2.0, 15.0, 0.0]),
    ("forearm l", Some(3), [5.0, 15.0, 0.0]),
    ("hand l", Some(4), [8.0, 15.0, 0.0]),
    ("finger l", Some(5), [9.0, 15.0, 0.2]),
    ("thigh l", Some(0), [1.0, 9.5, 0.0]),
    ("shin l", Some(7), [1.2, 5.0, 0.1]),
    ("foot l", Some(8), [1.3, 0.7, 0.0]),
    ("toes l", Some(9), [1.4, 0.2, 1.5]),
    ("thigh r", Some(0), [-1.0, 9.5, 0.0]),
    ("shin r", Some(11), [-1.2, 5.0, 0.1]),
    ("foot r", Some(12), [-1.3, 0.7, 0.0]),
    ("toes r", Some(13), [-1.4, 0.2, 1.5]),
    ("upper arm r", Some(1), [-2.0, 15.0, 0.0]),
    ("forearm r", Some(15), [-5.0, 15.0, 0.0]),
];

/// The motions here are random, so that they do not show a vertical.
fn upright() -> Options<'static> {
    Options {
        up: Some(UpAxis::Y),
        ..Options::default()
    }
}

/// The vector from one place to another.
fn between(from: [f64; 3], to: [f64; 3]) -> Vector<f64> {
    Vector::from(to) - Vector::from(from)
}

/// The body as a recording: the root has a place and all joints have three angles, in an order that
/// differs from joint to joint.
fn recording(frames: &[Vec<f64>]) -> Bvh {
    fn joint(index: usize, text: &mut String) {
        let (name, parent, place) = BODY[index];
        let above = parent.map_or([0.0; 3], |parent| BODY[parent].2);
        let [x, y, z] = between(above, place).coordinates();
        let order = [
            "Zrotation Yrotation Xrotation",
            "Xrotation Yrotation Zrotation",
            "Yrotation Zrotation Xrotation",
        ];
        let angles = order[index % 3];
        let (keyword, channels) = match parent {
            None => ("ROOT", format!("6 Xposition Yposition Zposition {angles}")),
            Some(_) => ("JOINT", format!("3 {angles}")),
        };
        *text += &format!("{keyword} {name}\n{{\nOFFSET {x} {y} {z}\nCHANNELS {channels}\n");
        for child in (0..BODY.len()).filter(|&child| BODY[child].1 == Some(index)) {
            joint(child, text);
        }
        *text += "}\n";
    }
    let mut text = "HIERARCHY\n".to_owned();
    joint(0, &mut text);
    text += &format!("MOTION\nFrames: {}\nFrame Time: 0.1\n", frames.len());
    for frame in frames {
        text += &frame
            .iter()
            .map(f64::to_string)
            .collect::<Vec<_>>()
            .join(" ");
        text.push('\n');
    }
    bvh::decode(text.as_bytes()).unwrap()
}

/// The body as a skeleton of another size, each joint moved at rest by `place`.
fn skeleton(scale: f64, place: impl Fn(&str, [f64; 3]) -> [f64; 3]) -> Skeleton {
    let at = |index: usize| place(BODY[index].0, BODY[index].2).map(|x| x * scale);
    let joints = BODY.iter().enumerate().map(|(index, &(name, parent, _))| {
        let child = (0..BODY.len()).find(|&child| BODY[child].1 == Some(index));
        let head = at(index);
        Joint {
            name: name.into(),
            parent,
            head,
            tail: child.map_or(head, at),
        }
    });
    Skeleton::new(joints.collect()).unwrap()
}

/// The head is in the same direction from the hips, or as near to it as the chest reaches.
fn is_trunk_alike(pairs: &[[[f64; 3]; 2]]) -> Result<(), TestCaseError> {
    let [ours, there] = [0, 1].map(|k| between(pairs[0][k], pairs[2][k]));
    let [hips, chest] = [(0, 1), (1, 2)].map(|(a, b)| between(pairs[a][0], pairs[b][0]));
    let across = hips.reject(there).unwrap().length();
    let reach = (chest.length_squared() - across * across).sqrt();
    if hips.dot(there) / there.length() + reach > 1e-3 {
        let angle = ours.angle(there).unwrap();
        prop_assert!(angle < 1e-7, "{angle}");
    }
    Ok(())
}

fn frames() -> impl Strategy<Value = Vec<Vec<f64>>> {
    let frame = (
        vec(-20.0..20.0f64, 3),
        vec(-170.0..170.0f64, 3 * BODY.len()),
    )
        .prop_map(|(place, angles)| [place, angles].concat());
    vec(frame, 1..6)
}

/// The heads of the joints of the target in a frame, and where the source has them, in units of the
/// target.
fn both(retarget: &Retarget, source: &Bvh, target: &Skeleton, frame: usize) -> Vec<[[f64; 3]; 2]> {
    let bones = retarget.pose(frame).unwrap().bones(target).unwrap();
    let places = source.joint_positions(frame).unwrap();
    let joints = target.joints().iter().zip(bones);
    joints
        .map(|(joint, [head, _])| {
            let index = source.index(&joint.name).unwrap();
            [head, places[index].map(|x| x * retarget.scale())]
        })
        .collect()
}

/// All heads are where the source has them, but for one height. The body is 17 high. Where the way
/// from the chest to the head is square to that from the hips to the head, the rotation that brings
/// the head there is a square root of zero, so that rounding is divided by the way along it.
fn same_places(pairs: &[[[f64; 3]; 2]]) -> Result<(), TestCaseError> {
    let lift = pairs[0][0][1] - pairs[0][1][1];
    let [hips, chest, head] = [0, 1, 2].map(|joint| pairs[joint][1]);
    let trunk = between(hips, head).normalized().unwrap();
    let along = between(chest, head).dot(trunk).abs();
    let within = 1e-12 + 1e-13 / along;
    for [ours, there] in pairs {
        let lifted = [there[0], there[1] + lift, there[2]];
        prop_assert!(
            between(*ours, lifted).length() < within,
            "{ours:?} instead of {lifted:?}"
        );
    }
    Ok(())
}

proptest! {
    #[test]
    fn a_body_alike_but_for_size_moves_alike(frames in frames(), size in 0.01..10.0f64) {
        let (source, target) = (recording(&frames), skeleton(size, |_, place| place));
        let retarget = Retarget::new(&source, &target, &upright()).unwrap();
        prop_assert!((retarget.scale() - size).abs() < 1e-12 * size);
        for frame in 0..frames.len() {
            let pairs: Vec<_> = both(&retarget, &source, &target, frame);
            same_places(&pairs.iter().map(|pair| pair.map(|x| x.map(|x| x / size))).collect::<Vec<_>>())?;
        }
    }

    /// A limb as a whole rotated square to its first bone at rest: what hangs on it goes with it,
    /// and nothing rolls. Only toes do not, since a rotated foot does not stand on its sole.
    #[test]
    fn a_limb_held_otherwise_at_rest_makes_no_difference(
        frames in frames(),
        (top, limb) in prop::sample::select(vec![(3, 4..7), (7, 8..11), (11, 12..15)]),
        across in uniform3(-1.0..1.0f64),
        angle in -0.8..0.8f64,
    ) {
        let joint = BODY[top].2;
        let axis = between(joint, BODY[top + 1].2).cross(across.into());
        prop_assume!(axis.length() > 0.1);
        let rotor = Rotor::from_axis_angle(axis.coordinates(), angle).unwrap();
        let turn = Motor::about(joint.into(), rotor);
        let target = skeleton(1.0, |name, place| {
            let turned = BODY[limb.clone()].iter().any(|joint| joint.0 == name);
            if turned { turn.transform(Point::from(place)).coordinates() } else { place }
        });
        let source = recording(&frames);
        let retarget = Retarget::new(&source, &target, &upright()).unwrap();
        for frame in 0..frames.len() {
            let mut pairs = both(&retarget, &source, &target, frame);
            // The toes lie flat, whatever the direction of the leg at rest.
            if top != 3 {
                pairs.remove(limb.end - 1);
            }
            same_places(&pairs)?;
        }
    }

    /// Other directions and lengths of limbs at rest: long bones point as the source's do, and the
    /// trunk turns as it does.
    #[test]
    fn long_bones_point_alike_and_the_rest_turns_alike(
        frames in frames(),
        nudges in vec(-0.4..0.4f64, 3 * BODY.len()),
    ) {
        let target = skeleton(1.0, |name, place| {
            let index = BODY.iter().position(|joint| joint.0 == name).unwrap();
            let nudged = std::array::from_fn(|axis| place[axis] + nudges[3 * index + axis]);
            match name {
                "hips" | "chest" | "head" => [place[0], nudged[1], nudged[2]],
                "foot l" | "foot r" | "toes l" | "toes r" => [nudged[0], place[1], nudged[2]],
                _ => nudged,
            }
        });
        let source = recording(&frames);
        let retarget = Retarget::new(&source, &target, &upright()).unwrap();
        for frame in 0..frames.len() {
            let pairs = both(&retarget, &source, &target, frame);
            for (from, to) in [(3, 4), (4, 5), (7, 8), (8, 9), (11, 12), (12, 13), (15, 16)] {
                let [ours, there] = [0, 1].map(|k| between(pairs[from][k], pairs[to][k]));
                let [ours, there] = [ours, there].map(|bone| bone.normalized().unwrap());
                prop_assert!(ours.distance(there) < 1e-12);
            }
            let motions = retarget.pose(frame).unwrap().motions(&target).unwrap();
            let turned = source.frames_of_joints(frame).unwrap();
            is_trunk_alike(&pairs)?;
            for name in ["hips", "head"] {
                let ours = motions[target.index(name).unwrap()].to_matrix();
                let there = turned[source.index(name).unwrap()].to_matrix();
                for row in 0..3 {
                    for column in 0..3 {
                        prop_assert!((ours[row][column] - there[row][column]).abs() < 1e-12);
                    }
                }
            }
        }
    }
}

proptest! {
    /// With every bone aligned, those of the trunk, the hands and the feet point alike too.
    #[test]
    fn every_matched_bone_points_alike(
        frames in frames(),
        nudges in vec(-0.4..0.4f64, 3 * BODY.len()),
    ) {
        let target = skeleton(1.0, |name, place| {
            let index = BODY.iter().position(|joint| joint.0 == name).unwrap();
            let nudged = std::array::from_fn(|axis| place[axis] + nudges[3 * index + axis]);
            match name {
                "hips" | "chest" | "head" => [place[0], nudged[1], nudged[2]],
                "toes l" | "toes r" => [nudged[0], place[1], nudged[2]],
                _ => nudged,
            }
        });
        let source = recording(&frames);
        let map = JointMap::by_names(&source, &target);
        let soles = Soles::of_skeleton(&target);
        let retarget =
            Retarget::new(&source, &target, &Options { soles: Some(&soles), map: Some(&map), alignment: Alignment::EveryBone, ..upright() }).unwrap();
        // One bone of each joint, at the hips the one upwards, and the trunk as a whole.
        let bones = [
            (0, 1), (3, 4), (4, 5), (5, 6), (7, 8), (8, 9), (9, 10), (11, 12), (12, 13),
            (13, 14), (15, 16),
        ];
        for frame in 0..frames.len() {
            let pairs = both(&retarget, &source, &target, frame);
            for (from, to) in bones {
                let [ours, there] = [0, 1].map(|k| between(pairs[from][k], pairs[to][k]));
                let angle = ours.angle(there).unwrap();
                prop_assert!(angle < 1e-9, "{}: {angle}", BODY[from].0);
            }
            is_trunk_alike(&pairs)?;
            // The head ends the trunk and keeps its form.
            let motions = retarget.pose(frame).unwrap().motions(&target).unwrap();
            let ours = motions[target.index("head").unwrap()].to_matrix();
            let there = source.frames_of_joints(frame).unwrap()[2].to_matrix();
            for row in 0..3 {
                for column in 0..3 {
                    prop_assert!((ours[row][column] - there[row][column]).abs() < 1e-12);
                }
            }
        }
    }
}

/// A body that looks along another axis at rest moves as one that looks along z.
#[test]
fn a_body_may_look_along_another_axis() {
    let angles = |frame: usize| (0..3 * BODY.len()).map(move |i| ((i * 7 + frame * 5) % 40) as f64);
    let frames: Vec<Vec<f64>> = (0..3)
        .map(|f| vec![1.0, 2.0, 3.0].into_iter().chain(angles(f)).collect())
        .collect();
    let source = recording(&frames);
    // Turned about y by a quarter: z becomes x, and x becomes −z.
    let target = skeleton(1.0, |_, [x, y, z]| [z, y, -x]);
    let retarget = Retarget::new(&source, &target, &upright()).unwrap();
    for frame in 0..frames.len() {
        same_places(&both(&retarget, &source, &target, frame)).unwrap();
    }
}

#[test]
fn a_joint_without_a_match_moves_with_its_parent() {
    let frames = [(0..54).map(|i| f64::from(i * 7 % 90)).collect::<Vec<_>>()];
    let source = recording(&frames);
    let same = skeleton(1.0, |_, place| place);
    let renamed = same.joints().iter().map(|joint| {
        let name = if joint.name == "hand l" {
            "claw".into()
        } else {
            joint.name.clone()
        };
        Joint {
            name,
            ..joint.clone()
        }
    });
    let target = Skeleton::new(renamed.collect()).unwrap();
    let retarget = Retarget::new(&source, &target, &upright()).unwrap();
    assert_eq!(retarget.unmatched().collect::<Vec<_>>(), ["claw"]);
    let pose = retarget.pose(0).unwrap();
    let claw = pose.joints[target.index("claw").unwrap()].to_matrix();
    let still = Motor::<f64>::default().to_matrix();
    for (entry, expected) in claw.as_flattened().iter().zip(still.as_flattened()) {
        assert!((entry - expected).abs() < 1e-12);
    }
}

#[test]
fn a_standing_body_stands_on_the_ground() {
    // Standing still, a leap, standing still again, at some height of its own.
    let frame = |y: f64| [vec![3.0, y, -2.0], vec![0.0; 3 * BODY.len()]].concat();
    let frames: Vec<Vec<f64>> = (0..30)
        .map(|i| frame(if (10..20).contains(&i) { 104.0 } else { 100.0 }))
        .collect();
    let source = recording(&frames);
    let target = skeleton(0.1, |_, place| place.map(|x| x - 5.0));
    let retarget = Retarget::new(&source, &target, &upright()).unwrap();
    let clip = retarget.clip(0..=29).unwrap();
    for (index, pose) in clip.frames().iter().enumerate() {
        let ankle = pose.bones(&target).unwrap()[9][0];
        let expected = 0.05 + if (10..20).contains(&index) { 0.4 } else { 0.0 };
        assert!(
            (ankle[1] - expected).abs() < 1e-12,
            "frame {index}: {}",
            ankle[1]
        );
    }
}

#[test]
fn soles_of_a_mesh_are_its_lowest_vertices() {
    // A post on the second joint, its foot spread over two vertices, and one vertex just above.
    let positions = [
        [0.0, -1.0, 0.0],
        [0.3, -0.99, 0.0],
        [0.0, -0.9, 0.0],
        [0.0, 3.0, 0.0],
    ]
    .map(Point::from);
    let rows = [
        vec![(1, 0.8), (0, 0.2)],
        vec![(1, 1.0)],
        vec![(0, 1.0)],
        vec![(0, 1.0)],
    ];
    let weights = SkinWeights::new(BODY.len(), rows).unwrap();
    let soles = Soles::of_mesh(&positions, &weights).unwrap();
    let without = [positions[0], positions[1], positions[3]];
    let other = Soles::of_mesh(&without, &weights.select(&[0, 1, 3]).unwrap()).unwrap();
    assert_eq!(soles, other);
    assert_eq!(
        Soles::of_mesh(&positions[1..], &weights),
        Err(SkinError::VertexCount {
            expected: 3,
            found: 4
        })
    );
}

#[test]
fn soles_belong_to_the_strongest_joint_and_to_bones_that_lie_low() {
    let positions = [[0.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(Point::from);
    let of_mesh = |row: Vec<(u32, f64)>| {
        let weights = SkinWeights::new(2, [row, vec![(0, 1.0)]]).unwrap();
        Soles::of_mesh(&positions, &weights).unwrap()
    };
    assert_eq!(of_mesh(vec![(0, 0.2), (1, 0.8)]), of_mesh(vec![(1, 1.0)]));
    assert_ne!(of_mesh(vec![(0, 0.8), (1, 0.2)]), of_mesh(vec![(1, 1.0)]));

    // 16 high, so that 1 is low: the shin is no sole, whether it begins at 3 or at 8 and ends at
    // 0.5 or at 1.5, since the foot lies lower.
    let of_leg = |shin: f64, ankle: f64, toes: f64| {
        let bone = |name: &str, parent, head, tail| Joint {
            name: name.into(),
            parent,
            head,
            tail,
        };
        let foot = [0.0, 0.9, 0.0];
        Soles::of_skeleton(
            &Skeleton::new(vec![
                bone("hips", None, [0.0, 16.0, 0.0], [0.0, 12.0, 0.0]),
                bone("shin", Some(0), [0.0, shin, 0.0], [0.0, ankle, 0.0]),
                bone("foot", Some(1), foot, [0.0, toes, 2.0]),
            ])
            .unwrap(),
        )
    };
    let known = of_leg(8.0, 1.5, 0.0);
    for (shin, ankle) in [(3.0, 1.5), (3.0, 1.2), (8.0, 0.5)] {
        assert_eq!(of_leg(shin, ankle, 0.0), known, "{shin} {ankle}");
    }
    // A toe that is not low takes the foot out, and the lowest ends are left.
    assert_ne!(of_leg(8.0, 1.5, 1.2), known);
}

#[test]
fn what_cannot_be_carried_over_is_an_error() {
    let still = vec![0.0; 3 + 3 * BODY.len()];
    let source = recording(std::slice::from_ref(&still));
    let target = skeleton(1.0, |_, place| place);
    let retarget = Retarget::new(&source, &target, &upright()).unwrap();
    assert_eq!(
        retarget.clip(0..=1),
        Err(RecordingError::FrameRange {
            from: 0,
            to: 1,
            frames: 1
        })
    );
    let backwards = std::ops::RangeInclusive::new(1, 0);
    assert_eq!(
        retarget.clip(backwards),
        Err(RecordingError::FrameRange {
            from: 1,
            to: 0,
            frames: 1
        })
    );
    assert!(matches!(
        retarget.pose(1),
        Err(RecordingError::FrameRange { .. })
    ));

    assert_eq!(
        Retarget::new(&recording(&[]), &target, &upright()).unwrap_err(),
        RecordingError::NoMotion
    );
    let stranger = Joint {
        name: "tentacle".into(),
        parent: None,
        head: [0.0; 3],
        tail: [0.0, 1.0, 0.0],
    };
    let stranger = Skeleton::new(vec![stranger]).unwrap();
    assert_eq!(
        Retarget::new(&source, &stranger, &upright()).unwrap_err(),
        RecordingError::NotAPerson {
            body: "the skeleton".into(),
            problem: BodyProblem::NoLegs,
        }
    );
    let soles = Soles::of_skeleton(&stranger);
    let error = RecordingError::Skeleton(SkeletonError::PoseLength {
        expected: BODY.len(),
        found: 1,
    });
    assert_eq!(
        Retarget::new(
            &source,
            &target,
            &Options {
                soles: Some(&soles),
                ..upright()
            }
        )
        .unwrap_err(),
        error
    );
    let trunk = Skeleton::new(target.joints()[..3].to_vec()).unwrap();
    assert_eq!(
        Retarget::new(&source, &trunk, &upright()).unwrap_err(),
        RecordingError::NoLegs
    );
    let far = [vec![1e308; 3], still[3..].to_vec()].concat();
    let giant = skeleton(100.0, |_, place| place);
    assert_eq!(
        Retarget::new(&recording(&[still, far]), &giant, &upright()).unwrap_err(),
        RecordingError::Overflow { frame: 1 }
    );
}

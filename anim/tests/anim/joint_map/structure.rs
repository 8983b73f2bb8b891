//! Joints without known names, matched by the structure of the skeleton.

use ga_anim::bvh::{self};
use ga_anim::retarget::{JointMap, Options, Retarget, Soles};
use ga_anim::skeleton::{Joint, Skeleton};
use ga_runtime::vga3::Vector;

use super::{BODY, NAMES, recording, skeleton, with_joints_in_between};

/// Names that mean nothing.
fn nameless() -> Vec<String> {
    (0..BODY.len())
        .map(|k| format!("thing {}", k * 7 % 20))
        .collect()
}

fn borrowed(names: &[String]) -> Vec<&str> {
    names.iter().map(String::as_str).collect()
}

#[test]
fn bodies_without_names_are_matched_by_their_structure() {
    let names = nameless();
    let other: Vec<String> = names.iter().map(|name| format!("{name}?")).collect();
    let expected: Vec<Option<usize>> = (0..BODY.len()).map(Some).collect();
    let (motion, target) = (recording(&borrowed(&names)), skeleton(&borrowed(&other)));
    // A recording has the joints in the order of its file, which is that of BODY.
    assert_eq!(
        JointMap::by_structure(&motion, &target).source_of(),
        expected
    );
    assert_eq!(
        JointMap::by_names_or_structure(&motion, &target)
            .unwrap()
            .source_of(),
        expected
    );
    // One of them has names.
    for (convention, known) in NAMES {
        let map = JointMap::by_names_or_structure(&motion, &skeleton(&known)).unwrap();
        assert_eq!(map.source_of(), expected, "{convention}");
        let map = JointMap::by_names_or_structure(&recording(&known), &target).unwrap();
        assert_eq!(map.source_of(), expected, "{convention}");
    }
}

#[test]
fn structure_tells_bones_in_between_and_sides() {
    let motion = recording(&NAMES[0].1);
    let plain = with_joints_in_between(&borrowed(&nameless()));
    let expected = |target: &Skeleton, place: [f64; 3]| {
        let at = |joint: &Joint| (0..3).all(|k| (joint.head[k] - place[k]).abs() < 1e-12);
        target.joints().iter().position(at)
    };
    // Larger, and looking along x or backwards: left stays left.
    type Place = fn([f64; 3]) -> [f64; 3];
    let places: [Place; 4] = [
        |place| place,
        |[x, y, z]| [3.0 * x, 2.0 * y, 2.0 * z],
        |[x, y, z]| [z, y, -x],
        |[x, y, z]| [-x, y, -z],
    ];
    for placed in places {
        let joints = plain.joints().iter().map(|joint| Joint {
            head: placed(joint.head),
            tail: placed(joint.tail),
            ..joint.clone()
        });
        let target = Skeleton::new(joints.collect()).unwrap();
        let map = JointMap::by_names_or_structure(&motion, &target).unwrap();
        for (joint, &(_, place)) in BODY.iter().enumerate() {
            let there = expected(&target, placed(place)).unwrap();
            assert_eq!(map.source_of()[there], Some(joint), "{}", NAMES[0].1[joint]);
        }
        assert_eq!(map.source_of().iter().flatten().count(), BODY.len());
        let soles = Soles::of_skeleton(&target);
        Retarget::new(
            &motion,
            &target,
            &Options {
                soles: Some(&soles),
                map: Some(&map),
                ..Options::default()
            },
        )
        .unwrap();
    }
}

#[test]
fn what_is_no_body_has_no_structure() {
    let motion = recording(&NAMES[0].1);
    let joint = |name: &str, parent, y: f64| Joint {
        name: name.into(),
        parent,
        head: [0.0, y, 0.0],
        tail: [0.0, y, 0.0],
    };
    let snake: Vec<Joint> = (0..9)
        .map(|k| joint(&format!("{k}"), (k > 0).then(|| k - 1), k as f64))
        .collect();
    let flat = vec![
        joint("a", None, 0.0),
        joint("b", Some(0), 0.0),
        joint("c", Some(0), 0.0),
    ];
    for joints in [snake, flat] {
        let target = Skeleton::new(joints).unwrap();
        let map = JointMap::by_structure(&motion, &target);
        assert!(map.source_of().iter().all(Option::is_none));
    }
}

/// Where the chain of the source is longer, a bone of the target is parallel to the line between
/// the joints that are matched, also when the joint in between bends.
#[test]
fn bones_in_between_in_the_source_bend_none_of_the_target() {
    let inserted = "LeftArm\n{\nOFFSET 0.15 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n\
         JOINT LeftArmRoll\n{\nOFFSET 0.1 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n\
         JOINT LeftForeArm\n{\nOFFSET 0.18 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n\
         JOINT LeftHand\n{\nOFFSET 0.26 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n}\n}\n}\n}\n";
    let leg = |side: &str, x: f64| {
        let zxy = "CHANNELS 3 Zrotation Xrotation Yrotation";
        format!(
            "JOINT {side}UpLeg\n{{\nOFFSET {x} -0.05 0\n{zxy}\nJOINT {side}Leg\n{{\nOFFSET 0 -0.4 0.02\n{zxy}\n\
             JOINT {side}Foot\n{{\nOFFSET 0 -0.42 -0.02\n{zxy}\n}}\n}}\n}}\n"
        )
    };
    let text = format!(
        "HIERARCHY\nROOT Hips\n{{\nOFFSET 0 0.95 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT {inserted}{}{}}}\n\
         MOTION\nFrames: 1\nFrame Time: 0.1\n{}\n",
        leg("Left", 0.1),
        leg("Right", -0.1),
        (0..33)
            .map(|k| format!("{}", k * 13 % 60))
            .collect::<Vec<_>>()
            .join(" ")
    );
    let motion = bvh::decode(text.as_bytes()).unwrap();
    let target = skeleton(&NAMES[1].1);
    let soles = Soles::of_skeleton(&target);
    let map = JointMap::by_names(&motion, &target);
    assert_eq!(map.source_of()[6], motion.index("LeftArm"));
    let retarget = Retarget::new(
        &motion,
        &target,
        &Options {
            soles: Some(&soles),
            map: Some(&map),
            ..Options::default()
        },
    )
    .unwrap();
    let bones = retarget.pose(0).unwrap().bones(&target).unwrap();
    let places = motion.joint_positions(0).unwrap();
    for (from, to) in [("LeftArm", "LeftForeArm"), ("LeftForeArm", "LeftHand")] {
        let ours = |name: &str| Vector::from(bones[target.index(name).unwrap()][0]);
        let there = |name: &str| Vector::from(places[motion.index(name).unwrap()]);
        let angle = (ours(to) - ours(from))
            .angle(there(to) - there(from))
            .unwrap();
        assert!(angle < 1e-9, "{from}: {angle}");
    }
}

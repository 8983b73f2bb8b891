//! Maps of joints by the usual names, and from JSON.

mod structure;

use ga_anim::bvh::{self, Bvh};
use ga_anim::recording::RecordingError;
use ga_anim::retarget::{JointMap, Options, Retarget, Soles};
use ga_anim::skeleton::{Joint, Skeleton};
use ga_runtime::vga3::Vector;

/// Parent and place of the joints of a person, left side first.
const BODY: [(Option<usize>, [f64; 3]); 20] = [
    (None, [0.0, 0.95, 0.0]),
    (Some(0), [0.0, 1.1, 0.0]),
    (Some(1), [0.0, 1.3, 0.02]),
    (Some(2), [0.0, 1.5, 0.0]),
    (Some(3), [0.0, 1.6, 0.02]),
    (Some(2), [0.05, 1.45, 0.0]),
    (Some(5), [0.2, 1.45, 0.0]),
    (Some(6), [0.48, 1.45, 0.0]),
    (Some(7), [0.74, 1.45, 0.0]),
    (Some(2), [-0.05, 1.45, 0.0]),
    (Some(9), [-0.2, 1.45, 0.0]),
    (Some(10), [-0.48, 1.45, 0.0]),
    (Some(11), [-0.74, 1.45, 0.0]),
    (Some(0), [0.1, 0.9, 0.0]),
    (Some(13), [0.1, 0.5, 0.02]),
    (Some(14), [0.1, 0.08, 0.0]),
    (Some(15), [0.1, 0.02, 0.12]),
    (Some(0), [-0.1, 0.9, 0.0]),
    (Some(17), [-0.1, 0.5, 0.02]),
    (Some(18), [-0.1, 0.08, 0.0]),
];

/// The names of these joints in several conventions.
const NAMES: [(&str, [&str; 20]); 7] = [
    (
        "Mixamo",
        [
            "mixamorig:Hips",
            "mixamorig:Spine",
            "mixamorig:Spine1",
            "mixamorig:Neck",
            "mixamorig:Head",
            "mixamorig:LeftShoulder",
            "mixamorig:LeftArm",
            "mixamorig:LeftForeArm",
            "mixamorig:LeftHand",
            "mixamorig:RightShoulder",
            "mixamorig:RightArm",
            "mixamorig:RightForeArm",
            "mixamorig:RightHand",
            "mixamorig:LeftUpLeg",
            "mixamorig:LeftLeg",
            "mixamorig:LeftFoot",
            "mixamorig:LeftToeBase",
            "mixamorig:RightUpLeg",
            "mixamorig:RightLeg",
            "mixamorig:RightFoot",
        ],
    ),
    (
        "CMU",
        [
            "Hips",
            "LowerBack",
            "Spine1",
            "Neck",
            "Head",
            "LeftShoulder",
            "LeftArm",
            "LeftForeArm",
            "LeftHand",
            "RightShoulder",
            "RightArm",
            "RightForeArm",
            "RightHand",
            "LeftUpLeg",
            "LeftLeg",
            "LeftFoot",
            "LeftToeBase",
            "RightUpLeg",
            "RightLeg",
            "RightFoot",
        ],
    ),
    (
        "MakeHuman",
        [
            "root",
            "spine05",
            "spine01",
            "neck01",
            "head",
            "clavicle.L",
            "upperarm01.L",
            "lowerarm01.L",
            "wrist.L",
            "clavicle.R",
            "upperarm01.R",
            "lowerarm01.R",
            "wrist.R",
            "upperleg01.L",
            "lowerleg01.L",
            "foot.L",
            "toe.L",
            "upperleg01.R",
            "lowerleg01.R",
            "foot.R",
        ],
    ),
    (
        "MakeHuman for games",
        [
            "pelvis",
            "spine_01",
            "spine_02",
            "neck_01",
            "head",
            "clavicle_l",
            "upperarm_l",
            "lowerarm_l",
            "hand_l",
            "clavicle_r",
            "upperarm_r",
            "lowerarm_r",
            "hand_r",
            "thigh_l",
            "calf_l",
            "foot_l",
            "ball_l",
            "thigh_r",
            "calf_r",
            "foot_r",
        ],
    ),
    (
        "Biped",
        [
            "Bip01 Pelvis",
            "Bip01 Spine",
            "Bip01 Spine1",
            "Bip01 Neck",
            "Bip01 Head",
            "Bip01 L Clavicle",
            "Bip01 L UpperArm",
            "Bip01 L Forearm",
            "Bip01 L Hand",
            "Bip01 R Clavicle",
            "Bip01 R UpperArm",
            "Bip01 R Forearm",
            "Bip01 R Hand",
            "Bip01 L Thigh",
            "Bip01 L Calf",
            "Bip01 L Foot",
            "Bip01 L Toe0",
            "Bip01 R Thigh",
            "Bip01 R Calf",
            "Bip01 R Foot",
        ],
    ),
    (
        "sides at the end",
        [
            "Hips",
            "Spine",
            "Chest",
            "Neck",
            "Head",
            "Shoulder_L",
            "UpperArm_L",
            "LowerArm_L",
            "Hand_L",
            "Shoulder_R",
            "UpperArm_R",
            "LowerArm_R",
            "Hand_R",
            "UpperLeg_L",
            "LowerLeg_L",
            "Foot_L",
            "Toes_L",
            "UpperLeg_R",
            "LowerLeg_R",
            "Foot_R",
        ],
    ),
    (
        "by joints",
        [
            "Hips",
            "Torso",
            "Chest",
            "Neck",
            "Head",
            "LeftCollar",
            "LeftShoulder",
            "LeftElbow",
            "LeftWrist",
            "RightCollar",
            "RightShoulder",
            "RightElbow",
            "RightWrist",
            "LeftHip",
            "LeftKnee",
            "LeftAnkle",
            "LeftToe",
            "RightHip",
            "RightKnee",
            "RightAnkle",
        ],
    ),
];

/// The body as a recording that stands still, with the arms bent.
fn recording(names: &[&str]) -> Bvh {
    fn joint(names: &[&str], index: usize, text: &mut String) {
        let (parent, place) = BODY[index];
        let above = parent.map_or([0.0; 3], |parent| BODY[parent].1);
        let [x, y, z]: [f64; 3] = std::array::from_fn(|k| place[k] - above[k]);
        let keyword = if index == 0 { "ROOT" } else { "JOINT" };
        let name = names[index];
        *text += &format!(
            "{keyword} {name}\n{{\nOFFSET {x} {y} {z}\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
        );
        for child in (0..BODY.len()).filter(|&child| BODY[child].0 == Some(index)) {
            joint(names, child, text);
        }
        *text += "}\n";
    }
    let mut text = "HIERARCHY\n".to_owned();
    joint(names, 0, &mut text);
    text += "MOTION\nFrames: 2\nFrame Time: 0.1\n";
    for frame in 0..2 {
        let angle = |k: usize| format!("{}", ((k * 37 + frame * 11) % 50) as f64 - 25.0);
        text += &(0..3 * BODY.len()).map(angle).collect::<Vec<_>>().join(" ");
        text.push('\n');
    }
    bvh::decode(text.as_bytes()).unwrap()
}

fn skeleton(names: &[&str]) -> Skeleton {
    let joints = BODY
        .iter()
        .zip(names)
        .enumerate()
        .map(|(index, (&(parent, head), name))| {
            let child = BODY.iter().position(|&(parent, _)| parent == Some(index));
            Joint {
                name: (*name).into(),
                parent,
                head,
                tail: child.map_or(head, |child| BODY[child].1),
            }
        });
    Skeleton::new(joints.collect()).unwrap()
}

#[test]
fn every_convention_maps_to_every_other() {
    for (from, source) in NAMES {
        let motion = recording(&source);
        for (to, target) in NAMES {
            let map = JointMap::by_names(&motion, &skeleton(&target));
            let names = |joint: usize| &motion.joints()[joint].name;
            for (joint, found) in map.source_of().iter().enumerate() {
                let found = found.map(names).map(String::as_str);
                assert_eq!(
                    found,
                    Some(source[joint]),
                    "{} of {to} from {from}",
                    target[joint]
                );
            }
        }
    }
}

#[test]
fn other_names_mean_nothing() {
    let names: Vec<String> = (0..20).map(|k| format!("Armature|thing{k}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let (motion, target) = (recording(&NAMES[0].1), skeleton(&names));
    let map = JointMap::by_names(&motion, &target);
    assert!(map.source_of().iter().all(Option::is_none));
    let soles = Soles::of_skeleton(&target);
    let error = Retarget::new(
        &motion,
        &target,
        &Options {
            soles: Some(&soles),
            map: Some(&map),
            ..Options::default()
        },
    )
    .unwrap_err();
    assert_eq!(error, RecordingError::NoMatch);
    // Helpers beside the joints that they are named after, and the CMU's joints beside the hips.
    let mut names = NAMES[5].1;
    names[3] = "UpperArm_Twist_L";
    names[4] = "HeadTop_End";
    names[16] = "LHipJoint";
    let map = JointMap::by_names(&motion, &skeleton(&names));
    for joint in [3, 4, 16] {
        assert_eq!(map.source_of()[joint], None, "{}", names[joint]);
    }
}

#[test]
fn longer_spines_are_matched_evenly() {
    let names = |spine: [&'static str; 4]| {
        let mut names = NAMES[1].1;
        names[1..5].copy_from_slice(&spine);
        names
    };
    let motion = recording(&names(["Spine", "Spine1", "Spine2", "Spine3"]));
    let target = skeleton(&names(["spine_01", "spine_02", "Neck", "Head"]));
    let map = JointMap::by_names(&motion, &target);
    assert_eq!(map.source_of()[1..5], [Some(1), Some(4), None, None]);
    let motion = recording(&names(["spine_01", "spine_02", "Neck", "Head"]));
    let target = skeleton(&names(["Spine", "Spine1", "Spine2", "Spine3"]));
    let map = JointMap::by_names(&motion, &target);
    assert_eq!(map.source_of()[1..5], [Some(1), Some(1), Some(2), Some(2)]);
}

/// A skeleton with a joint in the middle of each upper arm and thigh.
fn with_joints_in_between(names: &[&str]) -> Skeleton {
    let plain = skeleton(names);
    let mut joints: Vec<Joint> = plain.joints().to_vec();
    for (upper, lower) in [(6, 7), (10, 11), (13, 14), (17, 18)] {
        let [a, b] = [upper, lower].map(|joint| joints[joint].head);
        let middle = std::array::from_fn(|k| 0.5 * (a[k] + b[k]));
        joints.push(Joint {
            name: format!("{} twist", names[upper]),
            parent: Some(upper),
            head: middle,
            tail: b,
        });
        joints[upper].tail = middle;
        joints[lower].parent = Some(joints.len() - 1);
    }
    Skeleton::in_any_order(joints).unwrap().0
}

#[test]
fn bones_in_between_move_with_the_one_above() {
    let motion = recording(&NAMES[0].1);
    let target = with_joints_in_between(&NAMES[4].1);
    let soles = Soles::of_skeleton(&target);
    let retarget = Retarget::new(
        &motion,
        &target,
        &Options {
            soles: Some(&soles),
            ..Options::default()
        },
    )
    .unwrap();
    assert!((retarget.scale() - 1.0).abs() < 1e-12);
    assert_eq!(retarget.unmatched().count(), 4);
    for frame in 0..2 {
        let bones = retarget.pose(frame).unwrap().bones(&target).unwrap();
        let places = motion.joint_positions(frame).unwrap();
        for (from, to) in [(6, 7), (7, 8), (10, 11), (13, 14), (14, 15), (17, 18)] {
            let head = |k: usize| Vector::from(bones[target.index(NAMES[4].1[k]).unwrap()][0]);
            let there = |k: usize| Vector::from(places[motion.index(NAMES[0].1[k]).unwrap()]);
            let angle = (head(to) - head(from))
                .angle(there(to) - there(from))
                .unwrap();
            assert!(angle < 1e-6, "{}: {angle}", NAMES[4].1[from]);
        }
    }
}

#[test]
fn maps_from_json_and_their_faults() {
    let (motion, target) = (recording(&NAMES[0].1), skeleton(&NAMES[4].1));
    let map = |text: &str| JointMap::decode(text.as_bytes(), &motion, &target);
    let found =
        map(r#"{"mixamorig:LeftArm": "Bip01 R Thigh", "mixamorig:Hips": "Bip01 Pelvis"}"#).unwrap();
    assert_eq!(found.source_of()[0], Some(0));
    let arm = motion.index("mixamorig:LeftArm");
    assert_eq!(found.source_of()[17], arm);
    assert_eq!(found.source_of().iter().flatten().count(), 2);
    let several = map(r#"{"mixamorig:Hips": ["Bip01 Pelvis", "Bip01 R Thigh"]}"#).unwrap();
    let sources = several.source_of();
    assert_eq!((sources[0], sources[17]), (Some(0), Some(0)));
    assert_eq!(sources.iter().flatten().count(), 2);
    for (text, message) in [
        (
            r#"{"Hips": "Bip01 Pelvis"}"#,
            "the motion has no joint \"Hips\"",
        ),
        (
            r#"{"mixamorig:Hips": "Pelvis"}"#,
            "the skeleton has no joint \"Pelvis\"",
        ),
        (
            r#"{"mixamorig:Hips": "Bip01 Head", "mixamorig:Neck": "Bip01 Head"}"#,
            "joint \"Bip01 Head\" of the skeleton is listed twice in the map",
        ),
        (
            r#"{"mixamorig:Hips": ["Bip01 Head", "Bip01 Pelvis", "Bip01 Head"]}"#,
            "joint \"Bip01 Head\" of the skeleton is listed twice in the map",
        ),
        (
            r#"{"mixamorig:Hips": "Bip01 Head", "mixamorig:Hips": "Bip01 Pelvis"}"#,
            "joint \"mixamorig:Hips\" of the motion is listed twice in the map",
        ),
    ] {
        assert_eq!(map(text).unwrap_err().to_string(), message);
    }
    for text in ["", "[]", r#"{"a": 1}"#, r#"{"a": [1]}"#, r#"{"a": "#] {
        assert!(
            map(text)
                .unwrap_err()
                .to_string()
                .starts_with("a map is an object")
        );
    }
    let other = skeleton(&NAMES[0].1);
    let short = Skeleton::new(other.joints()[..5].to_vec()).unwrap();
    let soles = Soles::of_skeleton(&short);
    let wrong = Retarget::new(
        &motion,
        &short,
        &Options {
            soles: Some(&soles),
            map: Some(&found),
            ..Options::default()
        },
    );
    assert!(matches!(wrong, Err(RecordingError::Skeleton(_))));
}

#[test]
fn a_map_is_written_as_it_is_read() {
    let (motion, target) = (recording(&NAMES[0].1), skeleton(&NAMES[4].1));
    let text =
        r#"{"mixamorig:Hips":["Bip01 Pelvis","Bip01 R Thigh"],"mixamorig:LeftArm":"Bip01 Head"}"#;
    let map = JointMap::decode(text.as_bytes(), &motion, &target).unwrap();
    assert_eq!(map.to_json(&motion, &target).to_string(), text);
}

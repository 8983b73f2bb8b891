//! Mirror images of clips, and the names that say which joints belong together.

use ga_anim::bvh;
use ga_anim::clip::Mirror;
use ga_anim::recording::Recording;
use ga_runtime::cga3::DualPlane;
use nullcone_shared_data::shared;

use super::{assert_same, mirror_plane, named};

#[test]
fn a_mirror_knows_the_names_of_cmu() {
    let joints = [
        ("Hips", None),
        ("LHipJoint", Some(0)),
        ("LeftUpLeg", Some(1)),
        ("RHipJoint", Some(0)),
        ("RightUpLeg", Some(3)),
        ("LFingers", Some(0)),
        ("RFingers", Some(0)),
    ];
    let mirror = Mirror::by_names(&named(&joints), mirror_plane()).unwrap();
    assert!(mirror.counterparts().eq([0, 3, 4, 1, 2, 6, 5]));

    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let recording = Recording::from_bvh(&bvh::read(path).unwrap(), 1.0).unwrap();
    let skeleton = recording.to_skeleton().unwrap();
    let mirror = Mirror::by_names(&skeleton, DualPlane::new(1.0, 0.0, 0.0, 0.0)).unwrap();
    let joints = skeleton.joints();
    let opposite = |name: &str| match name.strip_prefix("Left") {
        Some(rest) => format!("Right{rest}"),
        None => format!("R{}", &name[1..]),
    };
    let mut sides = 0;
    for (joint, counterpart) in mirror.counterparts().enumerate() {
        let name = &joints[joint].name;
        if name.starts_with('L') && name != "LowerBack" {
            assert_eq!(joints[counterpart].name, opposite(name));
            sides += 2;
        } else if !name.starts_with('R') {
            assert_eq!(counterpart, joint, "{name}");
        }
    }
    let middle = mirror.counterparts().enumerate().filter(|(a, b)| a == b);
    assert_eq!(sides + middle.count(), joints.len());
    let clip = recording.to_clip().unwrap();
    let twice = mirror.pose(&mirror.pose(&clip.frames()[100]).unwrap());
    assert_same(&twice.unwrap(), &clip.frames()[100], 1e-9);
}

#[test]
fn a_mirror_leaves_names_that_only_contain_a_side() {
    let joints = [
        ("cleft", None),
        ("bright", None),
        ("L5", None),
        ("leftover", None),
        ("leftarm", None),
        ("rightarm", None),
    ];
    let mirror = Mirror::by_names(&named(&joints), mirror_plane()).unwrap();
    assert!(mirror.counterparts().eq([0, 1, 2, 3, 5, 4]));
}

//! Which joints of skeletons the joints of detectors are.

use ga_anim::skeleton::{Joint, Skeleton};
use ga_body::BodyError;
use ga_body::format::correspondence::correspondence;
use ga_body::format::{Model, coco, openpose};

fn skeleton(names: [&str; 8]) -> Skeleton {
    let places = [
        [0.0, 1.0, 0.0],
        [0.1, 0.9, 0.0],
        [0.1, 0.5, 0.0],
        [0.1, 0.1, 0.0],
        [-0.1, 0.9, 0.0],
        [-0.1, 0.5, 0.0],
        [-0.1, 0.1, 0.0],
        [0.0, 1.5, 0.0],
    ];
    let parents = [
        None,
        Some(0),
        Some(1),
        Some(2),
        Some(0),
        Some(4),
        Some(5),
        Some(0),
    ];
    let joints = (0..8).map(|index| Joint {
        name: names[index].to_owned(),
        parent: parents[index],
        head: places[index],
        tail: [places[index][0], places[index][1] - 0.1, 0.05],
    });
    Skeleton::new(joints.collect()).unwrap()
}

#[test]
fn joints_of_detectors_are_joints_of_skeletons() {
    let names = |names: &[&str]| -> Vec<String> { names.iter().map(|&n| n.to_owned()).collect() };
    let of = |list: &[String], skeleton: &Skeleton, name: &str| {
        let found = correspondence(list, skeleton).unwrap();
        let index = list.iter().position(|other| other == name).unwrap();
        found[index].map(|joint| skeleton.joints()[joint].name.clone())
    };
    let mixamo = skeleton([
        "mixamorig:Hips",
        "mixamorig:LeftUpLeg",
        "mixamorig:LeftLeg",
        "mixamorig:LeftFoot",
        "mixamorig:RightUpLeg",
        "mixamorig:RightLeg",
        "mixamorig:RightFoot",
        "mixamorig:Neck",
    ]);
    let coco = names(&coco::JOINTS);
    let body = names(&openpose::BODY_25);
    for (list, name, joint) in [
        (&coco, "left_hip", Some("mixamorig:LeftUpLeg")),
        (&coco, "right_knee", Some("mixamorig:RightLeg")),
        (&coco, "left_ankle", Some("mixamorig:LeftFoot")),
        (&coco, "nose", None),
        (&coco, "left_elbow", None),
        (&body, "MidHip", Some("mixamorig:Hips")),
        (&body, "Neck", Some("mixamorig:Neck")),
        (&body, "RHip", Some("mixamorig:RightUpLeg")),
        (&body, "LKnee", Some("mixamorig:LeftLeg")),
        (&body, "RAnkle", Some("mixamorig:RightFoot")),
        (&body, "LBigToe", None),
    ] {
        assert_eq!(of(list, &mixamo, name).as_deref(), joint, "{name}");
    }
    // Names without meaning: by the structure.
    let plain = skeleton(["a", "b", "c", "d", "e", "f", "g", "h"]);
    assert_eq!(of(&coco, &plain, "left_knee").as_deref(), Some("c"));
    assert_eq!(of(&coco, &plain, "right_ankle").as_deref(), Some("g"));
    // Its own names.
    let own = names(&["a", "d", "g"]);
    assert_eq!(
        correspondence(&own, &plain).unwrap(),
        [Some(0), Some(3), Some(6)]
    );
    let wrong = names(&["a", "d", "g", "tail"]);
    assert!(matches!(
        correspondence(&wrong, &plain),
        Err(BodyError::UnknownJoint { index: 3, .. })
    ));
    let few = names(&["a", "d", "nose"]);
    let text = correspondence(&few, &plain).unwrap_err().to_string();
    assert!(text.contains("2 of the joints"), "{text}");
}

/// The joint of a head is where it turns, far below its top.
#[test]
fn the_top_of_the_head_is_not_the_joint_of_the_head() {
    let mannequin = ga_mannequin::skeleton();
    let head = mannequin.joints().iter().position(|j| j.name == "Head");
    assert!(head.is_some());
    for model in Model::ALL {
        let found = correspondence(&model.joints(), &mannequin).unwrap();
        let top = model.joints().iter().position(|name| name == "head_top");
        assert_eq!(top.and_then(|top| found[top]), None, "{model}");
        assert!(!found.contains(&head), "{model}");
    }
}

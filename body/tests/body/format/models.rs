//! The names of detectors' joints in their orders.

use std::collections::HashSet;

use ga_body::format::Model;

#[test]
fn models_have_their_joints_once_and_on_both_sides() {
    for model in Model::ALL {
        let joints = model.joints();
        let names: HashSet<&str> = joints.iter().map(String::as_str).collect();
        assert_eq!(names.len(), joints.len(), "{model}");
        // The number is at the end of the name but for MediaPipe's and BODY_25B's.
        let digits: String = model.name().chars().filter(char::is_ascii_digit).collect();
        if let Ok(count) = digits.parse::<usize>() {
            assert_eq!(joints.len(), count, "{model}");
        }
        for name in names.iter().filter(|name| name.starts_with("left_")) {
            let other = name.replacen("left", "right", 1);
            assert!(names.contains(other.as_str()), "{model}: {other}");
        }
        let sided = |side: &str| names.iter().filter(|name| name.starts_with(side)).count();
        assert_eq!(sided("left_"), sided("right_"), "{model}");
        assert_eq!(model.to_string().to_uppercase().parse(), Ok(model));
    }
    assert_eq!(Model::MediaPipe.joints().len(), 33);
}

/// Places that the documentation of the detectors states.
#[test]
fn joints_are_in_the_orders_of_their_models() {
    for (model, index, name) in [
        (Model::Coco17, 16, "right_ankle"),
        (Model::Halpe26, 17, "head_top"),
        (Model::Halpe26, 18, "neck"),
        (Model::Halpe26, 19, "hip"),
        (Model::Halpe26, 20, "left_big_toe"),
        (Model::Halpe26, 21, "right_big_toe"),
        (Model::Halpe26, 25, "right_heel"),
        (Model::MediaPipe, 2, "left_eye"),
        (Model::MediaPipe, 7, "left_ear"),
        (Model::MediaPipe, 9, "left_mouth"),
        (Model::MediaPipe, 11, "left_shoulder"),
        (Model::MediaPipe, 16, "right_wrist"),
        (Model::MediaPipe, 17, "left_pinky"),
        (Model::MediaPipe, 22, "right_thumb"),
        (Model::MediaPipe, 23, "left_hip"),
        (Model::MediaPipe, 31, "left_foot_index"),
        (Model::Coco133, 17, "left_big_toe"),
        (Model::Coco133, 19, "left_heel"),
        (Model::Coco133, 20, "right_big_toe"),
        (Model::Coco133, 23, "face-0"),
        (Model::Coco133, 90, "face-67"),
        (Model::Coco133, 91, "left_hand_root"),
        (Model::Coco133, 111, "left_pinky_finger4"),
        (Model::Coco133, 112, "right_hand_root"),
        (Model::Coco133, 117, "right_forefinger1"),
        (Model::Coco133, 132, "right_pinky_finger4"),
        (Model::Halpe136, 26, "face-0"),
        (Model::Halpe136, 94, "left_hand_root"),
        (Model::Halpe136, 96, "left_thumb2"),
        (Model::Halpe136, 115, "right_hand_root"),
        (Model::Halpe136, 132, "right_pinky_finger1"),
        (Model::Body25b, 4, "right_ear"),
        (Model::Body25b, 17, "upper_neck"),
        (Model::Body25b, 18, "head_top"),
        (Model::Body25b, 21, "left_heel"),
        (Model::Body25b, 24, "right_heel"),
        (Model::Body135, 24, "right_heel"),
        (Model::Body135, 25, "left_thumb1"),
        (Model::Body135, 45, "right_thumb1"),
        (Model::Body135, 65, "face-0"),
        (Model::Body135, 134, "face-69"),
        (Model::Mpii16, 0, "right_ankle"),
        (Model::Mpii16, 6, "pelvis"),
        (Model::Mpii16, 9, "head_top"),
        (Model::Mpii16, 13, "left_shoulder"),
        (Model::Lsp14, 6, "right_wrist"),
        (Model::Lsp14, 12, "neck"),
    ] {
        assert_eq!(model.joints()[index], name, "{model}");
    }
}

#[test]
fn numbers_of_joints_tell_models_where_one_alone_has_them() {
    for (count, model) in [
        (17, Some(Model::Coco17)),
        (18, Some(Model::Coco18)),
        (25, Some(Model::Body25)),
        (26, Some(Model::Halpe26)),
        (33, Some(Model::MediaPipe)),
        (133, Some(Model::Coco133)),
        (135, Some(Model::Body135)),
        (136, Some(Model::Halpe136)),
        (16, None),
        (14, None),
        (0, None),
    ] {
        assert_eq!(Model::of_count(count), model);
    }
    let unknown = "body_26".parse::<Model>().unwrap_err().to_string();
    for part in ["\"body_26\"", "halpe26", "lsp14"] {
        assert!(unknown.contains(part), "{unknown}");
    }
}

#[test]
fn points_of_faces_and_hands_are_told_from_joints() {
    // By the parts of the models: a body, its feet, and MediaPipe's without fingers, mouth and
    // corners of the eyes.
    for (model, body) in [
        (Model::Coco17, 17),
        (Model::Coco133, 23),
        (Model::Halpe136, 26),
        (Model::Body135, 25),
        (Model::MediaPipe, 33 - 6 - 2 - 4),
    ] {
        let joints = model.joints();
        let of_body = joints.iter().filter(|name| !Model::is_face_or_hand(name));
        assert_eq!(of_body.count(), body, "{model}");
    }
    for name in [
        "left_wrist",
        "left_hip",
        "hip",
        "neck",
        "LHip",
        "left_foot_index",
    ] {
        assert!(!Model::is_face_or_hand(name), "{name}");
    }
}

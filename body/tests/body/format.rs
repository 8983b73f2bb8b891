//! Files of joints in pictures.

use ga_anim::skeleton::{Joint, Skeleton};
use ga_body::format::correspondence::correspondence;
use ga_body::format::{
    Detections, DetectorOptions, FrameKey, JointProblem, JointView, JointViews, JointsError, coco,
    openpose,
};
use ga_body::{BodyError, JointPixel};
use proptest::prelude::*;

/// Three numbers for each of `count` joints: (10 k, 20 k, c).
fn keypoints(count: usize, confidence: f64) -> String {
    let numbers = (0..count).map(|k| format!("{}, {}, {confidence}", 10 * k, 20 * k));
    numbers.collect::<Vec<_>>().join(", ")
}

fn pixel(view: &JointView, frame: usize, joint: usize) -> Option<([f64; 2], f64)> {
    view.frames[frame][joint].map(|pixel| (pixel.position, pixel.deviation))
}

fn views(detections: Detections, options: &DetectorOptions) -> JointViews {
    JointViews::from_detections(&[("a".to_owned(), detections)], options).unwrap()
}

#[test]
fn results_of_coco_are_read_in_the_order_of_pictures() {
    let text = format!(
        r#"[{{"image_id": 12, "category_id": 1, "keypoints": [{}], "score": 0.8}},
            {{"image_id": 3, "category_id": 1, "keypoints": [{}], "score": 0.8}},
            {{"image_id": 3, "category_id": 1, "keypoints": [{}], "score": 0.9}}]"#,
        keypoints(17, 0.25),
        keypoints(17, 0.5),
        keypoints(17, 1.0)
    );
    let found = coco::decode(text.as_bytes()).unwrap();
    assert_eq!(found.joints, coco::JOINTS);
    assert_eq!(found.frames[0].key, FrameKey::Number(3));
    assert_eq!(found.frames[0].people.len(), 2);
    let options = DetectorOptions {
        deviation_px: 3.0,
        frames_per_second: Some(25.0),
        ..DetectorOptions::default()
    };
    // The person with the greatest confidence, and the deviation σ/√c.
    let best = views(found.clone(), &options);
    assert_eq!(best.frames_per_second(), Some(25.0));
    let view = &best.views()[0];
    assert_eq!(pixel(view, 0, 5), Some(([50.0, 100.0], 3.0)));
    assert_eq!(pixel(view, 1, 5), Some(([50.0, 100.0], 6.0)));
    let first = DetectorOptions {
        person: Some(0),
        ..options
    };
    let first = views(found.clone(), &first);
    assert_eq!(
        pixel(&first.views()[0], 0, 5),
        Some(([50.0, 100.0], 3.0 / 0.5f64.sqrt()))
    );
    let none = DetectorOptions {
        person: Some(1),
        ..options
    };
    let refused = JointViews::from_detections(&[("a".to_owned(), found)], &none);
    let text = refused.unwrap_err().to_string();
    assert!(
        text.contains("picture 12") && text.contains("person 1"),
        "{text}"
    );
}

#[test]
fn annotations_of_coco_have_hidden_and_missing_joints() {
    let rest = keypoints(14, 2.0);
    let text = format!(
        r#"{{"images": [{{"id": 1}}, {{"id": 2}}],
             "annotations": [{{"id": 9, "image_id": 1, "category_id": 1, "num_keypoints": 16,
                 "keypoints": [1, 2, 2, 3, 4, 1, 0, 0, 0, {rest}]}}],
             "categories": [{{"id": 1, "name": "person"}}]}}"#
    );
    let found = views(
        coco::decode(text.as_bytes()).unwrap(),
        &DetectorOptions::default(),
    );
    let view = &found.views()[0];
    assert_eq!(found.frame_count(), 2);
    assert_eq!(pixel(view, 0, 0), Some(([1.0, 2.0], 2.0)));
    assert_eq!(pixel(view, 0, 1), Some(([3.0, 4.0], 2.0 / 0.5f64.sqrt())));
    assert_eq!(pixel(view, 0, 2), None);
    // A picture without people.
    assert!(view.frames[1].iter().all(Option::is_none));
}

#[test]
fn categories_name_other_joints() {
    let text = r#"{"annotations": [{"image_id": "a.png", "category_id": 4, "keypoints": [1, 2, 2, 0, 0, 0]}],
        "categories": [{"id": 1, "keypoints": ["x"]}, {"id": 4, "keypoints": ["hip", "knee"]}]}"#;
    let found = coco::decode(text.as_bytes()).unwrap();
    assert_eq!(found.joints, ["hip", "knee"]);
    assert_eq!(found.frames[0].key, FrameKey::Name("a.png".to_owned()));
}

#[test]
fn files_of_openpose_are_frames() {
    let file = |confidence: f64| {
        format!(
            r#"{{"version": 1.3, "people": [{{"person_id": [-1], "pose_keypoints_2d": [{}],
                "face_keypoints_2d": []}}]}}"#,
            keypoints(25, confidence)
        )
    };
    let (a, b) = (file(1.0), file(0.25));
    let nobody = r#"{"version": 1.3, "people": []}"#;
    let files = [
        ("walk_000000000012_keypoints.json", b.as_bytes()),
        ("walk_000000000003_keypoints.json", a.as_bytes()),
        ("walk_000000000007_keypoints.json", nobody.as_bytes()),
    ];
    let found = openpose::decode(&files).unwrap();
    assert_eq!(found.joints, openpose::BODY_25);
    let keys: Vec<_> = found.frames.iter().map(|frame| frame.key.clone()).collect();
    assert_eq!(keys, [3, 7, 12].map(FrameKey::Number));
    let found = views(found, &DetectorOptions::default());
    let view = &found.views()[0];
    assert_eq!(pixel(view, 0, 24), Some(([240.0, 480.0], 2.0)));
    assert_eq!(pixel(view, 1, 24), None);
    assert_eq!(pixel(view, 2, 24), Some(([240.0, 480.0], 4.0)));

    let eighteen = format!(
        r#"{{"people": [{{"pose_keypoints_2d": [{}]}}]}}"#,
        keypoints(18, 1.0)
    );
    let found = openpose::decode(&[("x.json", eighteen.as_bytes())]).unwrap();
    assert_eq!(found.joints, openpose::COCO_18);
    let mixed = [("a1.json", a.as_bytes()), ("a2.json", eighteen.as_bytes())];
    let text = openpose::decode(&mixed).unwrap_err().to_string();
    for part in ["a2.json", "person 0", "54", "75"] {
        assert!(text.contains(part), "{text}");
    }
    // OpenPose's documentation numbers the 18 joints in this way.
    for (index, name) in [
        (0, "Nose"),
        (1, "Neck"),
        (7, "LWrist"),
        (8, "RHip"),
        (13, "LAnkle"),
        (17, "LEar"),
    ] {
        assert_eq!(openpose::COCO_18[index], name);
    }
}

#[test]
fn joints_of_little_confidence_are_missing() {
    let numbers = (0..17).map(|k| format!("{k}, {k}, {}", 0.01 * f64::from(k)));
    let numbers: Vec<String> = numbers.collect();
    let text = format!(
        r#"[{{"image_id": 1, "keypoints": [{}]}}]"#,
        numbers.join(",")
    );
    let detections = coco::decode(text.as_bytes()).unwrap();
    let found = views(detections, &DetectorOptions::default());
    let is_there: Vec<bool> = found.views()[0].frames[0]
        .iter()
        .map(Option::is_some)
        .collect();
    let wanted: Vec<bool> = (0..17).map(|k| k >= 5).collect();
    assert_eq!(is_there, wanted);
}

#[test]
fn pictures_of_several_views_belong_together_by_their_numbers() {
    let view = |ids: &[i64]| {
        let people = ids.iter().map(|id| {
            let keypoints = keypoints(17, 1.0).replacen("0, 0", &format!("{id}, 0"), 1);
            format!(r#"{{"image_id": {id}, "keypoints": [{keypoints}]}}"#)
        });
        let text = format!("[{}]", people.collect::<Vec<_>>().join(","));
        coco::decode(text.as_bytes()).unwrap()
    };
    let join = |a: &[i64], b: &[i64]| {
        let views = [("a".to_owned(), view(a)), ("b".to_owned(), view(b))];
        JointViews::from_detections(&views, &DetectorOptions::default())
    };
    let nose = |views: &JointViews, view: usize| -> Vec<Option<f64>> {
        let frames = views.views()[view].frames.iter();
        frames
            .map(|frame| frame[0].map(|pixel| pixel.position[0]))
            .collect()
    };
    let joined = join(&[1, 2, 4], &[2, 3]).unwrap();
    assert_eq!(nose(&joined, 0), [Some(1.0), Some(2.0), None, Some(4.0)]);
    assert_eq!(nose(&joined, 1), [None, Some(2.0), Some(3.0), None]);
    // Without a common number, by their order.
    let joined = join(&[1, 2], &[11, 12]).unwrap();
    assert_eq!(nose(&joined, 1), [Some(11.0), Some(12.0)]);
    assert!(matches!(
        join(&[1], &[5, 6]),
        Err(JointsError::Frames { .. })
    ));
}

#[test]
fn bad_files_name_person_joint_and_index() {
    let short = format!(
        r#"[{{"image_id": 5, "keypoints": [{}]}}]"#,
        keypoints(16, 1.0)
    );
    let text = coco::decode(short.as_bytes()).unwrap_err().to_string();
    for part in ["picture 5", "person 0", "48", "51"] {
        assert!(text.contains(part), "{text}");
    }
    let negative = format!(
        r#"[{{"image_id": 5, "keypoints": [{}, 7, 8, -0.5]}}]"#,
        keypoints(16, 1.0)
    );
    let error = coco::decode(negative.as_bytes()).unwrap_err();
    let text = error.to_string();
    for part in ["picture 5", "person 0", "right_ankle", "16", "-0.5"] {
        assert!(text.contains(part), "{text}");
    }
    assert!(matches!(
        error,
        JointsError::OfPerson {
            index: 16,
            problem: JointProblem::Confidence(_),
            ..
        }
    ));
    let lost = r#"{"images": [{"id": 1}], "annotations": [{"image_id": 2, "keypoints": []}]}"#;
    assert!(matches!(
        coco::decode(lost.as_bytes()),
        Err(JointsError::NoImage { annotation: 0, .. })
    ));
    assert!(matches!(
        coco::decode(b"[]"),
        Err(JointsError::Empty("pictures"))
    ));
    assert!(matches!(coco::decode(b"[1"), Err(JointsError::Json(_))));
    let odd = r#"{"people": [{"pose_keypoints_2d": [1, 2]}]}"#;
    let text = openpose::decode(&[("f.json", odd.as_bytes())])
        .unwrap_err()
        .to_string();
    assert!(
        text.contains("f.json") && text.contains("2 numbers"),
        "{text}"
    );
}

#[test]
fn bad_views_name_view_frame_and_joint() {
    let decode = |views: &str| {
        let text = format!(r#"{{"version": 1, "joints": ["Hips", "Head"], "views": [{views}]}}"#);
        JointViews::decode(text.as_bytes())
    };
    assert!(decode(r#"{"name": "a", "frames": [[null, [1, 2, 0.5]]]}"#).is_ok());
    let cases: [(&str, &[&str]); 7] = [
        (
            r#"{"name": "a", "frames": [[null]]}"#,
            &["\"a\"", "frame 0", "1 joints", "2 are named"],
        ),
        (
            r#"{"name": "a", "frames": [[null, [1]]]}"#,
            &["\"a\"", "frame 0", "\"Head\" (1)", "1 numbers"],
        ),
        (
            r#"{"name": "a", "frames": [[null, [1, 2, 0]]]}"#,
            &["\"Head\" (1)", "0 px"],
        ),
        (r#"{"name": "a", "frames": []}"#, &["no frames"]),
        ("", &["no views"]),
        (
            r#"{"name": "a", "frames": [[null, null]]}, {"name": "b", "frames": []}"#,
            &["\"b\"", "0 frames"],
        ),
        (
            r#"{"name": "a", "frames": [[null, null]]}, {"name": "a", "frames": [[null, null]]}"#,
            &["two views", "\"a\""],
        ),
    ];
    for (views, parts) in cases {
        let text = decode(views).unwrap_err().to_string();
        for part in parts {
            assert!(text.contains(part), "{part:?} is not in {text:?}");
        }
    }
    let version = br#"{"version": 2, "joints": ["a"], "views": []}"#;
    assert!(matches!(
        JointViews::decode(version),
        Err(JointsError::Version { found: 2, .. })
    ));
    let unknown = br#"{"version": 1, "joints": ["a"], "views": [], "fps": 3}"#;
    assert!(matches!(
        JointViews::decode(unknown),
        Err(JointsError::Json(_))
    ));
    let rate = br#"{"version": 1, "joints": ["a"], "frames_per_second": 0, "views": []}"#;
    assert!(matches!(
        JointViews::decode(rate),
        Err(JointsError::FrameRate(_))
    ));
}

#[test]
fn files_and_folders_are_read_by_what_they_hold() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, text).unwrap();
        path
    };
    let pose = format!(
        r#"{{"people": [{{"pose_keypoints_2d": [{}]}}]}}"#,
        keypoints(25, 1.0)
    );
    for frame in 0..3 {
        write(&format!("left/l_{frame:012}_keypoints.json"), &pose);
        write(&format!("right/r_{frame:012}_keypoints.json"), &pose);
    }
    let options = DetectorOptions::default();
    let folders = ["left", "right"].map(|name| folder.path().join(name));
    let read = JointViews::read(&folders, &options).unwrap();
    assert_eq!(
        (read.views().len(), read.frame_count(), read.joints().len()),
        (2, 3, 25)
    );
    assert_eq!(read.views()[1].name, "right");

    let own = write("own.json", &read.encode());
    assert_eq!(JointViews::read(&[&own], &options).unwrap(), read);
    let text = JointViews::read(&[&own, &own], &options)
        .unwrap_err()
        .to_string();
    assert!(text.contains("own.json"), "{text}");

    let result = format!(
        r#"[{{"image_id": 1, "keypoints": [{}]}}]"#,
        keypoints(17, 1.0)
    );
    let [a, b] = ["a.json", "b.json"].map(|name| write(name, &result));
    assert_eq!(
        JointViews::read(&[a.clone(), b], &options)
            .unwrap()
            .views()
            .len(),
        2
    );
    // Views of different joints, and files that are damaged or not there.
    let mixed = JointViews::read(&[a, folders[0].clone()], &options).unwrap_err();
    assert!(mixed.to_string().contains("left"), "{mixed}");
    let damaged = write("left/l_000000000009_keypoints.json", r#"{"people": 1}"#);
    let text = JointViews::read(&folders, &options)
        .unwrap_err()
        .to_string();
    assert!(text.contains("l_000000000009"), "{text} {damaged:?}");
    let text = JointViews::read(&["nowhere.json"], &options)
        .unwrap_err()
        .to_string();
    assert!(text.contains("nowhere.json"), "{text}");
}

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

proptest! {
    #[test]
    fn what_is_written_is_read(
        frames in prop::collection::vec(
            prop::collection::vec(
                prop::option::of((-1e4..1e4f64, -1e4..1e4f64, 1e-3..1e3f64)),
                3,
            ),
            1..6,
        ),
        rate in prop::option::of(1.0..500.0f64),
    ) {
        let pixel = |(u, v, deviation)| JointPixel { position: [u, v], deviation };
        let frames: Vec<Vec<_>> = frames
            .into_iter()
            .map(|frame| frame.into_iter().map(|joint| joint.map(pixel)).collect())
            .collect();
        let names = ["Hips", "a \"b\"", "ä"].map(str::to_owned).to_vec();
        let view = |name: &str| JointView { name: name.to_owned(), frames: frames.clone() };
        let joints = JointViews::new(names, rate, vec![view("left"), view("right")]).unwrap();
        prop_assert_eq!(JointViews::decode(joints.encode().as_bytes()).unwrap(), joints);
    }
}

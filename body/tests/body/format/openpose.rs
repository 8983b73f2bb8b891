//! People in the format of OpenPose.

use ga_body::format::{DetectorOptions, FrameKey, JointViews, JointsError, Model, openpose};

use super::{keypoints, pixel, views};

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
    let found = openpose::decode(&files, None).unwrap();
    assert_eq!(found.joints, openpose::BODY_25);
    let keys: Vec<_> = found.frames.iter().map(|frame| frame.key.clone()).collect();
    assert_eq!(keys, [3, 7, 12].map(FrameKey::Number));
    let found = views(found, &DetectorOptions::default());
    let view = &found.views()[0];
    assert_eq!(pixel(view, 0, 24), Some(([240.0, 480.0], 2.0)));
    // Numbers between are frames too.
    assert_eq!(found.frame_count(), 10);
    assert_eq!(pixel(view, 4, 24), None);
    assert_eq!(pixel(view, 9, 24), Some(([240.0, 480.0], 4.0)));

    let eighteen = format!(
        r#"{{"people": [{{"pose_keypoints_2d": [{}]}}]}}"#,
        keypoints(18, 1.0)
    );
    let found = openpose::decode(&[("x.json", eighteen.as_bytes())], None).unwrap();
    assert_eq!(found.joints, openpose::COCO_18);
    let mixed = [("a1.json", a.as_bytes()), ("a2.json", eighteen.as_bytes())];
    let text = openpose::decode(&mixed, None).unwrap_err().to_string();
    for part in ["a2.json", "person 0", "18", "25"] {
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

/// Other detectors' joints in this form: the names follow from their number, or are given.
#[test]
fn joints_of_other_models_are_named() {
    let Some(folder) = nullcone_shared_data::shared("cases/people/openpose-json-other-models")
    else {
        return;
    };
    let read = |file: &str, model| {
        let options = DetectorOptions {
            model,
            ..DetectorOptions::default()
        };
        JointViews::read(&[folder.join(file)], &options)
    };
    // Joint k is at (300 + 3 k, 200 + 2 k).
    let check = |file: &str, joints: &[(usize, &str)]| {
        let found = read(file, None).unwrap();
        for &(index, name) in joints {
            let joint = found.joints().iter().position(|joint| joint == name);
            let place = pixel(&found.views()[0], 0, joint.unwrap()).unwrap().0;
            let k = index as f64;
            assert_eq!(place, [300.0 + 3.0 * k, 200.0 + 2.0 * k], "{name}");
        }
    };
    let halpe = "halpe26_000000000000_keypoints.json";
    let blazepose = "blazepose33_000000000000_keypoints.json";
    check(
        halpe,
        &[
            (5, "left_shoulder"),
            (17, "head_top"),
            (20, "left_big_toe"),
            (25, "right_heel"),
        ],
    );
    check(
        blazepose,
        &[
            (0, "nose"),
            (11, "left_shoulder"),
            (24, "right_hip"),
            (31, "left_foot_index"),
        ],
    );
    let wrong = read(halpe, Some(Model::Body25)).unwrap_err().to_string();
    for part in [halpe, "26 joints", "body25 has 25"] {
        assert!(wrong.contains(part), "{part:?} is not in {wrong:?}");
    }
}

#[test]
fn the_model_is_given_where_several_have_as_many_joints() {
    let file = |count| {
        let numbers = keypoints(count, 1.0);
        format!(r#"{{"people": [{{"pose_keypoints_2d": [{numbers}]}}]}}"#)
    };
    let decode = |count, model| openpose::decode(&[("a.json", file(count).as_bytes())], model);
    assert_eq!(decode(25, None).unwrap().joints[8], "MidHip");
    let other = decode(25, Some(Model::Body25b)).unwrap();
    assert_eq!(
        (other.joints[8].as_str(), other.joints[24].as_str()),
        ("right_elbow", "right_heel")
    );
    let unknown = decode(20, None).unwrap_err();
    assert!(matches!(
        unknown,
        JointsError::UnknownCount { found: 20, .. }
    ));
    let odd = r#"{"people": [{"pose_keypoints_2d": [1, 2]}]}"#;
    let text = openpose::decode(&[("f.json", odd.as_bytes())], None)
        .unwrap_err()
        .to_string();
    assert!(
        text.contains("f.json") && text.contains("2 numbers"),
        "{text}"
    );
    let missing = r#"{"people": [{"pose_keypoints_2d": [null, 2, 3]}]}"#;
    let text = openpose::decode(&[("f.json", missing.as_bytes())], None)
        .unwrap_err()
        .to_string();
    assert!(text.contains("f.json") && text.contains("null"), "{text}");
}

/// A view in which nobody is seen has the joints of the others.
#[test]
fn a_view_of_nobody_is_not_of_another_kind() {
    let one = format!(
        r#"{{"people": [{{"pose_keypoints_2d": [{}]}}]}}"#,
        keypoints(26, 1.0)
    );
    let nobody = r#"{"people": []}"#;
    let decode = |text: &str| openpose::decode(&[("1.json", text.as_bytes())], None).unwrap();
    let of = |texts: [&str; 2]| {
        let views = texts.map(|text| (text.len().to_string(), decode(text)));
        JointViews::from_detections(&views, &DetectorOptions::default())
    };
    let found = of([nobody, &one]).unwrap();
    assert_eq!(found.joints()[19], "hip");
    assert_eq!(pixel(&found.views()[0], 0, 19), None);
    assert!(pixel(&found.views()[1], 0, 19).is_some());
    let empty = [("a".to_owned(), decode(nobody))];
    let empty = JointViews::from_detections(&empty, &DetectorOptions::default());
    assert!(matches!(empty, Err(JointsError::Empty("people"))));
}

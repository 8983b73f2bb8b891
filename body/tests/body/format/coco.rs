//! People in the format of COCO, and of AlphaPose's lists.

use ga_body::format::{
    DetectorOptions, FrameKey, JointViews, JointsError, JointsNote, Model, alphapose, coco,
};

use super::{keypoints, pixel, views};

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
    let found = coco::decode(text.as_bytes(), None).unwrap();
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
        coco::decode(text.as_bytes(), None).unwrap(),
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
    let found = coco::decode(text.as_bytes(), None).unwrap();
    assert_eq!(found.joints, ["hip", "knee"]);
    assert_eq!(found.frames[0].key, FrameKey::Name("a.png".to_owned()));
}

#[test]
fn joints_of_little_confidence_are_missing() {
    let numbers = (0..17).map(|k| format!("{k}, {k}, {}", 0.01 * f64::from(k)));
    let numbers: Vec<String> = numbers.collect();
    let text = format!(
        r#"[{{"image_id": 1, "keypoints": [{}]}}]"#,
        numbers.join(",")
    );
    let detections = coco::decode(text.as_bytes(), None).unwrap();
    let found = views(detections, &DetectorOptions::default());
    let is_there: Vec<bool> = found.views()[0].frames[0]
        .iter()
        .map(Option::is_some)
        .collect();
    let wanted: Vec<bool> = (0..17).map(|k| k >= 5).collect();
    assert_eq!(is_there, wanted);
}

/// The last number in a name is that of the picture, padded or not.
#[test]
fn names_of_pictures_are_ordered_by_their_numbers() {
    let list = |name: &dyn Fn(usize) -> String| {
        let picture = |id: usize| {
            let numbers = keypoints(17, 1.0).replacen("0, 0", &format!("{id}, 0"), 1);
            format!(
                r#"{{"image_id": {:?}, "keypoints": [{numbers}]}}"#,
                name(id)
            )
        };
        // As AlphaPose writes them, in the order of the film.
        let pictures: Vec<String> = (0..12).map(picture).collect();
        let text = format!("[{}]", pictures.join(","));
        coco::decode(text.as_bytes(), None).unwrap()
    };
    for name in [
        &(|id| format!("{id}.jpg")) as &dyn Fn(usize) -> String,
        &|id| format!("{id:04}.jpg"),
        &|id| format!("cam2_{id}.mp4.jpg"),
        &|id| format!("{id}_cam2.jpg"),
        // Of several numbers that differ, the last.
        &|id| format!("{}_{id}.jpg", 100 - id),
    ] {
        let found = list(name);
        let keys: Vec<FrameKey> = found.frames.iter().map(|frame| frame.key.clone()).collect();
        let wanted: Vec<FrameKey> = (0..12).map(FrameKey::Number).collect();
        assert_eq!(keys, wanted, "{}", name(0));
        let view = &views(found, &DetectorOptions::default()).views()[0].clone();
        for frame in 0..12 {
            let u = pixel(view, frame, 0).unwrap().0[0];
            assert_eq!(u, frame as f64, "{}", name(frame));
        }
    }
    // Numbers that do not tell pictures apart: the natural order of the names.
    let found = list(&|id| format!("{}{}-7.jpg", ["a", "b"][id % 2], id / 2));
    let keys: Vec<String> = found
        .frames
        .iter()
        .map(|frame| frame.key.to_string())
        .collect();
    assert_eq!(keys[0], "picture \"a0-7.jpg\"");
    assert_eq!(keys[11], "picture \"b5-7.jpg\"");
}

#[test]
fn padded_and_plain_names_give_one_clip() {
    let Some(folder) = nullcone_shared_data::shared("cases/people/body-alphapose-order") else {
        return;
    };
    let read = |padding: &str| {
        let paths = ["cam0", "cam1"].map(|view| folder.join(format!("{padding}_{view}.json")));
        JointViews::read(&paths, &DetectorOptions::default()).unwrap()
    };
    let [plain, padded] = ["pad1", "pad4"].map(read);
    assert_eq!(plain.frame_count(), 12);
    for (plain, padded) in plain.views().iter().zip(padded.views()) {
        assert_eq!(plain.frames, padded.frames);
    }
    let text = std::fs::read(folder.join("pad1_cam1.json")).unwrap();
    let entries: Vec<serde_json::Value> = serde_json::from_slice(&text).unwrap();
    for entry in entries {
        let frame = entry["image_id"].as_str().unwrap().strip_suffix(".jpg");
        let frame: usize = frame.unwrap().parse().unwrap();
        let shoulder = [15, 16].map(|index| entry["keypoints"][index].as_f64().unwrap());
        assert_eq!(pixel(&plain.views()[1], frame, 5).unwrap().0, shoulder);
    }
}

/// The same people in AlphaPose's other formats, whose pictures are members of an object.
#[test]
fn formats_of_alphapose_are_read() {
    let joints = |first: f64| keypoints(18, 0.5).replacen("0, 0", &format!("{first}, 3"), 1);
    let cmu = |first| {
        format!(
            r#"{{"version": "0.3", "bodies": [{{"joints": [{}]}}]}}"#,
            joints(first)
        )
    };
    let open = |first| {
        cmu(first)
            .replace("bodies", "people")
            .replace("joints", "pose_keypoints_2d")
    };
    for body in [&cmu as &dyn Fn(f64) -> String, &open] {
        let text = format!(r#"{{"10.jpg": {}, "9.jpg": {}}}"#, body(10.0), body(9.0));
        let found = alphapose::decode(text.as_bytes(), None).unwrap();
        assert_eq!(found.joints[8], "RHip");
        let found = views(found, &DetectorOptions::default());
        let [first, second] = [0, 1].map(|frame| pixel(&found.views()[0], frame, 0).unwrap());
        assert_eq!(first, ([9.0, 3.0], 2.0 / 0.5f64.sqrt()));
        assert_eq!(second.0, [10.0, 3.0]);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("left.json");
        std::fs::write(&path, &text).unwrap();
        let read = JointViews::read(&[path], &DetectorOptions::default()).unwrap();
        assert_eq!(read.views()[0].frames, found.views()[0].frames);
    }
    let short = r#"{"1.jpg": {"bodies": [{"joints": [1, 2, 1, 3]}]}}"#;
    let text = alphapose::decode(short.as_bytes(), None)
        .unwrap_err()
        .to_string();
    assert!(
        text.contains("1.jpg") && text.contains("4 numbers"),
        "{text}"
    );
}

/// Scores of networks that are not probabilities.
#[test]
fn joints_with_negative_confidences_are_missing_and_noted() {
    let text = format!(
        r#"[{{"image_id": 5, "keypoints": [{}, 7, 8, -0.5]}}]"#,
        keypoints(16, 1.5)
    );
    let found = coco::decode(text.as_bytes(), None).unwrap();
    assert_eq!(found.frames[0].people[0].joints[16], None);
    let found = views(found, &DetectorOptions::default());
    assert_eq!(pixel(&found.views()[0], 0, 15), Some(([150.0, 300.0], 2.0)));
    assert_eq!(pixel(&found.views()[0], 0, 16), None);
    let note = JointsNote::NegativeConfidences {
        view: "a".to_owned(),
        joints: 1,
    };
    assert_eq!(found.notes(), [note]);
}

#[test]
fn bad_files_name_person_joint_and_index() {
    let with = |numbers: &str, model| {
        let text = format!(r#"[{{"image_id": 5, "keypoints": [{numbers}]}}]"#);
        coco::decode(text.as_bytes(), model).unwrap_err()
    };
    let contains = |error: JointsError, parts: &[&str]| {
        let text = error.to_string();
        for part in parts {
            assert!(text.contains(part), "{part:?} is not in {text:?}");
        }
    };
    let place = ["picture 5", "person 0"];
    // As many joints as MPII and other models have.
    let unclear = with(&keypoints(16, 1.0), None);
    contains(
        unclear,
        &[&place[..], &["16 joints", "mpii16 (16)"]].concat(),
    );
    let other = with(&keypoints(16, 1.0), Some(Model::Coco17));
    contains(
        other,
        &[&place[..], &["16 joints", "coco17 has 17"]].concat(),
    );
    let half = with("1, 2, 1, 4", None);
    contains(half, &[&place[..], &["4 numbers"]].concat());
    let far = format!("{}, 7, 1e999, 0.5", keypoints(16, 1.0));
    assert!(matches!(with(&far, None), JointsError::Json(_)));
    let named = r#"{"annotations": [{"image_id": 1, "keypoints": [1, 2, 2]}],
        "categories": [{"id": 1, "keypoints": ["hip", "knee"]}]}"#;
    let named = coco::decode(named.as_bytes(), None).unwrap_err();
    contains(named, &["picture 1", "1 joints", "2 are named"]);
    let lost = r#"{"images": [{"id": 1}], "annotations": [{"image_id": 2, "keypoints": []}]}"#;
    assert!(matches!(
        coco::decode(lost.as_bytes(), None),
        Err(JointsError::NoImage { annotation: 0, .. })
    ));
    assert!(matches!(
        coco::decode(b"[]", None),
        Err(JointsError::Empty("pictures"))
    ));
    assert!(matches!(
        coco::decode(b"[1", None),
        Err(JointsError::Json(_))
    ));
}

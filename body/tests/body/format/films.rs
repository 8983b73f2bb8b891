//! People in films: the formats of MMPose and of programs with MediaPipe.

use ga_body::format::{
    Detections, DetectorOptions, FrameKey, JointViews, JointsError, Model, film, mmpose,
};
use serde_json::{Value, json};

use super::{pixel, views};

/// A person of MMPose, joint k at (10 k + shift, 20 k).
fn instance(count: usize, shift: usize, score: f64) -> Value {
    let places: Vec<[usize; 2]> = (0..count).map(|k| [10 * k + shift, 20 * k]).collect();
    json!({"keypoints": places, "keypoint_scores": vec![score; count], "bbox": [[0, 0, 9, 9]],
        "bbox_score": 0.9})
}

fn of_mmpose(value: &Value) -> Result<Detections, JointsError> {
    mmpose::decode(value.to_string().as_bytes(), None)
}

#[test]
fn films_of_mmpose_are_read() {
    let frames = json!([
        {"frame_id": 1, "instances": [instance(17, 0, 1.2), instance(17, 1, 0.25)]},
        {"frame_id": 2, "instances": []},
        {"frame_id": 3, "instances": [instance(17, 2, 0.25)]},
    ]);
    let with_names = json!({"meta_info": {"dataset_name": "coco"}, "instance_info": frames});
    for film in [&frames, &with_names] {
        let found = of_mmpose(film).unwrap();
        assert_eq!(found.frames[0].key, FrameKey::Number(1));
        assert_eq!(found.frames[0].people.len(), 2);
        let found = views(found, &DetectorOptions::default());
        let view = &found.views()[0];
        assert_eq!(found.joints()[5], "left_shoulder");
        assert_eq!(pixel(view, 0, 5), Some(([50.0, 100.0], 2.0)));
        assert_eq!(pixel(view, 1, 5), None);
        assert_eq!(pixel(view, 2, 5), Some(([52.0, 100.0], 4.0)));
        assert_eq!(found.notes(), []);
    }
    // The same frames as files of pictures in a folder.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("view");
    std::fs::create_dir(&path).unwrap();
    for frame in frames.as_array().unwrap() {
        let name = path.join(format!("film_{}.json", frame["frame_id"]));
        std::fs::write(name, frame["instances"].to_string()).unwrap();
    }
    let read = |path| JointViews::read(&[path], &DetectorOptions::default());
    let pictures = read(path.clone()).unwrap();
    let film = folder.path().join("film.json");
    std::fs::write(&film, with_names.to_string()).unwrap();
    let film = read(film).unwrap();
    assert_eq!(pictures.views()[0].frames, film.views()[0].frames);
    // A film among the pictures.
    std::fs::write(path.join("film_4.json"), frames.to_string()).unwrap();
    let text = read(path).unwrap_err().to_string();
    assert!(
        text.contains("film_4.json") && text.contains("one picture"),
        "{text}"
    );
}

#[test]
fn joints_have_the_names_of_mmpose_or_of_the_model() {
    let with = |names: Value, count| {
        of_mmpose(&json!({"meta_info": {"keypoint_id2name": names},
            "instance_info": [instance(count, 0, 1.0)]}))
    };
    let own = with(json!({"0": "tail", "1": "paw"}), 2).unwrap();
    assert_eq!(own.joints, ["tail", "paw"]);
    // MMPose calls the roots of Halpe's hands wrists, which are there already, and the top of the
    // head as skeletons call the joint below it.
    let mut halpe = Model::Halpe136.joints();
    halpe[17] = "head".to_owned();
    halpe[94] = "left_wrist".to_owned();
    halpe[115] = "right_wrist".to_owned();
    let names: serde_json::Map<String, Value> = halpe
        .iter()
        .enumerate()
        .map(|(index, name)| (index.to_string(), json!(name)))
        .collect();
    assert_eq!(
        with(names.into(), 136).unwrap().joints,
        Model::Halpe136.joints()
    );
    let text = with(json!({"0": "tail", "1": "paw"}), 3)
        .unwrap_err()
        .to_string();
    assert!(
        text.contains("3 joints") && text.contains("2 are named"),
        "{text}"
    );
}

#[test]
fn bad_films_of_mmpose_name_frame_and_person() {
    let frame = |change: &dyn Fn(&mut Value)| {
        let mut person = instance(17, 0, 1.0);
        change(&mut person);
        json!([{"frame_id": 7, "instances": [instance(17, 0, 1.0), person]}])
    };
    let twice = json!([{"frame_id": 7, "instances": []}, {"frame_id": 7, "instances": []}]);
    let cases: [(Value, &[&str]); 8] = [
        (
            frame(&|person| person["keypoint_scores"] = json!([1, 1])),
            &["picture 7", "person 1", "17 joints", "2 scores"],
        ),
        (
            frame(&|person| person["keypoints"][4] = json!([1, 2, 3])),
            &["picture 7", "person 1", "joint 4", "3 numbers", "u and v"],
        ),
        (
            frame(&|person| person["keypoints"] = json!([])),
            &["picture 7", "person 1", "0 joints"],
        ),
        (
            frame(&|person| *person = instance(26, 0, 1.0)),
            &["person 1", "26 joints", "17"],
        ),
        (
            frame(&|person| person["keypoints"][4] = json!(1)),
            &["JSON", "line 1"],
        ),
        (twice, &["two frames 7"]),
        (
            json!([{"frame_id": 7}, {"frame_id": 8, "instances": []}]),
            &["entry 0"],
        ),
        (json!({"instance_info": []}), &["no pictures"]),
    ];
    for (film, parts) in cases {
        let mut film = film;
        if let Some(person) = film.pointer_mut("/0/instances/1/keypoint_scores")
            && parts.contains(&"0 joints")
        {
            *person = json!([]);
        }
        let text = of_mmpose(&film).unwrap_err().to_string();
        for part in parts {
            assert!(text.contains(part), "{part:?} is not in {text:?}");
        }
    }
}

fn of_film(value: &Value) -> Result<Detections, JointsError> {
    film::decode(value.to_string().as_bytes(), None)
}

#[test]
fn films_of_one_person_have_a_frame_rate() {
    let joints: Vec<[f64; 3]> = (0..33).map(|k| [f64::from(k), 2.0, 1.0]).collect();
    let mut hidden: Vec<Value> = joints.iter().map(|joint| json!(joint)).collect();
    hidden[11] = Value::Null;
    let film = |rate: Option<f64>| {
        json!({"width": 640, "height": 480, "frames_per_second": rate,
            "frames": [null, joints, hidden]})
    };
    let found = of_film(&film(Some(59.94))).unwrap();
    assert_eq!(found.frames_per_second, Some(59.94));
    let of = |rates: [Option<f64>; 2], given| {
        let named = |rate| (format!("{rate:?}"), of_film(&film(rate)).unwrap());
        let options = DetectorOptions {
            frames_per_second: given,
            ..DetectorOptions::default()
        };
        JointViews::from_detections(&rates.map(named), &options)
    };
    let found = of([Some(59.94), Some(60.0 / 1.001)], None).unwrap();
    assert_eq!(found.frames_per_second(), Some(59.94));
    let view = &found.views()[1];
    assert_eq!(
        [0, 1, 2].map(|frame| pixel(view, frame, 11).is_some()),
        [false, true, false]
    );
    assert_eq!(pixel(view, 2, 12), Some(([12.0, 2.0], 2.0)));
    assert_eq!(
        of([None, Some(25.0)], None).unwrap().frames_per_second(),
        Some(25.0)
    );
    let text = of([Some(25.0), Some(30.0)], None).unwrap_err().to_string();
    assert!(
        text.contains("\"Some(25.0)\" has 25") && text.contains("has 30"),
        "{text}"
    );
    assert_eq!(
        of([Some(25.0), Some(30.0)], Some(50.0))
            .unwrap()
            .frames_per_second(),
        Some(50.0)
    );
}

#[test]
fn bad_films_name_frame_and_joint() {
    let joints = |count: usize| json!(vec![[1.0, 2.0, 1.0]; count]);
    let mut short = joints(33);
    short[4] = json!([1, 2]);
    let cases: [(Value, &[&str]); 6] = [
        (
            json!({"frames": [joints(33), short]}),
            &["picture 1", "joint 4", "2 numbers"],
        ),
        (
            json!({"frames": [joints(33), joints(32)]}),
            &["picture 1", "32 joints", "33"],
        ),
        (
            json!({"frames": [joints(32)]}),
            &["picture 0", "32 joints", "mediapipe (33)"],
        ),
        (
            json!({"joints": ["a"], "frames": [joints(2)]}),
            &["2 joints", "1 are named"],
        ),
        (json!({"frames": []}), &["no pictures"]),
        (
            json!({"frames_per_second": 0, "frames": [joints(33)]}),
            &["0 frames a second"],
        ),
    ];
    for (film, parts) in cases {
        let text = of_film(&film).unwrap_err().to_string();
        for part in parts {
            assert!(text.contains(part), "{part:?} is not in {text:?}");
        }
    }
    let own = of_film(&json!({"joints": ["a", "b"], "frames": [joints(2)]})).unwrap();
    assert_eq!(own.joints, ["a", "b"]);
}

/// The same detections as a film of MediaPipe and as COCO's results, which have 17 of the joints.
#[test]
fn the_film_of_a_man_on_a_treadmill_is_read() {
    let Some(folder) = nullcone_shared_data::shared("data/people") else {
        return;
    };
    let read = |form: &str| {
        let files = [1, 2, 3, 4].map(|view| folder.join(format!("{form}/cam0{view}.json")));
        JointViews::read(&files, &DetectorOptions::default()).unwrap()
    };
    let (film, list) = (read("mediapipe"), read("coco"));
    assert_eq!(film.frames_per_second(), Some(60.0));
    assert_eq!(list.frames_per_second(), None);
    assert_eq!((film.frame_count(), list.frame_count()), (100, 100));
    let mut seen = 0;
    for (index, name) in list.joints().iter().enumerate() {
        let same = film
            .joints()
            .iter()
            .position(|joint| joint == name)
            .unwrap();
        for (film, list) in film.views().iter().zip(list.views()) {
            for (film, list) in film.frames.iter().zip(&list.frames) {
                if let (Some(film), Some(list)) = (film[same], list[index]) {
                    seen += 1;
                    for (a, b) in film.position.iter().zip(list.position) {
                        // Two decimals and three.
                        assert!((a - b).abs() < 0.006, "{name}: {a} {b}");
                    }
                }
            }
        }
    }
    assert!(seen > 6000, "{seen}");
}

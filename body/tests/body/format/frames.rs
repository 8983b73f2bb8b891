//! Frames of several views, and those between pictures.

use ga_body::format::{Detections, DetectorOptions, JointViews, JointsError, JointsNote, coco};

use super::keypoints;

/// A view with a person in each of these pictures, whose nose is at the number of the picture.
fn view(ids: &[i64]) -> Detections {
    let people = ids.iter().map(|id| {
        let keypoints = keypoints(17, 1.0).replacen("0, 0", &format!("{id}, 0"), 1);
        format!(r#"{{"image_id": {id}, "keypoints": [{keypoints}]}}"#)
    });
    let text = format!("[{}]", people.collect::<Vec<_>>().join(","));
    coco::decode(text.as_bytes(), None).unwrap()
}

fn join(views: &[&[i64]]) -> Result<JointViews, JointsError> {
    let named = |(index, ids): (usize, &&[i64])| (index.to_string(), view(ids));
    let views: Vec<(String, Detections)> = views.iter().enumerate().map(named).collect();
    JointViews::from_detections(&views, &DetectorOptions::default())
}

/// Where the nose is in the frames of a view.
fn nose(views: &JointViews, view: usize) -> Vec<Option<f64>> {
    let frames = views.views()[view].frames.iter();
    frames
        .map(|frame| frame[0].map(|pixel| pixel.position[0]))
        .collect()
}

fn missing(view: &str, missing: usize, frames: usize) -> JointsNote {
    JointsNote::FramesWithoutPeople {
        view: view.to_owned(),
        missing,
        frames,
    }
}

#[test]
fn pictures_of_several_views_belong_together_by_their_numbers() {
    let joined = join(&[&[1, 2, 4], &[2, 3]]).unwrap();
    assert_eq!(nose(&joined, 0), [Some(1.0), Some(2.0), None, Some(4.0)]);
    assert_eq!(nose(&joined, 1), [None, Some(2.0), Some(3.0), None]);
    assert_eq!(joined.notes(), [missing("0", 1, 4), missing("1", 2, 4)]);
    // Without a common number, by their order.
    let joined = join(&[&[1, 2], &[11, 12]]).unwrap();
    assert_eq!(nose(&joined, 1), [Some(11.0), Some(12.0)]);
    assert_eq!(joined.notes(), []);
    assert!(matches!(
        join(&[&[1], &[5, 6]]),
        Err(JointsError::Frames { .. })
    ));
}

#[test]
fn missing_numbers_are_frames_without_people() {
    // In both views, which the union of their numbers does not show.
    let joined = join(&[&[0, 1, 4], &[0, 4, 5]]).unwrap();
    let wanted = [Some(0.0), Some(1.0), None, None, Some(4.0), None];
    assert_eq!(nose(&joined, 0), wanted);
    assert_eq!(joined.notes(), [missing("0", 3, 6), missing("1", 3, 6)]);
    // Views that are numbered on have gaps of their own.
    let joined = join(&[&[0, 1, 3], &[100, 102, 103]]).unwrap();
    assert_eq!(nose(&joined, 0), [Some(0.0), Some(1.0), None, Some(3.0)]);
    assert_eq!(
        nose(&joined, 1),
        [Some(100.0), None, Some(102.0), Some(103.0)]
    );
}

#[test]
fn numbers_with_a_step_are_those_of_a_slower_film() {
    let joined = join(&[&[0, 10, 20, 40], &[10, 20, 30]]).unwrap();
    let wanted = [Some(0.0), Some(10.0), Some(20.0), None, Some(40.0)];
    assert_eq!(nose(&joined, 0), wanted);
    let notes = [
        JointsNote::Step { step: 10 },
        missing("0", 1, 5),
        missing("1", 2, 5),
    ];
    assert_eq!(joined.notes(), notes);
}

#[test]
fn numbers_that_are_not_of_frames_are_not_filled() {
    let joined = join(&[&[37777, 87038, 397_133]]).unwrap();
    assert_eq!(joined.frame_count(), 3);
    let note = JointsNote::NotFrameNumbers {
        view: "0".to_owned(),
        pictures: 3,
        span: 359_357,
    };
    assert_eq!(joined.notes(), [note]);
    // Nine of ten frames are empty, and one more.
    assert_eq!(join(&[&[0, 1, 29]]).unwrap().frame_count(), 30);
    assert_eq!(join(&[&[0, 1, 30]]).unwrap().frame_count(), 3);
    // The whole range of numbers.
    assert_eq!(join(&[&[i64::MIN, 0, i64::MAX]]).unwrap().frame_count(), 3);
}

#[test]
fn the_frames_of_a_film_in_which_nobody_was_found_are_there() {
    let Some(folder) = nullcone_shared_data::shared("cases/people/body-frames-without-people")
    else {
        return;
    };
    let paths = ["cam0.json", "cam1.json"].map(|name| folder.join(name));
    let found = JointViews::read(&paths, &DetectorOptions::default()).unwrap();
    assert_eq!(found.frame_count(), 12);
    assert_eq!(
        found.notes(),
        [missing("cam0", 3, 12), missing("cam1", 3, 12)]
    );
    for (view, path) in found.views().iter().zip(&paths) {
        let entries: Vec<serde_json::Value> =
            serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
        for (frame, joints) in view.frames.iter().enumerate() {
            let entry = entries.iter().find(|entry| entry["image_id"] == frame);
            let shoulder =
                entry.map(|entry| [15, 16].map(|k| entry["keypoints"][k].as_f64().unwrap()));
            assert_eq!(shoulder.is_none(), (5..8).contains(&frame));
            assert_eq!(joints[5].map(|pixel| pixel.position), shoulder);
        }
    }
}

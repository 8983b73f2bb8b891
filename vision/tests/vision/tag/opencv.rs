//! Pictures of tags and boards that OpenCV drew, and what its detectors find there.

use std::path::PathBuf;

use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_vision::calibration::BoardView;
use ga_vision::tag::{CharucoBoard, CharucoPattern, Dictionary, TagOptions, detect};
use serde_json::Value;

use super::scene::rms;

fn data(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "tests/data", name]
        .iter()
        .collect()
}

fn values() -> Value {
    serde_json::from_slice(&std::fs::read(data("tags.json")).unwrap()).unwrap()
}

fn grey(name: &str) -> Plane<u8> {
    ga_image::file::read(data(name))
        .unwrap()
        .to_grey(Luma::Bt601)
}

fn place(value: &Value) -> [f64; 2] {
    [0, 1].map(|k| value[k].as_f64().unwrap())
}

/// The numbers, and the corners in OpenCV's order.
#[test]
fn tags_are_those_of_opencv() {
    let values = values();
    for name in [
        "4X4_50",
        "5X5_250",
        "6X6_250",
        "APRILTAG_16h5",
        "APRILTAG_25h9",
        "APRILTAG_36h11",
    ] {
        let dictionary: Dictionary = name.parse().unwrap();
        let file = format!("tags_{}.png", name.to_lowercase());
        let found = detect(
            &grey(&file),
            TagOptions {
                dictionary,
                border: 1,
            },
        );
        let mut expected: Vec<u64> = values[&file]["ids"]
            .as_array()
            .unwrap()
            .iter()
            .map(|id| id.as_u64().unwrap())
            .collect();
        expected.sort_unstable();
        let ids: Vec<u64> = found.iter().map(|tag| tag.id as u64).collect();
        assert_eq!(ids, expected, "{name}");
        // Their corners are farther from the truth, by up to a third of a pixel.
        for (key, limit) in [("truth", 0.06), ("markers", 0.4)] {
            let corners = values[&file][key].as_object().unwrap();
            let pairs = found.iter().flat_map(|tag| {
                let corners = corners[&tag.id.to_string()].as_array().unwrap();
                tag.corners.into_iter().zip(corners.iter().map(place))
            });
            let error = rms(pairs);
            assert!(error < limit, "{name}, {key}: {error} px");
        }
    }
}

#[test]
fn charuco_corners_are_those_of_opencv() {
    let values = values();
    for (name, pattern) in [
        ("charuco", CharucoPattern::Current),
        ("charuco_legacy", CharucoPattern::Legacy),
    ] {
        let dictionary = Dictionary::Aruco5x5_100;
        let board = CharucoBoard::new([7, 6], [0.04, 0.03], dictionary, pattern).unwrap();
        for (point, theirs) in board
            .points()
            .iter()
            .zip(values[name]["points"].as_array().unwrap())
        {
            let [x, y, _] = point.coordinates();
            let [a, b] = place(theirs);
            assert!((x - a).abs() < 1e-6 && (y - b).abs() < 1e-6);
        }
        let picture = grey(&format!("{name}.png"));
        let found = board.find(&picture).unwrap();
        assert_eq!(found.points().len(), 30, "{name}");
        let theirs = values[name]["corners"].as_object().unwrap();
        assert_eq!(theirs.len(), 30);
        let pairs = found
            .points()
            .iter()
            .map(|seen| (seen.pixel, place(&theirs[&seen.point.to_string()])));
        let error = rms(pairs);
        assert!(error < 0.15, "{name}: {error} px");
        // The tags of the other pattern are elsewhere, and corners of the other colour are none.
        let other = match pattern {
            CharucoPattern::Current => CharucoPattern::Legacy,
            CharucoPattern::Legacy => CharucoPattern::Current,
        };
        let other = CharucoBoard::new([7, 6], [0.04, 0.03], dictionary, other).unwrap();
        assert_eq!(
            other.find(&picture).unwrap(),
            BoardView::default(),
            "{name}"
        );
    }
}

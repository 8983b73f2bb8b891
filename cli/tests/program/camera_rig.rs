//! `nullcone camera calibrate-rig`: several cameras from pictures of a chessboard.

use ga_camera::format;
use nullcone_shared_data::shared;
use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, nullcone, number};

fn arguments(views: &[&str]) -> Vec<String> {
    let fixed = "camera calibrate-rig --board 9x6 --square 0.025 --out rig.toml --json";
    let mut arguments: Vec<String> = fixed.split(' ').map(String::from).collect();
    for views in views {
        arguments.extend(["--views".to_owned(), (*views).to_owned()]);
    }
    arguments
}

/// The left camera of OpenCV's pair counts twice, with different pictures: it is at one place.
#[test]
fn a_camera_is_where_it_is_though_the_boards_between_are_seen_by_others() {
    let Some(pictures) = shared("data/vision/opencv") else {
        return;
    };
    let folder = tempdir().unwrap();
    let copy = |from: &str, to: &str| {
        std::fs::copy(pictures.join(from), folder.path().join(to)).unwrap();
    };
    for number in (1..=14).filter(|number| *number != 10) {
        let early = if number < 8 { "first" } else { "again" };
        copy(
            &format!("left{number:02}.jpg"),
            &format!("{early}{number}.jpg"),
        );
        copy(
            &format!("right{number:02}.jpg"),
            &format!("right{number:02}.jpg"),
        );
    }
    let output = nullcone(
        folder.path(),
        arguments(&["first*.jpg", "right*.jpg", "again*.jpg"]),
    );
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(number(&report, "/rms_px") < 0.46, "{report}");
    let baseline = number(&report, "/cameras/1/distance_metres");
    assert!((baseline - 0.0836).abs() < 0.0015, "{baseline}");
    let apart = number(&report, "/cameras/2/distance_metres");
    assert!(apart < 0.0015, "{apart}");
    assert!(number(&report, "/cameras/2/rotation_degrees") < 1.0);
    let common = serde_json::json!([[7, 7, 0], [7, 13, 6], [0, 6, 6]]);
    assert_eq!(report["common_boards"], common);
    assert_eq!(report["frames_used"], 13);
    assert_eq!(report["verdict"], "doubtful");
    let warnings = report["warnings"].as_array().unwrap().iter();
    let same_place = warnings.filter(|warning| warning["kind"] == "same_place");
    let messages: Vec<&str> = same_place.map(|w| w["message"].as_str().unwrap()).collect();
    assert!(
        matches!(messages[..], [message] if message.starts_with("cam2: ")),
        "{messages:?}"
    );
    // The file is read, and two of its cameras are a rig.
    let file = format::read(folder.path().join("rig.toml")).unwrap();
    let names: Vec<&str> = file
        .cameras
        .iter()
        .map(|camera| camera.name.as_str())
        .collect();
    assert_eq!(names, ["cam0", "cam1", "cam2"]);
    let rectify = "stereo rectify again8.jpg right08.jpg --rig rig.toml --view cam2 --view cam1";
    let output = nullcone(
        folder.path(),
        rectify.split(' ').chain(["--out", "rectified"]),
    );
    assert_success(&output);
}

#[test]
fn rigs_that_cannot_be_calibrated_are_refused_in_one_line() {
    let Some(pictures) = shared("data/vision/opencv") else {
        return;
    };
    let folder = tempdir().unwrap();
    for number in 1..=6 {
        for (side, name) in [("left", "a"), ("right", "b")] {
            let from = pictures.join(format!("{side}{number:02}.jpg"));
            std::fs::copy(from, folder.path().join(format!("{name}{number}.jpg"))).unwrap();
        }
    }
    let refused = |views: &[&str], more: &[&str], parts: &[&str]| {
        let more = more.iter().map(|word| (*word).to_owned());
        let all = arguments(views).into_iter().chain(more);
        assert_failure(&nullcone(folder.path(), all), parts);
        assert!(!folder.path().join("rig.toml").exists());
    };
    refused(&["a*.jpg"], &[], &["--views is given once"]);
    refused(
        &["a*.jpg", "none*"],
        &[],
        &["--views", "none*", "matches no file"],
    );
    refused(
        &["a*.jpg", "b*.jpg"],
        &["--name", "x"],
        &["--name is given 1 times"],
    );
    let twice = ["--name", "x", "--name", "x"];
    refused(&["a*.jpg", "b*.jpg"], &twice, &["--name x is given twice"]);
    refused(
        &["a[12].jpg", "b[12].jpg"],
        &[],
        &["cam0: a calibration needs 3 boards or more, not 2"],
    );
}

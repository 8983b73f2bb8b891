//! Cameras and rigs against those of OpenCV, from its corners and from its pictures.

use ga_vision::board::{Board, Pattern};
use ga_vision::calibration::{
    BoardView, CameraOptions, JointIntrinsics, StereoOptions, calibrate_camera, calibrate_stereo,
    square_edges,
};
use ga_vision::chessboard::BoardSize;

use super::{SIZE, complete};
use crate::chessboard::{opencv, opencv_boards, pixels};
use nullcone_shared_data::json::{matrix, numbers, rows};

fn board(square: f64) -> Board {
    Board::new(Pattern::Chessboard, "9x6".parse().unwrap(), square).unwrap()
}

/// The oracle's corners, with squares of side 1.
fn opencv_views() -> [Vec<BoardView>; 2] {
    let oracle = opencv();
    ["left", "right"].map(|side| {
        oracle[side]
            .as_array()
            .unwrap()
            .iter()
            .map(|view| BoardView::complete(&pixels(view)))
            .collect()
    })
}

#[test]
fn cameras_are_those_of_opencv() {
    let oracle = opencv();
    let places = BoardSize::new(9, 6).unwrap().places(1.0);
    for (views, side) in opencv_views().iter().zip(["left", "right"]) {
        let found = calibrate_camera(views, &places, SIZE, &CameraOptions::default()).unwrap();
        let rms = oracle[format!("rms_{side}")].as_f64().unwrap();
        assert!((found.rms / rms - 1.0).abs() < 1e-6, "{} {rms}", found.rms);
        let matrix = matrix(&oracle[format!("K_{side}")]);
        for (row, expected) in found.intrinsics.to_matrix().iter().zip(matrix) {
            for (found, expected) in row.iter().zip(expected) {
                assert!((found - expected).abs() < 0.05, "{found} {expected}");
            }
        }
        let expected = numbers::<5>(&oracle[format!("D_{side}")][0]);
        let coefficients = found.intrinsics.lens().coefficients();
        for (k, (found, expected)) in coefficients.iter().zip(expected).enumerate() {
            let tolerance = [1e-3, 1e-2, 1e-4, 1e-4, 2e-2][k];
            assert!(
                (found - expected).abs() < tolerance,
                "{k}: {found} {expected}"
            );
        }
    }
}

#[test]
fn the_rig_is_that_of_opencv() {
    let oracle = opencv();
    let places = BoardSize::new(9, 6).unwrap().places(1.0);
    let [left, right] = opencv_views();
    let with = |joint| {
        let options = StereoOptions {
            joint,
            outlier_ratio: None,
            ..StereoOptions::default()
        };
        calibrate_stereo([&left, &right], &places, SIZE, &options).unwrap()
    };
    let fixed = with(JointIntrinsics::Fixed);
    let rms = oracle["rms_stereo"].as_f64().unwrap();
    assert!(
        fixed.rms <= 0.448 && (fixed.rms / rms - 1.0).abs() < 1e-6,
        "{} {rms}",
        fixed.rms
    );
    let pose = fixed.rig.left_to_right().motor;
    let rotation = matrix(&oracle["R"]);
    for (row, expected) in pose.rotor().to_matrix().iter().zip(rotation) {
        for (found, expected) in row.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-5, "{found} {expected}");
        }
    }
    let translation = pose.translator().displacement();
    for (found, expected) in translation.iter().zip(rows::<1>(&oracle["t"])) {
        assert!((found - expected[0]).abs() < 1e-3, "{found} {expected:?}");
    }
    let alone = calibrate_camera(&left, &places, SIZE, &CameraOptions::default()).unwrap();
    assert_eq!(fixed.deviations[0], alone.deviations);
    let [l, r] = fixed.camera_rms;
    assert!((0.5 * (l * l + r * r) - fixed.rms * fixed.rms).abs() < 1e-12);
    // With free intrinsic parameters OpenCV comes to 0.44468.
    let free = with(JointIntrinsics::Free);
    assert!(free.rms < 0.44469, "{}", free.rms);
    let edges = square_edges(&free.rig, [&left, &right], &board(1.0)).unwrap();
    assert!((edges.mean - 1.0).abs() < 0.02, "{edges:?}");
}

/// The corners of all pairs from the pictures alone, and the rig from these.
#[test]
fn the_rig_is_found_from_pictures_alone() {
    let Some(boards) = opencv_boards() else {
        return;
    };
    let [left, right] = boards.each_ref().map(|corners| complete(corners));
    let square = 0.025;
    let size: BoardSize = "9x6".parse().unwrap();
    let options = StereoOptions {
        outlier_ratio: None,
        ..StereoOptions::default()
    };
    let places = size.places(square);
    let found = calibrate_stereo([&left, &right], &places, SIZE, &options).unwrap();
    let edges = square_edges(&found.rig, [&left, &right], &board(square)).unwrap();
    assert_eq!(found.used.len(), 13);
    assert!(found.rms < 0.46, "{}", found.rms);
    assert!((edges.mean / square - 1.0).abs() < 0.02, "{edges:?}");
    assert!(edges.rms_error < 0.02 * square, "{edges:?}");
    // OpenCV's corners give 3.344 squares.
    assert!((found.rig.baseline() / (3.344 * square) - 1.0).abs() < 0.02);
}

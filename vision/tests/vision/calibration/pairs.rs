//! Pairs of pictures in which a board is looked for.

use ga_camera::{Intrinsics, RadialTangential};
use ga_image::plane::Plane;
use ga_vision::board::{Board, Pattern};
use ga_vision::calibration::{
    BoardPairs, CalibrationError, CameraParameters, PairNames, StereoOptions,
};

fn names(index: usize) -> PairNames {
    PairNames {
        left: format!("left{index}"),
        right: format!("right{index}"),
    }
}

/// A board of 7 × 5 squares of 20 pixels, with its first column at a place.
fn board(left: usize) -> Plane<u8> {
    Plane::from_fn(240, 180, |column, row| {
        let is_inside = (left..left + 140).contains(&column) && (30..130).contains(&row);
        let is_dark = is_inside && ((column - left) / 20 + (row - 30) / 20).is_multiple_of(2);
        if is_dark { 20 } else { 230 }
    })
}

#[test]
fn pairs_without_boards_are_rejected_with_the_names_of_their_pictures() {
    let blank = Plane::filled(240, 180, 200u8);
    let grid = Board::new(Pattern::Chessboard, "6x4".parse().unwrap(), 0.02).unwrap();
    let mut pairs = BoardPairs::new(grid);
    let both = [blank.clone(), blank.clone()];
    assert_eq!(pairs.add(&both, names(0)), Ok(None));
    assert_eq!(pairs.add(&[board(40), blank.clone()], names(1)), Ok(None));
    let found = pairs
        .add(&[board(40), board(52)], names(2))
        .unwrap()
        .unwrap();
    let [left, right] = found.each_ref().map(|board| board.view().pixels()[0]);
    assert!((right[0] - left[0] - 12.0).abs() < 0.01 && (right[1] - left[1]).abs() < 0.01);

    let larger = Plane::filled(240, 181, 200u8);
    let error = pairs.add(&[blank, larger], names(3)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the views differ in size: right3 has 240 × 181 pixels and left0 has 240 × 180"
    );
    let error = pairs.calibrate(&StereoOptions::default()).unwrap_err();
    let CalibrationError::TooFewBoards {
        found: 1,
        pairs: 3,
        first: Some(first),
    } = error
    else {
        panic!("{error:?}")
    };
    assert!(first.starts_with("left0: board not found"), "{first}");
    assert!(first.contains("; right0: board not found"), "{first}");
}

#[test]
fn coefficients_after_the_last_that_counts_are_left_out() {
    let camera = Intrinsics::new([500.0, 501.0], [320.0, 240.0]).unwrap();
    let deviations = std::array::from_fn(|k| k as f64);
    let straight = CameraParameters::new(&camera, &deviations);
    assert_eq!(
        (straight.focal, straight.focal_deviation),
        ([500.0, 501.0], [0.0, 1.0])
    );
    assert_eq!(straight.principal_deviation, [2.0, 3.0]);
    assert!(straight.distortion.is_empty() && straight.distortion_deviation.is_empty());
    let lens = RadialTangential::new(&[0.1, 0.0, 0.0, 0.02]).unwrap();
    let bent = CameraParameters::new(&camera.with_lens(lens), &deviations);
    assert_eq!(bent.distortion, [0.1, 0.0, 0.0, 0.02]);
    assert_eq!(bent.distortion_deviation, [4.0, 5.0, 6.0, 7.0]);
}

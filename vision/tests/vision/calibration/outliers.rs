//! Pairs of views that do not fit the others.

use ga_camera::{Camera, Intrinsics, RadialTangential};
use ga_runtime::cga3::{Motor, Point, Translator};
use ga_vision::calibration::{
    CalibrationError, CameraOptions, LensTerms, StereoOptions, calibrate_stereo,
};

use super::{SIZE, TILTS, boards, complete, corners, motor, places, views, with_fixed};

#[test]
fn outliers_are_left_out_and_named() {
    let intrinsics = Intrinsics::new([540.0, 536.0], [325.0, 236.0]).unwrap();
    let rig = motor([0.0, 1.0, 0.0], 0.05, [-0.08, 0.001, 0.002]);
    let camera = |world_to_camera| Camera {
        intrinsics,
        world_to_camera,
    };
    let boards = boards(&TILTS);
    let left = views(&camera(Motor::default()), &boards, 0.1, 1);
    let mut right = corners(&camera(rig), &boards, 0.1, 2);
    // One board was moved between the two pictures, and one was read the other way round.
    for corner in &mut right[2] {
        corner[0] += 3.0;
        corner[1] -= 5.0;
    }
    right[5].reverse();
    let right = complete(&right);
    let options = StereoOptions {
        cameras: [CameraOptions {
            terms: LensTerms::none(),
            ..CameraOptions::default()
        }; 2],
        ..StereoOptions::default()
    };
    let found = calibrate_stereo([&left, &right], &places(), SIZE, &options).unwrap();
    let mut out: Vec<usize> = found.outliers.iter().map(|outlier| outlier.pair).collect();
    out.sort_unstable();
    assert_eq!(out, [2, 5]);
    assert_eq!(found.used, [0, 1, 3, 4, 6, 7]);
    assert!(found.rms < 0.2, "{}", found.rms);
    let limit = 5.0 * found.baseline_deviation;
    assert!((found.rig.baseline() - 0.08_f64.hypot(0.001).hypot(0.002)).abs() < limit);
}

#[test]
fn more_than_half_of_the_pairs_must_agree() {
    let intrinsics = Intrinsics::new([540.0, 536.0], [325.0, 236.0]).unwrap();
    let rig = motor([0.0, 1.0, 0.0], 0.05, [-0.08, 0.001, 0.002]);
    let camera = |world_to_camera| Camera {
        intrinsics,
        world_to_camera,
    };
    let seen_left = boards(&TILTS[..7]);
    let left = views(&camera(Motor::default()), &seen_left, 0.1, 1);
    let options = with_fixed(intrinsics);
    // Boards that were moved between the two pictures, each by more than all before together.
    let with_moved = |count: usize| {
        let mut seen_right = seen_left.clone();
        for (board, distance) in seen_right
            .iter_mut()
            .zip([0.004, 0.02, 0.05, 0.12])
            .take(count)
        {
            *board = Translator::from_displacement([0.0, distance, 0.0]) * *board;
        }
        let right = views(&camera(rig), &seen_right, 0.1, 2);
        calibrate_stereo([&left, &right], &places(), SIZE, &options)
    };
    let found = with_moved(3).unwrap();
    assert_eq!(found.used, [3, 4, 5, 6]);
    assert!(found.rms < 0.2, "{}", found.rms);
    let found = with_moved(4);
    assert!(
        matches!(found, Err(CalibrationError::Disagreement { pairs: 7, .. })),
        "{found:?}"
    );
}

/// One board of eight lies where a right camera with much distortion sees nothing.
#[test]
fn a_board_beyond_the_field_of_the_right_lens_is_an_outlier() {
    let lens = RadialTangential::new(&[-0.3, 0.0, 0.0, 0.0, 0.0]).unwrap();
    let intrinsics = Intrinsics::new([540.0, 536.0], [325.0, 236.0]).unwrap();
    let intrinsics = intrinsics.with_lens(lens);
    let rig = motor([1.0, 0.0, 0.0], 0.02, [-0.08, 0.001, 0.002]);
    let camera = |world_to_camera| Camera {
        intrinsics,
        world_to_camera,
    };
    let seen_right = boards(&TILTS);
    let mut seen_left = seen_right.clone();
    seen_left[2] = motor([0.0, 0.0, 1.0], 0.0, [-0.38, -0.0625, 0.4]);
    let beyond = seen_left[2].transform(Point::default());
    assert!(camera(Motor::default()).project(beyond).is_ok());
    assert!(camera(rig).project(beyond).is_err());
    let left = views(&camera(Motor::default()), &seen_left, 0.1, 1);
    let right = views(&camera(rig), &seen_right, 0.1, 2);
    let options = with_fixed(intrinsics);
    let found = calibrate_stereo([&left, &right], &places(), SIZE, &options).unwrap();
    assert_eq!(found.used, [0, 1, 3, 4, 5, 6, 7]);
    assert!(found.outliers[0].pair == 2 && found.outliers[0].rms.is_infinite());
    assert!(found.rms < 0.2, "{}", found.rms);
    let all = StereoOptions {
        outlier_ratio: None,
        ..options
    };
    let found = calibrate_stereo([&left, &right], &places(), SIZE, &all);
    assert_eq!(found, Err(CalibrationError::Unseen { pair: 2 }));
}

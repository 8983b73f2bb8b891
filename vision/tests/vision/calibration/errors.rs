//! Views from which no calibration follows.

use ga_camera::{Camera, Intrinsics, RadialTangential};
use ga_runtime::cga3::Motor;
use ga_vision::calibration::{
    BoardView, CalibrationError, CameraCalibration, CameraOptions, LensTerms, Start, StereoOptions,
    calibrate_camera, calibrate_stereo,
};

use super::{SIZE, TILTS, boards, complete, corners, motor, places, views};

fn intrinsics() -> Intrinsics {
    Intrinsics::new([540.0, 536.0], [325.0, 236.0]).unwrap()
}

fn camera() -> Camera {
    Camera {
        intrinsics: intrinsics(),
        world_to_camera: Motor::default(),
    }
}

fn calibrated(
    views: &[BoardView],
    options: &CameraOptions,
) -> Result<CameraCalibration, CalibrationError> {
    calibrate_camera(views, &places(), SIZE, options)
}

#[test]
fn views_that_are_no_boards_are_named() {
    let seen = corners(&camera(), &boards(&TILTS), 0.1, 1);
    let good = complete(&seen);
    let of = |views: &[BoardView]| calibrated(views, &CameraOptions::default());
    assert_eq!(
        of(&good[..2]),
        Err(CalibrationError::TooFewViews { found: 2 })
    );
    let mut long = seen.clone();
    long[4].push([100.0, 100.0]);
    let expected = CalibrationError::NoSuchPoint {
        view: 4,
        point: 54,
        count: 54,
    };
    assert_eq!(of(&complete(&long)), Err(expected));
    let mut short = seen.clone();
    short[4].truncate(3);
    let expected = CalibrationError::TooFewPoints { view: 4, found: 3 };
    assert_eq!(of(&complete(&short)), Err(expected));
    // A row of the board.
    short[4].clone_from_slice(&seen[4][..3]);
    short[4].extend(&seen[4][3..9]);
    assert_eq!(
        of(&complete(&short)),
        Err(CalibrationError::View { view: 4 })
    );
    let mut not_finite = seen.clone();
    not_finite[3][7][1] = f64::NAN;
    let expected = CalibrationError::NotFinite { view: 3, point: 7 };
    assert_eq!(of(&complete(&not_finite)), Err(expected));
    // All corners on one line.
    let mut flat = seen.clone();
    flat[1]
        .iter_mut()
        .for_each(|corner| corner[1] = 2.0 * corner[0]);
    let expected = CalibrationError::View { view: 1 };
    assert_eq!(of(&complete(&flat)), Err(expected));
    // A lens whose picture ends before some of the corners.
    let lens = RadialTangential::new(&[-1.5, 0.0, 0.0, 0.0, 0.0]).unwrap();
    let options = CameraOptions {
        start: Start::Fixed(intrinsics().with_lens(lens)),
        ..CameraOptions::default()
    };
    let error = calibrated(&good, &options).unwrap_err();
    assert!(
        matches!(error, CalibrationError::Pixel { .. }) && error.view().is_some(),
        "{error}"
    );
}

#[test]
fn views_that_determine_nothing_are_refused() {
    // Boards that are all parallel to the picture.
    let parallel: Vec<Motor<f64>> = (0..5)
        .map(f64::from)
        .map(|k| motor([0.0, 0.0, 1.0], 0.2 * k, [0.0, 0.0, 0.5 + 0.1 * k]))
        .collect();
    let options = CameraOptions {
        terms: LensTerms::none(),
        ..CameraOptions::default()
    };
    let found = calibrated(&views(&camera(), &parallel, 0.05, 1), &options);
    assert!(
        matches!(
            found,
            Err(CalibrationError::Undetermined { .. } | CalibrationError::LeastSquares(_))
        ),
        "{found:?}"
    );
    // Without distortion the terms of k1 and k4 cancel each other.
    let options = CameraOptions {
        start: Start::Guess(intrinsics()),
        terms: "k1,k4".parse().unwrap(),
    };
    let exact = views(&camera(), &boards(&TILTS), 0.0, 1);
    let parameter = "k4";
    assert_eq!(
        calibrated(&exact, &options),
        Err(CalibrationError::Undetermined { parameter })
    );
}

/// A lens with all terms and boards that are nearly parallel to the pictures: whatever the search
/// comes to, it is not given as a calibration.
#[test]
fn what_does_not_converge_is_no_calibration() {
    let nearly_parallel: Vec<Motor<f64>> = (0..4)
        .map(f64::from)
        .map(|k| motor([1.0, k, 0.0], 1e-3, [-0.1, -0.06, 0.4 + 0.02 * k]))
        .collect();
    let options = CameraOptions {
        terms: "k1,k2,k3,k4,k5,k6,p1,p2".parse().unwrap(),
        ..CameraOptions::default()
    };
    for seed in 1..6 {
        let seen = views(&camera(), &nearly_parallel, 0.3, seed);
        let found = calibrated(&seen, &options);
        assert!(
            matches!(
                found,
                Err(CalibrationError::Undetermined { .. } | CalibrationError::LeastSquares(_))
            ),
            "{seed}: {found:?}"
        );
    }
}

#[test]
fn pairs_without_a_baseline_are_refused() {
    let stereo = |left: &[BoardView], right: &[BoardView]| {
        calibrate_stereo([left, right], &places(), SIZE, &StereoOptions::default())
    };
    let good = views(&camera(), &boards(&TILTS), 0.1, 1);
    assert_eq!(
        stereo(&good, &good[..5]),
        Err(CalibrationError::Counts { left: 8, right: 5 })
    );
    // Views from the same place have no baseline: the same views, and views with other errors.
    let again = views(&camera(), &boards(&TILTS), 0.1, 2);
    for right in [&good, &again] {
        let found = stereo(&good, right);
        assert!(
            matches!(found, Err(CalibrationError::Baseline { metres }) if metres < 1e-3),
            "{found:?}"
        );
    }
}

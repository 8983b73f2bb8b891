//! Calibrations against scenes that are known, and against OpenCV.

use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_vision::calibration::{
    CalibrationError, CameraSettings, JointIntrinsics, LensTerms, Start, StereoSettings,
    calibrate_camera, calibrate_stereo, square_edges,
};
use ga_vision::camera::{Camera, Fisheye, Intrinsics, Lens, RadialTangential};
use ga_vision::chessboard::BoardSize;
use ga_vision::frame::In;
use proptest::prelude::*;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, Normal};

use super::chessboard::{opencv, opencv_boards, pixels};

const SIZE: [usize; 2] = [640, 480];

fn places() -> Vec<Point<f64>> {
    BoardSize::new(9, 6).expect("a size").places(0.025)
}

fn motor(axis: [f64; 3], angle: f64, place: [f64; 3]) -> Motor<f64> {
    Translator::from_displacement(place) * Rotor::from_axis_angle(axis, angle).expect("an axis")
}

/// Boards at different angles in front of a camera.
fn boards(tilts: &[[f64; 2]]) -> Vec<Motor<f64>> {
    let board = |(index, [x, y]): (usize, &[f64; 2])| {
        let roll = 0.3 * (index as f64 - 3.0);
        let tilt = motor([1.0, 0.0, 0.0], *x, [0.0; 3]) * motor([0.0, 1.0, 0.0], *y, [0.0; 3]);
        let side = |k: usize| 0.03 * ((index * k) as f64 % 5.0 - 2.0);
        let centre = Translator::from_displacement([-0.1, -0.0625, 0.0]);
        let depth = 0.32 + 0.04 * (index % 3) as f64;
        motor([0.0, 0.0, 1.0], roll, [side(1), side(2), depth]) * tilt * centre
    };
    tilts.iter().enumerate().map(board).collect()
}

const TILTS: [[f64; 2]; 8] = [
    [0.5, 0.0],
    [-0.5, 0.1],
    [0.1, 0.5],
    [-0.1, -0.5],
    [0.4, 0.4],
    [-0.4, 0.4],
    [0.3, -0.4],
    [0.0, 0.1],
];

/// The pixels of the corners of boards, with noise in pixels.
fn views(camera: &Camera, boards: &[Motor<f64>], noise: f64, seed: u64) -> Vec<Vec<[f64; 2]>> {
    let normal = Normal::new(0.0, noise).expect("a standard deviation");
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut view = |board: &Motor<f64>| {
        let places: Vec<Point<f64>> = places().iter().map(|p| board.transform(*p)).collect();
        let exact = camera.project_all(&places).expect("boards in front");
        let noisy = exact
            .into_iter()
            .map(|uv| uv.map(|u| u + normal.sample(&mut random)));
        noisy.collect()
    };
    boards.iter().map(&mut view).collect()
}

fn close(found: &Intrinsics, truth: &Intrinsics, tolerance: f64) -> Result<(), TestCaseError> {
    for (found, truth) in found.parameters().iter().zip(truth.parameters()) {
        let scale = truth.abs().max(1.0);
        prop_assert!((found - truth).abs() < tolerance * scale, "{found} {truth}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn exact_corners_give_the_exact_rig(
        focal in prop::array::uniform2(450.0..900.0),
        shift in prop::array::uniform4(-25.0..25.0),
        radial in prop::array::uniform3(-0.1..0.1),
        tangential in prop::array::uniform2(-0.003..0.003),
        between in (prop::array::uniform3(-0.15..0.15), -0.02..0.02),
    ) {
        let [k1, k2, k3] = radial;
        let lens = RadialTangential::new(&[3.0 * k1, k2, tangential[0], tangential[1], 0.3 * k3]);
        let lens = lens.expect("a lens");
        let [left, right] = [0, 2].map(|k| {
            let principal = [319.5 + shift[k], 239.5 + shift[k + 1]];
            Intrinsics::new([focal[k / 2], 1.01 * focal[k / 2]], principal)
                .expect("a camera")
                .with_lens(lens)
        });
        let ([a, b, c], aside) = between;
        let rig = Translator::from_displacement([-0.08 + aside, 0.5 * aside, aside])
            * Rotor::from_rotation_vector([a, b, c]).expect("a rotation");
        let boards = boards(&TILTS);
        let cameras = [
            Camera { intrinsics: left, world_to_camera: Motor::default() },
            Camera { intrinsics: right, world_to_camera: rig },
        ];
        let seen = |camera: &Camera| {
            boards.iter().all(|board| {
                places().iter().all(|p| camera.project(board.transform(*p)).is_ok())
            })
        };
        prop_assume!(cameras.iter().all(seen));
        let [l, r] = [0, 1].map(|k| views(&cameras[k], &boards, 0.0, 0));
        let found = calibrate_stereo([&l, &r], &places(), SIZE, &StereoSettings::default());
        let found = found.map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert!(found.rms < 1e-9, "{}", found.rms);
        prop_assert_eq!(found.used.len(), boards.len());
        close(&found.rig.left.intrinsics, &left, 1e-6)?;
        close(&found.rig.right.intrinsics, &right, 1e-6)?;
        let probe = Point::new(0.1, -0.1, 0.5);
        let moved = found.rig.left_to_right().motor.transform(probe);
        prop_assert!(moved.distance(rig.transform(probe)) < 1e-9);
        for (found, truth) in found.boards.iter().zip(&boards) {
            let placed = found.transform(In::new(probe)).value;
            prop_assert!(placed.distance(truth.transform(probe)) < 1e-8);
        }
    }

    #[test]
    fn errors_are_as_large_as_they_say(seed in 0_u64..1000) {
        let lens = RadialTangential::new(&[-0.2, 0.05, 1e-3, -1e-3, 0.0]).expect("a lens");
        let truth = Intrinsics::new([540.0, 536.0], [325.0, 236.0]).expect("a camera");
        let truth = truth.with_lens(lens);
        let camera = Camera { intrinsics: truth, world_to_camera: Motor::default() };
        let views = views(&camera, &boards(&TILTS), 0.3, seed);
        let found = calibrate_camera(&views, &places(), SIZE, &CameraSettings::default());
        let found = found.map_err(|error| TestCaseError::fail(error.to_string()))?;
        // The root mean square of both coordinates together, less what 9 + 48 unknowns absorb.
        let expected = 0.3 * 2.0_f64.sqrt() * (1.0 - 57.0 / 864.0_f64).sqrt();
        prop_assert!((found.rms / expected - 1.0).abs() < 0.15, "{} {expected}", found.rms);
        let pairs = found.intrinsics.parameters().into_iter().zip(truth.parameters());
        for (parameter, ((found, truth), deviation)) in pairs.zip(found.deviations).enumerate() {
            // Five standard deviations.
            let limit = 5.0 * deviation;
            prop_assert!((found - truth).abs() <= limit, "{parameter}: {found} {truth}");
        }
        // A deviation of the focal length of a fifth would say nothing.
        prop_assert!(found.deviations[0] > 0.05 && found.deviations[0] < 10.0);
    }
}

#[test]
fn a_fisheye_lens_is_found() {
    let lens = Fisheye::new(&[0.02, -0.01, 0.003, -0.0005]).unwrap();
    let truth = Intrinsics::new([300.0, 302.0], [322.0, 238.0])
        .unwrap()
        .with_lens(lens);
    let camera = Camera {
        intrinsics: truth,
        world_to_camera: Motor::default(),
    };
    let near = Translator::from_displacement([0.0, 0.0, -0.16]);
    let boards: Vec<Motor<f64>> = boards(&TILTS)
        .into_iter()
        .map(|board| near * board)
        .collect();
    let views = views(&camera, &boards, 0.0, 0);
    let settings = CameraSettings {
        terms: LensTerms::fisheye(),
        ..CameraSettings::default()
    };
    let found = calibrate_camera(&views, &places(), SIZE, &settings).unwrap();
    assert!(matches!(found.intrinsics.lens(), Lens::Fisheye(_)));
    close(&found.intrinsics, &truth, 1e-6).unwrap();
}

#[test]
fn known_intrinsics_stay_and_guesses_do_not() {
    let truth = Intrinsics::new([540.0, 536.0], [325.0, 236.0]).unwrap();
    let camera = Camera {
        intrinsics: truth,
        world_to_camera: Motor::default(),
    };
    let views = views(&camera, &boards(&TILTS), 0.1, 3);
    let with = |start, terms| {
        let settings = CameraSettings { start, terms };
        calibrate_camera(&views, &places(), SIZE, &settings).unwrap()
    };
    let fixed = with(Start::Fixed(truth), LensTerms::default());
    assert_eq!(fixed.intrinsics, truth);
    assert!(fixed.deviations.iter().all(|x| *x == 0.0));
    let off = Intrinsics::new([600.0, 500.0], [310.0, 250.0]).unwrap();
    let guessed = with(Start::Guess(off), LensTerms::none());
    let free = with(Start::Boards, LensTerms::none());
    close(&guessed.intrinsics, &free.intrinsics, 1e-7).unwrap();
    assert!(free.rms < fixed.rms && matches!(free.intrinsics.lens(), Lens::Pinhole));
    // Only the terms that were asked for differ from 0.
    let some = with(Start::Boards, "k1,p2".parse().unwrap());
    let coefficients = some.intrinsics.lens().coefficients();
    assert!(coefficients[0] != 0.0 && coefficients[3] != 0.0);
    assert!(coefficients[1] == 0.0 && coefficients[2] == 0.0 && coefficients[4] == 0.0);
}

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
    let mut right = views(&camera(rig), &boards, 0.1, 2);
    // One board was moved between the two pictures, and one was read the other way round.
    for corner in &mut right[2] {
        corner[0] += 3.0;
        corner[1] -= 5.0;
    }
    right[5].reverse();
    let settings = StereoSettings {
        cameras: [CameraSettings {
            terms: LensTerms::none(),
            ..CameraSettings::default()
        }; 2],
        ..StereoSettings::default()
    };
    let found = calibrate_stereo([&left, &right], &places(), SIZE, &settings).unwrap();
    let mut out: Vec<usize> = found.outliers.iter().map(|outlier| outlier.pair).collect();
    out.sort_unstable();
    assert_eq!(out, [2, 5]);
    assert_eq!(found.used, [0, 1, 3, 4, 6, 7]);
    assert!(found.rms < 0.2, "{}", found.rms);
    let limit = 5.0 * found.baseline_deviation;
    assert!((found.rig.baseline() - 0.08_f64.hypot(0.001).hypot(0.002)).abs() < limit);
}

/// Upside down, the boards are rotated by a little less than half a turn in the left views and by a
/// little more in the right ones.
#[test]
fn boards_upside_down_give_the_smaller_angle() {
    let intrinsics = Intrinsics::new([540.0, 536.0], [325.0, 236.0]).unwrap();
    let rig = motor([0.0, 0.0, 1.0], 0.04, [-0.08, 0.001, 0.002]);
    let camera = |world_to_camera| Camera {
        intrinsics,
        world_to_camera,
    };
    let centre = Translator::from_displacement([-0.1, -0.0625, 0.0]);
    let board = |tilt: &[f64; 2]| {
        let roll = motor(
            [0.0, 0.0, 1.0],
            std::f64::consts::PI - 0.02,
            [0.0, 0.0, 0.4],
        );
        let tilt = Rotor::from_rotation_vector([0.5 * tilt[0], 0.5 * tilt[1], 0.0]).unwrap();
        roll * tilt * centre
    };
    let boards: Vec<Motor<f64>> = TILTS.iter().map(board).collect();
    let left = views(&camera(Motor::default()), &boards, 0.0, 1);
    let right = views(&camera(rig), &boards, 0.0, 2);
    let settings = StereoSettings {
        cameras: [CameraSettings {
            start: Start::Fixed(intrinsics),
            ..CameraSettings::default()
        }; 2],
        ..StereoSettings::default()
    };
    let found = calibrate_stereo([&left, &right], &places(), SIZE, &settings).unwrap();
    let (_, angle) = found.rig.left_to_right().motor.rotor().to_axis_angle();
    assert!((angle - 0.04).abs() < 1e-9, "{angle}");
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
    let settings = StereoSettings {
        cameras: [CameraSettings {
            start: Start::Fixed(intrinsics),
            ..CameraSettings::default()
        }; 2],
        ..StereoSettings::default()
    };
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
        calibrate_stereo([&left, &right], &places(), SIZE, &settings)
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
    let settings = StereoSettings {
        cameras: [CameraSettings {
            start: Start::Fixed(intrinsics),
            ..CameraSettings::default()
        }; 2],
        ..StereoSettings::default()
    };
    let found = calibrate_stereo([&left, &right], &places(), SIZE, &settings).unwrap();
    assert_eq!(found.used, [0, 1, 3, 4, 5, 6, 7]);
    assert!(found.outliers[0].pair == 2 && found.outliers[0].rms.is_infinite());
    assert!(found.rms < 0.2, "{}", found.rms);
    let all = StereoSettings {
        outlier_ratio: None,
        ..settings
    };
    let found = calibrate_stereo([&left, &right], &places(), SIZE, &all);
    assert_eq!(found, Err(CalibrationError::Unseen { pair: 2 }));
}

/// The oracle's corners, with squares of side 1.
fn opencv_views() -> [Vec<Vec<[f64; 2]>>; 2] {
    let oracle = opencv();
    ["left", "right"].map(|side| {
        oracle[side]
            .as_array()
            .unwrap()
            .iter()
            .map(pixels)
            .collect()
    })
}

#[test]
fn cameras_are_those_of_opencv() {
    let oracle = opencv();
    let places = BoardSize::new(9, 6).unwrap().places(1.0);
    for (views, side) in opencv_views().iter().zip(["left", "right"]) {
        let found = calibrate_camera(views, &places, SIZE, &CameraSettings::default()).unwrap();
        let rms = oracle[format!("rms_{side}")].as_f64().unwrap();
        assert!((found.rms / rms - 1.0).abs() < 1e-6, "{} {rms}", found.rms);
        let matrix = super::matrix(&oracle[format!("K_{side}")]);
        for (row, expected) in found.intrinsics.to_matrix().iter().zip(matrix) {
            for (found, expected) in row.iter().zip(expected) {
                assert!((found - expected).abs() < 0.05, "{found} {expected}");
            }
        }
        let expected = super::numbers::<5>(&oracle[format!("D_{side}")][0]);
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
        let settings = StereoSettings {
            joint,
            outlier_ratio: None,
            ..StereoSettings::default()
        };
        calibrate_stereo([&left, &right], &places, SIZE, &settings).unwrap()
    };
    let fixed = with(JointIntrinsics::Fixed);
    let rms = oracle["rms_stereo"].as_f64().unwrap();
    assert!(
        fixed.rms <= 0.448 && (fixed.rms / rms - 1.0).abs() < 1e-6,
        "{} {rms}",
        fixed.rms
    );
    let pose = fixed.rig.left_to_right().motor;
    let rotation = super::matrix(&oracle["R"]);
    for (row, expected) in pose.rotor().to_matrix().iter().zip(rotation) {
        for (found, expected) in row.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-5, "{found} {expected}");
        }
    }
    let translation = pose.translator().displacement();
    for (found, expected) in translation.iter().zip(super::rows::<1>(&oracle["t"])) {
        assert!((found - expected[0]).abs() < 1e-3, "{found} {expected:?}");
    }
    let alone = calibrate_camera(&left, &places, SIZE, &CameraSettings::default()).unwrap();
    assert_eq!(fixed.deviations[0], alone.deviations);
    let [l, r] = fixed.camera_rms;
    assert!((0.5 * (l * l + r * r) - fixed.rms * fixed.rms).abs() < 1e-12);
    // With free intrinsic parameters OpenCV comes to 0.44468.
    let free = with(JointIntrinsics::Free);
    assert!(free.rms < 0.44469, "{}", free.rms);
    let edges = square_edges(&free.rig, [&left, &right], "9x6".parse().unwrap(), 1.0).unwrap();
    assert!((edges.mean - 1.0).abs() < 0.02, "{edges:?}");
}

/// The corners of all pairs from the pictures alone, and the rig from these.
#[test]
fn the_rig_is_found_from_pictures_alone() {
    let Some([left, right]) = opencv_boards() else {
        return;
    };
    let square = 0.025;
    let size: BoardSize = "9x6".parse().unwrap();
    let settings = StereoSettings {
        outlier_ratio: None,
        ..StereoSettings::default()
    };
    let places = size.places(square);
    let found = calibrate_stereo([&left, &right], &places, SIZE, &settings).unwrap();
    let edges = square_edges(&found.rig, [&left, &right], size, square).unwrap();
    assert_eq!(found.used.len(), 13);
    assert!(found.rms < 0.46, "{}", found.rms);
    assert!((edges.mean / square - 1.0).abs() < 0.02, "{edges:?}");
    assert!(edges.rms_error < 0.02 * square, "{edges:?}");
    // OpenCV's corners give 3.344 squares.
    assert!((found.rig.baseline() / (3.344 * square) - 1.0).abs() < 0.02);
}

#[test]
fn views_that_determine_nothing_are_refused() {
    let intrinsics = Intrinsics::new([540.0, 536.0], [325.0, 236.0]).unwrap();
    let camera = Camera {
        intrinsics,
        world_to_camera: Motor::default(),
    };
    let good = views(&camera, &boards(&TILTS), 0.1, 1);
    let of = |views: &[Vec<[f64; 2]>]| {
        calibrate_camera(views, &places(), SIZE, &CameraSettings::default())
    };
    assert_eq!(
        of(&good[..2]),
        Err(CalibrationError::TooFewViews { found: 2 })
    );
    let mut short = good.clone();
    short[4].pop();
    let expected = CalibrationError::Corners {
        view: 4,
        found: 53,
        expected: 54,
    };
    assert_eq!(of(&short), Err(expected));
    let mut not_finite = good.clone();
    not_finite[3][7][1] = f64::NAN;
    let expected = CalibrationError::NotFinite { view: 3, corner: 7 };
    assert_eq!(of(&not_finite), Err(expected));
    let mut flat = good.clone();
    flat[1]
        .iter_mut()
        .for_each(|corner| corner[1] = 2.0 * corner[0]);
    assert_eq!(of(&flat), Err(CalibrationError::View { view: 1 }));
    // A lens whose picture ends before some of the corners.
    let lens = RadialTangential::new(&[-1.5, 0.0, 0.0, 0.0, 0.0]).unwrap();
    let settings = CameraSettings {
        start: Start::Fixed(intrinsics.with_lens(lens)),
        ..CameraSettings::default()
    };
    let found = calibrate_camera(&good, &places(), SIZE, &settings);
    let error = found.unwrap_err();
    assert!(
        matches!(error, CalibrationError::Pixel { .. }) && error.view().is_some(),
        "{error}"
    );
    // Boards that are all parallel to the picture.
    let parallel: Vec<Motor<f64>> = (0..5)
        .map(|k| {
            motor(
                [0.0, 0.0, 1.0],
                0.2 * f64::from(k),
                [0.0, 0.0, 0.5 + 0.1 * f64::from(k)],
            )
        })
        .collect();
    let settings = CameraSettings {
        terms: LensTerms::none(),
        ..CameraSettings::default()
    };
    let found = calibrate_camera(
        &views(&camera, &parallel, 0.05, 1),
        &places(),
        SIZE,
        &settings,
    );
    assert!(
        matches!(
            found,
            Err(CalibrationError::Undetermined { .. } | CalibrationError::LeastSquares(_))
        ),
        "{found:?}"
    );
    // Without distortion the terms of k1 and k4 cancel each other.
    let settings = CameraSettings {
        start: Start::Guess(intrinsics),
        terms: "k1,k4".parse().unwrap(),
    };
    let exact = views(&camera, &boards(&TILTS), 0.0, 1);
    let found = calibrate_camera(&exact, &places(), SIZE, &settings);
    let parameter = "k4";
    assert_eq!(found, Err(CalibrationError::Undetermined { parameter }));
    let counts = calibrate_stereo(
        [&good, &good[..5]],
        &places(),
        SIZE,
        &StereoSettings::default(),
    );
    assert_eq!(counts, Err(CalibrationError::Counts { left: 8, right: 5 }));
    // Views from the same place have no baseline: the same views, and views with other errors.
    let again = views(&camera, &boards(&TILTS), 0.1, 2);
    for right in [&good, &again] {
        let found = calibrate_stereo([&good, right], &places(), SIZE, &StereoSettings::default());
        assert!(
            matches!(found, Err(CalibrationError::Baseline { metres }) if metres < 1e-3),
            "{found:?}"
        );
    }
}

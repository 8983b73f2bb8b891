//! Calibrations against scenes that are known, and against OpenCV.

mod errors;
mod lens;
mod opencv;
mod outliers;
mod pairs;
mod partial;
mod rigs;

use ga_camera::frame::In;
use ga_camera::{Camera, Fisheye, Intrinsics, Lens, RadialTangential};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_vision::calibration::{
    BoardView, CameraOptions, LensTerms, Start, StereoOptions, calibrate_camera, calibrate_stereo,
};
use ga_vision::chessboard::BoardSize;
use proptest::prelude::*;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, Normal};

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

/// Views of boards with all corners.
fn complete(corners: &[Vec<[f64; 2]>]) -> Vec<BoardView> {
    let views = corners.iter();
    views.map(|corners| BoardView::complete(corners)).collect()
}

/// Views of boards, with noise in pixels.
fn views(camera: &Camera, boards: &[Motor<f64>], noise: f64, seed: u64) -> Vec<BoardView> {
    complete(&corners(camera, boards, noise, seed))
}

/// The pixels of the corners of boards, with noise in pixels.
fn corners(camera: &Camera, boards: &[Motor<f64>], noise: f64, seed: u64) -> Vec<Vec<[f64; 2]>> {
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

/// Both cameras are known.
fn with_fixed(intrinsics: Intrinsics) -> StereoOptions {
    StereoOptions {
        cameras: [CameraOptions {
            start: Start::Fixed(intrinsics),
            ..CameraOptions::default()
        }; 2],
        ..StereoOptions::default()
    }
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
        let found = calibrate_stereo([&l, &r], &places(), SIZE, &StereoOptions::default());
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
        let found = calibrate_camera(&views, &places(), SIZE, &CameraOptions::default());
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
    let options = CameraOptions {
        terms: LensTerms::fisheye(),
        ..CameraOptions::default()
    };
    let found = calibrate_camera(&views, &places(), SIZE, &options).unwrap();
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
        let options = CameraOptions { start, terms };
        calibrate_camera(&views, &places(), SIZE, &options).unwrap()
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
    let options = with_fixed(intrinsics);
    let found = calibrate_stereo([&left, &right], &places(), SIZE, &options).unwrap();
    let (_, angle) = found.rig.left_to_right().motor.rotor().to_axis_angle();
    assert!((angle - 0.04).abs() < 1e-9, "{angle}");
}

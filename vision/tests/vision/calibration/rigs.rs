//! Rigs of several cameras that see boards in turns, against scenes that are known.

use ga_camera::{Camera, Intrinsics, RadialTangential};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_vision::calibration::{BoardView, CalibrationError, RigOptions, SeenPoint, calibrate_rig};
use proptest::prelude::*;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, Normal};

use super::{SIZE, motor, places};

/// Cameras on a circle of 0.5 m around a place, looking inwards, each rolled by itself.
fn ring(count: usize, step: f64, rolls: &[f64]) -> Vec<Camera> {
    let camera = |index: usize| {
        let lens = RadialTangential::new(&[-0.1 + 0.02 * index as f64, 0.03, 1e-3, -1e-3]);
        let intrinsics = Intrinsics::new([610.0 + 10.0 * index as f64, 605.0], [322.0, 238.0]);
        let away = Translator::from_displacement([0.0, 0.0, 0.5]);
        let around = Rotor::from_axis_angle([0.0, 1.0, 0.1], step * index as f64).unwrap();
        let roll = Rotor::about_z(rolls[index]).unwrap();
        Camera {
            intrinsics: intrinsics.unwrap().with_lens(lens.unwrap()),
            world_to_camera: roll * (away * around),
        }
    };
    (0..count).map(camera).collect()
}

/// Boards around the middle of the circle; four for each pair of neighbours, who alone see them.
fn boards(count: usize, step: f64) -> Vec<(Motor<f64>, [usize; 2])> {
    let tilts = [[0.4, 0.1], [-0.4, 0.2], [0.1, 0.45], [-0.2, -0.4]];
    let all = (0..count - 1).flat_map(|pair| tilts.into_iter().map(move |tilt| (pair, tilt)));
    let board = |(pair, [x, y]): (usize, [f64; 2])| {
        let facing = motor([0.0, 1.0, 0.1], -step * (pair as f64 + 0.5), [0.0; 3]);
        let tilt = motor([1.0, 0.0, 0.0], x, [0.0; 3]) * motor([0.0, 1.0, 0.0], y, [0.0; 3]);
        let centre = Translator::from_displacement([-0.1 + 0.05 * y, -0.0625 - 0.05 * x, 0.0]);
        (facing * tilt * centre, [pair, pair + 1])
    };
    all.map(board).collect()
}

/// For each camera and each board the corners with noise, of which only every `stride`-th is seen.
fn views(
    cameras: &[Camera],
    boards: &[(Motor<f64>, [usize; 2])],
    stride: usize,
    noise: f64,
    seed: u64,
) -> Vec<Vec<BoardView>> {
    let normal = Normal::new(0.0, noise).unwrap();
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut all = Vec::new();
    for (index, camera) in cameras.iter().enumerate() {
        let mut views = Vec::new();
        for (board, seen) in boards {
            let mut points = Vec::new();
            if seen.contains(&index) {
                for (point, place) in places().into_iter().enumerate() {
                    let pixel = camera.project(board.transform(place)).unwrap();
                    let pixel = pixel.map(|u| u + normal.sample(&mut random));
                    if (point + index).is_multiple_of(stride) {
                        points.push(SeenPoint { point, pixel });
                    }
                }
            }
            views.push(BoardView::new(points).unwrap());
        }
        all.push(views);
    }
    all
}

/// The camera with the first camera's frame as its world.
fn in_first(cameras: &[Camera], index: usize) -> Motor<f64> {
    cameras[index].world_to_camera * cameras[0].world_to_camera.reverse()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn exact_corners_of_some_places_give_the_exact_cameras(
        count in 2_usize..6,
        step in 0.15..0.5,
        rolls in prop::array::uniform5(-3.0..3.0),
        stride in 1_usize..4,
    ) {
        let cameras = ring(count, step, &rolls);
        let views = views(&cameras, &boards(count, step), stride, 0.0, 0);
        let found = calibrate_rig(&views, &places(), &vec![SIZE; count], &RigOptions::new(count));
        let found = found.map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert!(found.rms < 1e-8, "{}", found.rms);
        for (index, (own, truth)) in found.cameras.iter().zip(&cameras).enumerate() {
            let (a, b) = (own.intrinsics.parameters(), truth.intrinsics.parameters());
            for (a, b) in a.into_iter().zip(b) {
                prop_assert!((a - b).abs() < 1e-5 * b.abs().max(1.0), "{a} {b}");
            }
            let probe = Point::new(0.1, -0.1, 0.6);
            let expected = in_first(&cameras, index).transform(probe);
            prop_assert!(own.world_to_camera.transform(probe).distance(expected) < 1e-7);
        }
    }
}

/// Chi-squares of the motions of a chain of three cameras, by the deviations of single coordinates.
#[test]
fn motions_are_as_wrong_as_their_deviations_say() {
    let cameras = ring(3, 0.3, &[0.1, 1.7, -2.9]);
    let boards = boards(3, 0.3);
    let mut squares = Vec::new();
    for seed in 0..12 {
        let views = views(&cameras, &boards, 1, 0.2, seed);
        let mut options = RigOptions::new(3);
        for camera in &mut options.cameras {
            // Few boards do not determine more.
            camera.terms = "k1,k2,p1,p2".parse().unwrap();
        }
        let found = calibrate_rig(&views, &places(), &[SIZE; 3], &options).unwrap();
        assert!((found.rms / (0.2 * 2.0_f64.sqrt()) - 1.0).abs() < 0.15);
        assert_eq!(found.used.len(), 8);
        for index in 1..3 {
            let truth = in_first(&cameras, index);
            let length = |motor: &Motor<f64>| {
                let [x, y, z] = motor.translator().displacement();
                x.hypot(y).hypot(z)
            };
            let own = found.cameras[index].world_to_camera;
            let error = length(&own) - length(&truth);
            squares.push((error / found.distance_deviations[index]).powi(2));
            let twist = (own * truth.reverse()).log();
            let [angular, linear] = [
                twist.angular_velocity(),
                twist.velocity_at(Point::default()),
            ]
            .map(|velocity| velocity.vector());
            let errors = angular.into_iter().chain(linear);
            for (error, deviation) in errors.zip(found.motion_deviations[index]) {
                squares.push((error / deviation).powi(2));
            }
        }
    }
    let mean = squares.iter().sum::<f64>() / squares.len() as f64;
    // 168 squares of standard normal numbers that partly depend on each other.
    assert!((0.6..1.5).contains(&mean), "{mean}");
}

#[test]
fn frames_that_do_not_agree_are_left_out() {
    let cameras = ring(3, 0.3, &[0.0; 3]);
    let boards = boards(3, 0.3);
    let mut views = views(&cameras, &boards, 1, 0.1, 7);
    // The last camera shows its second board in another place.
    let shifted = views[2][5].points().iter();
    let shifted = shifted.map(|seen| SeenPoint {
        pixel: [seen.pixel[0] + 25.0, seen.pixel[1]],
        ..*seen
    });
    views[2][5] = BoardView::new(shifted.collect()).unwrap();
    let found = calibrate_rig(&views, &places(), &[SIZE; 3], &RigOptions::new(3)).unwrap();
    let outliers: Vec<usize> = found.outliers.iter().map(|outlier| outlier.pair).collect();
    assert_eq!(outliers, [5]);
    assert_eq!(found.used, [0, 1, 2, 3, 4, 6, 7]);
    assert!(found.rms < 0.2, "{}", found.rms);
}

#[test]
fn rigs_that_cannot_be_calibrated() {
    let cameras = ring(4, 0.3, &[0.0; 4]);
    let mut boards = boards(4, 0.3);
    let rig = |views: &[Vec<BoardView>], sizes: usize| {
        let options = RigOptions::new(views.len());
        calibrate_rig(views, &places(), &vec![SIZE; sizes], &options)
    };
    let all = views(&cameras, &boards, 1, 0.0, 0);
    assert_eq!(
        rig(&all, 3),
        Err(CalibrationError::CameraCounts { views: 4, other: 3 })
    );
    let mut short = all.clone();
    short[1].pop();
    assert_eq!(
        rig(&short, 4),
        Err(CalibrationError::Counts {
            left: 12,
            right: 11
        })
    );
    let mut few = all.clone();
    few[3][9] = BoardView::default();
    few[3][10] = BoardView::default();
    assert_eq!(
        rig(&few, 4),
        Err(CalibrationError::OfCamera {
            camera: 3,
            error: Box::new(CalibrationError::TooFewViews { found: 2 })
        })
    );
    let seen = |point: usize| SeenPoint {
        point,
        pixel: [10.0, 20.0],
    };
    let mut wrong = all.clone();
    wrong[0][2] = BoardView::new([0, 1, 2, 54].map(seen).to_vec()).unwrap();
    let error = Box::new(CalibrationError::NoSuchPoint {
        view: 2,
        point: 54,
        count: 54,
    });
    assert_eq!(
        rig(&wrong, 4),
        Err(CalibrationError::OfCamera { camera: 0, error })
    );
    // The boards of the second and the third camera are seen by one of them at a time.
    for (index, (_, seen)) in boards.iter_mut().enumerate().skip(4).take(4) {
        *seen = [1 + index % 2; 2];
    }
    assert_eq!(
        rig(&views(&cameras, &boards, 1, 0.0, 0), 4),
        Err(CalibrationError::Disconnected {
            cameras: vec![2, 3]
        })
    );
}

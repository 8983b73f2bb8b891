//! Boards of which each picture shows a part.

use ga_camera::{Camera, Intrinsics, RadialTangential};
use ga_runtime::cga3::Motor;
use ga_vision::calibration::{
    BoardView, CalibrationError, CameraOptions, SeenPoint, StereoOptions, calibrate_camera,
    calibrate_stereo,
};

use super::{SIZE, TILTS, boards, close, corners, motor, places};

fn camera(world_to_camera: Motor<f64>) -> Camera {
    let lens = RadialTangential::new(&[-0.2, 0.05, 1e-3, -1e-3, 0.0]).unwrap();
    let intrinsics = Intrinsics::new([540.0, 536.0], [325.0, 236.0]).unwrap();
    Camera {
        intrinsics: intrinsics.with_lens(lens),
        world_to_camera,
    }
}

/// Of each view the points for which a function of view and point is true, in another order.
fn parts(corners: &[Vec<[f64; 2]>], is_seen: impl Fn(usize, usize) -> bool) -> Vec<BoardView> {
    let part = |(view, pixels): (usize, &Vec<[f64; 2]>)| {
        let points = pixels.iter().enumerate().rev();
        let points = points.filter(|(point, _)| is_seen(view, *point));
        let points = points.map(|(point, &pixel)| SeenPoint { point, pixel });
        BoardView::new(points.collect()).unwrap()
    };
    corners.iter().enumerate().map(part).collect()
}

/// Each view shows some of the columns, and leaves out single corners.
fn is_seen(view: usize, point: usize) -> bool {
    let column = (point % 9 + 9 - view) % 9;
    column < 6 && !(3 * point + view).is_multiple_of(7)
}

#[test]
fn exact_parts_give_the_exact_camera() {
    let truth = camera(Motor::default());
    let all = corners(&truth, &boards(&TILTS), 0.0, 0);
    let seen = parts(&all, is_seen);
    assert!(seen.iter().all(|view| view.points().len() < 36));
    let found = calibrate_camera(&seen, &places(), SIZE, &CameraOptions::default()).unwrap();
    close(&found.intrinsics, &truth.intrinsics, 1e-6).unwrap();
    assert!(found.rms < 1e-9, "{}", found.rms);
    // A wrong index is a wrong place on the board.
    let mut wrong = seen;
    let points = wrong[2].points().iter();
    let moved = points.map(|seen| SeenPoint {
        point: (seen.point + 9) % 54,
        pixel: seen.pixel,
    });
    wrong[2] = BoardView::new(moved.collect()).unwrap();
    let found = calibrate_camera(&wrong, &places(), SIZE, &CameraOptions::default());
    assert!(found.is_err() || found.unwrap().rms > 0.1);
}

/// The root mean square and the deviations count the points that are there.
#[test]
fn errors_of_parts_are_as_large_as_they_say() {
    let truth = camera(Motor::default());
    let mut squares = 0.0;
    for seed in 0..12 {
        let seen = parts(&corners(&truth, &boards(&TILTS), 0.3, seed), is_seen);
        let count: usize = seen.iter().map(|view| view.points().len()).sum();
        let found = calibrate_camera(&seen, &places(), SIZE, &CameraOptions::default()).unwrap();
        // What 9 + 48 unknowns absorb is missing.
        let free = 1.0 - 57.0 / (2 * count) as f64;
        let expected = 0.3 * (2.0 * free).sqrt();
        assert!((found.rms / expected - 1.0).abs() < 0.2, "{}", found.rms);
        for k in 0..4 {
            let error = found.intrinsics.parameters()[k] - truth.intrinsics.parameters()[k];
            squares += (error / found.deviations[k]).powi(2);
        }
    }
    // The mean of the squares of 48 standardised errors is 1 ± 0.2, were they independent.
    let mean = squares / 48.0;
    assert!((0.4..2.0).contains(&mean), "{mean}");
}

/// Each camera sees another part of the boards.
#[test]
fn a_rig_comes_from_what_both_cameras_see() {
    let rig = motor([0.3, 1.0, -0.2], 0.06, [-0.08, 0.003, 0.01]);
    let boards = boards(&TILTS);
    let [left, right] =
        [Motor::default(), rig].map(|motor| corners(&camera(motor), &boards, 0.0, 0));
    let left = parts(&left, |view, point| (point % 9 + view) % 9 < 7);
    let right = parts(&right, |view, point| (point % 9 + view) % 9 > 1);
    let found = calibrate_stereo([&left, &right], &places(), SIZE, &StereoOptions::default());
    let found = found.unwrap();
    assert!(found.rms < 1e-9, "{}", found.rms);
    let baseline: f64 = [0.08, 0.003, 0.01].iter().map(|x| x * x).sum();
    assert!((found.rig.baseline() - baseline.sqrt()).abs() < 1e-8);
    // Three points in common are too few.
    let few = parts(&corners(&camera(rig), &boards, 0.0, 0), |_, point| {
        point < 3
    });
    let found = calibrate_stereo([&left, &few], &places(), SIZE, &StereoOptions::default());
    assert!(
        matches!(
            found,
            Err(CalibrationError::TooFewPoints {
                view: 0,
                found: 0..=3
            })
        ),
        "{found:?}"
    );
}

#[test]
fn a_point_is_seen_once() {
    let seen = |point: usize| SeenPoint {
        point,
        pixel: [1.0, 2.0],
    };
    let found = BoardView::new(vec![seen(4), seen(2), seen(4)]);
    assert_eq!(found, Err(CalibrationError::RepeatedPoint { point: 4 }));
}

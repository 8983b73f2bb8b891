//! Cameras and rigs from boards: each parameter against its deviation.

use ga_camera::Camera;
use ga_camera::Intrinsics;
use ga_runtime::cga3::{Motor, Point, Translator};
use ga_vision::calibration::{
    BoardView, CameraOptions, StereoOptions, calibrate_camera, calibrate_stereo,
};
use ga_vision::chessboard::BoardSize;

use super::super::motor;
use super::{Coverage, Random, check, runs};

const SIZE: [usize; 2] = [640, 480];

fn places() -> Vec<Point<f64>> {
    BoardSize::new(9, 6).unwrap().places(0.025)
}

/// A board about the optical axis at a depth, rolled and tilted.
fn board(random: &mut Random, depth: f64, tilt: f64, aside: f64) -> Motor<f64> {
    let mut within = |size: f64| random.within(-size, size);
    let roll = motor(
        [0.0, 0.0, 1.0],
        within(1.5),
        [within(aside), within(0.8 * aside), depth],
    );
    let centre = Translator::from_displacement([-0.1, -0.0625, 0.0]);
    let tilts = motor([1.0, 0.0, 0.0], within(tilt), [0.0; 3])
        * motor([0.0, 1.0, 0.0], within(tilt), [0.0; 3]);
    roll * tilts * centre
}

fn seen(camera: &Camera, board: Motor<f64>, random: &mut Random) -> BoardView {
    let corners: Vec<Point<f64>> = places().iter().map(|p| board.transform(*p)).collect();
    let pixels = camera.project_all(&corners).unwrap();
    let pixels = pixels.into_iter().map(|pixel| random.noisy(pixel));
    BoardView::complete(&pixels.collect::<Vec<_>>())
}

/// A scene: focal length, depth of the boards and how far they are tilted and aside.
struct Scene {
    name: &'static str,
    focal: f64,
    depth: f64,
    tilt: f64,
    aside: f64,
}

fn one_camera(scene: &Scene) -> Coverage {
    let intrinsics = Intrinsics::new([scene.focal, 1.01 * scene.focal], [322.0, 238.0]).unwrap();
    let camera = Camera {
        intrinsics,
        world_to_camera: Motor::default(),
    };
    let mut coverage = Coverage::new(format!("calibration, {}", scene.name));
    let options = CameraOptions {
        terms: "k1,k2".parse().unwrap(),
        ..CameraOptions::default()
    };
    for run in runs(12) {
        let mut random = Random::new(run);
        let views: Vec<_> = (0..8)
            .map(|_| {
                let depth = random.within(0.8, 1.2) * scene.depth;
                let board = board(&mut random, depth, scene.tilt, scene.aside);
                seen(&camera, board, &mut random)
            })
            .collect();
        let Ok(found) = calibrate_camera(&views, &places(), SIZE, &options) else {
            coverage.refused += 1;
            continue;
        };
        coverage.ambiguous += usize::from(!found.ambiguous.is_empty());
        coverage.add_each(&errors(&found.intrinsics, &intrinsics, &found.deviations));
    }
    coverage
}

/// The errors of focal lengths, principal point, k1 and k2, in deviations.
fn errors(found: &Intrinsics, truth: &Intrinsics, deviations: &[f64]) -> Vec<f64> {
    let both = found.parameters().into_iter().zip(truth.parameters());
    let errors = both.zip(deviations).take(6);
    errors
        .map(|((found, truth), deviation)| (found - truth) / deviation)
        .collect()
}

#[test]
fn cameras() {
    let general = Scene {
        name: "general",
        focal: 700.0,
        depth: 0.4,
        tilt: 0.5,
        aside: 0.04,
    };
    let narrow = |name: &'static str, focal: f64, depth: f64| Scene {
        name,
        focal,
        depth,
        ..general
    };
    check(&[
        one_camera(&Scene {
            name: "little tilt",
            tilt: 0.2,
            ..general
        }),
        one_camera(&Scene {
            name: "wide",
            focal: 400.0,
            depth: 0.25,
            aside: 0.02,
            ..general
        }),
        one_camera(&narrow("narrow", 2000.0, 1.2)),
        // Boards that are seen almost in parallel do not always show a focal length.
        one_camera(&narrow("very narrow", 3000.0, 1.8)).with_least_counted(0.75),
        one_camera(&general),
    ]);
}

#[test]
fn rigs() {
    let intrinsics = Intrinsics::new([700.0, 705.0], [322.0, 238.0]).unwrap();
    let truth = motor([0.3, 1.0, -0.2], 0.06, [-0.12, 0.003, 0.01]);
    let [left, right] = [Motor::default(), truth].map(|world_to_camera| Camera {
        intrinsics,
        world_to_camera,
    });
    let options = StereoOptions {
        cameras: [CameraOptions {
            terms: "k1,k2".parse().unwrap(),
            ..CameraOptions::default()
        }; 2],
        ..StereoOptions::default()
    };
    let mut coverage = Coverage::new("calibration, rig");
    for run in runs(12) {
        let mut random = Random::new(run);
        let boards: Vec<_> = (0..8)
            .map(|_| {
                let depth = random.within(0.4, 0.6);
                Motor::from(Translator::from_displacement([0.05, 0.0, 0.0]))
                    * board(&mut random, depth, 0.5, 0.04)
            })
            .collect();
        let views = [&left, &right].map(|camera| -> Vec<_> {
            let board = |board: &Motor<f64>| seen(camera, *board, &mut random);
            boards.iter().map(board).collect()
        });
        let views = [&views[0][..], &views[1][..]];
        let Ok(found) = calibrate_stereo(views, &places(), SIZE, &options) else {
            coverage.refused += 1;
            continue;
        };
        let cameras = [&found.rig.left, &found.rig.right];
        let cameras = cameras.into_iter().zip(found.deviations);
        let mut all: Vec<f64> = cameras
            .flat_map(|(camera, own)| errors(&camera.intrinsics, &intrinsics, &own))
            .collect();
        let [x, y, z] = truth.translator().displacement();
        let error = found.rig.baseline() - (x * x + y * y + z * z).sqrt();
        all.push(error / found.baseline_deviation);
        let between = super::rotation_between(found.rig.left_to_right().motor, truth);
        let between = between.coordinates().into_iter().zip(found.rig_deviations);
        all.extend(between.map(|(error, deviation)| error / deviation));
        coverage.add_each(&all);
    }
    check(&[coverage]);
}

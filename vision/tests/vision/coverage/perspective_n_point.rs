//! The pose of a camera that sees known points.

use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::{Motor, MotorGenerator, Point};
use ga_vision::perspective_n_point::{Options, PerspectivePose, estimate};

use super::super::motor;
use super::{Coverage, NOISE, Random, check, mahalanobis, runs};

/// The squared Mahalanobis distance of the twist from a pose to the truth.
fn distance(found: &PerspectivePose, truth: Motor<f64>) -> Option<f64> {
    let covariance = found.covariance?;
    let mut between = truth * found.world_to_camera.reverse();
    if between.rotor().scalar() < 0.0 {
        between = -between;
    }
    let twist: MotorGenerator<f64> = between.log();
    let [x, y, z] = twist.angular_velocity().vector();
    let [u, v, w] = twist.velocity_at(Point::ORIGIN).vector();
    let error = [x, y, z, u, v, w];
    Some(mahalanobis(&error, |i, j| covariance[i][j]))
}

fn coverage(
    name: &str,
    focal: f64,
    options: Options,
    truth: Motor<f64>,
    points: impl Fn(&mut Random) -> Vec<[f64; 3]>,
) -> Coverage {
    let intrinsics = Intrinsics::new([focal; 2], [319.5, 239.5]).unwrap();
    let camera = Camera {
        intrinsics,
        world_to_camera: truth,
    };
    let mut coverage = Coverage::new(format!("known points, {name}"));
    for run in runs(50) {
        let mut random = Random::new(run);
        let points: Vec<_> = points(&mut random).into_iter().map(Point::from).collect();
        let pixels = camera.project_all(&points).unwrap();
        let pixels: Vec<_> = pixels
            .into_iter()
            .map(|pixel| random.noisy(pixel))
            .collect();
        let found = estimate(&points, &pixels, &intrinsics, &options).ok();
        let first = found.as_ref().and_then(|found| distance(found, truth));
        let (Some(found), Some(first)) = (found, first) else {
            coverage.refused += 1;
            continue;
        };
        let others = found.alternatives.iter();
        let others = others.filter_map(|other| distance(other, truth));
        let nearest = others.fold(first, f64::min);
        coverage.ambiguous += usize::from(found.is_ambiguous());
        coverage.second += usize::from(nearest < first);
        coverage.add(nearest, 6);
    }
    coverage
}

/// The corners of a board of 9 × 6, with steps out of its plane.
fn board(random: &mut Random, relief: f64) -> Vec<[f64; 3]> {
    let corner = |k: usize| {
        let [x, y] = [(k % 9) as f64 - 4.0, (k / 9) as f64 - 2.5];
        [0.025 * x, 0.025 * y, relief * random.normal()]
    };
    (0..54).map(corner).collect()
}

fn inclined(depth: f64) -> Motor<f64> {
    motor([1.0, 0.5, 0.2], 0.6, [0.02, -0.01, depth])
}

#[test]
fn general_scenes() {
    let cloud = |count: usize| {
        move |random: &mut Random| {
            let point = |_| [0; 3].map(|_| random.within(-0.1, 0.1));
            (0..count).map(point).collect::<Vec<_>>()
        }
    };
    let (truth, options) = (inclined(0.6), Options::default());
    let with_threshold = |deviations: f64| {
        let options = Options {
            threshold: Some(deviations * NOISE),
            ..options
        };
        let name = format!("general, threshold {deviations} deviations");
        coverage(&name, 700.0, options, truth, cloud(50))
    };
    check(&[
        coverage("general", 700.0, options, truth, cloud(50)),
        with_threshold(3.0),
        // What is left of 100 coordinates does not always show its noise.
        with_threshold(2.0).with_least_counted(0.75),
        coverage("general, 12 points", 700.0, options, truth, cloud(12)),
        coverage("general, 6 points", 700.0, options, truth, cloud(6)),
    ]);
}

#[test]
fn boards() {
    let flat = |random: &mut Random| board(random, 0.0);
    let rough = |random: &mut Random| board(random, 0.002);
    let options = Options::default();
    let facing = motor([1.0, 0.5, 0.2], 0.02, [0.02, -0.01, 0.5]);
    let far = coverage("planar, far away", 700.0, options, inclined(3.0), flat);
    // A board of 20 cm, 3 m away: both poses explain the corners.
    assert!(far.ambiguous > far.counted / 2, "{}", far.ambiguous);
    check(&[
        far,
        coverage("planar", 700.0, options, inclined(0.5), flat),
        coverage("planar, facing the camera", 700.0, options, facing, flat),
        coverage("nearly planar", 700.0, options, inclined(0.5), rough),
        coverage("planar, narrow", 4000.0, options, inclined(4.0), flat),
    ]);
}

/// Points on both sides of a road, along which the camera looks.
#[test]
fn forward_views() {
    let road = |random: &mut Random| {
        let point = |k: usize| {
            let side = if k.is_multiple_of(2) { -1.0 } else { 1.0 };
            [
                side + random.within(-0.2, 0.2),
                random.within(-0.5, 0.5),
                random.within(3.0, 30.0),
            ]
        };
        (0..50).map(point).collect::<Vec<_>>()
    };
    let truth = motor([0.3, 1.0, -0.2], 0.03, [0.05, 0.02, 0.5]);
    check(&[coverage("forward", 700.0, Options::default(), truth, road)]);
}

//! The motion between two views.

use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;
use ga_vision::feature::PixelPair;
use ga_vision::relative_pose::{Options, RelativePose, estimate};

use super::super::motor;
use super::{Coverage, NOISE, Random, check, mahalanobis, rotation_between, runs};

/// The pixels of points that two cameras see, with noise.
fn pairs(points: &[[f64; 3]], truth: Motor<f64>, random: &mut Random) -> Vec<PixelPair> {
    let camera = |world_to_camera| Camera {
        intrinsics: intrinsics(),
        world_to_camera,
    };
    let (left, right) = (camera(Motor::default()), camera(truth));
    let pair = |point: &[f64; 3]| PixelPair {
        left: random.noisy(left.project(Point::from(*point)).unwrap()),
        right: random.noisy(right.project(Point::from(*point)).unwrap()),
    };
    points.iter().map(pair).collect()
}

fn intrinsics() -> Intrinsics {
    Intrinsics::new([700.0; 2], [319.5, 239.5]).unwrap()
}

/// The squared Mahalanobis distance of the truth in the five coordinates of a motion: a rotation,
/// and a step across the translation. The direction is compared in the plane that touches the
/// sphere of directions.
fn distance(found: &RelativePose, truth: Motor<f64>) -> Option<f64> {
    let covariance = found.covariance?;
    let motor = found.left_to_right.motor;
    let rotation = rotation_between(motor, truth);
    let [from, to] = [motor, truth].map(|motor| Vector::from(motor.translator().displacement()));
    let to = to.normalized().unwrap();
    let turn = Vector::from((truth.rotor() * motor.rotor().reverse()).transform(Point::from(from)));
    let step = to * (turn.dot(from) / to.dot(from)) - turn;
    let across = from.orthonormal_pair();
    let [x, y, z] = rotation.coordinates();
    let error = [x, y, z, across[0].dot(step), across[1].dot(step)];
    let row = |k: usize| -> [f64; 6] {
        let mut row = [0.0; 6];
        match k {
            0..3 => row[k] = 1.0,
            _ => row[3..].copy_from_slice(&across[k - 3].coordinates()),
        }
        row
    };
    let entry = |i: usize, j: usize| -> f64 {
        let (a, b) = (row(i), row(j));
        let terms = (0..36).map(|k| a[k / 6] * covariance[k / 6][k % 6] * b[k % 6]);
        terms.sum()
    };
    Some(mahalanobis(&error, entry))
}

fn coverage(
    name: &str,
    count: usize,
    threshold: f64,
    truth: Motor<f64>,
    point: impl Fn(&mut Random) -> [f64; 3],
) -> Coverage {
    let mut coverage = Coverage::new(format!("pose, {name}"));
    for run in runs(100) {
        let mut random = Random::new(run);
        let points: Vec<_> = (0..count).map(|_| point(&mut random)).collect();
        let pairs = pairs(&points, truth, &mut random);
        let options = Options {
            threshold,
            ..Options::default()
        };
        let Ok(found) = estimate(&pairs, &intrinsics(), &intrinsics(), &options) else {
            coverage.refused += 1;
            continue;
        };
        let Some(first) = distance(&found, truth) else {
            coverage.refused += 1;
            continue;
        };
        let others = found.alternatives.iter();
        let others = others.filter_map(|other| distance(other, truth));
        let nearest = others.fold(first, f64::min);
        coverage.ambiguous += usize::from(found.is_ambiguous());
        coverage.second += usize::from(nearest < first);
        coverage.add(nearest, 5);
    }
    coverage
}

fn sideways() -> Motor<f64> {
    motor([0.3, 1.0, -0.2], 0.06, [-0.8, 0.1, 0.3])
}

/// A point at a depth beyond a pixel of the left view.
fn beyond(
    random: &mut Random,
    part: f64,
    depth: impl Fn(&mut Random, f64, f64) -> f64,
) -> [f64; 3] {
    let x = random.within(-0.45 * part, 0.45 * part);
    let y = random.within(-0.34 * part, 0.34 * part);
    let z = depth(random, x, y);
    [x * z, y * z, z]
}

fn general(random: &mut Random) -> [f64; 3] {
    beyond(random, 1.0, |random, _, _| random.within(4.0, 8.0))
}

/// The depth of a plane that is inclined to the left camera.
fn on_plane(x: f64, y: f64) -> f64 {
    6.0 / (1.0 - 0.3 * x + 0.2 * y)
}

#[test]
fn general_scenes() {
    let with_threshold = |deviations: f64| {
        let name = format!("general, threshold {deviations} deviations");
        coverage(&name, 100, deviations * NOISE, sideways(), general)
    };
    check(&[
        coverage("general", 100, 3.0, sideways(), general),
        with_threshold(3.0),
        with_threshold(2.0),
        coverage("general, 20 pairs", 20, 3.0, sideways(), general),
    ]);
}

/// A plane, one with random steps of 1 % of the depth, and one with a smooth bulge.
#[test]
fn planar_scenes() {
    let flat = |random: &mut Random| beyond(random, 1.0, |_, x, y| on_plane(x, y));
    let rough = |random: &mut Random| {
        beyond(random, 1.0, |random, x, y| {
            on_plane(x, y) * (1.0 + 0.01 * random.normal())
        })
    };
    let bulge = |random: &mut Random| {
        beyond(random, 1.0, |_, x, y| {
            on_plane(x, y) * (1.0 + 0.05 * (x * x + y * y))
        })
    };
    check(&[
        coverage("planar", 100, 3.0, sideways(), flat),
        coverage("nearly planar, rough", 100, 3.0, sideways(), rough),
        coverage("nearly planar, bulge", 100, 3.0, sideways(), bulge),
    ]);
}

fn forwards() -> Motor<f64> {
    motor([0.3, 1.0, -0.2], 0.03, [0.05, 0.02, -1.0])
}

#[test]
fn forward_motions() {
    check(&[coverage("forward", 100, 3.0, forwards(), general)]);
}

#[test]
fn narrow_views() {
    let truth = motor([0.3, 1.0, -0.2], 0.06, [-1.0, 0.1, 0.1]);
    let point =
        |random: &mut Random| beyond(random, 0.33, |random, _, _| random.within(10.0, 30.0));
    check(&[coverage("narrow", 100, 3.0, truth, point)]);
}

/// Corners near a line of the left view, as above the edge of a table.
#[test]
fn corners_near_a_line() {
    let strip = |width: f64| {
        move |random: &mut Random| {
            let z = random.within(4.0, 8.0);
            [
                random.within(-0.45, 0.45) * z,
                width / 700.0 * random.normal() * z,
                z,
            ]
        }
    };
    check(&[
        coverage("within 2 px of a line", 100, 3.0, sideways(), strip(2.0)),
        coverage("within 8 px of a line", 100, 3.0, sideways(), strip(8.0)),
    ]);
}

/// Corners near one place are refused, or their deviation holds.
#[test]
fn corners_near_one_place() {
    let place = |radius: f64, depth: f64| {
        let place = |random: &mut Random| {
            let z = 6.0 + random.within(-depth, depth);
            let mut side = || random.within(-1.0, 1.0) * radius / 700.0 * z;
            [side(), side(), z]
        };
        let name = format!("within {radius} px, depth ± {depth}");
        coverage(&name, 100, 3.0, sideways(), place).with_least_counted(0.5)
    };
    for (radius, depth) in [
        (3.0, 0.1),
        (3.0, 2.0),
        (12.0, 0.1),
        (12.0, 2.0),
        (48.0, 0.1),
    ] {
        let found = place(radius, depth);
        found.print();
        let part = found.counted as f64 / (found.counted + found.refused) as f64;
        assert!(part <= 0.03, "{}: {part} are not refused", found.name);
    }
    check(&[place(48.0, 2.0)]);
}

//! Poses of cameras that see known points, against the oracle's heads and known scenes.

use ga_camera::{Camera, Intrinsics, RadialTangential};
use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;
use ga_vision::ViewGeometryError;
use ga_vision::perspective_n_point::{Options, estimate, three_points};
use proptest::prelude::*;
use serde_json::Value;

use super::{motor, vector};
use nullcone_shared_data::json::{matrix, numbers, rows};

/// The root mean square distance in pixels, by matrices and without the code under test.
fn root_mean_square(record: &Value, rotation: [[f64; 3]; 3], t: [f64; 3]) -> f64 {
    let k = matrix(&record["K"]);
    let pairs = rows::<3>(&record["model"])
        .into_iter()
        .zip(rows::<2>(&record["image"]));
    let mut sum = 0.0;
    let mut count = 0.0;
    for (x, pixel) in pairs {
        let y: [f64; 3] =
            std::array::from_fn(|i| (0..3).map(|j| rotation[i][j] * x[j]).sum::<f64>() + t[i]);
        let u = k[0][0] * y[0] / y[2] + k[0][2] - pixel[0];
        let v = k[1][1] * y[1] / y[2] + k[1][2] - pixel[1];
        sum += u * u + v * v;
        count += 1.0;
    }
    (sum / count).sqrt()
}

#[test]
fn heads_of_the_oracle_are_seen_at_least_as_near_as_by_opencv() {
    let Some(path) = nullcone_shared_data::shared("oracle/vision/seed1/truth.json") else {
        return;
    };
    let text = std::fs::read_to_string(path).expect("the oracle is readable");
    let oracle: Value = serde_json::from_str(&text).expect("JSON");
    for record in oracle["pnp_head"].as_array().expect("heads") {
        let points: Vec<_> = rows(&record["model"])
            .into_iter()
            .map(Point::<f64>::from)
            .collect();
        let pixels = rows::<2>(&record["image"]);
        let intrinsics = Intrinsics::from_matrix(matrix(&record["K"])).unwrap();
        let found = estimate(&points, &pixels, &intrinsics, &Options::default()).unwrap();
        let motion = found.world_to_camera;
        let (rotation, t) = (
            motion.rotor().to_matrix(),
            motion.translator().displacement(),
        );
        let ours = root_mean_square(record, rotation, t);
        let theirs = root_mean_square(record, matrix(&record["cv2_R"]), numbers(&record["cv2_t"]));
        // Distances that are zero up to rounding have no ratio.
        assert!(ours <= (1.0 + 1e-6) * theirs + 1e-10, "{ours} {theirs}");
        assert!((found.root_mean_square - ours).abs() < 1e-9);
        if record["sigma"].as_f64() == Some(0.0) {
            let truth = (matrix(&record["R_true"]), numbers::<3>(&record["t_true"]));
            for (a, b) in rotation.as_flattened().iter().zip(truth.0.as_flattened()) {
                assert!((a - b).abs() < 1e-9);
            }
            for (a, b) in t.iter().zip(truth.1) {
                assert!((a - b).abs() < 1e-9 * truth.1[2]);
            }
        }
    }
}

fn lens() -> Intrinsics {
    let distortion = RadialTangential::new(&[-0.25, 0.08, 0.001, -0.0005, 0.01]).expect("a lens");
    let intrinsics = Intrinsics::new([620.0, 615.0], [318.0, 243.0]).expect("a camera");
    intrinsics.with_lens(distortion)
}

fn cloud(count: usize, thickness: f64) -> Vec<Point<f64>> {
    let spread = |k: usize, by: f64| (k as f64 * by).fract() * 2.0 - 1.0;
    let point = |k| {
        let depth = thickness * spread(k, 0.754_877);
        Point::new(0.6 * spread(k, 0.618_034), 0.5 * spread(k, 0.569_84), depth)
    };
    (1..=count).map(point).collect()
}

fn far(found: Motor<f64>, truth: Motor<f64>, points: &[Point<f64>]) -> f64 {
    let distance = |p: &Point<f64>| found.transform(*p).distance(truth.transform(*p));
    points.iter().map(distance).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn exact_pixels_determine_the_pose(
        axis in vector(1.0), angle in -1.0..1.0, x in -0.3..0.3, y in -0.3..0.3, z in 2.5..6.0,
        count in 4..12_usize, is_flat in prop::bool::ANY,
    ) {
        let world_to_camera = motor(axis, angle, [x, y, z]);
        let points = cloud(count, if is_flat { 0.0 } else { 0.4 });
        let camera = Camera { intrinsics: lens(), world_to_camera };
        let Ok(pixels) = camera.project_all(&points) else { return Ok(()) };
        let found = estimate(&points, &pixels, &lens(), &Options::default()).unwrap();
        // Four points that are not in a plane may be seen alike from two places.
        prop_assume!(is_flat || count > 4);
        let error = far(found.world_to_camera, world_to_camera, &points);
        prop_assert!(error < 1e-7, "{error:e} {:?}", found);
        prop_assert_eq!(found.inliers.len(), count);
    }

    #[test]
    fn wrong_pixels_are_left_out(
        axis in vector(1.0), angle in -1.0..1.0, z in 2.5..6.0, seed in 0..100_u64,
    ) {
        let world_to_camera = motor(axis, angle, [0.1, -0.1, z]);
        let points = cloud(40, 0.4);
        let camera = Camera { intrinsics: lens(), world_to_camera };
        let Ok(mut pixels) = camera.project_all(&points) else { return Ok(()) };
        for k in (0..40).step_by(3) {
            pixels[k] = [400.0 - 7.0 * k as f64, 100.0 + 9.0 * k as f64];
        }
        let options = Options { threshold: Some(1.0), seed, ..Options::default() };
        let found = estimate(&points, &pixels, &lens(), &options).unwrap();
        prop_assert!(far(found.world_to_camera, world_to_camera, &points) < 1e-7);
        prop_assert!((26..=28).contains(&found.inliers.len()));
    }

    #[test]
    fn three_points_have_the_truth_among_their_poses(
        axis in vector(1.0), angle in -1.0..1.0, z in 2.5..6.0, first in 0..50_usize,
    ) {
        let points = cloud(60, 0.4);
        let points: [Point<f64>; 3] = std::array::from_fn(|k| points[first + k * k]);
        let [p, q, r] = points.map(Vector::from);
        prop_assume!((q - p).cross(r - p).length() > 0.05);
        has_the_truth_among_its_poses(points, motor(axis, angle, [0.1, -0.2, z]))?;
    }
}

/// The poses of three points, which a camera in the true pose sees.
fn poses_of_seen(points: [Point<f64>; 3], truth: Motor<f64>) -> Vec<Motor<f64>> {
    let directions = points.map(|p| Vector::from(truth.transform(p)).normalized().unwrap());
    three_points(points, directions)
}

fn has_the_truth_among_its_poses(
    points: [Point<f64>; 3],
    truth: Motor<f64>,
) -> Result<(), TestCaseError> {
    let found = poses_of_seen(points, truth);
    let far = found.iter().map(|m| far(*m, truth, &points));
    let nearest = far.fold(f64::INFINITY, f64::min);
    prop_assert!(nearest < 1e-6, "{nearest:e}");
    prop_assert!(found.len() <= 4, "{}", found.len());
    Ok(())
}

/// Two of the four poses differ by half a thousandth of the distance.
#[test]
fn poses_next_to_each_other_are_found_once() {
    let points = cloud(60, 0.4);
    let axis = [
        -0.6247296996699491,
        -0.24476706053332462,
        -0.7160283921155094,
    ];
    let truth = motor(axis, 0.11463725858694168, [0.1, -0.2, 3.048670777397367]);
    has_the_truth_among_its_poses([9, 10, 13].map(|k| points[k]), truth).unwrap();
}

/// The middle one of three points whose sides and rays are alike in a mirror has two places on its
/// ray for the same places of the others: the radii add up to twice the part of theirs along it.
#[test]
fn both_places_of_a_point_in_the_mirror_are_found() {
    let places = [[-0.5, 0.0, 0.0], [0.0, 0.6, 0.3], [0.5, 0.0, 0.0]];
    let points = places.map(Point::<f64>::from);
    let truth = motor([0.0, 0.0, 1.0], 0.0, [0.0, 0.1, 3.0]);
    let [p, q, _] = points.map(|p| Vector::from(truth.transform(p)));
    let along = p.dot(q) / q.length();
    for radius in [q.length(), 2.0 * along - q.length()] {
        let is_found = poses_of_seen(points, truth).iter().any(|pose| {
            let [first, middle, last] = points.map(|p| Vector::from(pose.transform(p)).length());
            (first - p.length()).abs() < 1e-9
                && (middle - radius).abs() < 1e-9
                && (last - p.length()).abs() < 1e-9
        });
        assert!(is_found, "{radius}");
    }
}

#[test]
fn points_that_determine_nothing_are_refused() {
    let world_to_camera = motor([1.0, 0.0, 0.0], 0.3, [0.0, 0.0, 4.0]);
    let camera = Camera {
        intrinsics: lens(),
        world_to_camera,
    };
    let points = cloud(10, 0.4);
    let pixels = camera.project_all(&points).unwrap();
    let find = |points: &[Point<f64>], pixels: &[[f64; 2]]| {
        estimate(points, pixels, &lens(), &Options::default()).unwrap_err()
    };
    let too_few = ViewGeometryError::TooFewPoints {
        found: 3,
        needed: 4,
    };
    assert_eq!(find(&points[..3], &pixels[..3]), too_few);
    let counts = ViewGeometryError::PointCounts {
        points: 10,
        pixels: 9,
    };
    assert_eq!(find(&points, &pixels[..9]), counts);
    let mut broken = points.clone();
    broken[6] = Point::new(f64::INFINITY, 0.0, 0.0);
    assert_eq!(find(&broken, &pixels), ViewGeometryError::PointNotFinite(6));
    let mut wrong = pixels.clone();
    wrong[2] = [f64::NAN, 0.0];
    assert!(matches!(
        find(&points, &wrong),
        ViewGeometryError::PointCamera { point: 2, .. }
    ));
    let line: Vec<_> = (0..10)
        .map(|k| Point::new(0.1 * f64::from(k), 0.2, 0.0))
        .collect();
    let seen = camera.project_all(&line).unwrap();
    assert!(matches!(
        find(&line, &seen),
        ViewGeometryError::PointsCollinear { .. }
    ));
    for threshold in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let options = Options {
            threshold: Some(threshold),
            ..Options::default()
        };
        let refused = estimate(&points, &pixels, &lens(), &options);
        assert!(matches!(refused, Err(ViewGeometryError::PointThreshold(_))));
    }
    // Points that no camera sees there.
    let behind = camera.project_all(&points[..4]).unwrap();
    let swapped = [behind[1], behind[0], [5000.0, -4000.0], [-300.0, 900.0]];
    let options = Options {
        threshold: Some(0.5),
        ..Options::default()
    };
    assert!(matches!(
        estimate(&points[..4], &swapped, &lens(), &options),
        Err(ViewGeometryError::NoPointConsensus { .. } | ViewGeometryError::PoseUndetermined)
    ));
    // A sample may have the same point twice.
    let [p, q] = [points[0], points[1]];
    let [a, b] = [p, q].map(|p| {
        Vector::from(world_to_camera.transform(p))
            .normalized()
            .unwrap()
    });
    assert!(three_points([p, p, q], [a, a, b]).is_empty());
}

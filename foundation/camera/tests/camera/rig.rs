//! Pairs of cameras, the rays of their pixels, and the points that two rays determine.

use ga_camera::observation::observe;
use ga_camera::rig::{RigError, StereoRig};
use ga_camera::triangulation::{TriangulationError, triangulate};
use ga_camera::{Camera, CameraError, Intrinsics};
use ga_runtime::cga3::{Direction, Point};
use ga_runtime::geometry::ray::Ray;
use proptest::prelude::*;
use serde_json::Value;

use super::{motor, vector};
use nullcone_shared_data::json::{matrix, numbers, rows};

fn oracle() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/rigs.json");
    let text = std::fs::read_to_string(path).expect("the extract is committed");
    serde_json::from_str(&text).expect("JSON")
}

#[test]
fn rigs_of_the_oracle() {
    for record in oracle()["rigs"].as_array().expect("rigs") {
        let intrinsics = |key: &str| Intrinsics::from_matrix(matrix(&record[key])).unwrap();
        let rig = StereoRig::from_matrices(
            intrinsics("K1"),
            intrinsics("K2"),
            matrix(&record["R"]),
            numbers(&record["t"]),
        )
        .unwrap();
        let (left, right) = (rows::<2>(&record["left"]), rows::<2>(&record["right"]));
        let found = rig.triangulate_all(&left, &right).unwrap();
        let midpoints = rows::<3>(&record["midpoint"]);
        let exact = record["sigma_px"].as_f64() == Some(0.0);
        for (index, place) in found.iter().enumerate() {
            assert!(place.is_in_front());
            let expected = Point::from(midpoints[index]);
            let range = place.depths[0];
            // The oracle's own midpoint is off by 1e-12 where the rays are almost parallel.
            let tolerance = 1e-12 * range / place.angle;
            assert!(
                place.position.distance(expected) <= tolerance,
                "{index}: {place:?}"
            );
            let gap = record["ray_gap"][index].as_f64().expect("a number");
            assert!((place.gap - gap).abs() <= tolerance, "{gap} {place:?}");
            if exact {
                let truth = Point::from(rows::<3>(&record["X"])[index]);
                assert!(place.position.distance(truth) <= 1e-11 * range);
                let pixel = rig.left.project(truth).unwrap();
                assert!((pixel[0] - left[index][0]).abs() < 1e-9);
                assert!((pixel[1] - left[index][1]).abs() < 1e-9);
            }
        }
    }
}

fn intrinsics() -> Intrinsics {
    Intrinsics::new([900.0, 880.0], [320.5, 239.5]).expect("a camera")
}

proptest! {
    #[test]
    fn a_point_seen_twice_is_found(
        world in (vector(1.0), -3.0..3.0, vector(5.0)),
        between in (vector(1.0), -0.2..0.2, vector(0.5)),
        place in (-1.0..1.0, -1.0..1.0, 2.0..9.0),
    ) {
        let left = motor(world.0, world.1, world.2);
        let right = motor(between.0, between.1, between.2) * left;
        let camera = |world_to_camera| Camera { intrinsics: intrinsics(), world_to_camera };
        let rig = StereoRig { left: camera(left), right: camera(right) };
        let point = left.reverse().transform(Point::new(place.0, place.1, place.2));
        prop_assume!(rig.baseline() > 0.05);
        let (Ok(a), Ok(b)) = (rig.left.project(point), rig.right.project(point)) else {
            return Err(TestCaseError::reject("a camera does not see the point"));
        };
        let Ok(found) = rig.triangulate(a, b) else {
            return Err(TestCaseError::reject("the rays are parallel"));
        };
        prop_assume!(found.angle > 1e-3);
        prop_assert!(found.position.distance(point) < 1e-12 / found.angle, "{found:?}");
        prop_assert!(found.gap < 1e-12 / found.angle);
        prop_assert!(found.is_in_front());
        // The feet lie on their rays, and the ray through a pixel contains what is seen there.
        let ray = rig.left.ray(a).unwrap();
        prop_assert!(ray.line().distance(point).unwrap() < 1e-13 * 20.0);
        prop_assert!((ray.depth(point) - found.depths[0]).abs() < 1e-11 / found.angle);
        // The motor between the cameras takes one frame into the other.
        let across = rig.left_to_right().motor.transform(left.transform(point));
        prop_assert!(across.distance(right.transform(point)) < 1e-13 * 20.0);
    }

    #[test]
    fn skew_rays_are_joined_by_their_common_perpendicular(
        a in (vector(2.0), vector(1.0)),
        b in (vector(2.0), vector(1.0)),
    ) {
        let ray = |(origin, direction): ([f64; 3], [f64; 3])| Ray::new(origin.into(), direction);
        let (Some(first), Some(second)) = (ray(a), ray(b)) else { return Ok(()) };
        let Ok(found) = triangulate(first, second) else {
            return Ok(());
        };
        let scale = 1e-12 / found.angle.sin().powi(2);
        let between: [f64; 3] = std::array::from_fn(|k| {
            found.feet[1].coordinates()[k] - found.feet[0].coordinates()[k]
        });
        for ray in [first, second] {
            let along: f64 = (0..3).map(|k| between[k] * ray.direction().vector()[k]).sum();
            prop_assert!(along.abs() < scale, "not perpendicular: {along}");
        }
        prop_assert!(first.line().distance(found.feet[0]).unwrap() < scale);
        prop_assert!(second.line().distance(found.feet[1]).unwrap() < scale);
        // Moving a foot along its ray never brings the rays closer.
        let other = second.line().distance(found.feet[0]).unwrap();
        prop_assert!((other - found.gap).abs() < scale);
    }
}

fn side_by_side() -> StereoRig {
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    StereoRig::from_matrices(intrinsics(), intrinsics(), identity, [-0.5, 0.0, 0.0]).expect("a rig")
}

#[test]
fn crossed_pictures_are_seen_behind() {
    let rig = side_by_side();
    let point = Point::new(0.3, 0.1, 4.0);
    let (left, right) = (
        rig.left.project(point).unwrap(),
        rig.right.project(point).unwrap(),
    );
    let swapped = rig.triangulate(right, left).unwrap();
    assert!(!swapped.is_in_front() && swapped.depths[0] < 0.0 && swapped.depths[1] < 0.0);
}

#[test]
fn bad_input_is_named() {
    let rig = side_by_side();
    let parallel = rig.triangulate([10.0, 20.0], [10.0, 20.0]);
    assert!(matches!(
        parallel,
        Err(RigError::Triangulation(TriangulationError::Point { error, .. }))
            if matches!(*error, TriangulationError::Parallel { .. })
    ));
    // A ray and itself, also with other lengths of its direction.
    for length in [1.0, 3.0] {
        let ray = |length: f64| {
            Ray::new(Point::default(), [0.0, 0.6 * length, 0.8 * length]).expect("a direction")
        };
        let found = triangulate(ray(1.0), ray(length));
        assert!(
            matches!(found, Err(TriangulationError::Parallel { .. })),
            "{found:?}"
        );
    }
    assert!(matches!(
        rig.triangulate_all(&[[0.0, 0.0], [f64::NAN, 0.0]], &[[1.0, 0.0], [0.0, 0.0]]),
        Err(RigError::Camera {
            point: 1,
            error: CameraError::NotFinite(_)
        })
    ));
    assert!(matches!(
        rig.triangulate_all(&[[0.0, 0.0]], &[]),
        Err(RigError::Counts { left: 1, right: 0 })
    ));
    assert!(matches!(
        rig.left.project(Point::new(0.0, 0.0, -1.0)),
        Err(CameraError::Behind { depth, .. }) if depth == -1.0
    ));
    assert!(matches!(
        rig.left.project(Point::new(f64::INFINITY, 0.0, 1.0)),
        Err(CameraError::NotFinite(_))
    ));
    assert!(Intrinsics::new([0.0, 1.0], [0.0, 0.0]).is_err());
    assert!(Intrinsics::new([1.0, 1.0], [f64::NAN, 0.0]).is_err());
    let skewed = [[900.0, 0.1, 0.0], [0.0, 900.0, 0.0], [0.0, 0.0, 1.0]];
    assert!(matches!(
        Intrinsics::from_matrix(skewed),
        Err(CameraError::Matrix {
            row: 0,
            column: 1,
            ..
        })
    ));
    let mirror = [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let refused = StereoRig::from_matrices(intrinsics(), intrinsics(), mirror, [0.0; 3]);
    assert!(matches!(refused, Err(CameraError::Pose { .. })));
    assert!(
        Camera::look_at(
            intrinsics(),
            Point::default(),
            Point::default(),
            [0.0, 1.0, 0.0]
        )
        .is_none()
    );
}

#[test]
fn looking_at_a_place_puts_it_in_the_middle() {
    let (eye, target) = (Point::new(3.0, 1.5, -2.0), Point::new(0.2, 0.9, 0.4));
    let camera = Camera::look_at(intrinsics(), eye, target, [0.0, 1.0, 0.0]).unwrap();
    assert!(camera.centre().distance(eye) < 1e-14);
    let [u, v] = camera.project(target).unwrap();
    assert!((u - 320.5).abs() < 1e-12 && (v - 239.5).abs() < 1e-12);
    // What is above the target is above it in the picture, where v counts downwards.
    let above = camera.project(Point::new(0.2, 1.0, 0.4)).unwrap();
    assert!(above[1] < v && (above[0] - u).abs() < 1e-9);
}

#[test]
fn noise_has_its_stated_size_and_seed() {
    let camera = side_by_side().left;
    let points = vec![Point::new(0.1, 0.2, 3.0); 20_000];
    let exact = camera.project(points[0]).unwrap();
    let noisy = observe(&camera, &points, 2.0, 7).unwrap();
    let count = (2 * noisy.len()) as f64;
    let deviations = || {
        noisy
            .iter()
            .flat_map(|p| [p[0] - exact[0], p[1] - exact[1]])
    };
    let mean = deviations().sum::<f64>() / count;
    let variance = deviations().map(|d| d * d).sum::<f64>() / count;
    // Five standard errors of the mean and of the variance.
    assert!(mean.abs() < 5.0 * 2.0 / count.sqrt());
    assert!((variance / 4.0 - 1.0).abs() < 5.0 * (2.0 / count).sqrt());
    assert_eq!(noisy, observe(&camera, &points, 2.0, 7).unwrap());
    assert_ne!(noisy, observe(&camera, &points, 2.0, 8).unwrap());
    assert_eq!(observe(&camera, &points[..1], 0.0, 7).unwrap(), [exact]);
    assert_eq!(
        observe(&camera, &points, -1.0, 7),
        Err(TriangulationError::Noise(-1.0))
    );
}

/// Two rays that meet at a distance of 1/s, with s near the limit at which they count as parallel:
/// the result is that place or an error, for directions of any length.
#[test]
fn almost_parallel_rays_meet_where_they_do_or_not_at_all() {
    let mut outcomes = [0, 0];
    for step in 8..80 {
        let sine = f64::from(step) * 0.5 * f64::EPSILON;
        for length in [0.7, 1.0, 3.0] {
            // The second direction has another length, as a ray that is not checked may have.
            let ray = |x: f64, direction: [f64; 3]| {
                Ray::new_unchecked(Point::new(x, 0.0, 0.0), Direction::from_vector(direction))
            };
            let second = ray(1.0, [-sine * length, 0.0, length]);
            match triangulate(ray(0.0, [0.0, 0.0, 1.0]), second) {
                Ok(found) => {
                    let [_, _, z] = found.position.coordinates();
                    assert!(
                        (z * sine - 1.0).abs() < 1e-3,
                        "{sine:e}, {length}: {found:?}"
                    );
                    outcomes[0] += 1;
                }
                Err(error) => {
                    assert!(
                        matches!(error, TriangulationError::Parallel { .. }),
                        "{error}"
                    );
                    outcomes[1] += 1;
                }
            }
        }
    }
    assert!(outcomes.iter().all(|count| *count > 30), "{outcomes:?}");
}

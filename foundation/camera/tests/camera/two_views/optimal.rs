//! Points with the least error in the pictures.

use ga_camera::rig::StereoRig;
use ga_camera::triangulation::{Method, triangulate_views};
use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::Point;
use nullcone_shared_data::shared;
use proptest::prelude::*;
use serde_json::Value;

use super::{METHODS, Pairs, cost, found, places, rigs, seen};
use nullcone_shared_data::json::{matrix, numbers, rows};

fn rig_of(record: &Value) -> StereoRig {
    let intrinsics = |key: &str| Intrinsics::from_matrix(matrix(&record[key])).unwrap();
    let (rotation, translation) = (matrix(&record["R"]), numbers(&record["t"]));
    StereoRig::from_matrices(intrinsics("K1"), intrinsics("K2"), rotation, translation).unwrap()
}

/// The points of the Hartley–Sturm method of OpenCV are the least in reprojection; ours may not be
/// worse, and the depth-weighted ones only by a part in a million together.
#[test]
fn rigs_of_the_oracle_reach_the_optimum() {
    let Some(path) = shared("oracle/vision/seed1/truth.json") else {
        return;
    };
    let text = std::fs::read_to_string(path).unwrap();
    let truth: Value = serde_json::from_str(&text).unwrap();
    for record in truth["rigs"].as_array().unwrap() {
        let rig = rig_of(record);
        let (left, right) = (rows::<2>(&record["left"]), rows::<2>(&record["right"]));
        let (optimal, exact) = (rows::<3>(&record["optimal"]), rows::<3>(&record["X"]));
        let pairs = Pairs::new(&left, &right);
        let noise = record["sigma_px"].as_f64().unwrap();
        for method in METHODS {
            let points = found(&rig, method, &pairs);
            points.check_in_front().unwrap();
            let (mut sum, mut least) = (0.0, 0.0);
            for index in 0..left.len() {
                let point = points.get(index).unwrap();
                let (a, b) = (left[index], right[index]);
                if noise == 0.0 {
                    let truth = Point::from(exact[index]);
                    let range = truth.distance(Point::default());
                    assert!(point.position.distance(truth) <= 1e-11 * range);
                    continue;
                }
                let ours = cost(&rig, point.position, a, b);
                let theirs = cost(&rig, optimal[index].into(), a, b);
                if method == Method::Optimal {
                    assert!(ours <= theirs * (1.0 + 1e-9) + 1e-18, "{ours} {theirs}");
                }
                sum += ours;
                least += theirs;
            }
            let bound = match method {
                Method::Midpoint => continue,
                Method::DepthWeighted => 1.0 + 1e-6,
                Method::Optimal => 1.0 + 1e-9,
            };
            assert!(
                noise == 0.0 || (sum / least).sqrt() <= bound,
                "{method:?}: {}",
                (sum / least).sqrt()
            );
        }
    }
}

proptest! {
    /// The optimal point has the least error in the pictures of all points: it is the point of
    /// least squares, found by another method, and no point beside it is better.
    #[test]
    fn optimal_points_are_those_of_least_squares(
        rig in rigs(), places in places(), errors in prop::collection::vec(prop::array::uniform4(-1.5..1.5), 10),
    ) {
        prop_assume!(rig.baseline() > 0.1);
        let Some((_, pairs)) = seen(&rig, &places, &errors) else { return Ok(()) };
        let optimal = found(&rig, Method::Optimal, &pairs);
        for index in 0..optimal.len() {
            let point = optimal.get(index).unwrap();
            prop_assume!(point.is_in_front() && point.angle > 0.02);
            let left = [pairs.left[0][index], pairs.left[1][index]];
            let right = [pairs.right[0][index], pairs.right[1][index]];
            let least = cost(&rig, point.position, left, right);
            let other = triangulate_views(&[rig.left, rig.right], &[left, right]);
            if let Ok(other) = other {
                let theirs = 2.0 * other.error_px.powi(2);
                prop_assert!((least - theirs).abs() <= 1e-8 * theirs + 1e-16, "{least} {theirs}");
            }
            for axis in 0..3 {
                for step in [-1e-3, 1e-3] {
                    let mut beside = point.position.coordinates();
                    beside[axis] += step * point.depths[0];
                    if rig.left.project(beside.into()).is_ok() && rig.right.project(beside.into()).is_ok() {
                        prop_assert!(cost(&rig, beside.into(), left, right) >= least);
                    }
                }
            }
        }
    }

    /// Away from the epipoles, one step leaves less than 0.1 % of the least error, with any rig.
    #[test]
    fn depth_weighted_points_are_nearly_those_of_least_squares(
        rig in rigs(), places in places(), errors in prop::collection::vec(prop::array::uniform4(-1.5..1.5), 10),
    ) {
        prop_assume!(rig.baseline() > 0.1);
        let pairs = seen(&rig, &places, &errors);
        prop_assume!(pairs.is_some());
        let (_, pairs) = pairs.unwrap();
        let [weighted, optimal] =
            [Method::DepthWeighted, Method::Optimal].map(|method| found(&rig, method, &pairs));
        for index in 0..optimal.len() {
            let [ours, best] = [&weighted, &optimal].map(|points| points.get(index).unwrap());
            prop_assume!(best.is_in_front() && best.angle > 0.1 && best.angle < 3.0);
            let left = [pairs.left[0][index], pairs.left[1][index]];
            let right = [pairs.right[0][index], pairs.right[1][index]];
            let [error, least] =
                [ours, best].map(|point| cost(&rig, point.position, left, right).sqrt());
            prop_assert!(error <= 1.001 * least + 1e-9, "{error} {least}");
            // Both depths belong to the point.
            for (camera, depth) in [rig.left, rig.right].iter().zip(best.depths) {
                let [_, _, z] = camera.world_to_camera.transform(best.position).coordinates();
                prop_assert!((depth - z).abs() < 1e-9);
            }
        }
    }
}

/// Where one camera is twice as near as the other, its errors count four times as much.
#[test]
fn weights_by_depth_matter_where_the_depths_differ() {
    let intrinsics = Intrinsics::new([1000.0, 1000.0], [640.0, 360.0]).unwrap();
    let camera = |eye: [f64; 3]| {
        let (eye, target) = (Point::from(eye), Point::default());
        Camera::look_at(intrinsics, eye, target, [0.0, 1.0, 0.0]).unwrap()
    };
    let rig = StereoRig {
        left: camera([0.0, 0.0, 6.0]),
        right: camera([1.5, 0.0, 2.6]),
    };
    let places: Vec<[f64; 3]> = (0..200)
        .map(|step| {
            let step = f64::from(step);
            [
                0.5 * (step * 0.7).sin(),
                0.5 * (step * 1.3).cos(),
                6.0 + 0.3 * (step * 0.4).sin(),
            ]
        })
        .collect();
    let noise = |step: usize| {
        let step = step as f64;
        [1.0, 2.3, 3.1, 4.7].map(|rate: f64| (rate * step * step + rate).sin())
    };
    let errors: Vec<_> = (0..200).map(noise).collect();
    let (_, pairs) = seen(&rig, &places, &errors).unwrap();
    let [midpoint, weighted, optimal] = METHODS.map(|method| -> f64 {
        let points = found(&rig, method, &pairs);
        let costs = (0..200).map(|index| {
            let left = [pairs.left[0][index], pairs.left[1][index]];
            let right = [pairs.right[0][index], pairs.right[1][index]];
            cost(&rig, points.get(index).unwrap().position, left, right)
        });
        costs.sum()
    });
    assert!(
        optimal <= weighted && weighted <= (1.0 + 1e-4) * optimal,
        "{weighted} {optimal}"
    );
    assert!(midpoint >= 1.15 * optimal, "{midpoint} {optimal}");
}

//! Simulated observations of bodies, and the errors of what is found from them.

use ga_body::BodyError;
use ga_body::evaluation::{Disturbance, score, simulate, triangulated_points};
use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;
use serde_json::Value;

use nullcone_shared_data::json::rows;

fn cameras() -> Vec<Camera> {
    let intrinsics = Intrinsics::new([1000.0, 1000.0], [960.0, 540.0]).unwrap();
    let half: f64 = 0.5;
    let camera = |x: f64| {
        let eye = Point::new(x, 0.0, (16.0 - half * half).sqrt());
        Camera::look_at(intrinsics, eye, Point::default(), [0.0, 1.0, 0.0]).unwrap()
    };
    vec![camera(-half), camera(half)]
}

fn motion() -> Vec<Vec<Point<f64>>> {
    let frame = |t: usize| {
        let joint = |k: usize| {
            let (a, b) = (k as f64 * 1.3, t as f64 * 0.2 + k as f64);
            Point::new(0.5 * a.sin(), 0.8 * b.cos(), 0.3 * (a + b).sin())
        };
        (0..21).map(joint).collect()
    };
    (0..60).map(frame).collect()
}

#[test]
fn noise_and_missing_joints_are_as_many_as_stated() {
    let (cameras, motion) = (cameras(), motion());
    let disturbance = Disturbance {
        noise_px: 2.0,
        missing: 0.2,
        seed: 5,
    };
    let seen = simulate(&cameras, &motion, &disturbance).unwrap();
    let (mut squares, mut count) = (0.0, 0.0);
    for (observation, points) in seen.iter().zip(&motion) {
        for (camera, view) in cameras.iter().zip(&observation.views) {
            for (pixel, point) in view.iter().zip(points) {
                let Some(pixel) = pixel else { continue };
                assert_eq!(pixel.deviation, 2.0);
                let [u, v] = camera.project(*point).unwrap();
                squares += (pixel.position[0] - u).powi(2) + (pixel.position[1] - v).powi(2);
                count += 2.0;
            }
        }
    }
    // Five standard errors.
    let all: f64 = 60.0 * 21.0 * 2.0;
    let expected = 0.8 * all;
    assert!(
        (count / 2.0 - expected).abs() < 5.0 * (all * 0.16).sqrt(),
        "{count}"
    );
    assert!((squares / count / 4.0 - 1.0f64).abs() < 5.0 * (2.0 / count).sqrt());
    assert_eq!(seen, simulate(&cameras, &motion, &disturbance).unwrap());
    let other = Disturbance {
        seed: 6,
        ..disturbance
    };
    assert_ne!(seen, simulate(&cameras, &motion, &other).unwrap());
}

/// The error of a point between two cameras is that of its depth, z²/(f b) √2 σ, and across.
#[test]
fn triangulated_points_have_the_errors_of_the_closed_form() {
    let (cameras, motion) = (cameras(), motion());
    let disturbance = Disturbance {
        noise_px: 2.0,
        missing: 0.0,
        seed: 1,
    };
    let seen = simulate(&cameras, &motion, &disturbance).unwrap();
    let found: Vec<_> = seen
        .iter()
        .map(|seen| triangulated_points(&cameras, seen))
        .collect();
    let scores = score(&cameras, &motion, &found).unwrap();
    let depth = 16.0 / 1000.0 * 2f64.sqrt() * 2.0;
    let across = 4.0 / 1000.0 * 2.0 / 2f64.sqrt();
    // The mean length of a vector with these deviations, by its expansion in across/depth:
    // √(2/π) depth (1 + (across/depth)² ln(…)) is within 5 % of the mean of the depth alone.
    let mean = (2.0 / std::f64::consts::PI).sqrt() * depth;
    assert!(scores.position_error > mean, "{scores:?}");
    assert!(scores.position_error < 1.1 * mean + across, "{scores:?}");
    assert_eq!(scores.found, 1.0);
    // Across a view, a triangulated point errs by the noise of both views: about σ in each.
    assert!((1.2..3.0).contains(&scores.joint_error_px), "{scores:?}");
}

#[test]
fn scores_do_not_see_what_they_are_free_of() {
    let (cameras, motion) = (cameras(), motion());
    let some = |points: &[Point<f64>]| points.iter().copied().map(Some).collect::<Vec<_>>();
    let moved = |change: &dyn Fn(Point<f64>) -> Point<f64>| -> Vec<Vec<Option<Point<f64>>>> {
        motion
            .iter()
            .map(|points| points.iter().map(|&p| Some(change(p))).collect())
            .collect()
    };
    let shifted =
        moved(&|p| Motor::from(Translator::from_displacement([0.0, 0.03, 0.04])).transform(p));
    let scores = score(&cameras, &motion, &shifted).unwrap();
    assert!((scores.position_error - 0.05).abs() < 1e-12);
    assert!(scores.root_relative_error.unwrap() < 1e-12);
    let rotor = Rotor::from_axis_angle([0.0, 1.0, 0.0], 0.1).unwrap();
    let turned = moved(&|p| {
        let grown = Point::from(Vector::from(p) * 1.05);
        Motor::from(rotor).transform(grown)
    });
    let scores = score(&cameras, &motion, &turned).unwrap();
    assert!(scores.root_relative_error.unwrap() > 0.01);
    assert!(scores.aligned_error.unwrap() < 1e-12);
    // A mirror image is not aligned.
    let mirrored = moved(&|p| {
        let [x, y, z] = p.coordinates();
        Point::new(-x, y, z)
    });
    assert!(
        score(&cameras, &motion, &mirrored)
            .unwrap()
            .aligned_error
            .unwrap()
            > 0.01
    );
    let exact: Vec<_> = motion.iter().map(|points| some(points)).collect();
    let scores = score(&cameras, &motion, &exact).unwrap();
    assert_eq!((scores.position_error, scores.joint_error_px), (0.0, 0.0));
}

/// The scores of a motion are the means of what numpy finds for its frames, whether all joints of a
/// frame are found or not.
#[test]
fn scores_are_means_of_the_oracle() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/procrustes.json");
    let text = std::fs::read_to_string(path).expect("committed");
    let oracle: Value = serde_json::from_str(&text).expect("JSON");
    let cases = oracle["cases"].as_array().expect("cases");
    let complete: Vec<&Value> = cases.iter().filter(|case| case["mpjpe"].is_f64()).collect();
    assert_eq!(complete.len(), 3);
    let points = |case: &Value, key: &str| -> Vec<Point<f64>> {
        rows::<3>(&case[key]).into_iter().map(Point::from).collect()
    };
    let mut truth: Vec<_> = complete.iter().map(|c| points(c, "ground_truth")).collect();
    let found = complete.iter().map(|c| points(c, "predicted"));
    let mut found: Vec<Vec<_>> = found.map(|f| f.into_iter().map(Some).collect()).collect();
    // Joints that are not found count for nothing.
    for (truth, found) in truth.iter_mut().zip(&mut found) {
        truth.insert(2, Point::new(7.0, -3.0, 9.0));
        found.insert(2, None);
    }
    let scores = score(&[], &truth, &found).unwrap();
    let mean = |key: &str| -> f64 {
        let values = complete.iter().map(|case| case[key].as_f64().unwrap());
        values.sum::<f64>() / 3.0
    };
    for (key, found) in [
        ("mpjpe", Some(scores.position_error)),
        ("mpjpe_root", scores.root_relative_error),
        ("pa_mpjpe", scores.aligned_error),
    ] {
        let (found, expected) = (found.unwrap(), mean(key));
        assert!(
            (found - expected).abs() <= 1e-12 * expected.max(1.0),
            "{key}: {found} is not {expected}"
        );
    }
    // The mirror image is rotated as well as can be, and not reflected.
    let mirrored = cases.iter().find(|case| case["mpjpe"].is_null()).unwrap();
    let truth = vec![points(mirrored, "ground_truth")];
    let found = points(mirrored, "predicted").into_iter().map(Some);
    let scores = score(&[], &truth, &[found.collect()]).unwrap();
    let expected = mirrored["pa_mpjpe"].as_f64().unwrap();
    assert!((scores.aligned_error.unwrap() - expected).abs() < 1e-12);
    assert!(expected > 0.01);
}

#[test]
fn frames_without_their_root_or_with_few_joints_have_fewer_scores() {
    let truth = vec![[[0.0, 0.0, 4.0], [1.0, 0.0, 4.0], [0.0, 1.0, 4.0]].map(Point::from); 3]
        .into_iter()
        .map(Vec::from)
        .collect::<Vec<_>>();
    let off = |k: usize| {
        Some(Point::from(
            Vector::from(truth[0][k]) + Vector::new(0.0, 0.0, 0.5),
        ))
    };
    // All; without the root; and none.
    let found = [
        vec![Some(truth[0][0]), Some(truth[0][1]), off(2)],
        vec![None, off(1), off(2)],
        vec![None; 3],
    ];
    let scores = score(&[], &truth, &found).unwrap();
    assert!((scores.position_error - (0.5 / 3.0 + 0.5) / 2.0).abs() < 1e-15);
    assert!((scores.root_relative_error.unwrap() - 0.5 / 3.0).abs() < 1e-15);
    assert!((scores.found - 5.0 / 9.0).abs() < 1e-15);
    let alone = score(&[], &truth[..1], &found[..1]).unwrap();
    assert_eq!(scores.aligned_error, alone.aligned_error);
    assert!(matches!(
        score(&[], &truth[..1], &found[2..]),
        Err(BodyError::NoJoints)
    ));
    let nan = vec![Some(Point::new(f64::NAN, 0.0, 0.0)), None, None];
    assert!(matches!(
        score(&[], &truth[..1], &[nan]),
        Err(BodyError::JointNotFinite { joint: 0 })
    ));
    assert!(matches!(
        score(&[], &truth[..1], &[vec![None; 2]]),
        Err(BodyError::JointCounts {
            expected: 3,
            found: 2
        })
    ));
}

/// A joint that is too deep by a metre is where it should be for the camera in front of it, and 50
/// px beside that for one a metre to the side.
#[test]
fn joint_errors_are_means_over_all_views() {
    let intrinsics = Intrinsics::new([1000.0, 1000.0], [0.0, 0.0]).unwrap();
    let camera = |x: f64| Camera {
        intrinsics,
        world_to_camera: Translator::from_displacement([-x, 0.0, 0.0]).into(),
    };
    let truth = vec![vec![Point::new(0.0, 0.0, 4.0)]];
    let found = vec![vec![Some(Point::new(0.0, 0.0, 5.0))]];
    let scores = score(&[camera(0.0), camera(1.0)], &truth, &found).unwrap();
    assert!((scores.joint_error_px - 25.0).abs() < 1e-9, "{scores:?}");
    assert_eq!(scores.position_error, 1.0);
}

/// The noise of a view says nothing about that of another view or frame.
#[test]
fn noise_is_independent_between_views_and_frames() {
    let cameras = cameras();
    let still = vec![motion()[0].clone(); 400];
    let disturbance = Disturbance {
        noise_px: 1.5,
        missing: 0.0,
        seed: 3,
    };
    let seen = simulate(&cameras, &still, &disturbance).unwrap();
    let noise = |frame: usize, view: usize, point: usize| {
        let pixel = seen[frame].views[view][point].unwrap().position;
        let [u, v] = cameras[view].project(still[0][point]).unwrap();
        [pixel[0] - u, pixel[1] - v]
    };
    let (mut views, mut frames, mut coordinates, mut count) = (0.0, 0.0, 0.0, 0.0_f64);
    for frame in 0..399 {
        for point in 0..21 {
            let here = noise(frame, 0, point);
            views += here[0] * noise(frame, 1, point)[0];
            frames += here[0] * noise(frame + 1, 0, point)[0];
            coordinates += here[0] * here[1];
            count += 1.0;
        }
    }
    // Five standard errors of the mean of products with the variance σ⁴.
    let bound = 5.0 * 1.5 * 1.5 / count.sqrt();
    for sum in [views, frames, coordinates] {
        assert!((sum / count).abs() < bound, "{}", sum / count);
    }
}

#[test]
fn what_cannot_be_simulated_is_named() {
    let (cameras, mut motion) = (cameras(), motion());
    let good = Disturbance {
        noise_px: 1.0,
        missing: 0.0,
        seed: 1,
    };
    for missing in [-0.1, 1.5, f64::NAN] {
        let bad = Disturbance { missing, ..good };
        assert!(matches!(
            simulate(&cameras, &motion, &bad),
            Err(BodyError::Missing(_))
        ));
    }
    motion[3][7] = Point::new(0.0, 0.0, 9.0);
    let text = simulate(&cameras, &motion, &good).unwrap_err().to_string();
    for part in ["frame 3", "view 0", "point 7"] {
        assert!(text.contains(part), "{text}");
    }
    assert!(score(&cameras, &motion, &[]).is_err());
}

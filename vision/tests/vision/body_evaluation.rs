//! Simulated observations of bodies, and the errors of what is found from them.

use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;
use ga_vision::body::evaluation::{
    Disturbance, SimulationError, score, simulate, triangulated_points,
};
use ga_vision::camera::{Camera, Intrinsics};

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
            Err(SimulationError::Missing(_))
        ));
    }
    motion[3][7] = Point::new(0.0, 0.0, 9.0);
    let text = simulate(&cameras, &motion, &good).unwrap_err().to_string();
    for part in ["frame 3", "view 0", "point 7"] {
        assert!(text.contains(part), "{text}");
    }
    assert!(score(&cameras, &motion, &[]).is_err());
}

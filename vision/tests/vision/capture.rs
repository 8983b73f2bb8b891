//! Heads: poses against known motions and the oracle, capture matrices and eq. 1 by hand.

use ga_runtime::cga3::{Motor, Point};
use ga_vision::capture::{
    Capture, CaptureError, PointSet, PoseOptions, description_constant, rigid_pose,
};
use proptest::prelude::*;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, Normal, Uniform};
use serde_json::Value;

use super::{motor, vector};
use nullcone_shared_data::json::{matrix, numbers, rows};

/// `R x + t`, by plain arithmetic.
fn moved(rotation: [[f64; 3]; 3], t: [f64; 3], x: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| (0..3).map(|j| rotation[i][j] * x[j]).sum::<f64>() + t[i])
}

fn points(places: &[[f64; 3]]) -> Vec<Point<f64>> {
    places.iter().copied().map(Point::from).collect()
}

#[track_caller]
fn assert_near_motion(found: Motor<f64>, rotation: [[f64; 3]; 3], t: [f64; 3]) {
    let rows = found.rotor().to_matrix();
    for (a, b) in rows.as_flattened().iter().zip(rotation.as_flattened()) {
        assert!((a - b).abs() < 1e-9, "{rows:?} {rotation:?}");
    }
    for (a, b) in found.translator().displacement().iter().zip(t) {
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
}

/// The heads of the oracle, in millimetres: all points of the model, and any four of them.
#[test]
fn heads_of_the_oracle() {
    let Some(path) = nullcone_shared_data::shared("oracle/vision/seed1/truth.json") else {
        return;
    };
    let text = std::fs::read_to_string(path).expect("the oracle is readable");
    let oracle: Value = serde_json::from_str(&text).expect("JSON");
    let heads = oracle["pnp_head"].as_array().expect("heads");
    assert!(heads.len() >= 10);
    for record in heads {
        let model = rows::<3>(&record["model"]);
        let (rotation, t) = (matrix(&record["R_true"]), numbers::<3>(&record["t_true"]));
        let seen: Vec<_> = model.iter().map(|&x| moved(rotation, t, x)).collect();
        let (rest, seen) = (points(&model), points(&seen));
        for options in [None, Some(1.0)].map(|threshold| PoseOptions {
            threshold,
            ..PoseOptions::default()
        }) {
            let found = rigid_pose(&rest, &seen, &options).unwrap();
            assert_near_motion(found.motor, rotation, t);
            assert!(found.root_mean_square < 1e-9);
            assert_eq!(found.inliers, [0, 1, 2, 3, 4, 5]);
            let found = rigid_pose(&rest[2..], &seen[2..], &options).unwrap();
            assert_near_motion(found.motor, rotation, t);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_pose_and_the_expression_of_exact_points_are_exact(
        axis in vector(1.0), angle in -3.1..3.1, displacement in vector(3.0),
        places in prop::collection::vec(vector(0.1), 4..12), is_flat in prop::bool::ANY,
        expression in vector(0.02),
    ) {
        prop_assume!(axis.iter().map(|x| x * x).sum::<f64>() > 0.01);
        let mut places = places;
        if is_flat {
            places.iter_mut().for_each(|place| place[2] = 0.3 * place[0]);
        }
        let truth = motor(axis, angle, displacement);
        let rotation = truth.rotor().to_matrix();
        let mut rest = points(&places);
        let calibrated: Vec<_> = (0..rest.len()).collect();
        let [a, b, c] = [0, 1, 2].map(|k| ga_runtime::vga3::Vector::from(places[k]));
        prop_assume!((b - a).cross(c - a).length() > 1e-4);
        let mut seen: Vec<_> = places.iter().map(|&x| moved(rotation, displacement, x)).collect();
        // A point that is not calibrated, moved by an expression in the frame of the head.
        let lip = [0.01, -0.05, 0.08];
        rest.push(lip.into());
        let raised = std::array::from_fn(|k| lip[k] + expression[k]);
        seen.push(moved(rotation, displacement, raised));
        let seen: Vec<_> = points(&seen).into_iter().map(Some).collect();
        let capture = Capture::new(rest, calibrated, PoseOptions::default()).unwrap();
        let found = capture.frame(&seen).unwrap();
        assert_near_motion(found.pose.motor, rotation, displacement);
        let lip = found.expression.last().unwrap().unwrap();
        for (a, b) in lip.coordinates().iter().zip(expression) {
            prop_assert!((a - b).abs() < 1e-9);
        }
        for still in &found.expression[..places.len()] {
            prop_assert!(still.unwrap().length() < 1e-9);
        }
    }
}

/// An orthonormal frame on three points: along the first side, in their plane, and normal to it.
fn frame_on([a, b, c]: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let [a, b, c] = [a, b, c].map(ga_runtime::vga3::Vector::from);
    let u = (b - a) * (b - a).length().recip();
    let w = u.cross(c - a);
    let w = w * w.length().recip();
    [u, w.cross(u), w].map(|axis| axis.coordinates())
}

proptest! {
    /// With a frame on three points at rest and one on those seen, the columns of F and G, the
    /// rotation is G Fᵀ.
    #[test]
    fn three_points_determine_a_pose(
        axis in vector(1.0), angle in -3.1..3.1, displacement in vector(3.0),
        places in prop::array::uniform3(vector(0.1)), lip in vector(0.1),
    ) {
        prop_assume!(axis.iter().map(|x| x * x).sum::<f64>() > 0.01);
        let [a, b, c] = places.map(ga_runtime::vga3::Vector::from);
        prop_assume!((b - a).cross(c - a).length() > 1e-4);
        let truth = motor(axis, angle, displacement).rotor().to_matrix();
        let seen = places.map(|place| moved(truth, displacement, place));
        let (f, g) = (frame_on(places), frame_on(seen));
        let rotation: [[f64; 3]; 3] = std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..3).map(|k| g[k][i] * f[k][j]).sum())
        });
        let turned = moved(rotation, [0.0; 3], places[0]);
        let translation: [f64; 3] = std::array::from_fn(|k| seen[0][k] - turned[k]);
        let found = rigid_pose(&points(&places), &points(&seen), &PoseOptions::default()).unwrap();
        assert_near_motion(found.motor, rotation, translation);
        prop_assert_eq!(found.inliers, [0, 1, 2]);

        // The same with a fourth calibrated point that is not seen.
        let mut rest = points(&places);
        rest.push(lip.into());
        let capture = Capture::new(rest, vec![0, 1, 2, 3], PoseOptions::default()).unwrap();
        let mut frame: Vec<_> = points(&seen).into_iter().map(Some).collect();
        frame.push(None);
        assert_near_motion(capture.frame(&frame).unwrap().motor(), rotation, translation);
    }
}

/// The error of a pose: the greatest distance by which it misses where the points are.
fn error(found: Motor<f64>, truth: Motor<f64>, rest: &[Point<f64>]) -> f64 {
    let miss = |&x: &Point<f64>| found.transform(x).distance(truth.transform(x));
    rest.iter().map(miss).fold(0.0, f64::max)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// With 30 % of gross errors the median error over 100 draws is within twice that without them.
#[test]
fn gross_errors_are_left_out() {
    for (count, sigma) in [(20, 1e-3), (30, 2e-4), (60, 3e-3)] {
        let noise = Normal::new(0.0, sigma).unwrap();
        let spread = Uniform::new(-0.1, 0.1).unwrap();
        let gross = Uniform::new(-0.3, 0.3).unwrap();
        let (mut clean, mut robust, mut plain) = (Vec::new(), Vec::new(), Vec::new());
        for draw in 0..100 {
            let mut random = ChaCha8Rng::seed_from_u64(1000 + draw);
            let mut place = || std::array::from_fn(|_| spread.sample(&mut random));
            let rest: Vec<_> = (0..count).map(|_| Point::from(place())).collect();
            let truth = motor([1.0, 2.0, -0.5], 0.03 * draw as f64, [0.1, 1.6, 0.4]);
            let mut seen: Vec<_> = rest
                .iter()
                .map(|&x| {
                    let [x, y, z] = truth.transform(x).coordinates();
                    let mut noise = || noise.sample(&mut random);
                    Point::new(x + noise(), y + noise(), z + noise())
                })
                .collect();
            let all = PoseOptions::default();
            let found = rigid_pose(&rest, &seen, &all).unwrap();
            clean.push(error(found.motor, truth, &rest));
            let wrong = count * 3 / 10;
            for point in &mut seen[..wrong] {
                let [x, y, z] = point.coordinates();
                let mut by = || gross.sample(&mut random);
                *point = Point::new(x + by(), y + by(), z + by());
            }
            let options = PoseOptions {
                threshold: Some(4.0 * sigma),
                seed: draw,
                ..all
            };
            let found = rigid_pose(&rest, &seen, &options).unwrap();
            robust.push(error(found.motor, truth, &rest));
            assert_eq!(found, rigid_pose(&rest, &seen, &options).unwrap());
            plain.push(error(
                rigid_pose(&rest, &seen, &all).unwrap().motor,
                truth,
                &rest,
            ));
        }
        let [clean, robust, plain] = [clean, robust, plain].map(median);
        assert!(robust <= 2.0 * clean, "{count}: {robust:e} {clean:e}");
        assert!(plain > 5.0 * clean, "{count}: {plain:e} {clean:e}");
    }
}

/// A quarter turn about z takes (x, y, z) to (−y, x, z); then a translation by (1, 2, 3).
#[test]
fn a_capture_matrix_by_hand() {
    let rest = [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [-1.0, 0.0, 0.0],
        [2.0, 1.0, 0.5],
        [0.0, -3.0, 1.0],
    ];
    // The fifth point is at (2.25, 1, 0.5) in the head's frame, so that it is seen at
    // (−1 + 1, 2.25 + 2, 0.5 + 3). The sixth is not seen.
    let seen = [
        Some([1.0, 3.0, 3.0]),
        Some([0.0, 2.0, 3.0]),
        Some([1.0, 2.0, 4.0]),
        Some([1.0, 1.0, 3.0]),
        Some([0.0, 4.25, 3.5]),
        None,
    ]
    .map(|place| place.map(Point::from));
    let capture = Capture::new(points(&rest), vec![0, 1, 2, 3], PoseOptions::default()).unwrap();
    let frame = capture.frames(&[seen]).unwrap().remove(0).unwrap();
    let matrix = frame.matrix();
    assert_eq!(matrix.points, [0, 1, 2, 3, 4]);
    let expected = [
        [1.0, 0.0, 0.0, -1.0, 2.25],
        [0.0, 1.0, 0.0, 0.0, 1.0],
        [0.0, 0.0, 1.0, 0.0, 0.5],
        [1.0; 5],
    ];
    for (row, expected) in matrix.rows().iter().zip(expected) {
        assert_eq!(row.len(), 5);
        for (a, b) in row.iter().zip(expected) {
            assert!((a - b).abs() < 1e-14, "{row:?} {expected:?}");
        }
    }
    let moved = frame.expression[4].unwrap().coordinates();
    for (a, b) in moved.iter().zip([0.25, 0.0, 0.0]) {
        assert!((a - b).abs() < 1e-14, "{moved:?}");
    }
    assert!(frame.expression[5].is_none() && frame.still[5].is_none());
    assert_near_motion(
        frame.motor(),
        [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        [1.0, 2.0, 3.0],
    );
}

#[test]
fn the_description_constant_by_hand() {
    let found = |h, times: &[f64], frame| description_constant(h, times, frame);
    // m = 0: H = h.
    assert_eq!(found(7.0, &[], 3.0), Ok(7.0));
    // m = 1: the ratio h is without effect, and H = 0.5 · 4.
    assert_eq!(found(7.0, &[0.5], 4.0), Ok(2.0));
    // m = 3: −2 · 7 + 1 · 2 + 0.5 · 4 + 0.25 · 8 = −8.
    assert_eq!(found(7.0, &[1.0, 0.5, 0.25], 2.0), Ok(-8.0));
    // m = 3, ϖ = −3: −2 · 1 + 2 · −3 + 0 · 9 + 1 · −27 = −35.
    assert_eq!(found(1.0, &[2.0, 0.0, 1.0], -3.0), Ok(-35.0));
    assert!(matches!(
        found(f64::NAN, &[], 1.0),
        Err(CaptureError::Ratio(_))
    ));
    let term = found(1.0, &[0.0, f64::INFINITY], 1.0);
    assert!(matches!(term, Err(CaptureError::Term { time: 2, .. })));
    let frame = found(1.0, &[1.0], f64::NAN);
    assert!(matches!(frame, Err(CaptureError::FrameValue(_))));
    let large = found(1.0, &[0.0, 1.0], 1e200);
    assert!(matches!(
        large,
        Err(CaptureError::DescriptionOutOfRange { terms: 2, .. })
    ));
}

#[test]
fn points_that_determine_no_pose_are_refused() {
    let all = PoseOptions::default();
    let line = points(&[0.0, 1.0, 2.0, 5.0].map(|s| [s, 2.0 * s, -s]));
    let square = points(&[
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ]);
    let fails =
        |rest: &[Point<f64>], seen: &[Point<f64>]| rigid_pose(rest, seen, &all).unwrap_err();
    assert!(rigid_pose(&square, &square, &all).is_ok());
    let place = PointSet::Rest;
    assert_eq!(fails(&line, &square), CaptureError::Collinear { place });
    let place = PointSet::Seen;
    assert_eq!(fails(&square, &line), CaptureError::Collinear { place });
    let one = vec![square[1]; 4];
    assert_eq!(fails(&square, &one), CaptureError::Coincident { place });
    assert_eq!(
        fails(&square[1..], &line[1..]),
        CaptureError::Collinear {
            place: PointSet::Seen
        }
    );
    let (found, needed) = (2, 3);
    assert_eq!(
        fails(&square[2..], &line[2..]),
        CaptureError::TooFew { found, needed }
    );
    assert_eq!(
        fails(&square, &line[1..]),
        CaptureError::Counts { rest: 4, seen: 3 }
    );
    let mut wrong = square.clone();
    wrong[2] = Point::new(0.0, f64::NAN, 0.0);
    assert_eq!(fails(&square, &wrong), CaptureError::NotFinite { point: 2 });
    // The mirror image of a cube fits equally well in several ways.
    let cube: Vec<_> = (0..8)
        .map(|k| [k & 1, k >> 1 & 1, k >> 2].map(|bit| f64::from(2 * bit - 1)))
        .collect();
    let mirror: Vec<_> = cube.iter().map(|p| p.map(|x| -x)).collect();
    assert_eq!(
        fails(&points(&cube), &points(&mirror)),
        CaptureError::NotUnique
    );
    let robust = |threshold| PoseOptions {
        threshold: Some(threshold),
        ..all
    };
    assert_eq!(
        rigid_pose(&square, &square, &robust(0.0)),
        Err(CaptureError::Threshold(0.0))
    );
    let mut bent = square.clone();
    bent[3] = Point::new(0.0, 1.0, 5.0);
    let found = rigid_pose(&square, &bent, &robust(0.1)).unwrap();
    assert_eq!(found.inliers, [0, 1, 2]);
    bent[2] = Point::new(1.0, 1.0, -7.0);
    assert!(matches!(
        rigid_pose(&square, &bent, &robust(0.1)),
        Err(CaptureError::NoConsensus {
            points: 4,
            needed: 3,
            ..
        })
    ));
}

#[test]
fn frames_that_cannot_be_captured_are_named() {
    let rest = points(&[
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 1.0, 0.0],
        [2.0, 2.0, 0.0],
    ]);
    let new = |calibrated: &[usize]| {
        Capture::new(rest.clone(), calibrated.to_vec(), PoseOptions::default())
    };
    let (point, points) = (6, 6);
    assert_eq!(
        new(&[0, 1, 2, 6]),
        Err(CaptureError::NoPoint { point, points })
    );
    assert_eq!(new(&[0, 1, 2, 1]), Err(CaptureError::Twice(1)));
    assert!(matches!(
        new(&[0, 1]),
        Err(CaptureError::Rest(error)) if matches!(*error, CaptureError::TooFew { .. })
    ));
    let mut bad = rest.clone();
    bad[5] = Point::new(0.0, f64::INFINITY, 0.0);
    assert_eq!(
        Capture::new(bad, vec![0, 1, 2, 3], PoseOptions::default()),
        Err(CaptureError::RestNotFinite { point: 5 })
    );
    let capture = new(&[0, 1, 2, 3, 4]).unwrap();
    let mut frame: Vec<_> = rest.iter().map(|&point| Some(point)).collect();
    // Three of five calibrated points, and others missing, are enough.
    frame[3] = None;
    frame[4] = None;
    frame[5] = None;
    assert!(capture.frame(&frame).is_ok());
    let good = frame.clone();
    frame[1] = None;
    let found = capture.frames(&[good.clone(), frame.clone()]).unwrap();
    let problem = CaptureError::Missing {
        seen: 2,
        needed: 3,
        missing: vec![1, 3, 4],
    };
    assert_eq!(found[0], capture.frame(&good));
    assert_eq!(found[1], Err(problem.clone()));
    assert!(problem.to_string().contains("point 1, point 3"));
    let none = capture.frames(&[frame.clone(), frame.clone()]);
    let problem = Box::new(problem);
    assert_eq!(none, Err(CaptureError::NoPose { problem }));
    // The four that are seen are on one line at rest, which the fifth is not.
    let mut rest = rest.clone();
    rest[2] = Point::new(2.0, 0.0, 0.0);
    rest[4] = Point::new(3.0, 0.0, 0.0);
    let line = Capture::new(rest.clone(), vec![0, 1, 2, 3, 4], PoseOptions::default()).unwrap();
    let mut seen: Vec<_> = rest.iter().map(|&point| Some(point)).collect();
    assert!(line.frame(&seen).is_ok());
    seen[3] = None;
    let place = PointSet::Rest;
    let problem = line.frame(&seen).unwrap_err();
    let error = Box::new(CaptureError::Collinear { place });
    let missing = vec![3];
    assert_eq!(problem, CaptureError::PoseOfSeen { missing, error });
    assert!(
        problem.to_string().ends_with("missing: point 3"),
        "{problem}"
    );
    frame[1] = Some(Point::new(f64::NAN, 0.0, 0.0));
    let problem = CaptureError::PointNotFinite { point: 1 };
    assert_eq!(capture.frame(&frame), Err(problem.clone()));
    let error = capture.frames(&[good.clone(), frame]).unwrap_err();
    let problem = Box::new(problem);
    assert_eq!(error, CaptureError::Frame { frame: 1, problem });
    let (expected, found) = (6, 5);
    assert_eq!(
        capture.frame(&good[..5]),
        Err(CaptureError::FrameCounts { expected, found })
    );
}

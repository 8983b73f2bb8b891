//! Errors of poses against numpy's singular value decomposition, and laws.

use ga_body::BodyError;
use ga_body::pose_error::{
    mean_per_joint_position_error, procrustes_aligned, rigidly_aligned, root_aligned_error,
};
use ga_runtime::cga3::{Motor, Point, Rotor, Similarity, Translator};
use proptest::prelude::*;
use serde_json::Value;

use nullcone_shared_data::json::{matrix, numbers, rows};

fn near(what: &str, found: f64, expected: f64) {
    assert!(
        (found - expected).abs() <= 1e-12 * expected.abs().max(1.0),
        "{what}: {found} is not {expected}"
    );
}

fn near_motion(found: (Rotor<f64>, [f64; 3]), expected: &Value) {
    let (rows, expected_rows) = (found.0.to_matrix(), matrix(&expected["R"]));
    for (row, expected) in rows.iter().zip(expected_rows) {
        for (found, expected) in row.iter().zip(expected) {
            near("rotation", *found, expected);
        }
    }
    for (found, expected) in found.1.iter().zip(numbers::<3>(&expected["t"])) {
        near("translation", *found, expected);
    }
}

#[test]
fn errors_of_the_oracle() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/procrustes.json");
    let text = std::fs::read_to_string(path).expect("committed");
    let oracle: Value = serde_json::from_str(&text).expect("JSON");
    let cases = oracle["cases"].as_array().expect("cases");
    assert_eq!(cases.len(), 4);
    let mut compared = 0;
    for case in cases {
        let points =
            |key: &str| -> Vec<_> { rows::<3>(&case[key]).into_iter().map(Point::from).collect() };
        let (truth, found) = (points("ground_truth"), points("predicted"));
        let similar = procrustes_aligned(&truth, &found).unwrap();
        let rigid = rigidly_aligned(&truth, &found).unwrap();
        let mut compare = |key: &str, found: f64| {
            if let Some(expected) = case[key].as_f64() {
                near(key, found, expected);
                compared += 1;
            }
        };
        let whole = mean_per_joint_position_error(&truth, &found).unwrap();
        compare("mpjpe", whole);
        compare("mpjpe_root", root_aligned_error(&truth, &found, 0).unwrap());
        compare("pa_mpjpe", similar.mean_error);
        compare("rms_similarity", similar.root_mean_square_error);
        compare("rigid_mpjpe", rigid.mean_error);
        let (motion, expected) = (similar.motion, &case["similarity"]);
        near_motion((motion.rotor(), motion.displacement()), expected);
        near(
            "scale",
            motion.factor(),
            expected["scale"].as_f64().unwrap(),
        );
        if !case["rigid"].is_null() {
            let displacement = rigid.motion.translator().displacement();
            near_motion((rigid.motion.rotor(), displacement), &case["rigid"]);
        }
    }
    // Five of each case, and of the mirror image the one that is stated.
    assert_eq!(compared, 3 * 5 + 1);
}

fn points() -> impl Strategy<Value = Vec<Point<f64>>> {
    let point = prop::array::uniform3(-1.0..1.0_f64).prop_map(Point::from);
    prop::collection::vec(point, 4..20)
}

proptest! {
    #[test]
    fn an_alignment_undoes_a_similarity(
        truth in points(),
        axis in prop::array::uniform3(0.1..1.0_f64),
        angle in -3.0..3.0_f64,
        displacement in prop::array::uniform3(-5.0..5.0_f64),
        factor in 0.2..5.0_f64,
    ) {
        let rotor = Rotor::from_axis_angle(axis, angle).unwrap();
        let motion: Motor<f64> = Translator::from_displacement(displacement) * rotor;
        let moved: Vec<_> = truth.iter().map(|&point| motion.transform(point)).collect();
        // Random points may lie close to a line.
        let Ok(rigid) = rigidly_aligned(&truth, &moved) else { return Ok(()) };
        prop_assert!(rigid.mean_error < 1e-12);
        let similarity = Similarity::from_parts(displacement, rotor, factor).unwrap();
        let moved: Vec<_> = truth.iter().map(|&point| similarity.transform_point(point)).collect();
        let similar = procrustes_aligned(&truth, &moved).unwrap();
        prop_assert!(similar.mean_error < 1e-12);
        prop_assert!((similar.motion.factor() * factor - 1.0).abs() < 1e-11);
        // Relative to the root, a translation does not count.
        let shift = Translator::from_displacement(displacement);
        let moved: Vec<_> = truth.iter().map(|&point| shift.transform(point)).collect();
        prop_assert!(root_aligned_error(&truth, &moved, 1).unwrap() < 1e-14);
    }

    #[test]
    fn better_alignments_leave_smaller_squares(truth in points(), found in points()) {
        let count = truth.len().min(found.len());
        let (truth, found) = (&truth[..count], &found[..count]);
        let (Ok(similar), Ok(rigid)) =
            (procrustes_aligned(truth, found), rigidly_aligned(truth, found))
        else {
            return Ok(());
        };
        let squares: f64 = truth.iter().zip(found).map(|(a, b)| a.distance_squared(*b)).sum();
        let rms = (squares / count as f64).sqrt();
        prop_assert!(similar.root_mean_square_error <= rigid.root_mean_square_error + 1e-12);
        prop_assert!(rigid.root_mean_square_error <= rms + 1e-12);
        prop_assert!(similar.mean_error <= similar.root_mean_square_error + 1e-12);
    }
}

#[test]
fn poses_that_cannot_be_compared() {
    let line: Vec<_> = (0..4).map(|x| Point::new(f64::from(x), 0.0, 0.0)).collect();
    assert_eq!(
        root_aligned_error(&line, &line, 4),
        Err(BodyError::Root { root: 4, joints: 4 })
    );
    let counts = Err(BodyError::JointCounts {
        expected: 4,
        found: 3,
    });
    assert_eq!(mean_per_joint_position_error(&line, &line[..3]), counts);
    assert_eq!(root_aligned_error(&line, &line[..3], 0), counts);
    assert_eq!(
        mean_per_joint_position_error(&[], &[]),
        Err(BodyError::NoJoints)
    );
    for error in [
        procrustes_aligned(&line, &line).unwrap_err(),
        rigidly_aligned(&line, &line).unwrap_err(),
    ] {
        assert!(matches!(error, BodyError::Alignment(_)), "{error}");
    }
}

#[test]
fn joint_errors_of_the_oracle() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/joint_errors.json");
    let text = std::fs::read_to_string(path).unwrap();
    let truth: Value = serde_json::from_str(&text).unwrap();
    for record in truth["mpjpe"].as_array().expect("poses") {
        let pose = |key| -> Vec<_> {
            rows::<3>(&record[key])
                .into_iter()
                .map(Point::from)
                .collect()
        };
        let error = mean_per_joint_position_error(&pose("gt"), &pose("pred")).unwrap();
        let expected = record["mpjpe"].as_f64().expect("a number");
        assert!((error - expected).abs() <= 1e-12 * expected);
    }
}

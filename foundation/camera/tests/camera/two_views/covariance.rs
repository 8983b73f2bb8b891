//! Covariances of points.

use ga_camera::triangulation::{
    CovarianceColumns, Method, PointColumns, TriangulationError, TwoViews, triangulate_views,
};
use ga_runtime::cga3::{Direction, Translator};
use proptest::prelude::*;

use super::{found, places, rigs, seen, side_by_side};

proptest! {
    /// The covariance is that of the inverse of the normal equations by differences.
    #[test]
    fn covariances_are_those_of_least_squares(rig in rigs(), places in places()) {
        prop_assume!(rig.baseline() > 0.1);
        let none = vec![[0.0; 4]; places.len()];
        let Some((_, pairs)) = seen(&rig, &places, &none) else { return Ok(()) };
        let views = TwoViews::new(&rig.left, &rig.right).unwrap();
        let points = found(&rig, Method::Optimal, &pairs);
        let mut covariances = CovarianceColumns::default();
        views.covariances(0.7, &points, &mut covariances).unwrap();
        for index in 0..points.len() {
            prop_assume!(points.angle[index] > 0.02);
            let left = [pairs.left[0][index], pairs.left[1][index]];
            let right = [pairs.right[0][index], pairs.right[1][index]];
            let Ok(other) = triangulate_views(&[rig.left, rig.right], &[left, right]) else { continue };
            let ours = covariances.get(index).unwrap();
            let size: f64 = (0..3).map(|k| ours[k][k]).sum();
            for (ours, theirs) in ours.iter().zip(&other.covariance) {
                for (ours, theirs) in ours.iter().zip(theirs) {
                    prop_assert!((ours - 0.49 * theirs).abs() < 1e-9 * size);
                }
            }
        }
    }
}

/// On the line of both centres the gradients span a plane, also where rounding leaves a volume.
#[test]
fn covariances_on_the_line_of_both_centres_are_errors() {
    let mut random = 1_u64;
    for _ in 0..200 {
        let [a, b, part] = [0, 1, 2].map(|_| {
            random = random.wrapping_mul(6_364_136_223_846_793_005) | 1;
            (random >> 40) as f64 / (1_u64 << 24) as f64
        });
        let mut rig = side_by_side();
        // The right camera is ahead of the left one, at `ahead`.
        let ahead = Direction::new(0.2 * a - 0.1, 0.2 * b - 0.1, 0.5);
        rig.right.world_to_camera = Translator::from_displacement((-ahead).coordinates()).into();
        let views = TwoViews::new(&rig.left, &rig.right).unwrap();
        let [x, y, z] = ahead.coordinates().map(|x| x * (3.0 + 7.0 * part));
        let points = PointColumns {
            x: vec![x],
            y: vec![y],
            z: vec![z],
            ..PointColumns::default()
        };
        let error = views
            .covariances(1.0, &points, &mut CovarianceColumns::default())
            .unwrap_err();
        assert!(
            matches!(error, TriangulationError::Point { point: 0, .. }),
            "{error}"
        );
    }
}

#[test]
fn what_has_no_covariance_is_named() {
    let rig = side_by_side();
    let views = TwoViews::new(&rig.left, &rig.right).unwrap();
    let mut points = PointColumns::default();
    let mut covariances = CovarianceColumns::default();
    let mut error = |points: &PointColumns, noise: f64| {
        let found = views.covariances(noise, points, &mut covariances);
        found.unwrap_err()
    };
    assert_eq!(error(&points, -1.0), TriangulationError::Noise(-1.0));
    // A point on the line of both centres has no finite covariance.
    points.x = vec![3.0, 1.0];
    points.y = vec![1.0, 0.0];
    points.z = vec![4.0, 0.0];
    let expected = TriangulationError::Point {
        point: 1,
        error: Box::new(TriangulationError::NotFinite),
    };
    assert_eq!(error(&points, 1.0), expected);
}

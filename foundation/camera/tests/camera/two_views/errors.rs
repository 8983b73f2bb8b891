//! Pairs, columns and rigs from which no point follows.

use ga_camera::triangulation::{Method, PixelColumns, PointColumns, TriangulationError, TwoViews};

use super::{METHODS, Pairs, side_by_side};

#[test]
fn faulty_pairs_are_named_by_index() {
    let rig = side_by_side();
    let views = TwoViews::new(&rig.left, &rig.right).unwrap();
    let mut points = PointColumns::default();
    for method in METHODS {
        for faulty in [0, 3, 6] {
            let mut left = vec![[330.0, 240.0]; 7];
            let right = vec![[320.0, 240.0]; 7];
            let error = |left: &[[f64; 2]], points: &mut PointColumns| {
                let pairs = Pairs::new(left, &right);
                let [a, b] = pairs.columns();
                views.triangulate(method, a, b, points).unwrap_err()
            };
            left[faulty] = [f64::NAN, 240.0];
            let expected = TriangulationError::Point {
                point: faulty,
                error: Box::new(TriangulationError::NotFinite),
            };
            assert_eq!(error(&left, &mut points), expected);
            left[faulty] = right[faulty];
            let found = error(&left, &mut points);
            assert!(
                matches!(&found, TriangulationError::Point { point, error }
                    if *point == faulty && matches!(**error, TriangulationError::Parallel { .. })),
                "{found}"
            );
            // Crossed pictures put the point behind both cameras, which by itself is not an error.
            left[faulty] = [310.0, 240.0];
            let pairs = Pairs::new(&left, &right);
            let [a, b] = pairs.columns();
            views.triangulate(method, a, b, &mut points).unwrap();
            let behind = points.check_in_front().unwrap_err();
            assert!(
                matches!(&behind, TriangulationError::Point { point, error }
                    if *point == faulty
                        && matches!(**error, TriangulationError::Behind { view: 0, .. })),
                "{behind}"
            );
        }
    }
}

#[test]
fn columns_of_other_lengths_and_rigs_without_a_baseline_are_refused() {
    let rig = side_by_side();
    let views = TwoViews::new(&rig.left, &rig.right).unwrap();
    let mut points = PointColumns::default();
    let short = PixelColumns {
        u: &[1.0, 2.0],
        v: &[1.0],
    };
    let right = PixelColumns {
        u: &[0.0, 0.0],
        v: &[1.0, 1.0],
    };
    let error = views
        .triangulate(Method::Optimal, short, right, &mut points)
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "the v column of the left view has 1 elements, but there are 2 columns of the left view"
    );
    let same = TwoViews::new(&rig.left, &rig.left).unwrap_err();
    assert_eq!(same, TriangulationError::NoBaseline);
    let none = PixelColumns { u: &[], v: &[] };
    views
        .triangulate(Method::Optimal, none, none, &mut points)
        .unwrap();
    assert!(points.is_empty());
}

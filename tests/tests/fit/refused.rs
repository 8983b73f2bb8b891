//! Points that determine no primitive, and settings outside of their range.

use ga_runtime::cga2;
use ga_runtime::cga3::{Circle, Line, Plane, Point, Sphere};
use ga_runtime::geometry::FitError;
use ga_runtime::geometry::fit::{Cylinder, Loss, RobustSettings};
use nullcone_tests::plain::{Vector, plus, rotated};
use nullcone_tests::random::SplitMix64;

type Error = FitError<f64>;

fn points(coordinates: &[Vector]) -> Vec<Point<f64>> {
    coordinates.iter().map(|&p| Point::from(p)).collect()
}

/// Points of a line, at one place, of a plane.
fn degenerate() -> [Vec<Vector>; 3] {
    let line = (0..9)
        .map(|k| f64::from(k * k))
        .map(|t| [0.1 * t, 0.3 - 0.2 * t, 0.7 * t]);
    let plane = (0..9).map(f64::from).map(|t| {
        let (x, y) = ((1.3 * t).sin(), 0.2 * t * t);
        [x, y, 0.25 * x - 0.5 * y + 1.0]
    });
    [line.collect(), vec![[0.1, 0.2, 0.3]; 9], plane.collect()]
}

#[test]
fn flat_points_are_named() {
    // Far away, what is flat is so up to rounding.
    for shift in [[0.0; 3], [1e6, -2e6, 1e6], [1e11, 3e11, -7e11]] {
        for scale in [1.0, 1e-30, 1e30] {
            let [line, heap, plane] = degenerate()
                .map(|set| {
                    set.iter()
                        .map(|&p| plus(p, shift).map(|x| x * scale))
                        .collect::<Vec<_>>()
                })
                .map(|set| points(&set));
            assert_eq!(Sphere::fit(&plane).unwrap_err(), Error::Coplanar);
            assert_eq!(Sphere::fit(&line).unwrap_err(), Error::Collinear);
            assert_eq!(Sphere::fit(&heap).unwrap_err(), Error::Coincident);
            assert_eq!(Cylinder::fit(&plane).unwrap_err(), Error::Coplanar);
            assert_eq!(Cylinder::fit(&line).unwrap_err(), Error::Collinear);
            assert_eq!(Cylinder::fit(&heap).unwrap_err(), Error::Coincident);
            assert_eq!(Circle::fit(&line).unwrap_err(), Error::Collinear);
            assert_eq!(Circle::fit(&heap).unwrap_err(), Error::Coincident);
            assert_eq!(Plane::fit(&line).unwrap_err(), Error::Collinear);
            assert_eq!(Plane::fit(&heap).unwrap_err(), Error::Coincident);
            assert_eq!(Line::fit(&heap).unwrap_err(), Error::Coincident);
            assert_eq!(
                Sphere::fit_algebraically(&plane).unwrap_err(),
                Error::Coplanar
            );
            assert_eq!(
                Cylinder::fit_algebraically(&plane).unwrap_err(),
                Error::Coplanar
            );
            assert_eq!(
                Circle::fit_algebraically(&line).unwrap_err(),
                Error::Collinear
            );
        }
    }
    let flat: Vec<_> = (0..9)
        .map(f64::from)
        .map(|t| cga2::Point::new(t, 3.0 - 0.5 * t))
        .collect();
    assert_eq!(cga2::Circle::fit(&flat).unwrap_err(), Error::Collinear);
}

#[test]
fn what_fits_equally_well_in_several_ways_is_named() {
    let corners = [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ];
    let corners = points(&corners);
    assert_eq!(Plane::fit(&corners).unwrap_err(), Error::NotUnique);
    assert_eq!(Line::fit(&corners).unwrap_err(), Error::NotUnique);
    // Up to rounding, in any orientation.
    for seed in 0..50 {
        let random = &mut SplitMix64(seed);
        let (axis, angle) = (random.axis(), 3.0 * random.unit());
        let turned: Vec<_> = corners
            .iter()
            .map(|p| Point::from(rotated(axis, angle, p.coordinates())))
            .collect();
        assert_eq!(Plane::fit(&turned).unwrap_err(), Error::NotUnique);
        assert_eq!(Line::fit(&turned).unwrap_err(), Error::NotUnique);
    }
    let square = points(&[
        [1.0, 1.0, 2.0],
        [1.0, -1.0, 2.0],
        [-1.0, 1.0, 2.0],
        [-1.0, -1.0, 2.0],
    ]);
    assert_eq!(Line::fit(&square).unwrap_err(), Error::NotUnique);
    assert_eq!(
        Plane::fit(&square).unwrap().primitive.unit_normal(),
        Some([0.0, 0.0, 1.0])
    );
}

/// Sets that are flat within 8√ε of their extent, which is 1.2 · 10⁻⁷, count as flat; thicker ones
/// do not.
#[test]
fn nearly_flat_points_are_named() {
    let [line, _, plane] = degenerate();
    let thick = |set: &[Vector], thickness: f64| -> Vec<Point<f64>> {
        let extent = 16.0 * thickness;
        let moved = set.iter().enumerate().map(|(k, p)| {
            let side = if k % 2 == 0 { extent } else { -extent };
            Point::new(p[0] + side, p[1], p[2] + side * (k % 3) as f64)
        });
        moved.collect()
    };
    assert_eq!(
        Sphere::fit(&thick(&plane, 1e-9)).unwrap_err(),
        Error::Coplanar
    );
    assert_eq!(
        Plane::fit(&thick(&line, 1e-9)).unwrap_err(),
        Error::Collinear
    );
    for (set, primitive) in [(&plane, "sphere"), (&line, "plane")] {
        let set = thick(set, 1e-6);
        let refused = match primitive {
            "sphere" => Sphere::fit(&set).err(),
            _ => Plane::fit(&set).err(),
        };
        assert_eq!(refused, None, "{primitive}");
    }
}

/// Points on both sides of a plane, as far on one as on the other and on average everywhere: a
/// sphere of either curvature fits as badly.
#[test]
fn points_that_no_radius_fits_best_are_named() {
    let mut flat = Vec::new();
    for (x, y) in [
        (1.0, 0.0),
        (-1.0, 0.0),
        (0.0, 1.0),
        (0.0, -1.0),
        (3.0, 1.0),
        (-3.0, -1.0),
    ] {
        flat.extend([[x, y, 0.01], [x, y, -0.01]]);
    }
    let flat = points(&flat);
    assert_eq!(Sphere::fit(&flat).unwrap_err(), Error::Flat);
    assert_eq!(
        Error::Flat.to_string(),
        "no radius fits the points best: larger ones fit ever better"
    );
}

#[test]
fn too_few_points_are_counted() {
    let all = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 2.0, 1.0],
    ];
    let all = points(&all);
    let expected = |found, needed| Error::TooFewPoints { found, needed };
    assert_eq!(Sphere::fit(&all[..3]).unwrap_err(), expected(3, 4));
    assert_eq!(Cylinder::fit(&all).unwrap_err(), expected(5, 6));
    assert_eq!(Circle::fit(&all[..2]).unwrap_err(), expected(2, 3));
    assert_eq!(Plane::fit(&all[..2]).unwrap_err(), expected(2, 3));
    assert_eq!(Line::fit(&all[..1]).unwrap_err(), expected(1, 2));
    assert_eq!(Line::fit(&[]).unwrap_err(), expected(0, 2));
    assert_eq!(
        Sphere::fit_robustly(&all[..3], &RobustSettings::new(0.1)).unwrap_err(),
        expected(3, 4)
    );
    let weighted: Vec<_> = [1.0, 0.0, 1.0, 2.0, 0.0]
        .into_iter()
        .zip(all.clone())
        .collect();
    assert_eq!(Sphere::fit_weighted(&weighted).unwrap_err(), expected(3, 4));
    assert_eq!(
        expected(3, 4).to_string(),
        "4 points with a weight above zero are needed, not 3"
    );
    // As many as are needed determine a primitive, but not the noise.
    assert!(Sphere::fit(&all[..4]).unwrap().covariance().is_none());
    assert!(
        Sphere::fit(&all[..4])
            .unwrap()
            .covariance_for(0.1)
            .is_some()
    );
    assert!(Circle::fit(&all[..3]).unwrap().rms() < 1e-15);
}

#[test]
fn wrong_numbers_are_named_by_their_index() {
    let [.., plane] = degenerate();
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut set = points(&plane);
        set[3] = Point::new(0.0, wrong, 1.0);
        let expected = Error::PointNotFinite { index: 3 };
        assert_eq!(Sphere::fit(&set).unwrap_err(), expected);
        assert_eq!(Cylinder::fit(&set).unwrap_err(), expected);
        assert_eq!(Circle::fit(&set).unwrap_err(), expected);
        assert_eq!(Plane::fit(&set).unwrap_err(), expected);
        assert_eq!(Line::fit(&set).unwrap_err(), expected);
        let robust = Plane::fit_robustly(&set, &RobustSettings::new(0.1));
        assert_eq!(robust.unwrap_err(), expected);
    }
    for wrong in [-1.0, f64::INFINITY] {
        let mut weighted: Vec<_> = points(&plane).into_iter().map(|p| (1.0, p)).collect();
        weighted[5].0 = wrong;
        let invalid = FitError::InvalidWeight {
            index: 5,
            weight: wrong,
        };
        assert_eq!(Plane::fit_weighted(&weighted).unwrap_err(), invalid);
        weighted[5].0 = f64::NAN;
        let error = Plane::fit_weighted(&weighted).unwrap_err();
        assert!(matches!(error, FitError::InvalidWeight { index: 5, .. }));
    }
    let nothing: Vec<_> = points(&plane).into_iter().map(|p| (0.0, p)).collect();
    assert_eq!(
        Line::fit_weighted(&nothing).unwrap_err(),
        FitError::ZeroWeights
    );
}

#[test]
fn settings_outside_of_their_range_are_named() {
    let [.., plane] = degenerate();
    let plane = points(&plane);
    let good = RobustSettings::new(0.1);
    let refused = |settings: RobustSettings<f64>, name: &'static str| match Plane::fit_robustly(
        &plane, &settings,
    )
    .unwrap_err()
    {
        Error::InvalidSetting { name: found, .. } => assert_eq!(found, name),
        other => panic!("{other}"),
    };
    for threshold in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        refused(RobustSettings { threshold, ..good }, "threshold");
        refused(
            RobustSettings {
                scale: Some(threshold),
                ..good
            },
            "scale",
        );
    }
    for confidence in [0.0, 1.0, -0.5, f64::NAN] {
        refused(RobustSettings { confidence, ..good }, "confidence");
    }
    refused(RobustSettings { samples: 0, ..good }, "samples");
    assert_eq!(good.loss, Loss::Tukey);
    assert!(Plane::fit_robustly(&plane, &good).is_ok());
}

#[test]
fn samples_that_never_span_a_primitive_are_no_consensus() {
    let [line, ..] = degenerate();
    let error = Plane::fit_robustly(&points(&line), &RobustSettings::new(0.1)).unwrap_err();
    assert_eq!(
        error,
        Error::NoConsensus {
            found: 0,
            needed: 3
        }
    );
}

//! Closed curves in space from their contours in two views, compared with the curves from which the
//! contours were made.

use std::f64::consts::TAU;

use ga_camera::rig::StereoRig;
use ga_camera::{Camera, Fisheye, Intrinsics, Lens, RadialTangential};
use ga_runtime::cga3::{Circle, Motor, Point, Rotor, Translator};
use ga_vision::contour::space_curve::{SpaceCurveOptions, space_curve};
use ga_vision::contour::{ContourError, resampled};

/// Cameras that look at a place 2 m away from different heights, 0.5 m apart, with distorted lenses
/// and rolled against each other.
fn oblique_rig() -> StereoRig {
    let lens = |k1: f64| RadialTangential::new(&[k1, 0.05, 1e-3, -8e-4, 0.0]).unwrap();
    let camera = |eye: [f64; 3], up: [f64; 3], k1: f64| {
        let intrinsics = Intrinsics::new([900.0, 910.0], [330.0, 235.0]).unwrap();
        let intrinsics = intrinsics.with_lens(lens(k1));
        let target = Point::new(0.0, 0.0, 2.0);
        Camera::look_at(intrinsics, Point::from(eye), target, up).unwrap()
    };
    StereoRig {
        left: camera([-0.2, 0.1, 0.0], [0.1, 1.0, 0.0], -0.2),
        right: camera([0.25, -0.15, 0.1], [-0.2, 1.0, 0.1], -0.15),
    }
}

/// Both contours of a closed curve: from one and the same points, then at points of their own at
/// equal distances.
fn contours(
    rig: &StereoRig,
    curve: impl Fn(f64) -> Point<f64>,
    count: usize,
) -> [Vec<[f64; 2]>; 2] {
    let fine: Vec<Point<f64>> = (0..20 * count)
        .map(|k| curve(k as f64 / (20 * count) as f64))
        .collect();
    let seen = |camera: &Camera, start: usize| {
        let mut pixels = camera.project_all(&fine).unwrap();
        pixels.rotate_left(start);
        resampled(&pixels, count)
    };
    [seen(&rig.left, 0), seen(&rig.right, 7 * count)]
}

/// A circle of radius 0.25 m in an oblique plane through (0, 0, 2).
fn circle(t: f64) -> Point<f64> {
    ellipse(t, [0.25, 0.25])
}

fn ellipse(t: f64, semi_axes: [f64; 2]) -> Point<f64> {
    let (sin, cos) = (TAU * t).sin_cos();
    let place = Point::new(semi_axes[0] * cos, semi_axes[1] * sin, 0.0);
    placement().transform(place)
}

fn placement() -> Motor<f64> {
    let rotor = Rotor::from_axis_angle([0.8, 0.5, 0.3], 0.7).unwrap();
    Translator::from_displacement([0.02, -0.03, 2.0]) * rotor
}

/// The least distances of points from a curve, by a fine search.
fn errors(points: &[Point<f64>], curve: impl Fn(f64) -> Point<f64>) -> Vec<f64> {
    let fine: Vec<Point<f64>> = (0..20_000)
        .map(|k| curve(f64::from(k) / 20_000.0))
        .collect();
    let nearest = |point: &Point<f64>| {
        let distances = fine.iter().map(|other| point.distance(*other));
        distances.fold(f64::INFINITY, f64::min)
    };
    points.iter().map(nearest).collect()
}

fn greatest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

#[test]
fn an_oblique_rig_finds_a_circle() {
    let rig = oblique_rig();
    let [left, right] = contours(&rig, circle, 400);
    let found = space_curve(&rig, &left, &right, &SpaceCurveOptions::default()).unwrap();
    assert_eq!(found.points.len(), 400);
    assert!(found.points.iter().filter(|point| point.is_bridged).count() < 120);
    // Chords of the right contour lie up to 5e-3 pixels inside it. At the least angle that is four
    // times as far along an epipolar line, and at a depth of four baselines 2e-4 m.
    let errors = errors(&found.positions(), circle);
    assert!(greatest(&errors) < 2e-4, "{}", greatest(&errors));
    for (point, left) in found.points.iter().zip(&left) {
        assert_eq!(point.left, *left);
        assert!(point.gap < 1e-4 && point.deviation < 0.02, "{point:?}");
        let seen = rig.right.project(point.position).unwrap();
        assert!((seen[0] - point.right[0]).hypot(seen[1] - point.right[1]) < 0.02);
    }
    assert!((found.length() - TAU * 0.25).abs() < 2e-4);
    let fitted = Circle::fit(&found.triangulated()).unwrap();
    assert!((fitted.radius() - 0.25).abs() < 2e-5);
    let truth = placement().transform(Point::default());
    assert!(fitted.origin().distance(truth) < 2e-5);
}

#[test]
fn ellipses_are_found_in_any_sense_and_from_any_start() {
    let rig = oblique_rig();
    let curve = |t| ellipse(t, [0.35, 0.12]);
    let [left, mut right] = contours(&rig, curve, 300);
    for _ in 0..2 {
        let found = space_curve(&rig, &left, &right, &SpaceCurveOptions::default());
        // At the ends of the ellipse, chords lie 0.03 pixels inside.
        let errors = errors(&found.unwrap().positions(), curve);
        assert!(greatest(&errors) < 1.5e-3, "{}", greatest(&errors));
        right.reverse();
    }
}

/// Two pinholes side by side.
fn rectified_rig() -> StereoRig {
    let intrinsics = Intrinsics::new([800.0; 2], [320.0, 240.0]).unwrap();
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    StereoRig::from_matrices(intrinsics, intrinsics, identity, [-0.3, 0.0, 0.0]).unwrap()
}

/// A point of the tilted plane z = 2 + 0.5 x + 0.3 y.
fn on_tilted_plane([x, y]: [f64; 2]) -> Point<f64> {
    Point::new(x, y, 2.0 + 0.5 * x + 0.3 * y)
}

/// A body with two arms along the baseline: four points of it are in each of many rows, and the two
/// horizontal sides of each arm are in one row. Equal distances along the contours cut its corners
/// by up to 1.5 pixels, and a pixel is 0.017 m in depth.
#[test]
fn sides_along_the_rows_and_arms_beside_each_other_are_matched_in_order() {
    let rig = rectified_rig();
    let corners = [
        [-0.3, -0.3],
        [0.3, -0.3],
        [0.3, -0.1],
        [-0.1, -0.1],
        [-0.1, 0.1],
        [0.3, 0.1],
        [0.3, 0.3],
        [-0.3, 0.3],
    ];
    let seen = |camera: &Camera| {
        let pixels = corners.map(|corner| camera.project(on_tilted_plane(corner)).unwrap());
        resampled(&pixels, 400)
    };
    let [left, right] = [seen(&rig.left), seen(&rig.right)];
    let found = space_curve(&rig, &left, &right, &SpaceCurveOptions::default());
    for point in found.unwrap().points {
        let [x, y, z] = point.position.coordinates();
        assert!((z - (2.0 + 0.5 * x + 0.3 * y)).abs() < 2e-2, "{point:?}");
    }
}

/// Bars along the baseline, of which only the ends have counterparts.
#[test]
fn bars_along_the_rows_are_bridged() {
    let rig = rectified_rig();
    for half_height in [0.15, 0.08, 0.04, 0.02, 0.012] {
        for is_round in [false, true] {
            let [a, b]: [f64; 2] = [0.3, half_height];
            let corners = if is_round {
                let arc = |k: i32| {
                    let (sin, cos) = (f64::from(k) * TAU / 80.0).sin_cos();
                    [(a - b).copysign(cos) + b * cos, b * sin]
                };
                (-20..60).map(arc).collect()
            } else {
                vec![[-a, -b], [a, -b], [a, b], [-a, b]]
            };
            let around = resampled(&corners, 8000);
            let bar = |t: f64| on_tilted_plane(around[(8000.0 * t).round() as usize % 8000]);
            let [left, right] = contours(&rig, bar, 400);
            let found = space_curve(&rig, &left, &right, &SpaceCurveOptions::default());
            let found = found.unwrap_or_else(|error| panic!("{half_height} {is_round}: {error}"));
            let errors = found.points.iter().map(|point| {
                let [x, y, z] = point.position.coordinates();
                (z - (2.0 + 0.5 * x + 0.3 * y)).abs()
            });
            let worst = errors.fold(0.0, f64::max);
            assert!(worst < 2e-2, "{half_height} {is_round}: {worst}");
        }
    }
}

/// Fisheye lenses, one camera before the other: the epipole lies inside the contours, and each
/// epipolar line meets them once.
#[test]
fn a_camera_behind_the_other_sees_every_point_once() {
    let lens = Fisheye::new(&[0.02, -0.004, 0.0, 0.0]).unwrap();
    let intrinsics = Intrinsics::new([400.0; 2], [320.0, 240.0]).unwrap();
    let camera = |z: f64| Camera {
        intrinsics: intrinsics.with_lens(Lens::Fisheye(lens)),
        world_to_camera: Translator::from_displacement([0.0, 0.0, -z]).into(),
    };
    let rig = StereoRig {
        left: camera(0.0),
        right: camera(0.8),
    };
    let [left, right] = contours(&rig, |t| ellipse(t, [0.8, 0.6]), 400);
    let found = space_curve(&rig, &left, &right, &SpaceCurveOptions::default()).unwrap();
    assert!(found.points.iter().all(|point| !point.is_bridged));
    let errors = errors(&found.positions(), |t| ellipse(t, [0.8, 0.6]));
    assert!(greatest(&errors) < 4e-4, "{}", greatest(&errors));
}

#[test]
fn contours_that_give_no_curve_are_errors() {
    let rig = oblique_rig();
    let options = SpaceCurveOptions::default();
    let [left, right] = contours(&rig, circle, 60);
    let fails = |left: &[[f64; 2]], right: &[[f64; 2]]| {
        space_curve(&rig, left, right, &options).unwrap_err()
    };
    let few = ContourError::ContourTooFew {
        view: "right",
        count: 7,
        least: 8,
    };
    assert_eq!(fails(&left, &right[..7]), few);
    let mut wrong = left.clone();
    wrong[11][0] = f64::NAN;
    let error = fails(&wrong, &right);
    let expected = |error: &ContourError| {
        matches!(
            error,
            ContourError::Camera {
                view: "left",
                index: 11,
                ..
            }
        )
    };
    assert!(expected(&error), "{error}");
    // What is far above in one view is not what is below in the other.
    let moved = |by: f64| -> Vec<[f64; 2]> { right.iter().map(|[u, v]| [*u, v + by]).collect() };
    assert_eq!(fails(&left, &moved(-600.0)), ContourError::NoOverlap);
    // A part of the one is in the planes of a part of the other.
    let error = fails(&left, &moved(-220.0));
    assert!(matches!(error, ContourError::Apart { .. }), "{error}");
    let flat: Vec<[f64; 2]> = (0..10).map(|k| [f64::from(k), 3.0]).collect();
    assert_eq!(fails(&flat, &right), ContourError::NoArea { view: "left" });
    // A bar along the baseline, too thin for points at its ends.
    let corners = [[-0.3, -0.002], [0.3, -0.002], [0.3, 0.002], [-0.3, 0.002]];
    let around = resampled(&corners, 8000);
    let bar = |t: f64| on_tilted_plane(around[(8000.0 * t).round() as usize % 8000]);
    let [thin, other] = contours(&rectified_rig(), bar, 400);
    let error = space_curve(&rectified_rig(), &thin, &other, &options).unwrap_err();
    assert!(
        matches!(
            error,
            ContourError::AlongLines {
                crossing: ..8,
                count: 400,
                least: 8
            }
        ),
        "{error}"
    );
    let same = StereoRig {
        left: rig.left,
        right: rig.left,
    };
    let error = space_curve(&same, &left, &left, &options).unwrap_err();
    assert!(matches!(error, ContourError::Cameras(_)), "{error}");
}

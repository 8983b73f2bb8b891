//! Grids of circles in rendered pictures against the truth, and against OpenCV.

use ga_camera::{Camera, Intrinsics};
use ga_image::filter::{Border, Gaussian};
use ga_image::plane::Plane;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_vision::board::{Board, Pattern};
use ga_vision::calibration::{BoardViews, CalibrationError, LensTerms};
use ga_vision::circle_grid::{Arrangement, find};
use proptest::prelude::*;

const SIZE: [usize; 2] = [480, 360];
const PATTERNS: [(Pattern, &str); 2] = [
    (Pattern::Circles, "7x5"),
    (Pattern::AsymmetricCircles, "4x9"),
];

fn board(pattern: Pattern, size: &str) -> Board {
    Board::new(pattern, size.parse().unwrap(), 0.02).unwrap()
}

/// The picture of a board whose discs have a radius, by a pinhole.
fn picture(board: &Board, radius: f64, camera: &Camera) -> Plane<u8> {
    const SAMPLES: usize = 5;
    let camera_to_board = camera.world_to_camera.reverse();
    let origin = camera_to_board.transform(Point::default()).coordinates();
    let places = board.places();
    let ([fx, fy], [cx, cy]) = (camera.intrinsics.focal(), camera.intrinsics.principal());
    // The place on the board, and the depth.
    let on_board = |u: f64, v: f64| {
        let through = Point::new((u - cx) / fx, (v - cy) / fy, 1.0);
        let through = camera_to_board.transform(through).coordinates();
        let depth = origin[2] / (origin[2] - through[2]);
        let place = [0, 1].map(|k| origin[k] + depth * (through[k] - origin[k]));
        (place, depth)
    };
    let distance = |[x, y]: [f64; 2], centre: &Point<f64>| {
        let [a, b, _] = centre.coordinates();
        (x - a).hypot(y - b)
    };
    let sharp = Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
        let (u, v) = (column as f64, row as f64);
        let (place, depth) = on_board(u, v);
        let nearest = places
            .iter()
            .min_by(|a, b| distance(place, a).total_cmp(&distance(place, b)))
            .unwrap();
        let brightness = |place| match distance(place, nearest) < radius {
            true => 0.15,
            false => 0.85,
        };
        // A pixel covers less than this of the board.
        if (distance(place, nearest) - radius).abs() > 3.0 * depth / fx {
            return brightness(place) as f32;
        }
        let samples = (0..SAMPLES * SAMPLES).map(|k| {
            let [du, dv] =
                [k % SAMPLES, k / SAMPLES].map(|k| (k as f64 + 0.5) / SAMPLES as f64 - 0.5);
            brightness(on_board(u + du, v + dv).0)
        });
        (samples.sum::<f64>() / (SAMPLES * SAMPLES) as f64) as f32
    });
    let blurred = Gaussian::new(0.8).unwrap().blur(&sharp, Border::Mirror);
    blurred.map(|value| (255.0 * value).round() as u8)
}

fn camera(board: &Board, [pitch, yaw, roll]: [f64; 3], distance: f64) -> Camera {
    let places = board.places();
    let extent = places.iter().map(|place| place.coordinates());
    let extent = extent.fold([0.0_f64; 2], |most, place| {
        [0, 1].map(|k| most[k].max(place[k]))
    });
    let about = |axis, angle| Rotor::from_axis_angle(axis, angle).unwrap();
    let rotor =
        about([0.0, 1.0, 0.0], yaw) * about([1.0, 0.0, 0.0], pitch) * about([0.0, 0.0, 1.0], roll);
    let centre = Translator::from_displacement([-0.5 * extent[0], -0.5 * extent[1], 0.0]);
    let place = [0.0, 0.0, distance * extent[0].max(extent[1])];
    Camera {
        intrinsics: Intrinsics::new([420.0, 420.0], [239.5, 179.5]).unwrap(),
        world_to_camera: Motor::from(Translator::from_displacement(place)) * (rotor * centre),
    }
}

fn greatest_distance(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    assert_eq!(a.len(), b.len());
    let distances = a.iter().zip(b);
    let distances = distances.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
    distances.fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// The centres, and not those of the ellipses, which are up to half a pixel beside them here.
    #[test]
    fn rendered_grids_are_found_where_they_are(
        which in 0_usize..2,
        pose in (-0.7..0.7, -0.7..0.7, -3.1..3.1),
        distance in 1.5..2.2,
    ) {
        let (pattern, size) = PATTERNS[which];
        let board = board(pattern, size);
        let camera = camera(&board, [pose.0, pose.1, pose.2], distance);
        let truth = camera.project_all(&board.places()).map_err(|(_, error)| error).unwrap();
        let is_inside = truth.iter().all(|[u, v]| {
            (22.0..458.0).contains(u) && (22.0..338.0).contains(v)
        });
        prop_assume!(is_inside);
        let found = board.find(&picture(&board, 0.3 * 0.02, &camera));
        let found = found.map_err(|error| TestCaseError::fail(error.to_string()))?;
        let mut turned = truth.clone();
        turned.reverse();
        let apart = greatest_distance(&found.view().pixels(), &truth)
            .min(match pattern {
                Pattern::Circles => greatest_distance(&found.view().pixels(), &turned),
                // With an odd number of rows it looks the same in no other direction.
                _ => f64::INFINITY,
            });
        prop_assert!(apart < 0.05, "{apart} px");
    }
}

/// Grids of other sizes, of the other arrangement, cut by the border, and no grids.
#[test]
fn other_grids_are_not_found() {
    let is_not_found = |picture: &Plane<u8>, size: &str, arrangement: Arrangement| {
        let found = find(picture, size.parse().unwrap(), arrangement);
        assert!(
            matches!(found, Err(CalibrationError::CirclesNotFound { .. })),
            "{size} {arrangement:?}: {found:?}"
        );
    };
    for (pattern, size) in PATTERNS {
        let board = board(pattern, size);
        let camera = camera(&board, [0.3, -0.2, 0.1], 1.6);
        let all = picture(&board, 0.3 * 0.02, &camera);
        assert!(board.find(&all).is_ok());
        for other in ["6x5", "7x4", "8x5", "4x8", "3x9", "4x10", "5x9"] {
            is_not_found(&all, other, Arrangement::Symmetric);
            is_not_found(&all, other, Arrangement::Asymmetric);
        }
        match pattern {
            Pattern::Circles => is_not_found(&all, size, Arrangement::Asymmetric),
            _ => is_not_found(&all, size, Arrangement::Symmetric),
        }
        let [u, _] = camera.project(board.places()[17]).unwrap();
        let part = Plane::from_fn(u as usize, SIZE[1], |column, row| {
            all.get(column, row).unwrap()
        });
        let found = board.find(&part);
        assert!(found.is_err(), "{found:?}");
    }
    let level = Plane::filled(60, 50, 90_u8);
    is_not_found(&level, "4x3", Arrangement::Symmetric);
    is_not_found(&Plane::filled(0, 0, 0), "4x3", Arrangement::Asymmetric);
}

/// Bright circles on a dark board.
#[test]
fn brightness_may_be_exchanged() {
    for (pattern, size) in PATTERNS {
        let board = board(pattern, size);
        let dark = picture(&board, 0.3 * 0.02, &camera(&board, [0.3, -0.2, 0.1], 1.6));
        let bright = dark.map(|level| 255 - level);
        assert_eq!(board.find(&bright).unwrap(), board.find(&dark).unwrap());
    }
}

/// Two views begin at one circle, on both sides of where the first one changes.
#[test]
fn grids_of_two_views_get_one_order() {
    let board = board(Pattern::Circles, "7x5");
    for quarter in 0..4 {
        let roll = f64::from(quarter) * std::f64::consts::FRAC_PI_2 - 0.8;
        let [left, right] = [roll - 0.08, roll + 0.08].map(|roll| {
            let camera = camera(&board, [0.0, 0.0, roll], 1.6);
            board.find(&picture(&board, 0.3 * 0.02, &camera)).unwrap()
        });
        let right = right.ordered_like(&left);
        assert!(greatest_distance(&left.view().pixels(), &right.view().pixels()) < 40.0);
    }
}

/// The focal length from rendered pictures of each pattern.
#[test]
fn cameras_are_calibrated_with_circles() {
    for (pattern, size) in PATTERNS {
        let board = board(pattern, size);
        let mut views = BoardViews::new(board);
        let tilts = [
            [0.5, 0.0, 0.1],
            [-0.5, 0.1, 0.4],
            [0.1, 0.5, -0.2],
            [-0.1, -0.5, 0.3],
            [0.4, 0.4, 0.0],
            [-0.4, 0.4, 0.2],
        ];
        for (index, tilt) in tilts.into_iter().enumerate() {
            let camera = camera(&board, tilt, 1.7 + 0.05 * index as f64);
            let picture = picture(&board, 0.3 * 0.02, &camera);
            views.add(&picture, index.to_string()).unwrap();
        }
        let found = views.calibrate(Some(LensTerms::none())).unwrap();
        assert_eq!(found.views.len(), tilts.len(), "{:?}", found.rejected);
        assert!(found.camera.rms < 0.03, "{pattern:?}: {}", found.camera.rms);
        let [fx, fy] = found.camera.intrinsics.focal();
        assert!(
            (fx - 420.0).abs() < 0.8 && (fy - 420.0).abs() < 0.8,
            "{pattern:?}: {fx} {fy}"
        );
    }
}

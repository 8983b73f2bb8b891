//! Cameras from boards with tags, of which pictures show a part.

use ga_image::plane::Plane;
use ga_vision::board::Board;
use ga_vision::calibration::{BoardPairs, BoardViews, CalibrationError, LensTerms, PairNames};
use ga_vision::tag::AprilGrid;

use super::boards::{SIZE, charuco, charuco_brightness, grid_brightness};
use super::scene::View;

const FOCAL: f64 = 700.0;
const PRINCIPAL: [f64; 2] = [318.0, 242.0];
/// Angles, the place on the board, in parts of its size, that the camera looks at, and how far it
/// is, in its widths.
const VIEWS: [([f64; 3], [f64; 2], f64); 7] = [
    ([35.0, 0.0, 5.0], [0.5, 0.5], 1.5),
    ([-35.0, 5.0, 95.0], [0.5, 0.5], 1.5),
    ([5.0, 35.0, 185.0], [0.5, 0.5], 1.4),
    ([0.0, -35.0, -10.0], [0.5, 0.5], 1.4),
    ([25.0, 25.0, 20.0], [0.9, 0.4], 1.1),
    ([-25.0, 25.0, 40.0], [0.1, 0.5], 1.1),
    ([20.0, -30.0, 10.0], [0.5, 0.9], 1.0),
];

/// The pictures of a board with an extent, whose y is up or down.
fn pictures(
    extent: [f64; 2],
    is_upwards: bool,
    brightness: impl Fn([f64; 2]) -> f64,
) -> Vec<Plane<u8>> {
    let picture = |(seed, (angles, at, distance)): (usize, ([f64; 3], [f64; 2], f64))| {
        let mut place = [0, 1].map(|k| at[k] * extent[k]);
        if is_upwards {
            place[1] = -place[1];
        }
        let view = View::new(angles, place, (FOCAL, distance * extent[0]), PRINCIPAL);
        let view = if is_upwards { view.upwards() } else { view };
        view.picture(SIZE, &brightness, (0.7, 1.0), seed as u64)
    };
    VIEWS.into_iter().enumerate().map(picture).collect()
}

fn check(board: Board, pictures: &[Plane<u8>]) {
    let mut views = BoardViews::new(board);
    for (index, picture) in pictures.iter().enumerate() {
        views.add(picture, index.to_string()).unwrap();
    }
    let found = views.calibrate(Some(LensTerms::none())).unwrap();
    assert_eq!(found.views.len(), VIEWS.len(), "{:?}", found.rejected);
    let count = board.places().len();
    let parts = found.views.iter().filter(|view| view.points < count);
    assert!(parts.count() >= 2, "{:?}", found.views);
    assert!(found.camera.rms < 0.08, "{}", found.camera.rms);
    let [fx, fy] = found.camera.intrinsics.focal();
    assert!(
        (fx - FOCAL).abs() < 1.5 && (fy - FOCAL).abs() < 1.5,
        "{fx} {fy}"
    );
    let principal = found.camera.intrinsics.principal();
    let apart = [0, 1].map(|k| principal[k] - PRINCIPAL[k]);
    assert!(apart[0].hypot(apart[1]) < 1.5, "{principal:?}");
}

#[test]
fn cameras_are_calibrated_with_charuco_boards() {
    check(
        charuco().into(),
        &pictures([7.0, 5.0], false, charuco_brightness),
    );
}

#[test]
fn cameras_are_calibrated_with_april_grids() {
    let grid = AprilGrid::new([4, 3], [1.0, 0.3], AprilGrid::BORDER_OF_KALIBR).unwrap();
    check(grid.into(), &pictures([4.9, 3.6], true, grid_brightness));
}

/// Edges are those of squares, and of tags where these stand alone.
#[test]
fn edges_are_as_long_as_the_board_says() {
    let grid = AprilGrid::new([4, 3], [0.08, 0.3], AprilGrid::BORDER_OF_KALIBR).unwrap();
    for (board, count) in [
        (Board::from(charuco()), 4 * 5 + 3 * 6),
        (grid.into(), 4 * 12),
    ] {
        let (places, edges) = (board.places(), board.edges());
        assert_eq!(edges.len(), count);
        for [a, b] in edges {
            let length = places[a].distance(places[b]);
            assert!(
                (length - board.spacing()).abs() < 1e-12,
                "{a} {b}: {length}"
            );
        }
    }
}

/// A view of one tag, and two views of different tags, say too little.
#[test]
fn few_points_are_refused() {
    let grid = AprilGrid::new([4, 3], [1.0, 0.3], AprilGrid::BORDER_OF_KALIBR).unwrap();
    let board = Board::from(grid);
    let view = View::new([10.0, 5.0, 0.0], [2.45, -1.8], (700.0, 9.5), [322.0, 237.0]).upwards();
    let seen_in = |range: [[f64; 2]; 2]| {
        let is_seen =
            move |place: [f64; 2]| (0..2).all(|k| (range[k][0]..range[k][1]).contains(&place[k]));
        let brightness = move |place| {
            if is_seen(place) {
                grid_brightness(place)
            } else {
                1.0
            }
        };
        view.picture(SIZE, brightness, (0.7, 1.0), 0)
    };
    let one = seen_in([[-0.3, 1.3], [-0.3, 1.3]]);
    let refused = board.find(&one);
    let not_found = |found| CalibrationError::TagsNotFound { found, count: 48 };
    assert_eq!(refused, Err(not_found(4)));
    let [left, right] = [[-0.3, 2.55], [2.4, 5.2]].map(|columns| seen_in([columns, [-0.3, 4.0]]));
    assert!(board.find(&left).is_ok() && board.find(&right).is_ok());
    let mut pairs = BoardPairs::new(board);
    let names = PairNames {
        left: "left.png".to_owned(),
        right: "right.png".to_owned(),
    };
    assert!(
        pairs
            .add(&[left.clone(), right], names.clone())
            .unwrap()
            .is_none()
    );
    assert!(pairs.add(&[left.clone(), left], names).unwrap().is_some());
}

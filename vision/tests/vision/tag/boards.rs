//! Boards of tags in rendered pictures.

use ga_image::plane::Plane;
use ga_vision::calibration::{BoardView, SeenPoint};
use ga_vision::tag::{AprilGrid, CharucoBoard, CharucoPattern, Dictionary, TagError};

use super::scene::{View, rms};
use super::tags::tag_brightness;

pub(super) const SIZE: [usize; 2] = [640, 480];
const DICTIONARY: Dictionary = Dictionary::Aruco4x4_100;

/// A board of 7 × 5 squares with sides of 1 and tags of 0.72: the square at the top left is dark,
/// and tags are numbered along the rows.
pub(super) fn charuco_brightness([x, y]: [f64; 2]) -> f64 {
    let (columns, rows) = (7.0, 5.0);
    if !(0.0..columns).contains(&x) || !(0.0..rows).contains(&y) {
        return 1.0;
    }
    let (column, row) = (x as usize, y as usize);
    if (column + row).is_multiple_of(2) {
        return 0.0;
    }
    // White squares before this one.
    let id = (row * 7 + column) / 2;
    let module = 0.72 / 6.0;
    let inside = [x - column as f64, y - row as f64].map(|place| (place - 0.14) / module);
    tag_brightness(DICTIONARY, id, 1, inside)
}

pub(super) fn charuco() -> CharucoBoard {
    CharucoBoard::new([7, 5], [1.0, 0.72], DICTIONARY, CharucoPattern::Current).unwrap()
}

fn check(found: &BoardView, places: &[[f64; 2]], view: &View) -> f64 {
    let pairs = found
        .points()
        .iter()
        .map(|seen| (seen.pixel, view.pixel(places[seen.point])));
    let worst = pairs
        .clone()
        .map(|pair| rms([pair].into_iter()))
        .fold(0.0, f64::max);
    assert!(worst < 0.3, "{worst} px");
    rms(pairs)
}

fn in_plane(points: Vec<ga_runtime::cga3::Point<f64>>) -> Vec<[f64; 2]> {
    let places = points.into_iter().map(|point| {
        let [x, y, z] = point.coordinates();
        assert_eq!(z, 0.0);
        [x, y]
    });
    places.collect()
}

#[test]
fn corners_of_charuco_boards_are_found_where_they_are() {
    let board = charuco();
    let places = in_plane(board.points());
    let mut errors = Vec::new();
    for (n, pose) in [
        [0.0, 0.0, 0.0],
        [30.0, 10.0, 15.0],
        [-35.0, 25.0, 200.0],
        [5.0, -45.0, 95.0],
    ]
    .into_iter()
    .enumerate()
    {
        let view = View::new(pose, [3.5, 2.5], (700.0, 10.5), [318.3, 241.6]);
        let picture = view.picture(SIZE, charuco_brightness, (0.7, 1.5), n as u64);
        let found = board.find(&picture).unwrap();
        assert_eq!(found.points().len(), 24, "{pose:?}");
        errors.push(check(&found, &places, &view));
    }
    assert!(errors.iter().all(|error| *error < 0.05), "{errors:?}");
}

/// A board that is cut by the border of the picture and has a paper on it.
#[test]
fn parts_of_charuco_boards_have_the_right_numbers() {
    let board = charuco();
    let places = in_plane(board.points());
    let view = View::new([20.0, 15.0, 25.0], [3.5, 2.5], (700.0, 7.0), [130.0, 200.0]);
    let is_paper = |[x, y]: [f64; 2]| (4.3..5.7).contains(&x) && (1.3..2.7).contains(&y);
    let brightness = |place| {
        if is_paper(place) {
            0.6
        } else {
            charuco_brightness(place)
        }
    };
    let picture = view.picture(SIZE, brightness, (0.7, 1.5), 9);
    let found = board.find(&picture).unwrap();
    assert!(
        (10..22).contains(&found.points().len()),
        "{}",
        found.points().len()
    );
    check(&found, &places, &view);
    let hidden = |seen: &SeenPoint| is_paper(places[seen.point]);
    assert!(!found.points().iter().any(hidden));
}

/// Two tags that have been exchanged lead to no wrong corners.
#[test]
fn a_tag_that_is_elsewhere_is_left_out() {
    let board = charuco();
    let places = in_plane(board.points());
    let view = View::new([10.0, 5.0, 5.0], [3.5, 2.5], (700.0, 9.5), [320.0, 240.0]);
    // The square at column 3, row 2 shows what the one at column 1, row 0 shows.
    let moved = |[x, y]: [f64; 2]| match (3.0..4.0).contains(&x) && (2.0..3.0).contains(&y) {
        true => charuco_brightness([x - 2.0, y - 2.0]),
        false => charuco_brightness([x, y]),
    };
    let picture = view.picture(SIZE, moved, (0.7, 1.5), 5);
    let found = board.find(&picture).unwrap();
    assert!(found.points().len() >= 18, "{}", found.points().len());
    check(&found, &places, &view);
}

/// Of a board with exchanged colours nothing is found: the corners are not those of the pattern.
#[test]
fn another_pattern_is_not_found() {
    let legacy = CharucoPattern::Legacy;
    let even = CharucoBoard::new([7, 6], [1.0, 0.72], DICTIONARY, legacy).unwrap();
    let view = View::new([10.0, 5.0, 5.0], [3.5, 2.5], (700.0, 9.5), [320.0, 240.0]);
    let picture = view.picture(SIZE, charuco_brightness, (0.7, 1.5), 6);
    assert_eq!(even.find(&picture).unwrap(), BoardView::default());
    assert_eq!(
        charuco().find(&Plane::filled(100, 80, 7u8)).unwrap(),
        BoardView::default()
    );
}

/// kalibr's board: tags as their authors draw them where y is up, borders of two modules, and dark
/// squares in the corners of the gaps.
pub(super) fn grid_brightness([x, y]: [f64; 2]) -> f64 {
    const GAP: f64 = 0.3;
    let (columns, rows) = (4.0, 3.0);
    let [right, top] = [columns, rows].map(|count| count + (count - 1.0) * GAP);
    if !(-GAP..right + GAP).contains(&x) || !(-GAP..top + GAP).contains(&y) {
        return 1.0;
    }
    let [cell_x, cell_y] = [x, y].map(|place| (place / (1.0 + GAP)).floor());
    let [inside_x, inside_y] = [x - cell_x * (1.0 + GAP), y - cell_y * (1.0 + GAP)];
    if inside_x >= 1.0 && inside_y >= 1.0 {
        return 0.0;
    }
    if inside_x >= 1.0 || inside_y >= 1.0 {
        return 1.0;
    }
    let id = cell_y as usize * 4 + cell_x as usize;
    // Upright where y is up is (x, 1 − y); rotated by 180° from the dictionary, (1 − x, y).
    let modules = [1.0 - inside_x, inside_y].map(|place| (10.0 * place).clamp(0.0, 9.999));
    tag_brightness(Dictionary::April36h11, id, 2, modules)
}

#[test]
fn corners_of_april_grids_are_found_where_they_are() {
    let grid = AprilGrid::new([4, 3], [1.0, 0.3], AprilGrid::BORDER_OF_KALIBR).unwrap();
    let places = in_plane(grid.points());
    let mut errors = Vec::new();
    for (n, pose) in [[0.0, 0.0, 0.0], [30.0, -20.0, 30.0], [-25.0, 35.0, 170.0]]
        .into_iter()
        .enumerate()
    {
        let view = View::new(pose, [2.45, -1.8], (700.0, 9.5), [322.0, 237.0]).upwards();
        let picture = view.picture(SIZE, grid_brightness, (0.7, 1.5), n as u64);
        let found = grid.find(&picture);
        assert_eq!(found.points().len(), 48, "{pose:?}");
        errors.push(check(&found, &places, &view));
    }
    assert!(errors.iter().all(|error| *error < 0.06), "{errors:?}");
    // With a border of one module they are no tags of the family.
    let narrow = AprilGrid::new([4, 3], [1.0, 0.3], 1).unwrap();
    let view = View::new([0.0; 3], [2.45, -1.8], (700.0, 9.5), [322.0, 237.0]).upwards();
    let picture = view.picture(SIZE, grid_brightness, (0.7, 1.5), 1);
    assert_eq!(narrow.find(&picture), BoardView::default());
}

#[test]
fn descriptions_that_are_no_boards_are_errors() {
    let board = |squares, sides| {
        let found = CharucoBoard::new(
            squares,
            sides,
            Dictionary::Aruco4x4_50,
            CharucoPattern::Current,
        );
        found.unwrap_err().to_string()
    };
    assert_eq!(
        board([2, 5], [1.0, 0.5]),
        "a board of 2 × 5 squares is not one: each is from 3 to 100"
    );
    assert_eq!(
        board([20, 20], [1.0, 0.5]),
        "4X4_50 has 50 tags, and the board needs 200"
    );
    assert_eq!(
        board([5, 5], [0.03, 0.03]),
        "tags of 0.03 m do not fit into squares of 0.03 m"
    );
    assert_eq!(
        board([5, 5], [f64::NAN, 0.03]),
        "a square of NaN m is not positive and finite"
    );
    let grid = |tags, sides, border| AprilGrid::new(tags, sides, border).unwrap_err();
    assert!(matches!(
        grid([30, 30], [1.0, 0.3], 2),
        TagError::TooFewTags { needed: 900, .. }
    ));
    assert!(matches!(
        grid([6, 6], [1.0, 0.0], 2),
        TagError::Length { .. }
    ));
    assert!(matches!(
        grid([6, 6], [1.0, 0.3], 3),
        TagError::Border { border: 3 }
    ));
    let error = "5X5_77".parse::<Dictionary>().unwrap_err().to_string();
    assert!(
        error.starts_with("\"5X5_77\" is no dictionary of tags: 4X4_50, 4X4_100, "),
        "{error}"
    );
    assert_eq!("dict_apriltag_36H11".parse(), Ok(Dictionary::April36h11));
}

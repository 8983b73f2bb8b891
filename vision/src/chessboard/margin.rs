//! Whether a grid of corners is a whole board, and not a part of a larger one.

use ga_image::interpolation::bilinear;
use ga_image::plane::Plane;

use super::BoardSize;
use crate::homography::Homography;

/// The difference between bright and dark squares beyond the margin at which a board goes on, as a
/// part of that on the board.
const LEAST_CONTRAST: f64 = 0.5;

/// Whether the squares between the corners are bright and dark in turn, and those beyond the
/// outermost squares are not.
pub(super) fn is_whole_board(picture: &Plane<f32>, corners: &[[f64; 2]], size: BoardSize) -> bool {
    let (columns, rows) = (size.columns(), size.rows());
    let place = |index: usize| [(index % columns) as f64, (index / columns) as f64];
    let places: Vec<[f64; 2]> = (0..corners.len()).map(place).collect();
    let Some(homography) = Homography::from_pairs(&places, corners) else {
        return false;
    };
    let square = |column: f64, row: f64| brightness(picture, &homography, [column, row]);
    // Differences between neighbours, with the sign that makes them equal on a board.
    let contrast = |squares: &[Option<f64>]| {
        let pairs = squares.windows(2).enumerate();
        let differences = pairs.filter_map(|(k, pair)| {
            let difference = pair[0]? - pair[1]?;
            Some(if k % 2 == 0 { difference } else { -difference })
        });
        let differences: Vec<f64> = differences.collect();
        let count = differences.len();
        (count > 0).then(|| differences.iter().sum::<f64>() / count as f64)
    };
    let row = |row: f64| -> Vec<Option<f64>> {
        (0..=columns).map(|k| square(k as f64 - 1.0, row)).collect()
    };
    let column = |column: f64| -> Vec<Option<f64>> {
        (0..=rows).map(|k| square(column, k as f64 - 1.0)).collect()
    };
    let inside = |row_index: usize| {
        let squares = row(row_index as f64);
        contrast(&squares[1..columns]).map(|sum| {
            if row_index.is_multiple_of(2) {
                sum
            } else {
                -sum
            }
        })
    };
    let Some(on_board) = (0..rows - 1).map(inside).collect::<Option<Vec<f64>>>() else {
        return false;
    };
    let on_board = on_board.iter().sum::<f64>() / on_board.len() as f64;
    let beyond = [
        row(-2.0),
        row(rows as f64),
        column(-2.0),
        column(columns as f64),
    ];
    let goes_on = |squares: &Vec<Option<f64>>| {
        contrast(squares).is_some_and(|found| found.abs() > LEAST_CONTRAST * on_board.abs())
    };
    on_board != 0.0 && !beyond.iter().any(goes_on)
}

/// The mean brightness in the middle of the square that begins at a corner. `None` where the square
/// is not in the picture.
fn brightness(picture: &Plane<f32>, homography: &Homography, corner: [f64; 2]) -> Option<f64> {
    const PARTS: [f64; 3] = [0.35, 0.5, 0.65];
    let mut sum = 0.0;
    for x in PARTS {
        for y in PARTS {
            let place = homography.apply([corner[0] + x, corner[1] + y])?;
            sum += bilinear(picture, place)?;
        }
    }
    Some(sum / (PARTS.len() * PARTS.len()) as f64)
}

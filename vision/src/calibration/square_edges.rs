//! The edges of the squares of boards, measured in space.

use std::collections::HashMap;

use super::board_view::BoardView;
use crate::board::Board;
use ga_camera::rig::{RigError, StereoRig};

/// The lengths of the edges of squares, between triangulated corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SquareEdges {
    /// How many edges were measured.
    pub count: usize,
    /// The mean length, in the unit of the rig's translation.
    pub mean: f64,
    /// The root mean square difference from the given length.
    pub rms_error: f64,
    /// The greatest difference from the given length.
    pub greatest_error: f64,
}

/// Measures the edges between neighbouring points of boards: what the rig says about lengths, from
/// the points alone. An edge that is longer than the board's length counts as much shorter, such as
/// the two lengths from a circle to the next in a row, where every other row is moved.
///
/// # Errors
///
/// [`RigError`] for the first corner that cannot be triangulated, counted over all boards.
///
/// ```
/// use ga_runtime::cga3::{Point, Translator};
/// use ga_vision::calibration::{BoardView, square_edges};
/// use ga_camera::Intrinsics;
/// use ga_vision::board::{Board, Pattern};
/// use ga_camera::rig::StereoRig;
///
/// let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
/// let parallel = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let rig = StereoRig::from_matrices(intrinsics, intrinsics, parallel, [-0.12, 0.0, 0.0])?;
/// // A board at 1 m with squares of 25 mm: 48 edges along its rows, and 45 along its columns.
/// let board = Board::new(Pattern::Chessboard, "9x6".parse()?, 0.025)?;
/// let away = Translator::from_displacement([0.0, 0.0, 1.0]);
/// let corners: Vec<Point<f64>> = board.places().iter().map(|p| away.transform(*p)).collect();
/// let left = rig.left.project_all(&corners).map_err(|(_, error)| error)?;
/// let right = rig.right.project_all(&corners).map_err(|(_, error)| error)?;
/// let [left, right] = [left, right].map(|pixels| [BoardView::complete(&pixels)]);
/// let edges = square_edges(&rig, [&left, &right], &board)?;
/// assert_eq!(edges.count, 93);
/// assert!((edges.mean - 0.025).abs() < 1e-12 && edges.greatest_error < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn square_edges(
    rig: &StereoRig,
    views: [&[BoardView]; 2],
    board: &Board,
) -> Result<SquareEdges, RigError> {
    let mut lengths = Vec::new();
    let (edges, places, square) = (board.edges(), board.places(), board.spacing());
    for (left, right) in views[0].iter().zip(views[1]) {
        let [left, right] = left.shared(right);
        let corners = rig.triangulate_all(&left.pixels(), &right.pixels())?;
        let numbers = left.points().iter().map(|seen| seen.point);
        let found: HashMap<usize, _> = numbers.zip(&corners).collect();
        let length = |[a, b]: &[usize; 2]| {
            let [first, second] = [found.get(a)?, found.get(b)?];
            let measured = first.position.distance(second.position);
            Some(measured * square / places[*a].distance(places[*b]))
        };
        lengths.extend(edges.iter().filter_map(length));
    }
    let count = lengths.len();
    let mean = |values: &dyn Fn(f64) -> f64| {
        lengths.iter().map(|length| values(*length)).sum::<f64>() / count.max(1) as f64
    };
    let errors = lengths.iter().map(|length| (length - square).abs());
    Ok(SquareEdges {
        count,
        mean: mean(&|length| length),
        rms_error: mean(&|length| (length - square).powi(2)).sqrt(),
        greatest_error: errors.fold(0.0, f64::max),
    })
}

//! The edges of the squares of boards, measured in space.

use crate::chessboard::BoardSize;
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

/// Measures the edges between neighbouring corners of boards with squares of a given side: what the
/// rig says about lengths, from the corners alone.
///
/// # Errors
///
/// [`RigError`] for the first corner that cannot be triangulated, counted over all boards.
///
/// ```
/// use ga_runtime::cga3::{Point, Translator};
/// use ga_vision::calibration::square_edges;
/// use ga_camera::Intrinsics;
/// use ga_vision::chessboard::BoardSize;
/// use ga_camera::rig::StereoRig;
///
/// let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
/// let parallel = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let rig = StereoRig::from_matrices(intrinsics, intrinsics, parallel, [-0.12, 0.0, 0.0])?;
/// // A board at 1 m with squares of 25 mm: 48 edges along its rows, and 45 along its columns.
/// let size = BoardSize::new(9, 6)?;
/// let away = Translator::from_displacement([0.0, 0.0, 1.0]);
/// let corners: Vec<Point<f64>> = size.places(0.025).iter().map(|p| away.transform(*p)).collect();
/// let left = [rig.left.project_all(&corners).map_err(|(_, error)| error)?];
/// let right = [rig.right.project_all(&corners).map_err(|(_, error)| error)?];
/// let edges = square_edges(&rig, [&left, &right], size, 0.025)?;
/// assert_eq!(edges.count, 93);
/// assert!((edges.mean - 0.025).abs() < 1e-12 && edges.greatest_error < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn square_edges(
    rig: &StereoRig,
    views: [&[Vec<[f64; 2]>]; 2],
    size: BoardSize,
    square: f64,
) -> Result<SquareEdges, RigError> {
    let mut lengths = Vec::new();
    for (left, right) in views[0].iter().zip(views[1]) {
        let corners = rig.triangulate_all(left, right)?;
        let length = |a: usize, b: usize| corners[a].position.distance(corners[b].position);
        let columns = size.columns();
        let along = (1..corners.len()).filter(|index| index % columns > 0);
        lengths.extend(along.map(|index| length(index, index - 1)));
        lengths.extend((columns..corners.len()).map(|index| length(index, index - columns)));
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

//! What can go wrong with contours.

use ga_camera::CameraError;
use ga_camera::triangulation::TriangulationError;
use ga_image::plane::PlaneError;
use ga_runtime::geometry::FitError;

/// Why a picture has no outline, points no ellipse, a snake does not move, or two contours are not
/// those of a curve in space. Points are counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ContourError {
    /// There are too few points.
    #[error("{count} points do not determine an ellipse; at least {least} are needed")]
    EllipseTooFew {
        /// The number of points.
        count: usize,
        /// The least number.
        least: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("point {index} is not finite")]
    EllipseNotFinite {
        /// The point, counted from 0.
        index: usize,
    },
    /// The points lie so that several ellipses or none fit them best.
    #[error("the points do not determine an ellipse: {arrangement}")]
    Degenerate {
        /// How the points lie.
        arrangement: &'static str,
    },
    /// All pixels have the same level.
    #[error("no contour is found: all pixels have the same level")]
    OneLevel,
    /// No border encloses the least area.
    #[error("no contour is found: no border encloses {least_area} or more pixels")]
    NoBorder {
        /// The least area, in pixels.
        least_area: f64,
    },
    /// The largest border touches that of the picture.
    #[error(
        "the contour leaves the picture of {} × {} pixels at the pixel ({}, {})",
        size[0], size[1], pixel[0], pixel[1]
    )]
    LeavesPicture {
        /// Column and row of the first pixel at the border.
        pixel: [u32; 2],
        /// Columns and rows of the picture.
        size: [usize; 2],
    },
    /// There are too few points.
    #[error("{count} points are too few for a snake; at least {least} are needed")]
    SnakeTooFew {
        /// The number of points.
        count: usize,
        /// The least number.
        least: usize,
    },
    /// All points are at one place, or so near each other that the tension or the rigidity by the
    /// power of their distance is infinite.
    #[error("the points of a snake are {spacing} pixels apart on average")]
    NoLength {
        /// The mean distance of neighbouring points in pixels.
        spacing: f64,
    },
    /// A point is not in the picture.
    #[error(
        "point {index} of the contour, at ({}, {}), is outside the picture of {} × {} pixels",
        point[0], point[1], size[0], size[1]
    )]
    Outside {
        /// The point, counted from 0.
        index: usize,
        /// Where it is.
        point: [f64; 2],
        /// Columns and rows of the picture.
        size: [usize; 2],
    },
    /// A setting is not a number that it can be.
    #[error("the {setting} of a snake cannot be {value}")]
    Setting {
        /// The setting.
        setting: &'static str,
        /// Its value.
        value: f64,
    },
    /// The energy or its slope is infinite or not a number.
    #[error(
        "the energy of the snake is beyond the range of numbers: the tension of {tension}, the \
         rigidity of {rigidity} or the potential is too great"
    )]
    EnergyNotFinite {
        /// α.
        tension: f64,
        /// β.
        rigidity: f64,
    },
    /// The picture is too small for slopes.
    #[error("a picture of {width} × {height} pixels is too small for a snake")]
    TooSmall {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// A pixel is infinite or not a number.
    #[error("the pixel in column {column} and row {row} is not finite")]
    PixelNotFinite {
        /// The column.
        column: usize,
        /// The row.
        row: usize,
    },
    /// The equations of a flow were not solved.
    #[error("the flow of the edges was not found in {steps} steps: a part of {residual} is left")]
    FlowNotConverged {
        /// How many steps were taken.
        steps: usize,
        /// The residual by the right-hand side.
        residual: f64,
    },
    /// The picture cannot be blurred so.
    #[error(transparent)]
    Sigma(#[from] PlaneError),
    /// A contour has too few points.
    #[error("{count} points are too few for the contour of the {view} view; {least} are needed")]
    ContourTooFew {
        /// Left or right.
        view: &'static str,
        /// The number of its points.
        count: usize,
        /// The least number.
        least: usize,
    },
    /// A pixel gives no ray.
    #[error("point {index} of the contour of the {view} view: {error}")]
    Camera {
        /// Left or right.
        view: &'static str,
        /// The point, counted from 0.
        index: usize,
        /// What is wrong with it.
        error: Box<CameraError>,
    },
    /// A contour encloses no area, so that it does not run in one sense round anything.
    #[error("the contour of the {view} view encloses no area")]
    NoArea {
        /// Left or right.
        view: &'static str,
    },
    /// The cameras stand at one place.
    #[error(transparent)]
    Cameras(TriangulationError),
    /// No point of the left contour has an epipolar line that meets the right contour in front of
    /// both cameras.
    #[error(
        "the contours have no points in common: no epipolar line of the left one meets the right \
         one in front of both cameras"
    )]
    NoOverlap,
    /// The left contour runs along the epipolar lines nearly everywhere: it is a thin bar or a slit
    /// along the baseline.
    #[error(
        "only {crossing} of {count} points of the left contour are where it crosses epipolar lines, \
         and {least} are needed: take more points, or views from cameras one of which is to the \
         side of the contour's length"
    )]
    AlongLines {
        /// How many points are where the contour crosses their epipolar lines.
        crossing: usize,
        /// The number of points.
        count: usize,
        /// The least number that cross them.
        least: usize,
    },
    /// Few points of the left contour have a counterpart on the right one in the same order.
    #[error(
        "only {matched} of the {crossing} points where the left contour crosses epipolar lines \
         have a counterpart on the right one; the contours are not those of one curve, or have too \
         few points"
    )]
    TooFewMatches {
        /// How many have one.
        matched: usize,
        /// The number of points at which the left contour crosses epipolar lines.
        crossing: usize,
    },
    /// The place of a point that was not matched is not on the right contour.
    #[error(
        "point {index} of the left contour has its place {deviation:.1} pixels beside the right \
         one; the contours are not those of one curve"
    )]
    Apart {
        /// The point, counted from 0.
        index: usize,
        /// The distance from the right contour in pixels.
        deviation: f64,
    },
    /// A stretch whose epipolar lines touch the curve has no place in front of the cameras.
    #[error("point {index} of the left contour has no place on the curve through its neighbours")]
    NotBridged {
        /// The point, counted from 0.
        index: usize,
    },
    /// No circle is nearest to a curve in space.
    #[error("the circle through the curve: {0}")]
    Circle(FitError<f64>),
    /// No line is nearest to a curve in space.
    #[error("the line through the curve: {0}")]
    Line(FitError<f64>),
    /// The nearest line has no point or direction in numbers.
    #[error("the line through the curve is beyond the range of numbers")]
    LineNotFinite,
}

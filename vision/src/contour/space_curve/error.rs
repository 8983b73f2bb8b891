//! What does not give a curve in space.

use ga_camera::CameraError;
use ga_camera::triangulation::TriangulationError;

/// Why two contours do not give a closed curve in space.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SpaceCurveError {
    /// A contour has too few points.
    #[error("{count} points are too few for the contour of the {view} view; {least} are needed")]
    TooFew {
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
}

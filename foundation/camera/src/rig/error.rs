//! What can be wrong with two cameras and their pictures.

use crate::CameraError;
use crate::triangulation::TriangulationError;

/// Why two pictures do not determine points, or two cameras are not a rectified rig.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RigError {
    /// A pixel gives no ray.
    #[error("point {point}: {error}")]
    Camera {
        /// Which point, from 0.
        point: usize,
        /// What is wrong with it.
        error: CameraError,
    },
    /// The cameras, or pairs of pixels, determine no points.
    #[error("{0}")]
    Triangulation(#[from] TriangulationError),
    /// The pictures have different numbers of points.
    #[error("{left} points in the left picture, {right} in the right one")]
    Counts {
        /// How many there are on the left.
        left: usize,
        /// How many there are on the right.
        right: usize,
    },
    /// A lens is not a pinhole.
    #[error("the lens of the {view} camera is not a pinhole")]
    Lens {
        /// Left or right.
        view: &'static str,
    },
    /// The focal lengths differ.
    #[error("the focal lengths {left:?} and {right:?} of the two cameras differ")]
    Focal {
        /// Those of the left camera in pixels.
        left: [f64; 2],
        /// Those of the right camera in pixels.
        right: [f64; 2],
    },
    /// The principal points are in different rows.
    #[error("the principal points are in the rows {left} and {right}, which differ")]
    Rows {
        /// That of the left camera.
        left: f64,
        /// That of the right camera.
        right: f64,
    },
    /// The baseline is not positive and finite.
    #[error("the baseline is {0} m, which is not positive and finite")]
    Baseline(f64),
}
